// Full-screen passes: the background, and the atoms' layer brought to the picture's size with outlines.
// Needs a current context.
#pragma once

#include "engine/render/gl_objects.h"
#include "engine/render/sphere_impostors.h"

namespace moltact {

class Resolve {
 public:
  static Expected<Resolve> build();

  void background(const Lighting& lighting);

  /// Writes colour and depth of `from` into the bound framebuffer of the projection's size: the mean of samples x samples
  /// texels, darkened where the depth jumps (`outlines`), its depth that of the nearest texel.
  void layer(const GlTarget& from, int samples, bool outlines, const Projection& projection);

 private:
  GlProgram background_, layer_;
  std::unique_ptr<GlStream> stream_ = std::make_unique<GlStream>();
};

}  // namespace moltact
