# Sources of one target compiled several at a time: a clean build takes half of the time, because headers are read and
# templates instantiated once for a group. A change of one source then costs that of its whole group. What is compiled
# together, and why it means the same as apart: source_groups.py.
option(NDFRAME_COMPILE_GROUPS "Compile the sources of a target in groups: for clean builds" OFF)

function(ndframe_compile_in_groups target)
  if(NOT NDFRAME_COMPILE_GROUPS)
    return()
  endif()
  find_program(NDFRAME_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
  get_target_property(sources ${target} SOURCES)
  set(script ${PROJECT_SOURCE_DIR}/cmake/source_groups.py)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script})
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  # A new name in a source can part its group.
  foreach(source IN LISTS sources)
    get_filename_component(path ${source} ABSOLUTE)
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  endforeach()
  execute_process(COMMAND ${NDFRAME_PYTHON} -B ${script} ${sources} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
                  OUTPUT_VARIABLE groups OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE ";" "," groups "${groups}")
  string(REPLACE "\n" ";" groups "${groups}")
  set(number 0)
  foreach(group IN LISTS groups)
    string(REPLACE "," ";" group "${group}")
    set_source_files_properties(${group} PROPERTIES UNITY_GROUP ${target}_${number})
    math(EXPR number "${number} + 1")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # A source of a group is no header, although the compiler takes it for one.
  target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
endfunction()
