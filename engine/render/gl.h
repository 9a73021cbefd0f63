// OpenGL's functions: 3.3 core through libepoxy, or in a page WebGL 2, which is OpenGL ES 3.0. What the two share is used
// everywhere; what each needs for itself stands here.
#pragma once

#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
#else
#include <epoxy/gl.h>
#endif

namespace moltact {

/// How every shader's text begins, whoever compiles it.
#ifdef __EMSCRIPTEN__
inline constexpr const char* kShaderVersion = "#version 300 es";
inline constexpr const char* kShaderPrecision =
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\nprecision highp sampler3D;\n";
#else
inline constexpr const char* kShaderVersion = "#version 330 core";
inline constexpr const char* kShaderPrecision = "";
#endif

/// The version of the current context if it is too old to draw with, as 10 * major + minor; else 0.
inline int tooOldGl() {
#ifdef __EMSCRIPTEN__
  return 0;  // a WebGL 2 context or none
#else
  const int version = epoxy_gl_version();
  return version < 33 ? version : 0;
#endif
}

}  // namespace moltact
