#include "engine/bench/scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/core/units.h"

namespace moltact::scenes {
namespace {

constexpr double kC = 1.7, kO = 1.52, kH = 1.1;

// The signed distance to the nearest surface and the outward direction.
struct Near {
  double gap = std::numeric_limits<double>::infinity();
  Vec3 out{0, 0, 1};
};
Near nearest(const Scene& scene, Vec3 p) {
  Near n;
  for (const Sphere& b : scene.spheres) {
    const Vec3 from = p - b.centre_A;
    const double r = glm::length(from);
    if (r - b.radius_A - scene.probe_A >= n.gap) continue;
    n.gap = r - b.radius_A - scene.probe_A;
    n.out = r > 0 ? from / r : Vec3(0, 0, 1);
  }
  return n;
}

struct Box {
  Vec3 low{1e300}, high{-1e300};
  Vec3 middle() const { return (low + high) / 2.0; }
  double half() const { return glm::length(high - low) / 2.0; }
};
Box boxOf(const Scene& scene) {
  Box box;
  for (const Sphere& b : scene.spheres) {
    const Vec3 r(b.radius_A + scene.probe_A);
    box.low = glm::min(box.low, b.centre_A - r);
    box.high = glm::max(box.high, b.centre_A + r);
  }
  return box;
}

}  // namespace

double Random::uniform(double low, double high) {
  std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return low + (high - low) * (double((z ^ (z >> 31)) >> 11) * 0x1p-53);
}

Vec3 Random::direction() {
  for (;;) {
    const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
    const double r2 = x * x + y * y + z * z;
    if (r2 < 1 && r2 > 1e-3) return Vec3(x, y, z) / std::sqrt(r2);
  }
}

Scene oneSphere() { return {"one ball", {{{0, 0, 0}, kC}}}; }

Scene bond() { return {"bond", {{{0, 0, 0}, kC}, {{1.23, 0, 0}, kO}}}; }

Scene pit() {
  const double a = 2.5;
  return {"pit", {{{0, 0, 0}, kC}, {{a, 0, 0}, kC}, {{a / 2, a * std::sqrt(3.0) / 2, 0}, kC}}};
}

Scene tetrahedron() {
  const double h = 1.09 / std::sqrt(3.0);
  return {"tetrahedron", {{{0, 0, 0}, kC}, {{h, h, h}, kH}, {{h, -h, -h}, kH}, {{-h, h, -h}, kH}, {{-h, -h, h}, kH}}};
}

Scene cube() {
  Scene s{"cube", {}};
  const double h = 1.57 / 2;
  for (int k = 0; k < 8; ++k) s.spheres.push_back({{k & 1 ? h : -h, k & 2 ? h : -h, k & 4 ? h : -h}, kC});
  return s;
}

Scene shell() {
  // Even permutations of (0, +-1, +-3g), (+-1, +-(2 + g), +-2g), (+-g, +-2, +-(2g + 1)): edge 2.
  Scene s{"shell", {}};
  const double g = std::numbers::phi, scale = 1.43 / 2;
  const Vec3 kinds[] = {{0, 1, 3 * g}, {1, 2 + g, 2 * g}, {g, 2, 2 * g + 1}};
  for (const Vec3& kind : kinds)
    for (int turn = 0; turn < 3; ++turn)
      for (int signs = 0; signs < 8; ++signs) {
        if (kind.x == 0 && (signs & 1)) continue;
        const Vec3 v{signs & 1 ? -kind.x : kind.x, signs & 2 ? -kind.y : kind.y, signs & 4 ? -kind.z : kind.z};
        s.spheres.push_back({Vec3(v[turn], v[(turn + 1) % 3], v[(turn + 2) % 3]) * scale, kC});
      }
  return s;
}

Scene cluster(int n, std::uint64_t seed) {
  Scene s{"cluster of " + std::to_string(n) + ", seed " + std::to_string(seed), {}};
  Random random(seed);
  const double edge = std::cbrt(n * 10.0);  // 10 cubic angstroms per atom
  for (int k = 0; k < n; ++k) {
    const double x = random.uniform(0, edge), y = random.uniform(0, edge), z = random.uniform(0, edge);
    s.spheres.push_back({{x, y, z}, random.uniform(1.1, 2.0)});
  }
  return s;
}

Scene simpleCubic(int n) {
  // R is half the body diagonal, so that the eight spheres of a cell meet in its middle.
  Scene s{"simple cubic " + std::to_string(n), {}};
  const double a = 2 * (kC + s.probe_A) / std::sqrt(3.0);
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) s.spheres.push_back({{x * a, y * a, z * a}, kC});
  return s;
}

Scene faceCentred(int n) {
  // R is half the cell's edge, so that the six spheres around an octahedral hole meet in its middle.
  Scene s{"face-centred " + std::to_string(n), {}};
  const double h = kC + s.probe_A;
  for (int z = 0; z < 2 * n; ++z)
    for (int y = 0; y < 2 * n; ++y)
      for (int x = 0; x < 2 * n; ++x)
        if ((x + y + z) % 2 == 0) s.spheres.push_back({{x * h, y * h, z * h}, kC});
  return s;
}

