# The engine's library for other programs: `find_package(moltact)` gives moltact::haptics and moltact::molecule
# (docs/library.md). These are the public headers; all others may change without notice. They are installed with their
# folders in include/moltact. The component is `development`.
include(CMakePackageConfigHelpers)

# moltact_public(TARGET NAME headers…): installs the target as moltact::NAME with these headers of engine/.
function(moltact_public target name)
  get_target_property(type ${target} TYPE)
  set(scope PUBLIC)
  if(type STREQUAL INTERFACE_LIBRARY)
    set(scope INTERFACE)
  endif()
  set(file_set)
  if(ARGN)
    target_sources(${target} ${scope} FILE_SET HEADERS BASE_DIRS ${CMAKE_SOURCE_DIR} FILES ${ARGN})
    set(file_set FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/moltact COMPONENT development)
  endif()
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT moltact-targets ARCHIVE COMPONENT development ${file_set})
endfunction()

moltact_public(moltact_options options
  core/offered_word.h
  core/printable.h
  core/problem.h
  core/shared_array.h
  core/short_text.h
  core/sphere.h
  core/units.h
  core/utf8.h)
moltact_public(moltact_language language
  language/units.h)
moltact_public(moltact_haptics haptics
  haptics/atom_chemistry.h
  haptics/body/held_body.h
  haptics/contact.h
  haptics/felt_force.h
  haptics/field/energy_part.h
  haptics/field/pair_field.h
  haptics/field/pair_kernel.h
  haptics/field/pair_model.h
  haptics/field/pair_sum.h
  haptics/friction.h
  haptics/hip_input.h
  haptics/interaction.h
  haptics/interactions.h
  haptics/methods.h
  haptics/nearby_spheres.h
  haptics/sphere_grid.h
  haptics/sphere_motion.h
  haptics/surface_properties.h
  haptics/sweep.h
  haptics/touch_setup.h
  haptics/tracker.h
  haptics/wrapped_interaction.h)
moltact_public(moltact_molecule molecule
  molecule/catalogue.h
  molecule/elements.h
  molecule/molecule.h
  molecule/molecule_key.h
  molecule/radius_tables.h
  molecule/reader.h
  molecule/summary.h)
# What the two are linked with.
moltact_public(moltact_platform platform)
moltact_public(moltact_gemmi gemmi)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/moltact)
configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/moltact-config.cmake.in moltact-config.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(moltact-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/moltact-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/moltact-config-version.cmake
  DESTINATION ${package_folder} COMPONENT development)
install(EXPORT moltact-targets NAMESPACE moltact:: DESTINATION ${package_folder} COMPONENT development)
