#include "engine/lesson/hand_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/core/even_directions.h"
#include "engine/core/saturated.h"
#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

constexpr double kBefore_A = 1.0;       // distance from the place at which the hand begins
constexpr double kSettle_s = 0.3;       // time for the force to reach its full size after a soft start
constexpr double kApart_A = 0.5;        // minimum distance of two places
constexpr double kStep_A = 0.4;         // step of a slide between two tests of the surface
constexpr int kMaxSteps = 20'000;       // upper limit for paths longer than any molecule
constexpr double kRoom_A = 1.5;         // clearance beyond which a place is not better
constexpr int kDirections = 60;         // number of directions tested for an atom's face
constexpr double kHandSpacing_A = 0.4;  // spacing of places in a crease

// The distance from the probe, at this place, to the nearest atom outside the active set.
double room(const HandPlanInput& view, const SurfacePlace& place) {
  double min = kRoom_A;
  view.spheres.visitNear(place.scp_A, view.probe_A + kRoom_A, [&](std::uint32_t i, const Sphere& b) {
    const auto atom = static_cast<std::int32_t>(i);
    if (atom == place.atoms[0] || atom == place.atoms[1] || atom == place.atoms[2]) return;
    min = std::min(min, glm::distance(place.scp_A, b.centre_A) - b.radius_A - view.probe_A);
  });
  return min;
}

// number of directions from which a body approaches an atom
constexpr int kBodyDirections = 100, kFewBodyDirections = 12;
// cosine of the largest angle between the motion and the normal; beyond, the body slides off
constexpr double kFrontal = 0.5;

// The direction from the scene's atom to the nearest of the body's atoms, for a body whose middle is at that position.
Vec3 contactNormal(const HandPlanInput& view, std::int32_t atom, const Vec3& middle_A) {
  const Vec3 centre = view.spheres[std::size_t(atom)].centre_A;
  const glm::dmat3 axes = glm::mat3_cast(view.orientation);
  Vec3 nearest(0.0, 0.0, 1.0);
  double min_A = 1e300;
  for (const Sphere& sphere : view.body->spheres) {
    const Vec3 from = middle_A + axes * sphere.centre_A - centre;
    const double gap_A = glm::length(from) - sphere.radius_A;
    if (gap_A >= min_A || glm::length(from) == 0.0) continue;
    min_A = gap_A;
    nearest = glm::normalize(from);
  }
  return nearest;
}

