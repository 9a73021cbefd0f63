# Builds libraries for systems without Debian packages (presets `web` and `windows`). Headers come from Debian's -dev
# packages, sources from its source packages. find_package and pkg_check_modules find them as they find the system's
# libraries, so that other CMakeLists.txt need no conditions.
#
#   set(sources_wanted PACKAGE…)  the source packages
#   set(headers_wanted NAME…)     of /usr/include
#   include(…/sources.cmake)
#   macro(provide_libraries) … endmacro()
set(sources ${CMAKE_BINARY_DIR}/sources)
set(headers ${CMAKE_BINARY_DIR}/headers)

execute_process(COMMAND ${CMAKE_CURRENT_LIST_DIR}/fetch_sources.sh ${sources} ${sources_wanted}
  OUTPUT_FILE ${CMAKE_BINARY_DIR}/fetch_sources.log ERROR_FILE ${CMAKE_BINARY_DIR}/fetch_sources.log
  RESULT_VARIABLE fetched)
if(NOT fetched EQUAL 0)
  list(JOIN sources_wanted ", " names)
  message(FATAL_ERROR "The sources of Debian's packages ${names} cannot be had; see ${CMAKE_BINARY_DIR}/fetch_sources.log")
endif()

# Only these headers of /usr/include are used: the others belong to another platform.
file(MAKE_DIRECTORY ${headers})
foreach(name ${headers_wanted})
  if(NOT EXISTS /usr/include/${name})
    message(FATAL_ERROR "/usr/include/${name} is missing; it is in a package that .ci/packages or .ci/packages-web lists")
  endif()
  file(CREATE_LINK /usr/include/${name} ${headers}/${name} SYMBOLIC)
endforeach()
include_directories(SYSTEM ${headers})

