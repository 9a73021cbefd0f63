#include "engine/haptics/paper/paper_tracker.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/haptics/hip_input.h"

namespace moltact {

PaperTracker::PaperTracker(std::shared_ptr<const SphereGrid> scene, double probe_A)
    : scene_(std::move(scene)), models_((assert(scene_), *scene_)) {
  setProbe(probe_A);
}

void PaperTracker::reset() noexcept {
  has_been_outside_ = false;
  state_ = Feature::Free;
  atom_ = -1;
  models_.clear();
}

MemoryUsage PaperTracker::memoryUsage() const noexcept {
  return {models_.held(), scene_->bytes() + models_.bytes() + sizeof *this};
}

// Algorithm 1. A state found in a tick constrains the SCP in the same tick.
Contact PaperTracker::step(PointA hip) noexcept {
  const Vec3& h = hip.A;
  if (!usableHip(h)) return {.scp = {scp_}, .fault = Fault::NotFinite};

  // "if Not in collision with an atom": the test of all atoms, through the spatial partition.
  if (state_ == Feature::Free) {
    scp_ = h;
    atom_ = deepestAtomAround(h);
    if (atom_ < 0) {
      has_been_outside_ = true;
      return {.scp = hip};
    }
    if (!has_been_outside_) return {.scp = hip, .fault = Fault::StartedInside};
    state_ = Feature::Sphere;
  }

  if (state_ == Feature::Point) leavePoint(h);

  // Section 4.3: "If the HIP moves out of the current sphere it is assumed to be no longer in collision."
  // The test of all atoms follows in the next tick, according to the if and else of Algorithm 1.
  if (!insideSphere(atom_, h)) {
    state_ = Feature::Free;
    scp_ = h;
    return {.scp = hip};
  }

  if (state_ == Feature::Circle) followCone(h);
  if (state_ == Feature::Sphere) {
    constrainToSphere(h);
    findCone(h);
  }
  if (state_ == Feature::Circle) scp_ = paper::closestOnCircle(cone_.circle, h, scp_);
  if (state_ != Feature::Point) findPoint(h);
  return contact(hip);
}

// Of several atoms that contain the HIP, the one in which it is deepest: a moving HIP entered it first.
std::int32_t PaperTracker::deepestAtomAround(const Vec3& hip) const {
  std::int32_t deepest = -1;
  double depth = 0.0;
  scene_->visitNear(hip, probe_, [&](std::uint32_t index, const Sphere& sphere) {
    const double here = sphere.radius_A + probe_ - glm::distance(hip, sphere.centre_A);
    if (here > depth || (here == depth && here > 0.0 && std::int32_t(index) < deepest)) {
      depth = here;
      deepest = std::int32_t(index);
    }
  });
  return deepest;
}

bool PaperTracker::insideSphere(std::int32_t atom, const Vec3& hip) const {
  return glm::distance(hip, centre(atom)) < radius(atom);
}

std::optional<paper::Cone> PaperTracker::coneOf(std::int32_t atom, std::int32_t neighbour) const {
  const auto circle = paper::intersectionCircle(centre(atom), radius(atom), centre(neighbour), radius(neighbour));
  if (!circle) return std::nullopt;
  return paper::Cone{*circle, centre(atom), atom, neighbour};
}

// Case 1 (section 4.3): the closest point of the current sphere; from its centre, the last direction.
void PaperTracker::constrainToSphere(const Vec3& hip) {
  const Vec3& c = centre(atom_);
  Vec3 out = hip - c;
  double size = glm::length(out);
  if (!(size > 1e-12)) {
    out = scp_ - c;
    size = glm::length(out);
  }
  if (!(size > 1e-12)) {
    out = Vec3(0, 0, 1);
    size = 1.0;
  }
  scp_ = c + out * (radius(atom_) / size);
}

// Case 1 to 2 (section 4.4): the cones of the current atom; of several that contain the HIP, the one with the nearest
// circle.
void PaperTracker::findCone(const Vec3& hip) {
  double nearest = 0.0;
  for (const paper::Cone& cone : models_.model(*scene_, atom_, probe_).cones) {
    if (!paper::insideCone(cone, hip)) continue;
    const double away = glm::distance(hip, paper::closestOnCircle(cone.circle, hip, scp_));
    if (state_ == Feature::Circle && away >= nearest) continue;
    nearest = away;
    cone_ = cone;
    state_ = Feature::Circle;
  }
}

// Case 2 (section 4.4): beyond the base, cone and atom become the neighbour's; outside the cone it is case 1 again.
void PaperTracker::followCone(const Vec3& hip) {
  if (paper::pastBase(cone_, hip)) {
    cone_ = paper::neighbourCone(cone_, centre(cone_.neighbour));
    atom_ = cone_.atom;
  }
  if (!paper::insideCone(cone_, hip)) state_ = Feature::Sphere;
}

// Case 1 or 2 to 3 (section 4.5): the planes of the current atom's points within epsilon of the SCP.
void PaperTracker::findPoint(const Vec3& hip) {
  double nearest2 = kEpsilon_A * kEpsilon_A;
  const Vec3 from = scp_;
  for (const paper::ModelPoint& p : models_.model(*scene_, atom_, probe_).points) {
    const Vec3 off = p.P - from;
    const double away2 = glm::dot(off, off);
    if (!(away2 < nearest2)) continue;
    const auto volume =
        paper::pointVolume(p.P, {atom_, p.second, p.third}, {centre(atom_), centre(p.second), centre(p.third)});
    if (!volume || volume->crossed(hip)) continue;
    nearest2 = away2;
    volume_ = *volume;
    scp_ = p.P;
    state_ = Feature::Point;
  }
}

// Case 3 (section 4.5): beyond a plane, the circle to which the plane belongs.
void PaperTracker::leavePoint(const Vec3& hip) {
  const paper::PointPlane* plane = volume_.crossed(hip);
  if (!plane) return;
  const auto [first, second] = plane->circle;
  const bool keep = second == atom_;
  const auto cone = coneOf(keep ? second : first, keep ? first : second);
  atom_ = keep ? second : first;
  state_ = cone ? Feature::Circle : Feature::Sphere;
  if (cone) cone_ = *cone;
  // The plane's circle may not pass through the current atom: use the sphere of the two in which the HIP is deeper.
  if (cone && paper::pastBase(cone_, hip)) {
    cone_ = paper::neighbourCone(cone_, centre(cone_.neighbour));
    atom_ = cone_.atom;
  }
}

void PaperTracker::setProbe(double probe_A) noexcept {
  if (!std::isfinite(probe_A)) return;
  probe_ = std::clamp(probe_A, 0.0, kMaxProbe_A);
  models_.clear();

  // In contact, the circle or point of the same atoms at the new radius; if there is none, the sphere.
  if (state_ == Feature::Circle) {
    const auto cone = coneOf(cone_.atom, cone_.neighbour);
    if (cone)
      cone_ = *cone;
    else
      state_ = Feature::Sphere;
  } else if (state_ == Feature::Point) {
    // The planes' circles are (i, j), (j, k), (k, i).
    const std::array<std::int32_t, 3> ids{volume_.planes[0].circle[0], volume_.planes[1].circle[0],
                                          volume_.planes[2].circle[0]};
    std::optional<paper::PointVolume> volume;
    if (const auto cone = coneOf(ids[0], ids[1]))
      if (const auto both = paper::intersectionPoints(cone->circle, centre(ids[2]), radius(ids[2]))) {
        const bool first = glm::distance(both->P0, scp_) <= glm::distance(both->P1, scp_);
        volume = paper::pointVolume(first ? both->P0 : both->P1, ids, {centre(ids[0]), centre(ids[1]), centre(ids[2])});
      }
    if (volume) {
      volume_ = *volume;
      scp_ = volume->P;
    } else {
      state_ = Feature::Sphere;
    }
  }
}

Contact PaperTracker::contact(PointA hip) const {
  Contact out;
  out.scp = {scp_};
  out.feature = state_;
  if (state_ == Feature::Sphere) out.atoms = {atom_, -1, -1};
  if (state_ == Feature::Circle)
    out.atoms = {std::min(cone_.atom, cone_.neighbour), std::max(cone_.atom, cone_.neighbour), -1};
  if (state_ == Feature::Point) {
    for (std::size_t k = 0; k < 3; ++k) out.atoms[k] = volume_.planes[k].circle[0];
    std::sort(out.atoms.begin(), out.atoms.end());
  }
  if (!out.touching()) return out;
  stretchToScp(out, hip);
  // The SCP may lie off a sphere on which the algorithm assumes it to be.
  for (std::size_t k = 0; k < 3 && out.atoms[k] >= 0; ++k)
    if (const Vec3 away = scp_ - centre(out.atoms[k]); away != Vec3(0.0)) out.normals[k] = glm::normalize(away);
  return out;
}

}  // namespace moltact