// Where the body first meets one of these atoms on straight paths from many directions. On each path, the body's
// foremost atom is aimed at the atom's centre.
std::vector<SurfacePlace> bodyPlaces(const HandPlanInput& view, std::span<const std::uint32_t> atoms,
                                     std::size_t max_count, const std::function<bool(const SurfacePlace&)>& wanted) {
  // Of many atoms only every n-th is aimed at, from fewer directions, because each aim sweeps the whole body.
  constexpr std::size_t kMaxAims = 6000;
  const std::size_t each = std::max<std::size_t>(1, atoms.size());
  const int directions = int(std::clamp<std::size_t>(kMaxAims / each, kFewBodyDirections, kBodyDirections));
  const std::size_t stride = std::max<std::size_t>(1, each * std::size_t(directions) / kMaxAims);
  std::vector<char> in(view.spheres.size(), 0);
  for (const std::uint32_t a : atoms) in[a] = view.spheres.touchable(a);
  const double far_A = glm::distance(view.spheres.low_A(), view.spheres.high_A()) + 2.0 * view.body->reach_A + 1.0;
  const glm::dmat3 axes = glm::mat3_cast(view.orientation);
  std::vector<std::pair<double, SurfacePlace>> found;
  for (std::size_t n = 0; n < atoms.size(); n += stride) {
    const std::uint32_t a = atoms[n];
    if (!in[a]) continue;
    for (int k = 0; k < directions; ++k) {
      const Vec3 out = evenDirection(k, directions);
      // The body's foremost atom on this path meets the target before its other atoms do, if any does.
      std::size_t foremost = 0;
      const auto ahead = [&](std::size_t i) {
        return view.body->spheres[i].radius_A - glm::dot(out, axes * view.body->spheres[i].centre_A);
      };
      for (std::size_t i = 1; i < view.body->spheres.size(); ++i)
        if (ahead(i) > ahead(foremost)) foremost = i;
      const Vec3 aim = view.spheres[a].centre_A - axes * view.body->spheres[foremost].centre_A;
      const Vec3 start = aim + out * far_A;
      const Hit hit = sweep(view.spheres, view.hand(), start, aim);
      if (hit.sphere < 0 || !in[std::size_t(hit.sphere)]) continue;
      const Vec3 middle = start + (aim - start) * hit.t;
      const double frontal = glm::dot(out, contactNormal(view, hit.sphere, middle));
      SurfacePlace place{middle, out, {hit.sphere, -1, -1}, Feature::Sphere};
      if (frontal >= kFrontal && (!wanted || wanted(place))) found.emplace_back(-frontal, place);
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<SurfacePlace> out;
  for (const auto& [frontal, place] : found) {
    if (out.size() >= max_count) break;
    const Vec3 here = place.scp_A;
    const auto near = [&](const SurfacePlace& p) { return glm::distance(p.scp_A, here) < kApart_A; };
    if (std::none_of(out.begin(), out.end(), near)) out.push_back(place);
  }
  return out;
}

}  // namespace

PoseA HandWay::at(std::size_t k) const {
  if (k >= ticks) return to;
  const double part = double(k) / double(ticks);
  return {{from.place.A + (to.place.A - from.place.A) * part}, glm::slerp(from.orientation, to.orientation, part)};
}

HandWay wayOf(const HandAct& act, const PoseA& from, double tick_s) {
  HandWay way{from, {act.to.value_or(from.place), act.turned_to.value_or(from.orientation)}, 0};
  const double turn_deg = glm::degrees(glm::length(rotationBetween(from.orientation, way.to.orientation)));
  const double takes_s = std::max(glm::distance(from.place.A, way.to.place.A) / std::max(0.1, act.speed_A_per_s),
                                  turn_deg / std::max(1.0, act.turn_deg_per_s));
  way.ticks = saturateToInteger<std::size_t>(std::ceil(takes_s / tick_s));
  return way;
}

std::vector<std::uint32_t> everyAtom(const SphereGrid& spheres) {
  std::vector<std::uint32_t> all(spheres.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

std::vector<SurfacePlace> openPlaces(const HandPlanInput& view, std::span<const std::uint32_t> atoms, Feature feature,
                                     std::size_t max_count, const std::function<bool(const SurfacePlace&)>& wanted) {
  if (view.body)
    return feature == Feature::Sphere ? bodyPlaces(view, atoms, max_count, wanted) : std::vector<SurfacePlace>();
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
    // a variable instead of a structured binding, which lambdas cannot capture in clang before 16
    const std::size_t k = ordered.second;
    if (out.size() >= max_count) break;
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
  const double far = glm::distance(view.spheres.low_A(), view.spheres.high_A()) + 2.0 * view.hand().reach_A() + 1.0;
  for (int k = 1; k <= steps; ++k) {
    const double part = double(k) / steps;
    const Vec3 mixed = from.outward * (1.0 - part) + to.outward * part;
    const Vec3 out = glm::length(mixed) > 1e-6 ? glm::normalize(mixed) : to.outward;
    const Vec3 between = from.scp_A * (1.0 - part) + to.scp_A * part;
    // The surface as met from outside at this point; if nothing is met, the straight path is used.
    const Vec3 start = between + out * far, end = between - out * (0.5 * length + depth_A);
    const Hit hit = sweep(view.spheres, view.hand(), start, end);
    const Vec3 surface = k == steps ? to.scp_A : hit.sphere >= 0 ? start + (end - start) * hit.t : between;
    plan.push_back({.to = PointA{surface - out * depth_A}, .speed_A_per_s = speed_A_per_s});
  }
}

}  // namespace moltact
