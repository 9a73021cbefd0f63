#include "app/ui/scene/body_contacts.h"

#include <algorithm>

#include "engine/haptics/sweep.h"

namespace moltact {

LoadedAtoms bodyContacts(const TouchableModel& stage, const ServoSample& now, std::span<const AtomForce> reactions,
                         const SphereMotion* motion) {
  if (!stage.body || !now.contact.touching()) return {};
  LoadedAtoms out = loadedAtoms(reactions);
  if (out.count > 0) return out;
  const PoseA drawn = now.shownBody();
  const SphereGrid& others = motion ? motion->sweptSpheres() : *stage.spheres;
  for (std::size_t k = 0; k < stage.body->spheres.size(); ++k) {
    const Sphere& sphere = stage.body->spheres[k];
    const Vec3 place = drawn.place.A + drawn.orientation * sphere.centre_A;
    if (clearance(others, sphere.radius_A, place, motion, now.fraction) < kAtRest_A)
      out.body.push_back({std::uint32_t(k)});
  }
  for (const std::int32_t atom : now.contact.atoms)
    if (atom >= 0) out.scene.push_back({std::uint32_t(atom)});
  for (auto* all : {&out.body, &out.scene})
    for (LoadedAtom& one : *all) one.share = 1.0 / double(all->size());
  return out;
}

}  // namespace moltact
