# What the program reads, in the folder ${data}: alike on every system.
install(DIRECTORY ${CMAKE_SOURCE_DIR}/lessons/ DESTINATION ${data}/lessons PATTERN README.md EXCLUDE)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/molecules/ DESTINATION ${data}/molecules
  PATTERN generator EXCLUDE PATTERN README.md EXCLUDE)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/assets/models ${CMAKE_SOURCE_DIR}/assets/hands DESTINATION ${data}/assets
  PATTERN *.sh EXCLUDE)
install(FILES ${CMAKE_SOURCE_DIR}/assets/icon.png DESTINATION ${data}/assets)
# The browser edition, where the preset `web` has made it: `moltact pack --html` writes pages with it.
install(FILES ${CMAKE_SOURCE_DIR}/build/web/moltact.html DESTINATION ${data} OPTIONAL)
install(DIRECTORY ${CMAKE_BINARY_DIR}/translations/ DESTINATION ${data}/translations FILES_MATCHING PATTERN *.mo)
