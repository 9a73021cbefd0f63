# The libraries of the browser edition (preset `web`), because Debian builds none for emscripten.
set(sources_wanted imgui freetype zlib md4c libzip)
set(headers_wanted glm eigen3 Spectra gemmi tao nlohmann fmt fast_float tiny_gltf.h stb zip.h zipconf.h)
include(${CMAKE_CURRENT_LIST_DIR}/sources.cmake)

# For every target, also of libraries: libc++ 13 lacks parts of C++20 (web/missing_std.h).
add_compile_options(-fwasm-exceptions)
add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include ${CMAKE_CURRENT_LIST_DIR}/web/missing_std.h>")
add_link_options(-fwasm-exceptions)

macro(provide_libraries)
  source_library(source_epoxy PkgConfig::EPOXY)
  source_library(source_threads Threads::Threads)
  provide_libzip(4 "FCHMOD;FILENO;FSEEKO;FTELLO;LOCALTIME_R;MKSTEMP;SNPRINTF;STDBOOL_H;STRCASECMP;STRDUP;STRINGS_H;STRTOLL;STRTOULL;UNISTD_H" win32)
  # 32-bit vertex indices, because WebGL cannot draw a part of a list with a base vertex.
  provide_imgui(DEFINE IMGUI_IMPL_OPENGL_ES3 ImDrawIdx=unsigned)
endmacro()
