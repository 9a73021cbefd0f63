# Strips what the packages contain, as Debian's own packages do.
file(GLOB programs ${CPACK_TEMPORARY_DIRECTORY}/*/usr/bin/* ${CPACK_TEMPORARY_DIRECTORY}/*/usr/lib/python3/dist-packages/*/*.so
  ${CPACK_TEMPORARY_DIRECTORY}/*/usr/lib/*/moltact/*.so ${CPACK_TEMPORARY_DIRECTORY}/*/usr/lib/*/moltact/moltact-bench)
foreach(program ${programs})
  execute_process(COMMAND strip --remove-section=.comment --remove-section=.note ${program} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(GLOB_RECURSE archives ${CPACK_TEMPORARY_DIRECTORY}/*.a)
foreach(archive ${archives})
  execute_process(COMMAND strip --strip-debug --remove-section=.comment --remove-section=.note --enable-deterministic-archives ${archive}
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# Without the browser edition, its lintian overrides would be unused.
set(folder ${CPACK_TEMPORARY_DIRECTORY}/program/usr/share)
set(overrides ${folder}/lintian/overrides/moltact)
if(EXISTS ${overrides} AND NOT EXISTS ${folder}/moltact/moltact.html)
  file(READ ${overrides} text)
  string(REGEX REPLACE "[^\n]*(moltact\\.html|big-usr-share)[^\n]*\n" "" text "${text}")
  file(WRITE ${overrides} "${text}")
endif()
