#include "app/ui/scene/body_place.h"

namespace moltact {

BodyPlace bodyPlace(const TouchableModel& stage, const ServoSample& now) {
  BodyPlace out;
  if (!stage.body) return out;
  const PoseA drawn = now.shownBody();
  out.atoms = stage.body->spheres.size();
  for (const Sphere& sphere : stage.body->spheres) {
    const Vec3 home_A = stage.body->middle.A + sphere.centre_A;
    out.in_place += glm::distance(drawn.place.A + drawn.orientation * sphere.centre_A, home_A) <= kInPlace_A;
  }
  return out;
}

}  // namespace moltact
