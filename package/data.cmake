# The data files of the program in the folder ${data}, the same on every system.
install(DIRECTORY ${CMAKE_SOURCE_DIR}/lessons/ DESTINATION ${data}/lessons PATTERN README.md EXCLUDE)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/molecules/ DESTINATION ${data}/molecules
  PATTERN generator EXCLUDE PATTERN README.md EXCLUDE)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/assets/models ${CMAKE_SOURCE_DIR}/assets/hands ${CMAKE_SOURCE_DIR}/assets/simulate ${CMAKE_SOURCE_DIR}/assets/studies DESTINATION ${data}/assets
  PATTERN *.sh EXCLUDE PATTERN __pycache__ EXCLUDE)
install(FILES ${CMAKE_SOURCE_DIR}/assets/icon.png DESTINATION ${data}/assets)
# The browser edition, if the preset `web` has built it: `moltact pack --html` generates pages with it.
install(FILES ${CMAKE_SOURCE_DIR}/build/web/moltact.html DESTINATION ${data} OPTIONAL)
install(DIRECTORY ${CMAKE_BINARY_DIR}/translations/ DESTINATION ${data}/translations FILES_MATCHING PATTERN *.mo)
