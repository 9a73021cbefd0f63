# The libraries of the browser edition (preset `web`), whose emscripten has none of Debian's built for it: headers come
# from Debian's -dev packages, what has to be compiled from Debian's source packages. find_package and pkg_check_modules
# find here what they find in the system elsewhere, so that the other CMakeLists.txt need not know.
set(web_sources ${CMAKE_BINARY_DIR}/sources)
set(web_headers ${CMAKE_BINARY_DIR}/headers)

execute_process(COMMAND ${CMAKE_CURRENT_LIST_DIR}/web/fetch_sources.sh ${web_sources} imgui freetype zlib md4c libzip
  OUTPUT_FILE ${CMAKE_BINARY_DIR}/fetch_sources.log ERROR_FILE ${CMAKE_BINARY_DIR}/fetch_sources.log
  RESULT_VARIABLE web_fetched)
if(NOT web_fetched EQUAL 0)
  message(FATAL_ERROR "The sources of Debian's imgui, freetype, zlib, md4c and libzip cannot be had; see ${CMAKE_BINARY_DIR}/fetch_sources.log")
endif()

# Of /usr/include only these: the rest is of another machine.
file(MAKE_DIRECTORY ${web_headers})
foreach(name glm gemmi tao nlohmann fmt fast_float tiny_gltf.h stb zip.h zipconf.h)
  if(NOT EXISTS /usr/include/${name})
    message(FATAL_ERROR "/usr/include/${name} is missing; ./run.sh web installs what .ci/packages and .ci/packages-web list")
  endif()
  file(CREATE_LINK /usr/include/${name} ${web_headers}/${name} SYMBOLIC)
endforeach()

# For every target, ours and theirs; libc++ 13 lacks some of C++20 (web/missing_std.h).
add_compile_options(-fwasm-exceptions)
add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include ${CMAKE_CURRENT_LIST_DIR}/web/missing_std.h>")
include_directories(SYSTEM ${web_headers})
add_link_options(-fwasm-exceptions)

