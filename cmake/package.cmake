# Compiler and linker flags for Debian packages: the distribution's own hardening flags, without debug symbols and
# without the path of this folder in the program. The preset's build type appends its own flags.
function(package_flags into)
  set(flags "")
  foreach(kind ${ARGN})
    execute_process(COMMAND ${CMAKE_COMMAND} -E env DEB_BUILD_MAINT_OPTIONS=hardening=+all dpkg-buildflags --get ${kind}
      WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} OUTPUT_VARIABLE got OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE status)
    if(NOT status EQUAL 0)
      message(FATAL_ERROR "dpkg-buildflags is missing; ./run.sh package installs what .ci/packages-package lists")
    endif()
    string(APPEND flags " ${got}")
  endforeach()
  string(REGEX REPLACE " -g( |$)" " " flags "${flags}")
  set(${into} "${flags}" PARENT_SCOPE)
endfunction()

package_flags(CMAKE_C_FLAGS_INIT CPPFLAGS CFLAGS)
package_flags(CMAKE_CXX_FLAGS_INIT CPPFLAGS CXXFLAGS)
package_flags(CMAKE_EXE_LINKER_FLAGS_INIT LDFLAGS)
package_flags(CMAKE_MODULE_LINKER_FLAGS_INIT LDFLAGS)
