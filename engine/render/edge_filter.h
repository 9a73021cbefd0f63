// Smooth edges for a picture that was drawn with one sample a pixel: along an edge of brightness the picture is blended,
// elsewhere it stays as it is. After Lottes, "FXAA" (2009), in its short form. Needs a current context.
#pragma once

#include <memory>

#include "engine/render/gl_objects.h"

namespace moltact {

class EdgeFilter {
 public:
  static constexpr int kReach_px = 4;  ///< what a pixel becomes depends on those within this

  static Expected<EdgeFilter> build();

  /// Draws `from` into the bound framebuffer, which is as large.
  void draw(const GlTarget& from);

 private:
  GlProgram program_;
  std::unique_ptr<GlStream> stream_ = std::make_unique<GlStream>();
};

}  // namespace moltact
