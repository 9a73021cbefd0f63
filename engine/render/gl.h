// OpenGL's functions: 3.3 core through libepoxy, or in a browser WebGL 2, which is OpenGL ES 3.0. Code uses the common
// subset; this file contains the differences.
#pragma once

#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
#else
#include <epoxy/gl.h>
#endif

namespace moltact {

/// The first lines of every shader.
#ifdef __EMSCRIPTEN__
inline constexpr const char* kShaderVersion = "#version 300 es";
inline constexpr const char* kShaderPrecision =
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\nprecision highp sampler3D;\n";
#else
inline constexpr const char* kShaderVersion = "#version 330 core";
inline constexpr const char* kShaderPrecision = "";
#endif

/// The version of the current context, as 10 * major + minor, if it is too old; else 0.
inline int tooOldGl() {
#ifdef __EMSCRIPTEN__
  return 0;  // a context is always WebGL 2
#else
  const int version = epoxy_gl_version();
  return version < 33 ? version : 0;
#endif
}

}  // namespace moltact
