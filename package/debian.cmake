# The Debian packages, NAME_VERSION-1~debNN_ARCHITECTURE.deb, for the Debian release on which they are built. An upgrade
# of the system thus also installs the program's next build. Each component of the installation is one package: moltact,
# libmoltact-dev and, where they are built, python3-moltact and moltact-openmm.
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
set(package_name moltact)
configure_file(linux/changelog.in changelog.Debian @ONLY)
configure_file(${CMAKE_SOURCE_DIR}/CHANGELOG.md changelog COPYONLY)
add_custom_command(OUTPUT ${made}/changelog.Debian.gz ${made}/changelog.gz
  COMMAND gzip -9nfk changelog.Debian changelog DEPENDS ${made}/changelog.Debian ${made}/changelog VERBATIM)
add_custom_target(moltact_debian_files DEPENDS ${made}/changelog.Debian.gz ${made}/changelog.gz)
add_dependencies(moltact_package_files moltact_debian_files)
install(FILES ${made}/changelog.Debian.gz ${made}/changelog.gz DESTINATION ${package_documents})
install(FILES linux/lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME moltact)

# moltact_package_documents(COMPONENT PACKAGE samples…): what a further package has of /usr/share/doc, with samples.
function(moltact_package_documents component package)
  set(documents ${CMAKE_INSTALL_DATADIR}/doc/${package})
  file(READ linux/copyright text)
  string(REPLACE /usr/share/doc/moltact/ /usr/share/doc/${package}/ text "${text}")
  file(CONFIGURE OUTPUT ${package}/copyright CONTENT "${text}" @ONLY)
  file(CONFIGURE OUTPUT ${package}/overrides @ONLY CONTENT "# The maker of a package sets an address with -DMOLTACT_MAINTAINER.
${package}: bogus-mail-host *
${package}: bogus-mail-host-in-debian-changelog *
")
  set(package_name ${package})
  configure_file(linux/changelog.in ${package}/changelog.Debian @ONLY)
  add_custom_command(OUTPUT ${made}/${package}/changelog.Debian.gz
    COMMAND gzip -9nfk ${package}/changelog.Debian DEPENDS ${made}/${package}/changelog.Debian VERBATIM)
  add_custom_target(moltact_${component}_documents DEPENDS ${made}/${package}/changelog.Debian.gz)
  add_dependencies(moltact_package_files moltact_${component}_documents)
  install(FILES ${made}/${package}/copyright ${made}/${package}/changelog.Debian.gz ${made}/changelog.gz DESTINATION ${documents} COMPONENT ${component})
  install(FILES ${made}/libraries.gz DESTINATION ${documents} COMPONENT ${component} OPTIONAL)
  install(FILES ${made}/${package}/overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT ${component} RENAME ${package})
  list(TRANSFORM ARGN PREPEND ${CMAKE_SOURCE_DIR}/docs/samples/ OUTPUT_VARIABLE samples)
  install(FILES ${samples} DESTINATION ${documents}/examples COMPONENT ${component})
endfunction()
moltact_package_documents(development libmoltact-dev CMakeLists.txt add_a_method.cpp feel_a_path.cpp time_a_method.cpp)
if(TARGET moltact_python)
  moltact_package_documents(python python3-moltact feel_a_groove.py)
endif()

if(TARGET moltact_openmm)
  moltact_package_documents(simulation moltact-openmm)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME moltact)
set(CPACK_PACKAGE_CONTACT ${MOLTACT_MAINTAINER})
set(CPACK_PACKAGE_VENDOR "The Moltact authors")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)

# The first line of a description is its summary.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME moltact)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "structural biology by touch, with a haptic stylus or a mouse
Moltact teaches structural biology by touch. A student works through a guided
lesson, pushes a probe against a molecule with a force-feedback stylus, a
mouse or a keyboard, and meets atoms, creases, pits and grooves by what
pushes back.

Teachers write lessons in Markdown, hand them out as one file and get a
report on a class. Commands without a window draw molecules, check lessons
and measure methods of haptic rendering.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libmoltact-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(development_depends libglm-dev libfmt-dev zlib1g-dev libcurl4-openssl-dev)
if(GEMMI_LIBRARY)
  list(APPEND development_depends gemmi-dev)
endif()
list(JOIN development_depends ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "cmake")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "haptic rendering of molecules, as a C++ library
The methods with which Moltact computes what a hand feels of a molecule, and
its readers of molecules, as static libraries with a CMake package. A program
moves a probe or a rigid body through poses and gets contacts, forces and
torques; it can time the methods, or add one and measure its error.")

if(TARGET moltact_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-moltact)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${MOLTACT_PYTHON_DEPENDS}, python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "moltact")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_SOURCE_DIR}/python/postinst;${CMAKE_CURRENT_SOURCE_DIR}/python/prerm")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "haptic rendering of molecules, as a Python module
The methods with which Moltact computes what a hand feels of a molecule, over
numpy arrays: load a molecule, move a probe or a rigid body along an array of
poses, and get positions, forces, torques and contacts.

The package moltact brings the molecules that load() knows by name.")
endif()
if(TARGET moltact_openmm)
  # A package of its own, so that the program does not need OpenMM. dpkg-shlibdeps finds the library of this release.
  list(APPEND CPACK_COMPONENTS_ALL simulation)
  set(CPACK_DEBIAN_SIMULATION_PACKAGE_NAME moltact-openmm)
  set(CPACK_DEBIAN_SIMULATION_PACKAGE_DEPENDS "libopenmm-plugins")
  set(CPACK_DEBIAN_SIMULATION_PACKAGE_RECOMMENDS "moltact")
  set(CPACK_DEBIAN_SIMULATION_DESCRIPTION "simulations of molecules that the hand pushes, for Moltact
The module with which Moltact simulates a molecule while it is touched: its
atoms move as their force field and a heat bath demand, and give way to the
hand. OpenMM computes the forces.

The package python3-simtk (Debian 12) or python3-openmm (Debian 13) prepares
further molecules.")
endif()
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
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "fonts-inter, fonts-dejavu-core, libgl1, libegl1")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libgl1-mesa-dri, libopenal1, libxcursor1, libxi6, libxinerama1, libxrandr2, ca-certificates")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "speech-dispatcher, moltact-openmm")
set(CPACK_OUTPUT_FILE_PREFIX ${CMAKE_BINARY_DIR})
include(CPack)
