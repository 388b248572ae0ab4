# cpack runs this on what is to be packed: Debian keeps manual pages and changelogs compressed.
file(GLOB files ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/share/man/man1/*.1 ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/share/doc/*/changelog)
if(NOT files)
  message(FATAL_ERROR "${CPACK_TEMPORARY_INSTALL_DIRECTORY} has neither a manual page nor a changelog where they were expected")
endif()
foreach(file IN LISTS files)
  execute_process(COMMAND gzip -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
