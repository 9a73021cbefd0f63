# The libraries of the build for Windows (preset `windows`), cross-compiled by mingw-w64. docs/windows.md lists what is
# left out, and why.
set(sources_wanted imgui freetype zlib md4c libzip glfw3 hidapi libepoxy cpp-httplib qrencode)
set(headers_wanted glm eigen3 Spectra gemmi tao nlohmann fmt tiny_gltf.h stb zip.h zipconf.h CLI)
include(${CMAKE_CURRENT_LIST_DIR}/sources.cmake)

# Units of several sources exceed the default section limit of object files.
add_compile_options(-Wa,-mbig-obj)
add_compile_definitions(NOMINMAX WIN32_LEAN_AND_MEAN UNICODE _UNICODE _WIN32_WINNT=0x0A00 _USE_MATH_DEFINES)
# A single file without dependencies: the compiler's runtime is linked statically.
add_link_options(-static)

# OpenGL's functions: the tables are generated from its registry.
function(windows_epoxy)
  set(made ${sources}/libepoxy/made)
  file(MAKE_DIRECTORY ${made}/epoxy)
  file(CONFIGURE OUTPUT ${made}/config.h CONTENT
    "#define ENABLE_GLX 0\n#define ENABLE_EGL 0\n#define ENABLE_X11 0\n#define HAVE_KHRPLATFORM_H 0\n#define EPOXY_PUBLIC extern\n")
  foreach(registry gl wgl)
    execute_process(COMMAND python3 ${sources}/libepoxy/src/gen_dispatch.py --source --header --includedir ${made}/epoxy
      --srcdir ${made} ${sources}/libepoxy/registry/${registry}.xml COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  source_library(source_epoxy PkgConfig::EPOXY FOLDER libepoxy INCLUDE ${made} ${sources}/libepoxy/include
    SOURCES src/dispatch_common.c src/dispatch_wgl.c made/gl_generated_dispatch.c made/wgl_generated_dispatch.c
    LINK opengl32 gdi32)
  target_include_directories(source_epoxy PRIVATE ${sources}/libepoxy/src)
  # It is not a DLL here: engine/platform/offscreen_gl_windows.cpp lets the system call it.
  target_compile_definitions(source_epoxy PRIVATE DllMain=epoxy_on_thread)
endfunction()

macro(provide_libraries)
  source_library(source_threads Threads::Threads LINK -pthread)
  source_library(source_cli11 CLI11::CLI11)
  windows_epoxy()
  provide_libzip(8 "_CLOSE;_DUP;_FDOPEN;_FILENO;_SETMODE;_STRDUP;_STRICMP;_STRTOI64;_STRTOUI64;_UNLINK;FSEEKO;FTELLO;SNPRINTF;STDBOOL_H;STRCASECMP;STRDUP;STRINGS_H;STRTOLL;STRTOULL;UNISTD_H"
    "_stdio|_unix|_mkstempm")
  target_link_libraries(source_zip PRIVATE advapi32)
  source_library(source_glfw PkgConfig::GLFW FOLDER glfw3 INCLUDE ${sources}/glfw3/include
    SOURCES src/context.c src/init.c src/input.c src/monitor.c src/vulkan.c src/window.c src/win32_init.c src/win32_joystick.c
    src/win32_monitor.c src/win32_time.c src/win32_thread.c src/win32_window.c src/wgl_context.c src/egl_context.c
    src/osmesa_context.c DEFINE _GLFW_WIN32 LINK gdi32)
  file(CREATE_LINK ${sources}/hidapi/hidapi ${headers}/hidapi SYMBOLIC)
  source_library(source_hidapi PkgConfig::HIDAPI FOLDER hidapi INCLUDE ${sources}/hidapi/hidapi
    SOURCES windows/hid.c LINK setupapi hid)
  target_compile_options(source_hidapi PRIVATE -UWIN32_LEAN_AND_MEAN)
  # The live class. Its page is served without encryption and compression.
  source_library(source_httplib PkgConfig::HTTPLIB INCLUDE ${sources}/cpp-httplib LINK ws2_32)
  source_library(source_qrencode PkgConfig::QRENCODE FOLDER qrencode INCLUDE ${sources}/qrencode
    SOURCES bitstream.c mask.c mmask.c mqrspec.c qrencode.c qrinput.c qrspec.c rsecc.c split.c)
  target_compile_definitions(source_qrencode PRIVATE STATIC_IN_RELEASE=static MAJOR_VERSION=4 MINOR_VERSION=1 MICRO_VERSION=1
    VERSION="4.1.1")
  provide_imgui(SOURCES backends/imgui_impl_glfw.cpp LINK source_glfw opengl32 imm32)
endmacro()
