// The shadow of a sphere on the picture below it: dark where it nearly touches and where it blocks the key light. It
// indicates the distance of the probe from the surface. Needs a current context. Units: angstrom, the camera's axes.
#pragma once

#include <memory>

#include "engine/render/gl_objects.h"
#include "engine/render/projection.h"

namespace moltact {

class ContactShadow {
 public:
  static Expected<ContactShadow> build();

  /// Darkens the bound framebuffer, which has the size of `drawn`; the depth of `drawn` contains the surfaces.
  void draw(const GlTarget& drawn, const glm::vec3& centre, float radius, const Projection& projection);

  /// Range of the shadow from the sphere's centre, in radii.
  static constexpr float kReach = 4.5f;

 private:
  GlProgram program_;
  std::unique_ptr<GlStream> stream_ = std::make_unique<GlStream>();
};

}  // namespace moltact
