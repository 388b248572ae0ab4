# cpack runs this before it takes what is to be packed: sources that changed since the last build are built, tests are not.
message(STATUS "Building ${CPACK_NDFRAME_BUILD}: ndframe, up to date")
execute_process(COMMAND ${CMAKE_COMMAND} --build ${CPACK_NDFRAME_BUILD} --target ndframe RESULT_VARIABLE status
                OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${output}\nthe build failed; nothing was packed. Try: cmake --build ${CPACK_NDFRAME_BUILD} --target ndframe")
endif()
