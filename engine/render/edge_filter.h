// Antialiasing for a picture with one sample per pixel: blends along brightness edges and leaves the rest unchanged.
// After Lottes, "FXAA" (2009), in its short form. Needs a current context.
#pragma once

#include <memory>

#include "engine/render/gl_objects.h"

namespace moltact {

class EdgeFilter {
 public:
  static constexpr int kReach_px = 4;  ///< each pixel depends on the pixels within this distance

  static Expected<EdgeFilter> build();

  /// Draws `from` into the bound framebuffer of the same size.
  void draw(const GlTarget& from);

 private:
  GlProgram program_;
  std::unique_ptr<GlStream> stream_ = std::make_unique<GlStream>();
};

}  // namespace moltact
