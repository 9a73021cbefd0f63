#include "engine/lesson/passable.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/even_directions.h"
#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

constexpr int kFaceDirections = 100;        // per atom
constexpr int kWays = 64;                   // directions from outside to a place
constexpr double kPassableSpacing_A = 0.2;  // spacing of places in a crease
constexpr double kLift_A = 1e-4;
constexpr double kAway = 0.02;   // minimum cosine between a direction and the outward directions of the holding atoms
constexpr double kGrid_A = 0.1;  // spacing of the lines through a ring

bool open(const SphereGrid& scene, const SurfacePlace& place, double probe_A) {
  if (openFromOutside(scene, place, probe_A)) return true;
  const double far = glm::distance(scene.low_A(), scene.high_A()) + 2.0 * probe_A + 1.0;
  for (int k = 0; k < kWays; ++k) {
    const Vec3 way = evenDirection(k, kWays);
    const bool away = std::all_of(place.atoms.begin(), place.atoms.end(), [&](std::int32_t a) {
      return a < 0 || glm::dot(glm::normalize(place.scp_A - scene[static_cast<std::size_t>(a)].centre_A), way) >= kAway;
    });
    if (away && sweep(scene, probe_A, place.scp_A + way * far, place.scp_A + way * kLift_A).sphere < 0) return true;
  }
  return false;
}

bool rests(const SurfacePlace& place, const std::vector<char>& in) {
  return std::any_of(place.atoms.begin(), place.atoms.end(),
                     [&](std::int32_t a) { return a >= 0 && in[static_cast<std::size_t>(a)]; });
}

}  // namespace

std::vector<SurfacePlace> reachablePlaces(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A,
                                          bool first_only, const std::function<bool(const SurfacePlace&)>& wanted) {
  std::vector<SurfacePlace> out;
  std::vector<char> in(scene.size(), 0), near(scene.size(), 0);
  for (const std::uint32_t a : atoms) in[a] = near[a] = 1;
  const auto take = [&](const std::vector<SurfacePlace>& places) {
    for (const SurfacePlace& p : places)
      if ((out.empty() || !first_only) && rests(p, in) && (!wanted || wanted(p)) && open(scene, p, probe_A))
        out.push_back(p);
  };
  take(facePlaces(scene, atoms, probe_A, kFaceDirections));
  if (!out.empty()) return out;
  // At its maximum size, a probe touches the place and its neighbours: in creases and pits, which have closed forms.
  for (const std::uint32_t a : atoms)
    scene.visitNear(scene[a].centre_A, scene[a].radius_A + 2.0 * probe_A,
                    [&](std::uint32_t b, const Sphere&) { near[b] = 1; });
  std::vector<std::uint32_t> around;
  for (std::uint32_t a = 0; a < near.size(); ++a)
    if (near[a]) around.push_back(a);
  take(creasePlaces(scene, around, probe_A, kPassableSpacing_A));
  if (out.empty() || !first_only) take(pitPlaces(scene, around, probe_A));
  return out;
}

std::optional<AtomRing> ringOf(const SphereGrid& scene, std::span<const std::uint32_t> atoms) {
  if (atoms.size() < 3) return std::nullopt;
  AtomRing ring;
  for (const std::uint32_t a : atoms) ring.centre_A += scene[a].centre_A / double(atoms.size());
  glm::dmat3 spread(0.0);
  for (const std::uint32_t a : atoms) {
    const Vec3 d = scene[a].centre_A - ring.centre_A;
    spread += glm::outerProduct(d, d);
    ring.radius_A = std::max(ring.radius_A, glm::length(d));
  }
  const double size = spread[0][0] + spread[1][1] + spread[2][2];
  if (!(size > 0.0)) return std::nullopt;
  // The direction of least variance, by inverse iteration.
  const glm::dmat3 inverse = glm::inverse(spread + glm::dmat3(1e-6 * size));
  Vec3 axis = glm::normalize(Vec3(0.36, 0.48, 0.8));
  for (int k = 0; k < 60; ++k) axis = glm::normalize(inverse * axis);
  ring.axis = axis;
  return ring;
}

std::optional<Vec3> pathThrough(const SphereGrid& scene, const AtomRing& ring, double probe_A) {
  const Vec3 x = glm::normalize(glm::cross(ring.axis, std::abs(ring.axis.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0))),
             y = glm::cross(ring.axis, x);
  const double before_A = ring.radius_A + probe_A + 2.0;
  const int steps = std::clamp(static_cast<int>(ring.radius_A / kGrid_A), 1, 60);
  const double step_A = ring.radius_A / steps;
  std::optional<Vec3> best;
  double most = ring.radius_A;
  // Lines are tried from the centre outward.
  for (int i = -steps; i <= steps; ++i)
    for (int j = -steps; j <= steps; ++j) {
      const double off_A = step_A * std::hypot(i, j);
      if (off_A >= most && best) continue;
      if (off_A > ring.radius_A) continue;
      const Vec3 at = ring.centre_A + (x * double(i) + y * double(j)) * step_A;
      const Vec3 from = at + ring.axis * before_A, to = at - ring.axis * before_A;
      bool inside = false;
      scene.visitNear(from, probe_A, [&](std::uint32_t, const Sphere& b) {
        inside = inside || glm::distance(from, b.centre_A) < b.radius_A + probe_A;
      });
      if (inside || sweep(scene, probe_A, from, to).sphere >= 0) continue;
      best = at;
      most = off_A;
    }
  return best;
}

}  // namespace moltact
