// The shadow of a sphere on what is already drawn: dark where it nearly touches, and where it stands before the key light.
// It tells how far the probe is from the surface. Needs a current context. Units: angstrom, the camera's axes.
#pragma once

#include <memory>

#include "engine/render/gl_objects.h"
#include "engine/render/projection.h"

namespace moltact {

class ContactShadow {
 public:
  static Expected<ContactShadow> build();

  /// Darkens the bound framebuffer, which is as large as `drawn`, whose depth tells where the surfaces lie.
  void draw(const GlTarget& drawn, const glm::vec3& centre, float radius, const Projection& projection);

  /// How far the shadow of a sphere reaches from its middle, in radii.
  static constexpr float kReach = 4.5f;

 private:
  GlProgram program_;
  std::unique_ptr<GlStream> stream_ = std::make_unique<GlStream>();
};

}  // namespace moltact
