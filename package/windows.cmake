# The program for Windows with all files that it reads, including its fonts: one folder, which `moltact_folder` creates as
# moltact/ in the build folder. `moltact_installer` makes the installer and the zip of it (docs/windows.md).
set(data .)
install(TARGETS moltact moltact-bench RUNTIME DESTINATION .)
include(${CMAKE_CURRENT_SOURCE_DIR}/data.cmake)
foreach(face Regular SemiBold Italic)
  install(FILES /usr/share/fonts/opentype/inter/Inter-${face}.otf DESTINATION fonts)
endforeach()
install(FILES /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf DESTINATION fonts)

# The pages that messages refer to, without their pictures.
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs DESTINATION . FILES_MATCHING PATTERN *.md PATTERN pictures EXCLUDE PATTERN samples EXCLUDE)
# Licences: the project's, and those of the libraries, the compiler's runtime and the fonts, from Debian's packages.
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION licences RENAME moltact.txt)
set(notices)
foreach(library libimgui-dev libfreetype-dev zlib1g-dev libmd4c-dev libzip-dev libglfw3-dev libhidapi-dev libepoxy-dev
        libcpp-httplib-dev libqrencode-dev libglm-dev libeigen3-dev libspectra-dev gemmi-dev tao-pegtl-dev
        nlohmann-json3-dev libfmt-dev libtinygltf-dev libstb-dev libcli11-dev gcc-mingw-w64-base mingw-w64-x86-64-dev
        fonts-inter fonts-dejavu-core)
  if(NOT EXISTS /usr/share/doc/${library}/copyright)
    message(FATAL_ERROR "The licence of ${library} is missing: install this Debian package")
  endif()
  list(APPEND notices /usr/share/doc/${library}/copyright)
endforeach()
add_custom_command(OUTPUT ${made}/libraries.txt COMMAND tail -v -n +1 ${notices} > libraries.txt DEPENDS ${notices} VERBATIM)
install(FILES ${made}/libraries.txt DESTINATION licences)

add_custom_target(moltact_folder
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${CMAKE_BINARY_DIR}/moltact
  COMMAND ${CMAKE_COMMAND} --install ${CMAKE_BINARY_DIR} --prefix ${CMAKE_BINARY_DIR}/moltact --strip
  DEPENDS moltact moltact-bench moltact_translations ${made}/libraries.txt VERBATIM COMMENT "The folder moltact/, to be handed out")

find_program(MAKENSIS makensis REQUIRED)  # Debian: nsis
set(package_name moltact-${PROJECT_VERSION}-windows-x64)
file(READ ${CMAKE_SOURCE_DIR}/LICENSE licence)
file(CONFIGURE OUTPUT ${made}/licence.txt CONTENT "${licence}" @ONLY NEWLINE_STYLE DOS)
set(side ${made}/side.bmp)
add_custom_command(OUTPUT ${side}
  COMMAND convert -size 164x314 xc:\#10293d \( ${CMAKE_SOURCE_DIR}/assets/icon.png -resize 116x116 \) -geometry +24+60 -composite BMP3:${side}
  DEPENDS ${CMAKE_SOURCE_DIR}/assets/icon.png VERBATIM)
add_custom_target(moltact_installer
  COMMAND ${CMAKE_COMMAND} -E rm -f ${package_name}.zip
  COMMAND ${CMAKE_COMMAND} -E tar cf ${package_name}.zip --format=zip moltact
  COMMAND ${CMAKE_COMMAND} -D FOLDER=${CMAKE_BINARY_DIR}/moltact -D LISTS=${made} -P ${CMAKE_CURRENT_SOURCE_DIR}/windows/installed_files.cmake
  COMMAND ${MAKENSIS} -V2 -WX -NOCD -DVERSION=${PROJECT_VERSION} -DVERSION4=${PROJECT_VERSION}.0 -DOUT=${package_name}-setup.exe
    -DLISTS=${made} -DLICENCE=${made}/licence.txt -DICON=${CMAKE_BINARY_DIR}/app/windows/moltact.ico -DSIDE=${side}
    ${CMAKE_CURRENT_SOURCE_DIR}/windows/moltact.nsi
  DEPENDS ${side} WORKING_DIRECTORY ${CMAKE_BINARY_DIR} VERBATIM COMMENT "The installer and the zip for Windows")
add_dependencies(moltact_installer moltact_folder)
