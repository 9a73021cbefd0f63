# The Debian package, moltact_VERSION-1~debNN_ARCHITECTURE.deb, for the Debian release on which it is built. An upgrade
# of the system thus also installs the program's next build.
set(release_id 0)
set(release_name unknown)
file(STRINGS /etc/os-release lines)
foreach(line ${lines})
  if(line MATCHES "^VERSION_ID=\"?([0-9.]+)")
    set(release_id ${CMAKE_MATCH_1})
  elseif(line MATCHES "^VERSION_CODENAME=\"?([a-z]+)")
    set(release_name ${CMAKE_MATCH_1})
  endif()
endforeach()
set(MOLTACT_MAINTAINER "The Moltact authors <moltact@localhost.localdomain>" CACHE STRING "Whom a package names as its maintainer")

set(package_release 1~deb${release_id})
set(package_version ${PROJECT_VERSION}-${package_release})
configure_file(linux/changelog.in changelog.Debian @ONLY)
configure_file(${CMAKE_SOURCE_DIR}/CHANGELOG.md changelog COPYONLY)
add_custom_command(OUTPUT ${made}/changelog.Debian.gz ${made}/changelog.gz
  COMMAND gzip -9nfk changelog.Debian changelog DEPENDS ${made}/changelog.Debian ${made}/changelog VERBATIM)
add_custom_target(moltact_debian_files DEPENDS ${made}/changelog.Debian.gz ${made}/changelog.gz)
add_dependencies(moltact_package_files moltact_debian_files)
install(FILES ${made}/changelog.Debian.gz ${made}/changelog.gz DESTINATION ${package_documents})
install(FILES linux/lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME moltact)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME moltact)
set(CPACK_PACKAGE_CONTACT ${MOLTACT_MAINTAINER})
set(CPACK_PACKAGE_VENDOR "The Moltact authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "structural biology by touch, with a haptic stylus or a mouse")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Moltact teaches structural biology by touch. A student works through a guided
lesson, pushes a probe against a molecule with a force-feedback stylus, a
mouse or a keyboard, and meets atoms, creases, pits and grooves by what
pushes back.

Teachers write lessons in Markdown, hand them out as one file and get a
report on a class. Commands without a window draw molecules, check lessons
and measure methods of haptic rendering.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/strip.cmake)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_DEBIAN_PACKAGE_RELEASE ${package_release})
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# dpkg-shlibdeps finds the linked libraries. Further dependencies: the window's fonts, and OpenGL, which libepoxy opens
# by name. Optional ones: sound, X pointers and screens, certificates for downloads.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-inter, fonts-dejavu-core, libgl1, libegl1")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, libopenal1, libxcursor1, libxi6, libxinerama1, libxrandr2, ca-certificates")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "speech-dispatcher")
set(CPACK_OUTPUT_FILE_PREFIX ${CMAKE_BINARY_DIR})
include(CPack)
