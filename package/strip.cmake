# Strips the program in the package, as Debian's own packages do.
file(GLOB programs ${CPACK_TEMPORARY_DIRECTORY}/usr/bin/*)
foreach(program ${programs})
  execute_process(COMMAND strip --remove-section=.comment --remove-section=.note ${program} COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# Without the browser edition, its lintian overrides would be unused.
if(NOT EXISTS ${CPACK_TEMPORARY_DIRECTORY}/usr/share/moltact/moltact.html)
  set(overrides ${CPACK_TEMPORARY_DIRECTORY}/usr/share/lintian/overrides/moltact)
  file(READ ${overrides} text)
  string(REGEX REPLACE "[^\n]*(moltact\\.html|big-usr-share)[^\n]*\n" "" text "${text}")
  file(WRITE ${overrides} "${text}")
endif()
