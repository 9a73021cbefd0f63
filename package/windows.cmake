# Builds one folder for distribution: the program with all files that it reads, including its fonts. `moltact_folder`
# creates it as moltact/ in the build folder.
set(data .)
install(TARGETS moltact moltact-bench RUNTIME DESTINATION .)
include(${CMAKE_CURRENT_SOURCE_DIR}/data.cmake)
foreach(face Regular SemiBold Italic)
  install(FILES /usr/share/fonts/opentype/inter/Inter-${face}.otf DESTINATION fonts)
endforeach()
install(FILES /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf DESTINATION fonts)

add_custom_target(moltact_folder
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${CMAKE_BINARY_DIR}/moltact
  COMMAND ${CMAKE_COMMAND} --install ${CMAKE_BINARY_DIR} --prefix ${CMAKE_BINARY_DIR}/moltact --strip
  DEPENDS moltact moltact-bench moltact_translations VERBATIM COMMENT "The folder moltact/, to be handed out")
