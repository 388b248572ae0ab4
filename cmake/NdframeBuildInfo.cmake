# What the program says of itself (--version, summaries): versions of the libraries' headers, read when CMake configures, and
# the commit, looked up when it has changed.

# ndframe_header_version(VARIABLE HEADER PATTERN [SUFFIXES...]): the first group of the pattern in a header; empty without it.
function(ndframe_header_version variable header pattern)
  find_file(NDFRAME_HEADER_${variable} ${header} HINTS ${MPI_C_INCLUDE_DIRS} PATH_SUFFIXES suitesparse coin x86_64-linux-gnu)
  set(version "")
  if(NDFRAME_HEADER_${variable})
    file(STRINGS ${NDFRAME_HEADER_${variable}} lines REGEX "${pattern}")
    foreach(line IN LISTS lines)
      string(REGEX MATCH "${pattern}" found "${line}")
      list(APPEND parts ${CMAKE_MATCH_1})
    endforeach()
    list(JOIN parts "." version)
  endif()
  set(${variable} "${version}" PARENT_SCOPE)
endfunction()

ndframe_header_version(cholmod cholmod_core.h "^#define CHOLMOD_[MS][A-Z]+_VERSION +([0-9]+)")
ndframe_header_version(mumps dmumps_c.h "^#define MUMPS_VERSION +\"([0-9.]+)\"")
ndframe_header_version(metis metis.h "^#define METIS_VER_[A-Z]+ +([0-9]+)")
ndframe_header_version(openblas openblas_config.h "OPENBLAS_VERSION \" OpenBLAS ([0-9.]+)")
ndframe_header_version(clp ClpConfig.h "^#define CLP_VERSION +\"([0-9.]+)\"")
ndframe_header_version(basix basix/version.h "^#define BASIX_VERSION_[MP][A-Z]+ +([0-9]+)")
ndframe_header_version(exodus exodusII.h "^#define EX_API_VERS +([0-9.]+)")
ndframe_header_version(gmsh gmshc.h "^#define GMSH_API_VERSION +\"([0-9.]+)\"")
if(NOT NDFRAME_SANITIZE)
  ndframe_header_version(jemalloc jemalloc/jemalloc.h "^#define JEMALLOC_VERSION +\"([0-9.]+)")
endif()
ndframe_header_version(mpi mpi.h "^#define OMPI_[MR][A-Z]+_VERSION +([0-9]+)")

set(libraries "")
foreach(pair "Trilinos=${Trilinos_VERSION}" "CHOLMOD=${cholmod}" "MUMPS=${mumps}" "METIS=${metis}" "OpenBLAS=${openblas}"
             "Clp=${clp}" "Basix=${basix}" "Exodus II=${exodus}" "gmsh=${gmsh}" "jemalloc=${jemalloc}" "Open MPI=${mpi}")
  string(REGEX MATCH "^([^=]+)=(.*)$" found "${pair}")
  if(NOT CMAKE_MATCH_2 STREQUAL "")
    string(APPEND libraries "{\"${CMAKE_MATCH_1}\", \"${CMAKE_MATCH_2}\"}, ")
  endif()
endforeach()
# Headers that change only when what they say does; the commit belongs to the program alone, so that only it is linked again.
set(NDFRAME_GENERATED_DIR ${PROJECT_BINARY_DIR}/generated)
file(CONFIGURE OUTPUT ${NDFRAME_GENERATED_DIR}/ndframe_build.hpp CONTENT
     "#pragma once\n#define NDFRAME_BUILD_TYPE \"@CMAKE_BUILD_TYPE@\"\n#define NDFRAME_COMPILER \"@CMAKE_CXX_COMPILER_ID@ @CMAKE_CXX_COMPILER_VERSION@\"\n#define NDFRAME_LIBRARIES @libraries@\n" @ONLY)

# The rule that writes NDFRAME_COMMIT_HEADER; in the folder of the target that has it among its sources.
set(NDFRAME_COMMIT_HEADER ${NDFRAME_GENERATED_DIR}/ndframe_commit.hpp)
function(ndframe_commit_header)
  set(script "commit=$(git -C '${PROJECT_SOURCE_DIR}' describe --always --abbrev=10 --exclude='*' 2>/dev/null || echo unknown)")
  # One line more with every commit and every other one that is checked out; elsewhere than in .git for a second working tree.
  execute_process(COMMAND git rev-parse --git-path logs/HEAD WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                  OUTPUT_VARIABLE head_log OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    set(head_log .git/logs/HEAD)
  endif()
  get_filename_component(head_log "${head_log}" ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
  if(NOT EXISTS ${head_log})
    set(head_log "")
  endif()
  add_custom_command(
    OUTPUT ${NDFRAME_COMMIT_HEADER}
    COMMAND sh -c "${script}; printf '#pragma once\\n#define NDFRAME_COMMIT \"%s\"\\n' $commit > '${NDFRAME_COMMIT_HEADER}'"
    DEPENDS ${head_log} COMMENT "The commit" VERBATIM)
endfunction()
