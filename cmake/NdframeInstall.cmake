# `cmake --install` also gives a CMake package: find_package(ndframe) defines ndframe::PACKAGE.
include(CMakePackageConfigHelpers)

set(NDFRAME_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/ndframe)
install(EXPORT ndframeTargets NAMESPACE ndframe:: DESTINATION ${NDFRAME_CMAKE_DIR})

configure_package_config_file(cmake/ndframeConfig.cmake.in ${PROJECT_BINARY_DIR}/ndframeConfig.cmake
                              INSTALL_DESTINATION ${NDFRAME_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ndframeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ndframeConfig.cmake ${PROJECT_BINARY_DIR}/ndframeConfigVersion.cmake
              cmake/NdframeThirdParty.cmake
        DESTINATION ${NDFRAME_CMAKE_DIR})

# nddiff compares any two Exodus files; `ndframe report` makes pages. Both look for their modules in ../share/ndframe.
install(PROGRAMS regression/nddiff DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY regression/harness apps/ndreport DESTINATION ${NDFRAME_SHARE_DIR} PATTERN __pycache__ EXCLUDE)
