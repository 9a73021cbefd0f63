// Full-screen passes: the background, and the atoms' layer brought to the picture's size.
// Needs a current context.
#pragma once

#include <memory>

#include "engine/render/gl_objects.h"
#include "engine/render/lighting.h"

namespace moltact {

class Resolve {
 public:
  static Expected<Resolve> build();

  void background(const Lighting& lighting);

  /// Writes colour and depth of `from` into the bound framebuffer: the mean of samples x samples texels with the depth
  /// of the nearest.
  void layer(const GlTarget& from, int samples);

 private:
  GlProgram background_, layer_;
  std::unique_ptr<GlStream> stream_ = std::make_unique<GlStream>();
};

}  // namespace moltact