Scene ring(int n, double slack_A) {
  Scene s{"ring of " + std::to_string(n) + (slack_A < 0 ? ", closed" : ", open"), {}};
  const double radius = kC + s.probe_A + slack_A;
  for (int k = 0; k < n; ++k) {
    const double t = kTwoPi * k / n;
    s.spheres.push_back({{radius * std::cos(t), radius * std::sin(t), 0}, kC});
  }
  return s;
}

Scene touching() {
  // Binary fractions, so that the sum of the radii equals the distance exactly.
  return {"touching in one point", {{{0, 0, 0}, 1.5}, {{6, 0, 0}, 1.5}}, 1.5};
}

Scene barelyOverlapping(double overlap_A) {
  return {"overlapping by a hair", {{{0, 0, 0}, 1.5}, {{6 - overlap_A, 0, 0}, 1.5}}, 1.5};
}

Scene touchingAcross() {
  return {"touching in one point under a third", {{{0, 0, 0}, 1.5}, {{6, 0, 0}, 1.5}, {{3, 2.5, 0}, 1.0}}, 1.5};
}

Scene nested() {
  return {
      "nested", {{{0, 0, 0}, 2.5}, {{0.25, 0, 0}, 1.0}, {{1.0, 0, 0}, 1.5}, {{0, 0, 0}, 1.0}, {{0, 3.0, 0}, 1.5}}, 1.5};
}

Scene duplicates() {
  Scene s = pit();
  s.name = "duplicates";
  s.spheres.insert(s.spheres.end(), {s.spheres[0], s.spheres[1], s.spheres[2], s.spheres[1]});
  return s;
}

Scene shifted(Scene scene, Vec3 by, const std::string& how) {
  for (Sphere& b : scene.spheres) b.centre_A += by;
  scene.name += " " + how;
  return scene;
}

std::vector<Scene> all(std::uint64_t seed) {
  std::vector<Scene> out{oneSphere(),
                         bond(),
                         pit(),
                         tetrahedron(),
                         cube(),
                         shell(),
                         simpleCubic(3),
                         faceCentred(2),
                         ring(6, -0.05),
                         ring(6, 0.05),
                         ring(12, -0.01),
                         ring(12, 0.2),
                         touching(),
                         barelyOverlapping(),
                         touchingAcross(),
                         nested(),
                         duplicates(),
                         cluster(5, seed),
                         cluster(20, seed + 1),
                         cluster(50, seed + 2)};
  const Vec3 far(1e6, -1e6, 1e6);
  for (const Scene& s : {pit(), simpleCubic(3), cluster(20, seed + 3)})
    out.push_back(shifted(s, far, "a million angstroms away"));
  return out;
}

Path walk(const Scene& scene, int ticks, std::uint64_t seed, double step_A, double depth_A) {
  Random random(seed);
  const Box box = boxOf(scene);
  // From a random side to the surface.
  Vec3 p = box.middle() + random.direction() * (box.half() + 0.5);
  while (nearest(scene, p).gap > 0.3) p += glm::normalize(box.middle() - p) * 0.1;
  Vec3 heading = random.direction();
  Path path;
  path.reserve(std::size_t(ticks));
  double wanted = 0;
  for (int k = 0; k < ticks; ++k) {
    path.push_back(p);
    const Near here = nearest(scene, p);
    if (k % 50 == 0) wanted = random.uniform(-1.05, 0.1) * depth_A;
    heading = glm::normalize(heading + random.direction() * 0.1);
    Vec3 along = heading - here.out * glm::dot(heading, here.out);
    const double depth_off = std::clamp((wanted - here.gap) / (4 * step_A), -1.0, 1.0);
    Vec3 go = along * (1.1 - std::abs(depth_off)) + here.out * depth_off;
    if (glm::length(go) < 1e-6) go = here.out;
    p += glm::normalize(go) * step_A;
    heading = glm::length(along) > 1e-6 ? glm::normalize(along) : random.direction();
  }
  return path;
}

Path jumps(const Scene& scene, int ticks, std::uint64_t seed, double step_A) {
  Random random(seed ^ 0x5ca1ab1e);
  const Box box = boxOf(scene);
  Path path;
  while (int(path.size()) < ticks) {
    const Path piece = walk(scene, 36, seed + path.size(), step_A);
    path.insert(path.end(), piece.begin(), piece.end());
    path.push_back(box.middle() + random.direction() * random.uniform(0, box.half() * 1.2));
  }
  path.resize(std::size_t(ticks));
  return path;
}

Path passes(const Scene& scene, int ticks, std::uint64_t seed) {
  Random random(seed ^ 0xdecade);
  const Box box = boxOf(scene);
  const double half = box.half() + 1;
  Path path;
  while (int(path.size()) < ticks) {
    const Vec3 direction = random.direction();
    const Vec3 aside = random.direction() * random.uniform(0, 0.6) * half;
    const double step = 0.05 * std::pow(240.0, random.uniform(0, 1));
    for (double t = -half; t < half && int(path.size()) < ticks; t += step)
      path.push_back(box.middle() + aside + direction * t);
  }
  return path;
}

}  // namespace moltact::scenes
