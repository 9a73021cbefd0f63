// A mesh of the solvent-accessible surface: closed, a manifold, with vertices on the spheres; and the god-object on it.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "engine/bench/hip_paths.h"
#include "engine/bench/methods/sas_mesh_tracker.h"
#include "engine/haptics/exact/exact_tracker.h"
#include "tests/haptics/judge.h"
#include "tests/haptics/walk.h"

using namespace moltact;
using test::makeScene;
using test::walkTo;

namespace {

struct Shape {
  double volume = 0, area = 0, farthest_off = 0, shortest = 1e300;
  int unpaired = 0, lost = 0;
};

// By brute force over the list of triangles.
Shape shapeOf(const SurfaceMesh& mesh, const std::vector<Sphere>& spheres, double probe, const Vec3& origin) {
  Shape out;
  std::map<std::pair<std::int32_t, std::int32_t>, std::pair<int, std::int32_t>> sides;
  const auto& v = mesh.vertices();
  for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
    const auto& c = mesh.triangles()[k].corners;
    const Vec3 &p = v[std::size_t(c[0])], &q = v[std::size_t(c[1])], &r = v[std::size_t(c[2])];
    out.volume += glm::dot(p, glm::cross(q, r)) / 6;
    out.area += 0.5 * glm::length(glm::cross(q - p, r - p));
    for (std::size_t e = 0; e < 3; ++e) {
      auto& side = sides[{c[e], c[(e + 1) % 3]}];
      ++side.first, side.second = std::int32_t(k);
      out.shortest = std::min(out.shortest, glm::distance(v[std::size_t(c[e])], v[std::size_t(c[(e + 1) % 3])]));
    }
  }
  for (const auto& [corners, side] : sides) {
    const auto back = sides.find({corners.second, corners.first});
    if (side.first != 1 || back == sides.end()) {
      ++out.unpaired;
      continue;
    }
    const auto& across = mesh.triangles()[std::size_t(side.second)].across;
    out.lost += std::find(across.begin(), across.end(), back->second.second) == across.end();
  }
  for (const Vec3& x : v) {
    double gap = 1e300;
    for (const Sphere& b : spheres) gap = std::min(gap, glm::distance(x + origin, b.centre_A) - b.radius_A - probe);
    out.farthest_off = std::max(out.farthest_off, std::abs(gap));
  }
  return out;
}

}  // namespace

TEST_CASE("the mesh of one sphere of 3 A has the sphere's volume and area to 1 in 100, less by 4 at half the spacing") {
  const std::vector<Sphere> spheres{{{0, 0, 0}, 1.6}};
  const auto scene = makeScene(spheres);
  const double volume = 4.0 / 3 * std::numbers::pi * 27, area = 4 * std::numbers::pi * 9;
  double before = 0;
  for (const double spacing : {0.5, 0.25, 0.125}) {
    CAPTURE(spacing);
    const Shape s = shapeOf(SurfaceMesh(*scene, 1.4, spacing, Vec3(0)), spheres, 1.4, Vec3(0));
    CHECK(s.unpaired == 0);
    CHECK(s.lost == 0);
    CHECK(s.farthest_off <= 0.02 * spacing);
    CHECK(s.volume < volume);
    CHECK(s.area < area);
    CHECK(s.volume == doctest::Approx(volume).epsilon(0.03 * spacing));
    CHECK(s.area == doctest::Approx(area).epsilon(0.03 * spacing));
    if (before > 0) CHECK(before / (volume - s.volume) == doctest::Approx(4).epsilon(0.2));
    before = volume - s.volume;
  }
}

