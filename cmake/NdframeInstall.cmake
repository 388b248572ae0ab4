# `cmake --install` also gives a CMake package: find_package(ndframe) defines ndframe::PACKAGE.
include(CMakePackageConfigHelpers)

set(NDFRAME_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/ndframe)
install(EXPORT ndframeTargets NAMESPACE ndframe:: DESTINATION ${NDFRAME_CMAKE_DIR} COMPONENT development)

configure_package_config_file(cmake/ndframeConfig.cmake.in ${PROJECT_BINARY_DIR}/ndframeConfig.cmake
                              INSTALL_DESTINATION ${NDFRAME_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ndframeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ndframeConfig.cmake ${PROJECT_BINARY_DIR}/ndframeConfigVersion.cmake
              cmake/NdframeThirdParty.cmake
        DESTINATION ${NDFRAME_CMAKE_DIR} COMPONENT development)

# nddiff compares any two Exodus files; ndregress runs the regression cases, the test of an installation; `ndframe report` makes pages.
# All look for their modules in ../share/ndframe.
install(PROGRAMS regression/nddiff regression/ndregress DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY regression/harness regression/cases DESTINATION ${NDFRAME_SHARE_DIR}/regression PATTERN __pycache__ EXCLUDE)
install(FILES regression/tolerances.toml DESTINATION ${NDFRAME_SHARE_DIR}/regression)
install(DIRECTORY apps/ndreport python/ndframe DESTINATION ${NDFRAME_SHARE_DIR} PATTERN __pycache__ EXCLUDE)
# Where Debian's Python looks below the prefix /usr; it finds `import ndframe` there.
set(NDFRAME_PYTHON_DIR lib/python3/dist-packages)
file(RELATIVE_PATH NDFRAME_PYTHON_LINK /prefix/${NDFRAME_PYTHON_DIR} /prefix/${NDFRAME_SHARE_DIR}/ndframe)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/python_link)
file(CREATE_LINK ${NDFRAME_PYTHON_LINK} ${PROJECT_BINARY_DIR}/python_link/ndframe SYMBOLIC)
install(FILES ${PROJECT_BINARY_DIR}/python_link/ndframe DESTINATION ${NDFRAME_PYTHON_DIR})

install(DIRECTORY decks DESTINATION ${NDFRAME_SHARE_DIR})
install(DIRECTORY docs/examples DESTINATION ${NDFRAME_SHARE_DIR} PATTERN __pycache__ EXCLUDE)
install(DIRECTORY tests/install/client DESTINATION ${NDFRAME_SHARE_DIR}/examples COMPONENT development)
