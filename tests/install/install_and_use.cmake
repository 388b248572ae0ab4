# Installs the build NDFRAME_BUILD below WORK, builds the client against it, and runs the client.
function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(client ${CMAKE_CURRENT_LIST_DIR}/client)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run(${CMAKE_COMMAND} --install ${NDFRAME_BUILD} --prefix ${WORK}/prefix)
run(${WORK}/prefix/bin/ndframe --version)
run(${CMAKE_COMMAND} -S ${client} -B ${WORK}/build -G Ninja -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/client -i ${client}/own-relaxation.xml)