TEST_CASE("the mesh of two spheres has the volume of their union, the lens between them taken off once") {
  const double r = 3.0, d = 2.0;
  const std::vector<Sphere> spheres{{{0, 0, 0}, 1.6}, {{d, 0, 0}, 1.6}};
  const auto scene = makeScene(spheres);
  const double lens = std::numbers::pi * (2 * r - d) * (2 * r - d) * (d * d + 4 * d * r) / (12 * d);
  const Shape s = shapeOf(SurfaceMesh(*scene, 1.4, 0.25, Vec3(0)), spheres, 1.4, Vec3(0));
  CHECK(s.volume == doctest::Approx(2 * 4.0 / 3 * std::numbers::pi * 27 - lens).epsilon(0.005));
  CHECK(s.unpaired == 0);
}

TEST_CASE(
    "over every scene and 3000 protein-like spheres each edge has two triangles, the other way round, and none is "
    "inner") {
  std::vector<scenes::Scene> all = scenes::all();
  all.push_back({"3000 protein-like", bench::proteinLike(3000, 1)});
  for (const scenes::Scene& scene : all)
    for (const double spacing : {0.5, 0.3}) {
      CAPTURE(scene.name);
      CAPTURE(spacing);
      const auto spheres = makeScene(scene.spheres);
      const Vec3 origin = glm::round(spheres->low_A());
      const SurfaceMesh mesh(*spheres, scene.probe_A, spacing, origin);
      const Shape s = shapeOf(mesh, scene.spheres, scene.probe_A, origin);
      CHECK(s.unpaired == 0);
      CHECK(s.lost == 0);
      CHECK(s.shortest > 1e-6);
      CHECK(s.farthest_off <= 1.8 * spacing);  // a cell's diagonal
      CHECK(s.volume > 0);
    }
}

TEST_CASE("a ray meets the triangle by the tree as by trying all, over 50 random spheres") {
  const scenes::Scene scene = scenes::cluster(50, 3);
  const auto spheres = makeScene(scene.spheres);
  const SurfaceMesh mesh(*spheres, scene.probe_A, 0.5, Vec3(0));
  scenes::Random random(6);
  int hits = 0;
  for (int k = 0; k < 300; ++k) {
    const Vec3 from = 20.0 * random.direction(), way = 8.0 * random.direction() - from;
    double least = 1.0;
    for (std::size_t f = 0; f < mesh.triangles().size(); ++f) {
      const SurfaceMesh::Plane p = mesh.plane(std::int32_t(f));
      const double falls = -glm::dot(p.normal, way);
      if (falls <= 0) continue;
      const double t = (glm::dot(p.normal, from) - p.height) / falls;
      if (t < 0 || t >= least) continue;
      const Vec3 x = from + t * way;
      if (glm::dot(p.out[0], x) <= p.reach[0] && glm::dot(p.out[1], x) <= p.reach[1] &&
          glm::dot(p.out[2], x) <= p.reach[2])
        least = t;
    }
    const SurfaceMesh::Hit hit = mesh.cast(from, way);
    CHECK((hit.triangle >= 0) == (least < 1.0));
    if (hit.triangle >= 0) CHECK(hit.t == doctest::Approx(least).epsilon(1e-9));
    hits += hit.triangle >= 0;
  }
  CHECK(hits > 30);
}

TEST_CASE(
    "on one sphere of 3 A the SCP on a mesh of 0.25 A lies at most 0.006 A under the sphere, and the force is off by "
    "less than 8 degrees") {
  SasMeshTracker tracker(makeScene({{{0, 0, 0}, 1.6}}), 1.4, 0.25);
  tracker.step({{0, 0, 5}});
  scenes::Random random(9);
  double high = 0, low = 9, tilt = 0;
  Vec3 u(0, 0, 1);
  for (int k = 0; k < 3000; ++k) {
    u = glm::normalize(u + 0.05 * random.direction());
    const Contact c = tracker.step({2.4 * u});
    REQUIRE(c.touching());
    CHECK(c.atoms[0] == 0);
    high = std::max(high, glm::length(c.scp.A));
    low = std::min(low, glm::length(c.scp.A));
    tilt = std::max(tilt, std::acos(glm::dot(glm::normalize(c.scp.A - 2.4 * u), u)) * 180 / std::numbers::pi);
  }
  CHECK(high <= 3.0 + 1e-9);
  CHECK(low >= 3.0 - 0.006);
  CHECK(tilt < 8);
  CHECK(tracker.cutShort() == 0);
}

