#include "engine/platform/offscreen_gl.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdio>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

Problem noContext(const std::string& what) {
  return {.file = {},
          .message = trf("no off-screen OpenGL: {0}", what),
          .remedy = tr("install the packages libegl1 and libgl1-mesa-dri (software OpenGL 3.3)")};
}

std::string eglCode() {
  char code[16];
  std::snprintf(code, sizeof code, "0x%04X", unsigned(eglGetError()));
  return code;
}

// Mesa's surfaceless platform needs neither display server nor device; the default display is the second choice.
EGLDisplay openDisplay() {
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless") &&
      epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) {
    const EGLDisplay d = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (d != EGL_NO_DISPLAY && eglInitialize(d, nullptr, nullptr)) return d;
  }
  const EGLDisplay d = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  return d != EGL_NO_DISPLAY && eglInitialize(d, nullptr, nullptr) ? d : EGL_NO_DISPLAY;
}

}  // namespace

Expected<std::unique_ptr<OffscreenGl>> OffscreenGl::create() {
  // libepoxy ends the process if it cannot load EGL, so this is tested first.
  if (!epoxy_has_egl()) return noContext(tr("the library libEGL is not there"));
  std::unique_ptr<OffscreenGl> gl(new OffscreenGl);
  gl->display_ = openDisplay();
  if (gl->display_ == EGL_NO_DISPLAY) return noContext(trf("EGL gives no display ({0})", eglCode()));
  if (!eglBindAPI(EGL_OPENGL_API)) return noContext(trf("EGL here does not offer desktop OpenGL ({0})", eglCode()));

  const EGLint want[] = {EGL_SURFACE_TYPE,
                         EGL_PBUFFER_BIT,
                         EGL_RENDERABLE_TYPE,
                         EGL_OPENGL_BIT,
                         EGL_RED_SIZE,
                         8,
                         EGL_GREEN_SIZE,
                         8,
                         EGL_BLUE_SIZE,
                         8,
                         EGL_ALPHA_SIZE,
                         8,
                         EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(gl->display_, want, &config, 1, &count) || count == 0)
    return noContext(trf("EGL has no suitable configuration ({0})", eglCode()));
  const EGLint version[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  gl->context_ = eglCreateContext(gl->display_, config, EGL_NO_CONTEXT, version);
  if (gl->context_ == EGL_NO_CONTEXT) return noContext(trf("OpenGL 3.3 core is not offered ({0})", eglCode()));
  const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
  gl->surface_ = eglCreatePbufferSurface(gl->display_, config, size);
  if (!gl->makeCurrent()) return noContext(trf("the context cannot be made current ({0})", eglCode()));
  return {std::move(gl)};
}

bool OffscreenGl::makeCurrent() { return eglMakeCurrent(display_, surface_, surface_, context_) == EGL_TRUE; }

// The display is shared by the whole program, so it is not terminated: another context may use it.
OffscreenGl::~OffscreenGl() {
  if (!display_) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (surface_) eglDestroySurface(display_, surface_);
  if (context_) eglDestroyContext(display_, context_);
}

}  // namespace moltact
