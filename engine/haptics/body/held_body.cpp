#include "engine/haptics/body/held_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moltact {

std::shared_ptr<const HeldBody> heldBody(std::span<const Sphere> scene, std::span<const std::uint32_t> atoms,
                                         double overlap_A) {
  constexpr double kMinRadius_A = 0.2;
  auto out = std::make_shared<HeldBody>();
  out->overlap_A = overlap_A;
  for (const std::uint32_t a : atoms)
    if (a < scene.size()) out->atoms.push_back(a);
  if (out->atoms.empty() || out->atoms.size() > kMaxHeldAtoms) return nullptr;
  for (const std::uint32_t a : out->atoms) out->middle.A += scene[a].centre_A / double(out->atoms.size());
  for (const std::uint32_t a : out->atoms) {
    const Sphere felt{scene[a].centre_A - out->middle.A, std::max(kMinRadius_A, scene[a].radius_A - overlap_A)};
    out->reach_A = std::max(out->reach_A, glm::length(felt.centre_A) + felt.radius_A);
    out->spheres.push_back(felt);
  }
  return out;
}

std::shared_ptr<const HeldBody> bodyOfSpheres(std::vector<Sphere> spheres) {
  if (spheres.empty() || spheres.size() > kMaxHeldAtoms) return nullptr;
  auto out = std::make_shared<HeldBody>();
  for (const Sphere& s : spheres) out->reach_A = std::max(out->reach_A, glm::length(s.centre_A) + s.radius_A);
  out->spheres = std::move(spheres);
  return out;
}

double radiusOfGyration_A(const HeldBody& body) {
  double sum = 0.0;
  for (const Sphere& s : body.spheres) sum += glm::dot(s.centre_A, s.centre_A);
  return std::sqrt(sum / double(std::max<std::size_t>(1, body.spheres.size())));
}

Hit sweep(const SphereGrid& scene, const HandShape& hand, const Vec3& from, const Vec3& to) noexcept {
  if (!hand.body) return sweep(scene, hand.probe_A, from, to);
  Hit first;
  const glm::dmat3 axes = glm::mat3_cast(hand.orientation);
  for (const Sphere& sphere : hand.body->spheres) {
    const Vec3 lever = axes * sphere.centre_A;
    // The search ends at the first hit of the other atoms.
    const Vec3 end = from + (to - from) * first.t;
    Hit hit = sweep(scene, sphere.radius_A, from + lever, end + lever);
    if (hit.sphere < 0) continue;
    hit.t *= first.t;
    first = hit;
  }
  return first;
}

}  // namespace moltact