function(web_library name target)
  cmake_parse_arguments(web "" "FOLDER" "SOURCES;INCLUDE;DEFINE;LINK" ${ARGN})
  if(web_SOURCES)
    list(TRANSFORM web_SOURCES PREPEND ${web_sources}/${web_FOLDER}/)
    add_library(${name} STATIC EXCLUDE_FROM_ALL ${web_SOURCES})
    set(scope PUBLIC)
    target_compile_options(${name} PRIVATE -w)
  else()
    add_library(${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${name} SYSTEM ${scope} ${web_headers} ${web_INCLUDE})
  target_compile_definitions(${name} ${scope} ${web_DEFINE})
  target_link_libraries(${name} ${scope} ${web_LINK})
  add_library(${target} ALIAS ${name})
endfunction()

# Reading and writing packs in memory: without encryption, without compression but zlib's. Release 1.7 (Debian 12) makes its
# table of errors at the end of its own CMakeLists.txt, later ones in a file of its own.
function(web_libzip)
  set(made ${web_sources}/libzip/web)
  file(MAKE_DIRECTORY ${made})
  set(errors ${web_sources}/libzip/cmake/GenerateZipErrorStrings.cmake)
  if(NOT EXISTS ${errors})
    file(READ ${web_sources}/libzip/lib/CMakeLists.txt text)
    string(FIND "${text}" "# create zip_err_str" begins)
    string(SUBSTRING "${text}" ${begins} -1 text)
    set(errors ${made}/errors.cmake)
    file(WRITE ${errors} "${text}")
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} -D PROJECT_SOURCE_DIR=${web_sources}/libzip -P ${errors}
    WORKING_DIRECTORY ${made} COMMAND_ERROR_IS_FATAL ANY)
  set(config "#include \"zipconf.h\"\n#define SIZEOF_OFF_T 8\n#define SIZEOF_SIZE_T 4\n#define PACKAGE \"libzip\"\n#define VERSION \"\"\n")
  foreach(has FCHMOD FILENO FSEEKO FTELLO LOCALTIME_R MKSTEMP SNPRINTF STDBOOL_H STRCASECMP STRDUP STRINGS_H STRTOLL STRTOULL UNISTD_H)
    string(APPEND config "#define HAVE_${has}\n")
  endforeach()
  file(CONFIGURE OUTPUT ${made}/config.h CONTENT "${config}")
  file(GLOB parts RELATIVE ${web_sources}/libzip ${web_sources}/libzip/lib/*.c)
  list(FILTER parts EXCLUDE REGEX "win32|uwp|winzip|zip_crypto_|_algorithm_(bzip2|xz|zstd)")
  web_library(web_zip PkgConfig::LIBZIP FOLDER libzip SOURCES ${parts} web/zip_err_str.c)
  target_include_directories(web_zip PRIVATE ${made} ${web_sources}/libzip/lib)
  target_compile_definitions(web_zip PRIVATE HAVE_CONFIG_H)
  target_link_libraries(web_zip PRIVATE web_zlib)
endfunction()

macro(web_libraries)
  if(NOT TARGET web_glm)
    web_library(web_glm glm::glm)
    web_library(web_fmt fmt::fmt DEFINE FMT_HEADER_ONLY=1)
    web_library(web_json nlohmann_json::nlohmann_json)
    # Libraries that are headers alone but for one source that asks for their functions.
    file(CONFIGURE OUTPUT ${web_sources}/stb/stb.c CONTENT "#define STB_IMAGE_IMPLEMENTATION\n#include <stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION\n#include <stb_image_write.h>\n")
    web_library(web_stb PkgConfig::STB FOLDER stb SOURCES stb.c INCLUDE ${web_headers}/stb)
    file(CONFIGURE OUTPUT ${web_sources}/tinygltf/tinygltf.cpp CONTENT
      "#include <nlohmann/json.hpp>\n#define TINYGLTF_IMPLEMENTATION\n#include <tiny_gltf.h>\n")
    web_library(web_tinygltf PkgConfig::TINYGLTF FOLDER tinygltf SOURCES tinygltf.cpp
      DEFINE TINYGLTF_NO_INCLUDE_JSON TINYGLTF_NO_STB_IMAGE TINYGLTF_NO_STB_IMAGE_WRITE)
    web_library(web_epoxy PkgConfig::EPOXY)
    web_library(web_threads Threads::Threads)
    web_library(web_zlib ZLIB::ZLIB FOLDER zlib INCLUDE ${web_sources}/zlib
      SOURCES adler32.c compress.c crc32.c deflate.c gzclose.c gzlib.c gzread.c gzwrite.c infback.c inffast.c inflate.c
      inftrees.c trees.c uncompr.c zutil.c DEFINE HAVE_UNISTD_H)
    web_library(web_md4c PkgConfig::md4c FOLDER md4c INCLUDE ${web_sources}/md4c/src SOURCES src/md4c.c DEFINE MD4C_USE_UTF8)
    # The modules that Debian's FreeType has for scalable fonts.
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/freetype/web_modules.h CONTENT
"FT_USE_MODULE( FT_Module_Class, autofit_module_class )
FT_USE_MODULE( FT_Driver_ClassRec, tt_driver_class )
FT_USE_MODULE( FT_Driver_ClassRec, cff_driver_class )
FT_USE_MODULE( FT_Module_Class, psaux_module_class )
FT_USE_MODULE( FT_Module_Class, psnames_module_class )
FT_USE_MODULE( FT_Module_Class, pshinter_module_class )
FT_USE_MODULE( FT_Module_Class, sfnt_module_class )
FT_USE_MODULE( FT_Renderer_Class, ft_smooth_renderer_class )
")
    web_library(web_freetype PkgConfig::FREETYPE FOLDER freetype INCLUDE ${CMAKE_BINARY_DIR}/freetype ${web_sources}/freetype/include
      SOURCES src/autofit/autofit.c src/base/ftbase.c src/base/ftbbox.c src/base/ftbitmap.c src/base/ftdebug.c
      src/base/ftglyph.c src/base/ftinit.c src/base/ftmm.c src/base/ftsynth.c src/base/ftsystem.c src/cff/cff.c src/gzip/ftgzip.c
      src/psaux/psaux.c src/pshinter/pshinter.c src/psnames/psnames.c src/sfnt/sfnt.c src/smooth/smooth.c
      src/truetype/truetype.c
      DEFINE FT2_BUILD_LIBRARY FT_CONFIG_MODULES_H=<web_modules.h>)
    target_link_libraries(web_freetype PRIVATE web_zlib)
    set_source_files_properties(${web_sources}/freetype/src/gzip/ftgzip.c PROPERTIES COMPILE_DEFINITIONS FT_CONFIG_OPTION_SYSTEM_ZLIB)
    web_libzip()
    # Vertices are counted in 32 bits: WebGL draws no part of a list from a base of its own.
    web_library(web_imgui PkgConfig::IMGUI FOLDER imgui INCLUDE ${web_sources}/imgui ${web_sources}/imgui/misc/freetype
      ${web_sources}/imgui/misc/cpp
      SOURCES imgui.cpp imgui_draw.cpp imgui_tables.cpp imgui_widgets.cpp misc/cpp/imgui_stdlib.cpp
      misc/freetype/imgui_freetype.cpp backends/imgui_impl_opengl3.cpp
      DEFINE IMGUI_IMPL_OPENGL_ES3 ImDrawIdx=unsigned IMGUI_ENABLE_FREETYPE LINK web_freetype)
  endif()
endmacro()

macro(web_provide method name)
  web_libraries()
  set(${name}_FOUND TRUE)
endmacro()
cmake_language(SET_DEPENDENCY_PROVIDER web_provide SUPPORTED_METHODS FIND_PACKAGE)
macro(pkg_check_modules)
endmacro()
