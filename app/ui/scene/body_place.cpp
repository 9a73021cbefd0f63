#include "app/ui/scene/body_place.h"

#include "engine/haptics/sweep.h"

namespace moltact {

BodyPlace bodyPlace(const TouchableModel& stage, const ServoSample& now, const SphereMotion* motion) {
  BodyPlace out;
  if (!stage.body) return out;
  const bool touching = now.contact.touching();
  const PoseA drawn = now.shownBody();
  const SphereGrid& others = motion ? motion->sweptSpheres() : *stage.spheres;
  out.atoms = stage.body->spheres.size();
  for (std::size_t k = 0; k < stage.body->spheres.size(); ++k) {
    const Sphere& sphere = stage.body->spheres[k];
    const Vec3 lever_A = now.orientation * sphere.centre_A;
    const Vec3 home_A = stage.body->middle.A + sphere.centre_A;
    out.in_place += glm::distance(drawn.place.A + drawn.orientation * sphere.centre_A, home_A) <= kInPlace_A;
    if (touching && clearance(others, sphere.radius_A, now.hip.A + lever_A, motion, now.fraction) < 0.0)
      out.stopped.push_back(std::uint32_t(k));
  }
  return out;
}

}  // namespace moltact