TEST_CASE(
    "over every scene the SCP on a mesh of 0.25 A is off by less than 0.05 A in half the ticks, and always comes to "
    "rest") {
  std::uint64_t seed = 700;
  for (const scenes::Scene& scene : scenes::all()) {
    CAPTURE(scene.name);
    CAPTURE(seed);
    SasMeshTracker tracker(makeScene(scene.spheres), scene.probe_A, 0.25);
    const test::Judged walk = test::judge(tracker, scene, scenes::walk(scene, 1000, seed++));
    CHECK(walk.both > 600);
    CHECK(walk.off(0.5) <= 0.05);
    CHECK(walk.turn(0.5) <= 5.0);
    CHECK(walk.deepest_A <= 0.25);
    CHECK(tracker.cutShort() == 0);
  }
}

TEST_CASE(
    "known failure: a HIP that turns 1 A deep under one sphere by 0.03 degrees a tick: at a facet's edge the SCP leaps "
    "by 0.05 A and more, the force by 3 degrees") {
  SasMeshTracker mesh(makeScene({{{0, 0, 0}, 1.6}}), 1.4, 0.25);
  ExactTracker exact(makeScene({{{0, 0, 0}, 1.6}}), 1.4);
  const auto most = [](Tracker& tracker) {
    tracker.step({{0, 0, 5}});
    Vec3 scp_before(0), force_before(0);
    double leap = 0, turn = 0;
    for (int k = 0; k <= 2000; ++k) {
      const double angle = 0.0005 * k;
      const Vec3 hip = 2.0 * Vec3(0.8 * std::sin(angle), 0.6 * std::sin(angle), std::cos(angle));
      const Vec3 scp = tracker.step({hip}).scp.A, force = glm::normalize(scp - hip);
      if (k > 0) {
        leap = std::max(leap, glm::distance(scp, scp_before));
        turn = std::max(turn, std::acos(std::min(1.0, glm::dot(force, force_before))) * 180 / std::numbers::pi);
      }
      scp_before = scp, force_before = force;
    }
    return std::pair(leap, turn);
  };
  const auto [leap, turn] = most(mesh);
  CHECK(leap > 0.05);
  CHECK(turn > 3);
  const auto [true_leap, true_turn] = most(exact);
  CHECK(true_leap == doctest::Approx(3 * 0.0005).epsilon(1e-3));
  CHECK(true_turn < 0.04);
}

TEST_CASE(
    "known failure: a gap of 0.04 A between two spheres is closed by a mesh of 0.25 A, and a sphere of 0.1 A is "
    "missed") {
  int closed = 0, missed = 0;
  for (int k = 0; k < 10; ++k) {
    CAPTURE(k);
    const double shift = 0.025 * k;  // against the grid
    const std::vector<Sphere> gap{{{shift - 3.02, 0, 0}, 1.6}, {{shift + 3.02, 0, 0}, 1.6}},
        small{{{shift, 0, 0}, 0.1}, {{shift, 6, 0}, 1.6}};
    const Vec3 from(shift, 0, 4), to(shift, 0, -0.05);
    SasMeshTracker mesh_gap(makeScene(gap), 1.4, 0.25), mesh_small(makeScene(small), 0.0, 0.25);
    ExactTracker exact_gap(makeScene(gap), 1.4), exact_small(makeScene(small), 0.0);
    closed += walkTo(mesh_gap, from, to, 0.02).touching();
    CHECK_FALSE(walkTo(exact_gap, from, to, 0.02).touching());
    missed += !walkTo(mesh_small, from, to, 0.02).touching();
    CHECK(walkTo(exact_small, from, to, 0.02).touching());
  }
  CHECK(closed == 10);
  CHECK(missed == 10);
}
