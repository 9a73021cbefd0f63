# The libraries of the browser edition (preset `web`), because Debian builds none for emscripten.
set(sources_wanted imgui freetype zlib md4c libzip openmm)
set(headers_wanted glm eigen3 Spectra gemmi tao nlohmann fmt fast_float tiny_gltf.h stb zip.h zipconf.h)
include(${CMAKE_CURRENT_LIST_DIR}/sources.cmake)

# For every target in C++20, also of libraries: libc++ 13 lacks parts of it (web/missing_std.h).
add_compile_options(-fwasm-exceptions)
add_compile_options("$<$<AND:$<COMPILE_LANGUAGE:CXX>,$<STREQUAL:$<TARGET_PROPERTY:CXX_STANDARD>,20>>:SHELL:-include ${CMAKE_CURRENT_LIST_DIR}/web/missing_std.h>")
add_link_options(-fwasm-exceptions)

macro(provide_libraries)
  source_library(source_epoxy PkgConfig::EPOXY)
  source_library(source_threads Threads::Threads)
  provide_libzip(4 "FCHMOD;FILENO;FSEEKO;FTELLO;LOCALTIME_R;MKSTEMP;SNPRINTF;STDBOOL_H;STRCASECMP;STRDUP;STRINGS_H;STRTOLL;STRTOULL;UNISTD_H" win32)
  # 32-bit vertex indices, because WebGL cannot draw a part of a list with a base vertex.
  provide_imgui(DEFINE IMGUI_IMPL_OPENGL_ES3 ImDrawIdx=unsigned)
endmacro()

# OpenMM without plugins: its interface, the platform Reference and the reader of serialised systems. Of OpenMM's sources
# only the pool of threads is replaced (openmm_thread_pool.cpp), because a page has none.
function(provide_openmm)
  set(parts openmmapi olla serialization platforms/reference libraries/jama libraries/quern libraries/lepton libraries/sfmt
    libraries/lbfgs libraries/hilbert libraries/csha1 libraries/irrxml)
  foreach(part ${parts})
    file(GLOB found RELATIVE ${sources}/openmm ${sources}/openmm/${part}/src/*.cpp ${sources}/openmm/${part}/src/*/*.cpp)
    list(APPEND compiled ${found})
    list(APPEND include ${sources}/openmm/${part}/include)
  endforeach()
  list(FILTER compiled EXCLUDE REGEX "src/ThreadPool.cpp$")
  file(STRINGS ${sources}/openmm/CMakeLists.txt lines REGEX "^ *SET\\(OPENMM_(MAJOR|MINOR|BUILD)_VERSION [0-9]+\\)")
  foreach(line ${lines})
    string(REGEX REPLACE "^ *SET\\((OPENMM_[A-Z]+_VERSION) ([0-9]+)\\)" "\\1=\\2" one "${line}")
    list(APPEND version ${one})
  endforeach()
  source_library(source_openmm OpenMM::OpenMM FOLDER openmm SOURCES ${compiled} INCLUDE ${include}
    DEFINE OPENMM_USE_STATIC_LIBRARIES LEPTON_USE_STATIC_LIBRARIES)
  target_sources(source_openmm PRIVATE ${CMAKE_SOURCE_DIR}/cmake/web/openmm_thread_pool.cpp)
  target_include_directories(source_openmm PRIVATE ${sources}/openmm/platforms/reference/src)
  target_compile_definitions(source_openmm PRIVATE OPENMM_LIBRARY_NAME=OpenMM ${version}
    IEEE_8087                        # dtoa.cpp: the order of bytes
    DEB_HOST_MULTIARCH="wasm32")     # Platform.cpp, Debian's patch: a part of the plugins' folder, which a page lacks
  set_source_files_properties(${sources}/openmm/serialization/src/dtoa.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  # In batches its 190 small sources take two minutes of one processor.
  set_target_properties(source_openmm PROPERTIES CXX_STANDARD 14 UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
endfunction()
