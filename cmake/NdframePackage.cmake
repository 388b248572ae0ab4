# A package that the program loads when it is needed. It sees the headers of its DEPENDS and links none of them, which
# the linker proves.
function(ndframe_module target)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;LIBRARIES" ${ARGN})
  add_library(${target} MODULE ${ARG_SOURCES})
  ndframe_compile_in_groups(${target})
  foreach(package ${ARG_DEPENDS})
    target_include_directories(${target} PRIVATE $<TARGET_PROPERTY:ndframe_${package},INTERFACE_INCLUDE_DIRECTORIES>)
  endforeach()
  target_link_libraries(${target} PRIVATE ndframe_options ${ARG_LIBRARIES})
  target_link_options(${target} PRIVATE LINKER:--no-undefined LINKER:--as-needed)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${target}-${PROJECT_VERSION}
                                             LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${NDFRAME_MODULE_DIR})
  install(TARGETS ${target} LIBRARY DESTINATION ${NDFRAME_MODULE_DIR})
endfunction()

# Packages that compute little and spend much of the compiler's time: not optimised under the sanitizers, in half of it.
set(NDFRAME_QUICK_PACKAGES run accuracy report drawing driver)

# ndframe_package(NAME [MODULE] SOURCES ... [DEPENDS packages ...] [LIBRARIES third-party targets ...] [PUBLIC_LIBRARIES ...])
# One static library `ndframe_NAME` (installed as ndframe::NAME) with its headers in packages/NAME/include/ndframe/NAME.
function(ndframe_package name)
  cmake_parse_arguments(ARG "MODULE" "" "SOURCES;DEPENDS;LIBRARIES;PUBLIC_LIBRARIES" ${ARGN})
  set(target ndframe_${name})
  if(ARG_MODULE)
    ndframe_module(${target} SOURCES ${ARG_SOURCES} DEPENDS ${ARG_DEPENDS} LIBRARIES ${ARG_LIBRARIES})
    return()
  endif()
  add_library(${target} STATIC ${ARG_SOURCES})
  ndframe_compile_in_groups(${target})
  add_library(ndframe::${name} ALIAS ${target})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} PUBLIC cxx_std_17)
  if(NDFRAME_SANITIZE AND name IN_LIST NDFRAME_QUICK_PACKAGES)
    target_compile_options(${target} PRIVATE -O0)
  endif()
  list(TRANSFORM ARG_DEPENDS PREPEND ndframe_)
  target_link_libraries(${target} PUBLIC ${ARG_DEPENDS} ${ARG_PUBLIC_LIBRARIES}
                                  PRIVATE $<BUILD_INTERFACE:ndframe_options> ${ARG_LIBRARIES})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT ndframeTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
endfunction()

# Of tests that start programs, perhaps on more ranks than there are cores: who waits leaves its core to others. mpirun would
# wait for one or two seconds after every run whose exit code is not 0.
set(NDFRAME_RUN_ENVIRONMENT
    "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;OPENBLAS_NUM_THREADS=1;OMPI_MCA_mpi_yield_when_idle=1"
    "OMPI_MCA_odls_base_sigkill_timeout=0")

set(NDFRAME_TEST_ENVIRONMENT "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;OMPI_MCA_rmaps_base_oversubscribe=1")

# Test programs spend more time in the compiler than in their own loops. Under the sanitizers they look at addresses
# only: undefined behaviour is looked for in the packages.
function(ndframe_compile_quickly target)
  set_target_properties(${target} PROPERTIES NDFRAME_IS_TEST ON)
  if(NDFRAME_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  else()
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# Half of a build is the compilation of tests. A build with sanitizers can take the objects of another one instead: what is
# looked into is then the packages and the program, not the tests themselves. .ci/run does so.
set(NDFRAME_TEST_OBJECTS "" CACHE PATH "Folder of a finished build whose objects of tests are linked; empty: tests are compiled")

# ndframe_test_objects(NAME SOURCES...): a program or library of tests has these sources, or their objects of another build.
function(ndframe_test_objects name)
  set(record objects/${name}.txt)
  if(NDFRAME_TEST_OBJECTS)
    file(STRINGS ${NDFRAME_TEST_OBJECTS}/${record} objects)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${NDFRAME_TEST_OBJECTS}/${record})
    target_sources(${name} PRIVATE ${objects})
    set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  else()
    target_sources(${name} PRIVATE ${ARGN})
    file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/${record} CONTENT "$<JOIN:$<TARGET_OBJECTS:${name}>,\n>\n")
  endif()
  ndframe_compile_in_groups(${name})
endfunction()

option(NDFRAME_ALL_SCENES "Under the sanitizers, too, all tests of a program and as many random scenes as in the release build" OFF)

# ndframe_without(VARIABLE PATTERNS...): the argument with which a GoogleTest program leaves out tests; empty without patterns.
function(ndframe_without variable)
  list(JOIN ARGN ":" patterns)
  if(NOT ARGN)
    set(${variable} "" PARENT_SCOPE)
  else()
    set(${variable} --gtest_filter=-${patterns} PARENT_SCOPE)
  endif()
endfunction()

# ndframe_test(NAME SOURCES ... PACKAGES ... [LONG ...]): a GoogleTest program; every TEST in it becomes one ctest entry. Under the
# sanitizers the program is one entry: to start two thousand processes would take longer than the tests. LONG: patterns of tests
# that take long there, and reach no code that others do not.
function(ndframe_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PACKAGES;LIBRARIES;LONG" ${ARGN})
  add_executable(${name})
  ndframe_test_objects(${name} ${ARG_SOURCES})
  list(TRANSFORM ARG_PACKAGES PREPEND ndframe_)
  target_link_libraries(${name} PRIVATE ndframe_options ${ARG_PACKAGES} ${ARG_LIBRARIES} GTest::gtest GTest::gmock ndframe_test_main
                                       ndframe_patient_waits)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  ndframe_compile_quickly(${name})
  if(NDFRAME_SANITIZE)
    if(NDFRAME_ALL_SCENES)
      set(ARG_LONG "")
    endif()
    ndframe_without(chosen ${ARG_LONG})
    add_test(NAME ${name} COMMAND ${name} ${chosen})
    list(LENGTH ARG_SOURCES length) # who takes long starts first
    set_tests_properties(${name} PROPERTIES TIMEOUT 1500 COST ${length} ENVIRONMENT "${NDFRAME_TEST_ENVIRONMENT}")
  else()
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600 ENVIRONMENT "${NDFRAME_TEST_ENVIRONMENT}")
  endif()
endfunction()

# ndframe_mpi_test(NAME RANKS r1 r2 ... [LONG ...]): the same program again as one ctest entry per rank count. LONG: patterns of
# tests that are left out, because they take long and every rank does the same.
function(ndframe_mpi_test name)
  cmake_parse_arguments(ARG "" "" "RANKS;LONG" ${ARGN})
  ndframe_without(chosen ${ARG_LONG})
  foreach(ranks IN LISTS ARG_RANKS)
    add_test(NAME ${name}.np${ranks} COMMAND ${MPIEXEC_EXECUTABLE} --oversubscribe -np ${ranks} $<TARGET_FILE:${name}> ${chosen})
    set_tests_properties(${name}.np${ranks} PROPERTIES PROCESSORS 2 TIMEOUT 600 COST 20
                         ENVIRONMENT "${NDFRAME_RUN_ENVIRONMENT}")
  endforeach()
endfunction()