# source_library(NAME TARGET [FOLDER package SOURCES …] [INCLUDE …] [DEFINE …] [LINK …]): other CMakeLists.txt link it
# as TARGET.
function(source_library name target)
  cmake_parse_arguments(library "" "FOLDER" "SOURCES;INCLUDE;DEFINE;LINK" ${ARGN})
  if(library_SOURCES)
    list(TRANSFORM library_SOURCES PREPEND ${sources}/${library_FOLDER}/)
    add_library(${name} STATIC EXCLUDE_FROM_ALL ${library_SOURCES})
    set(scope PUBLIC)
    target_compile_options(${name} PRIVATE -w)
    set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  else()
    add_library(${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${name} SYSTEM ${scope} ${headers} ${library_INCLUDE})
  target_compile_definitions(${name} ${scope} ${library_DEFINE})
  target_link_libraries(${name} ${scope} ${library_LINK})
  add_library(${target} ALIAS ${name})
endfunction()

# libzip for packs in memory: without encryption, with zlib's compression only. `has`: what config.h states about the
# system; `left_out`: a pattern of other systems' files. Release 1.7 (Debian 12) generates its table of errors at the
# end of its CMakeLists.txt, later releases in a file of its own.
function(provide_libzip pointer_bytes has left_out)
  set(made ${sources}/libzip/made)
  file(MAKE_DIRECTORY ${made})
  set(errors ${sources}/libzip/cmake/GenerateZipErrorStrings.cmake)
  if(NOT EXISTS ${errors})
    file(READ ${sources}/libzip/lib/CMakeLists.txt text)
    string(FIND "${text}" "# create zip_err_str" begins)
    string(SUBSTRING "${text}" ${begins} -1 text)
    set(errors ${made}/errors.cmake)
    file(WRITE ${errors} "${text}")
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} -D PROJECT_SOURCE_DIR=${sources}/libzip -P ${errors}
    WORKING_DIRECTORY ${made} COMMAND_ERROR_IS_FATAL ANY)
  set(config "#include \"zipconf.h\"\n#define SIZEOF_OFF_T 8\n#define SIZEOF_SIZE_T ${pointer_bytes}\n#define PACKAGE \"libzip\"\n#define VERSION \"\"\n")
  foreach(one ${has})
    string(APPEND config "#define HAVE_${one}\n")
  endforeach()
  file(CONFIGURE OUTPUT ${made}/config.h CONTENT "${config}")
  file(GLOB parts RELATIVE ${sources}/libzip ${sources}/libzip/lib/*.c)
  list(FILTER parts EXCLUDE REGEX "uwp|winzip|zip_crypto_|_algorithm_(bzip2|xz|zstd)|${left_out}")
  source_library(source_zip PkgConfig::LIBZIP FOLDER libzip SOURCES ${parts} made/zip_err_str.c DEFINE ZIP_STATIC)
  target_include_directories(source_zip PRIVATE ${made} ${sources}/libzip/lib)
  target_compile_definitions(source_zip PRIVATE HAVE_CONFIG_H)
  target_link_libraries(source_zip PRIVATE source_zlib)
endfunction()

# The libraries that are built the same way for every such system.
macro(provide_common)
  source_library(source_glm glm::glm)
  source_library(source_fmt fmt::fmt DEFINE FMT_HEADER_ONLY=1)
  source_library(source_json nlohmann_json::nlohmann_json)
  source_library(source_eigen Eigen3::Eigen INCLUDE ${headers}/eigen3)
  # Header-only libraries whose functions one source must instantiate.
  file(CONFIGURE OUTPUT ${sources}/stb/stb.c CONTENT "#define STB_IMAGE_IMPLEMENTATION\n#include <stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION\n#include <stb_image_write.h>\n")
  source_library(source_stb PkgConfig::STB FOLDER stb SOURCES stb.c INCLUDE ${headers}/stb DEFINE STBI_WINDOWS_UTF8)
  file(CONFIGURE OUTPUT ${sources}/tinygltf/tinygltf.cpp CONTENT
    "#include <nlohmann/json.hpp>\n#define TINYGLTF_IMPLEMENTATION\n#include <tiny_gltf.h>\n")
  source_library(source_tinygltf PkgConfig::TINYGLTF FOLDER tinygltf SOURCES tinygltf.cpp
    DEFINE TINYGLTF_NO_INCLUDE_JSON TINYGLTF_NO_STB_IMAGE TINYGLTF_NO_STB_IMAGE_WRITE)
  source_library(source_zlib ZLIB::ZLIB FOLDER zlib INCLUDE ${sources}/zlib
    SOURCES adler32.c compress.c crc32.c deflate.c gzclose.c gzlib.c gzread.c gzwrite.c infback.c inffast.c inflate.c
    inftrees.c trees.c uncompr.c zutil.c DEFINE HAVE_UNISTD_H)
  source_library(source_md4c PkgConfig::md4c FOLDER md4c INCLUDE ${sources}/md4c/src SOURCES src/md4c.c DEFINE MD4C_USE_UTF8)
  # The modules of Debian's FreeType for scalable fonts.
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/freetype/chosen_modules.h CONTENT
"FT_USE_MODULE( FT_Module_Class, autofit_module_class )
FT_USE_MODULE( FT_Driver_ClassRec, tt_driver_class )
FT_USE_MODULE( FT_Driver_ClassRec, cff_driver_class )
FT_USE_MODULE( FT_Module_Class, psaux_module_class )
FT_USE_MODULE( FT_Module_Class, psnames_module_class )
FT_USE_MODULE( FT_Module_Class, pshinter_module_class )
FT_USE_MODULE( FT_Module_Class, sfnt_module_class )
FT_USE_MODULE( FT_Renderer_Class, ft_smooth_renderer_class )
")
  source_library(source_freetype PkgConfig::FREETYPE FOLDER freetype INCLUDE ${CMAKE_BINARY_DIR}/freetype ${sources}/freetype/include
    SOURCES src/autofit/autofit.c src/base/ftbase.c src/base/ftbbox.c src/base/ftbitmap.c src/base/ftdebug.c
    src/base/ftglyph.c src/base/ftinit.c src/base/ftmm.c src/base/ftsynth.c src/base/ftsystem.c src/cff/cff.c src/gzip/ftgzip.c
    src/psaux/psaux.c src/pshinter/pshinter.c src/psnames/psnames.c src/sfnt/sfnt.c src/smooth/smooth.c
    src/truetype/truetype.c
    DEFINE FT2_BUILD_LIBRARY FT_CONFIG_MODULES_H=<chosen_modules.h>)
  target_link_libraries(source_freetype PRIVATE source_zlib)
  set_source_files_properties(${sources}/freetype/src/gzip/ftgzip.c PROPERTIES COMPILE_DEFINITIONS FT_CONFIG_OPTION_SYSTEM_ZLIB)
endmacro()

# provide_imgui([SOURCES its backends] [DEFINE …] [INCLUDE …] [LINK …])
function(provide_imgui)
  cmake_parse_arguments(imgui "" "" "SOURCES;INCLUDE;DEFINE;LINK" ${ARGN})
  source_library(source_imgui PkgConfig::IMGUI FOLDER imgui
    INCLUDE ${sources}/imgui ${sources}/imgui/misc/freetype ${sources}/imgui/misc/cpp ${imgui_INCLUDE}
    SOURCES imgui.cpp imgui_draw.cpp imgui_tables.cpp imgui_widgets.cpp misc/cpp/imgui_stdlib.cpp
    misc/freetype/imgui_freetype.cpp backends/imgui_impl_opengl3.cpp ${imgui_SOURCES}
    DEFINE IMGUI_ENABLE_FREETYPE ${imgui_DEFINE} LINK source_freetype ${imgui_LINK})
endfunction()

macro(provide method name)
  if(NOT TARGET source_glm)
    provide_common()
    provide_libraries()
  endif()
  set(${name}_FOUND TRUE)
endmacro()
cmake_language(SET_DEPENDENCY_PROVIDER provide SUPPORTED_METHODS FIND_PACKAGE)
macro(pkg_check_modules)
endmacro()
