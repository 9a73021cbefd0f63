#include "engine/lesson/hand_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/core/saturated.h"
#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

constexpr double kBefore_A = 1.0;       // the hand begins so far before a place
constexpr double kSettle_s = 0.3;       // in which the force after a new beginning has grown to its full size
constexpr double kApart_A = 0.5;        // places nearer to each other than this are one
constexpr double kStep_A = 0.4;         // of a slide, between two looks for the surface
constexpr int kMaxSteps = 20'000;       // longer on ways that are no molecule's
constexpr double kRoom_A = 1.5;         // more room than this round a place is no better
constexpr int kDirections = 60;         // in which an atom's face is looked at
constexpr double kHandSpacing_A = 0.4;  // of places in a crease

// How far the nearest atom that does not hold the probe is away from it there.
double room(const HandPlanInput& view, const SurfacePlace& place) {
  double least = kRoom_A;
  view.spheres.visitNear(place.scp_A, view.probe_A + kRoom_A, [&](std::uint32_t i, const Sphere& b) {
    const auto atom = static_cast<std::int32_t>(i);
    if (atom == place.atoms[0] || atom == place.atoms[1] || atom == place.atoms[2]) return;
    least = std::min(least, glm::distance(place.scp_A, b.centre_A) - b.radius_A - view.probe_A);
  });
  return least;
}

}  // namespace

std::vector<std::uint32_t> everyAtom(const SphereGrid& spheres) {
  std::vector<std::uint32_t> all(spheres.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

std::vector<SurfacePlace> openPlaces(const HandPlanInput& view, std::span<const std::uint32_t> atoms, Feature feature,
                                     std::size_t at_most, const std::function<bool(const SurfacePlace&)>& wanted) {
  std::vector<SurfacePlace> found;
  if (feature == Feature::Sphere)
    found = facePlaces(view.spheres, atoms, view.probe_A, kDirections);
  else if (feature == Feature::Circle)
    found = creasePlaces(view.spheres, atoms, view.probe_A, kHandSpacing_A);
  else if (feature == Feature::Point)
    found = pitPlaces(view.spheres, atoms, view.probe_A);
  if (wanted) std::erase_if(found, [&](const SurfacePlace& p) { return !wanted(p); });
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < found.size(); ++k) order.emplace_back(-room(view, found[k]), k);
  std::sort(order.begin(), order.end());
  std::vector<SurfacePlace> out;
  for (const auto& ordered : order) {
    const std::size_t k = ordered.second;  // no binding, which clang before 16 lets no lambda take
    if (out.size() >= at_most) break;
    const auto near = [&](const SurfacePlace& p) { return glm::distance(p.scp_A, found[k].scp_A) < kApart_A; };
    if (std::none_of(out.begin(), out.end(), near) && openFromOutside(view.spheres, found[k], view.probe_A))
      out.push_back(found[k]);
  }
  return out;
}

std::optional<SurfacePlace> placeFor(const HandPlanInput& view, const std::vector<SurfacePlace>& places) {
  if (places.empty()) return std::nullopt;
  return places[static_cast<std::size_t>(view.attempt) % places.size()];
}

double depthFor(const HandPlanInput& view, double force_N) { return view.N_per_A > 0.0 ? force_N / view.N_per_A : 0.0; }

void comeTo(HandPlan& plan, const SurfacePlace& place, double depth_A, double wait_s) {
  plan.push_back({.to = PointA{place.scp_A + place.outward * kBefore_A}, .placed = true, .wait_s = kSettle_s});
  plan.push_back({.to = PointA{place.scp_A - place.outward * depth_A}, .wait_s = wait_s});
}

void slide(HandPlan& plan, const HandPlanInput& view, const SurfacePlace& from, const SurfacePlace& to, double depth_A,
           double speed_A_per_s) {
  const double length = glm::distance(from.scp_A, to.scp_A);
  const int steps = std::clamp(saturateToInteger<int>(std::ceil(length / kStep_A)), 1, kMaxSteps);
  const double far = glm::distance(view.spheres.low_A(), view.spheres.high_A()) + 2.0 * view.probe_A + 1.0;
  for (int k = 1; k <= steps; ++k) {
    const double part = double(k) / steps;
    const Vec3 mixed = from.outward * (1.0 - part) + to.outward * part;
    const Vec3 out = glm::length(mixed) > 1e-6 ? glm::normalize(mixed) : to.outward;
    const Vec3 between = from.scp_A * (1.0 - part) + to.scp_A * part;
    // The surface as it is met from outside there; where nothing is met the straight way will do.
    const Vec3 start = between + out * far, end = between - out * (0.5 * length + depth_A);
    const Hit hit = sweep(view.spheres, view.probe_A, start, end);
    const Vec3 surface = k == steps ? to.scp_A : hit.sphere >= 0 ? start + (end - start) * hit.t : between;
    plan.push_back({.to = PointA{surface - out * depth_A}, .speed_A_per_s = speed_A_per_s});
  }
}

}  // namespace moltact
