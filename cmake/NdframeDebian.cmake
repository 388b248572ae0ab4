# `cpack --config build/release/CPackConfig.cmake` makes three packages for Debian 12: ndframe (program, reports, Python module, decks),
# ndframe-dev (headers and libraries for find_package) and ndframe-doc (the documentation site).

# The site is built when it is packed, and not installed otherwise.
install(CODE "
  execute_process(COMMAND /usr/bin/python3 -B \"${PROJECT_SOURCE_DIR}/docs/site/build.py\" \"${PROJECT_BINARY_DIR}/docs\" COMMAND_ERROR_IS_FATAL ANY)
  file(INSTALL \"${PROJECT_BINARY_DIR}/docs/html\" DESTINATION \"\${CMAKE_INSTALL_PREFIX}/share/doc/ndframe-doc\")"
  COMPONENT documentation EXCLUDE_FROM_ALL)

set(CPACK_PACKAGE_CONTACT "the ndframe maintainers <root@localhost>" CACHE STRING "Who answers for the Debian packages: Name <mail>")

# Debian's papers: copyright holds LICENSE as a field, changelog has the date of CHANGELOG.md.
set(papers ${PROJECT_BINARY_DIR}/debian)
file(READ LICENSE license)
string(REGEX REPLACE "\n\n" "\n.\n" license "${license}")
string(REGEX REPLACE "\n([^\n])" "\n \\1" license " ${license}")
file(TIMESTAMP CHANGELOG.md date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(cmake/debian/copyright.in ${papers}/copyright @ONLY)
configure_file(cmake/debian/changelog.in ${papers}/changelog @ONLY)
foreach(pair "program=ndframe" "development=ndframe-dev" "documentation=ndframe-doc")
  string(REGEX MATCH "(.*)=(.*)" pair "${pair}")
  install(FILES ${papers}/copyright ${papers}/changelog CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CMAKE_MATCH_2}
          COMPONENT ${CMAKE_MATCH_1} EXCLUDE_FROM_ALL)
endforeach()

# What find_package(ndframe) looks for: the -dev packages that the build needs, without those of tests, of
# gmsh, which is not linked, and of the program's allocator.
file(STRINGS packages.txt headers REGEX "-dev$")
list(FILTER headers EXCLUDE REGEX "^(lib(gtest|gmock|gmsh|jemalloc)|dpkg)-dev$")
list(JOIN headers ", " headers)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ndframe)
set(CPACK_PACKAGE_VENDOR "the ndframe maintainers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
# What is packed is up to date, and the tests need not be built for it (makefiles would build `all` first).
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(CPACK_NDFRAME_BUILD ${PROJECT_BINARY_DIR})
set(CPACK_INSTALL_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/build_first.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/finish.cmake)
set(CPACK_COMPONENTS_ALL program development documentation)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# The terms of the libraries that are linked: docs/dependencies.md, Licences.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "certified unilateral contact between elastic bodies")

set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Solves frictionless contact by Neumann-Dirichlet domain decomposition and says,
with a guaranteed bound, how wrong the answer is. With reports, a Python
module, decks to begin with and the test of an installation, ndregress.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME ndframe)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/prerm)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "python3, python3-netcdf4")
# gmsh and meshio for drawings and foreign meshes, the others for reports and several processes
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libgmsh4.8, python3-matplotlib, python3-jinja2, python3-meshio, python3-h5py, openmpi-bin")

set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Headers, static libraries and the CMake package, for components of your own.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME ndframe-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "ndframe (= ${PROJECT_VERSION}), ${headers}")

set(CPACK_DEBIAN_DOCUMENTATION_DESCRIPTION "Tutorials, reference, theory and the public headers as pages for a browser.")
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_NAME ndframe-doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
include(CPack)
