# Installs the build NDFRAME_BUILD below WORK, builds the client against it, and runs the client.
function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(client ${CMAKE_CURRENT_LIST_DIR}/client)
set(krylov -i ${client}/own-relaxation.xml --set "Linear Solver/Type=Krylov")
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run(${CMAKE_COMMAND} --install ${NDFRAME_BUILD} --prefix ${WORK}/prefix)
run(${WORK}/prefix/bin/ndframe --version)
run(${WORK}/prefix/bin/ndframe --check ${client}/../../../decks/krylov.xml)
run(${WORK}/prefix/bin/ndframe -q -i ${client}/../../../decks/patch.xml --set Output/Report=true)
run(${WORK}/prefix/bin/ndregress --np 1 punch rings) # the test of the installation
foreach(place share/ndframe lib/python3/dist-packages)
  run(${CMAKE_COMMAND} -E env PYTHONPATH=${WORK}/prefix/${place} /usr/bin/python3 -B -c
      "import ndframe; run = ndframe.run('${client}/../../../decks/patch.xml'); assert run.fields.blocks == ('upper', 'lower'), run.fields.blocks; assert ndframe.find_program() == '${WORK}/prefix/bin/ndframe', ndframe.find_program()")
endforeach()
if(NOT EXISTS ${WORK}/patch.report.html)
  message(FATAL_ERROR "the installed program has written no report")
endif()
foreach(file share/man/man1/ndframe.1 share/bash-completion/completions/ndframe share/zsh/vendor-completions/_ndframe
             share/fish/vendor_completions.d/ndframe.fish)
  if(NOT EXISTS ${WORK}/prefix/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
run(${CMAKE_COMMAND} -S ${client} -B ${WORK}/build -G Ninja -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/client -i ${client}/own-relaxation.xml)
run(${WORK}/build/client -i ${client}/own-coupling.xml)

# The module of the Krylov solver is the installed one: without it the client refuses the deck.
run(${WORK}/build/client ${krylov})
file(GLOB_RECURSE module ${WORK}/prefix/*ndframe_krylov*)
file(REMOVE ${module})
execute_process(COMMAND ${WORK}/build/client ${krylov} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status
                ERROR_VARIABLE message)
if(NOT status EQUAL 2 OR NOT message MATCHES "needs the module libndframe_krylov")
  message(FATAL_ERROR "without the module the client ended with ${status}: ${message}")
endif()
