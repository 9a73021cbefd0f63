// Full-screen passes: the background, and downsampling the atoms' layer to the picture's size. Needs a current context.
#pragma once

#include <memory>

#include "engine/render/gl_objects.h"
#include "engine/render/lighting.h"
#include "engine/render/pixel_box.h"

namespace moltact {

/// GLSL: a vertex shader that covers the whole picture with one triangle; v_uv is 0 to 1 over the picture.
extern const char* const kWholePictureText;

/// Copies colour or depth (GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT) between targets of equal size.
void copyPart(const GlTarget& from, const GlTarget& to, const PixelBox& part, GLbitfield what);

class Resolve {
 public:
  static Expected<Resolve> build();

  void background(const Lighting& lighting);

  /// Downsamples `from` into the bound framebuffer: the mean of each samples x samples texels.
  void layer(const GlTarget& from, int samples);

 private:
  GlProgram background_, layer_;
  std::unique_ptr<GlStream> stream_ = std::make_unique<GlStream>();
};

}  // namespace moltact
