// One mesh of the solvent-accessible surface: closed, a manifold, on the balls; and the god-object on it.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "engine/bench/hip_paths.h"
#include "engine/haptics/sas_mesh/sas_mesh_tracker.h"
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
Shape shapeOf(const SurfaceMesh& mesh, const std::vector<Ball>& balls, double probe, const Vec3& origin) {
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
    for (const Ball& b : balls) gap = std::min(gap, glm::distance(x + origin, b.centre_A) - b.radius_A - probe);
    out.farthest_off = std::max(out.farthest_off, std::abs(gap));
  }
  return out;
}

}  // namespace

TEST_CASE("the mesh of one ball of 3 A has the sphere's volume and area to 1 in 100, less by 4 at half the spacing") {
  const std::vector<Ball> balls{{{0, 0, 0}, 1.6}};
  const auto scene = makeScene(balls);
  const double volume = 4.0 / 3 * std::numbers::pi * 27, area = 4 * std::numbers::pi * 9;
  double before = 0;
  for (const double spacing : {0.5, 0.25, 0.125}) {
    CAPTURE(spacing);
    const Shape s = shapeOf(SurfaceMesh(*scene, 1.4, spacing, Vec3(0)), balls, 1.4, Vec3(0));
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

TEST_CASE("the mesh of two balls has the volume of their union, the lens between them taken off once") {
  const double r = 3.0, d = 2.0;
  const std::vector<Ball> balls{{{0, 0, 0}, 1.6}, {{d, 0, 0}, 1.6}};
  const auto scene = makeScene(balls);
  const double lens = std::numbers::pi * (2 * r - d) * (2 * r - d) * (d * d + 4 * d * r) / (12 * d);
  const Shape s = shapeOf(SurfaceMesh(*scene, 1.4, 0.25, Vec3(0)), balls, 1.4, Vec3(0));
  CHECK(s.volume == doctest::Approx(2 * 4.0 / 3 * std::numbers::pi * 27 - lens).epsilon(0.005));
  CHECK(s.unpaired == 0);
}

TEST_CASE(
    "over every scene and 3000 protein-like balls each edge has two triangles, the other way round, and none is "
    "inner") {
  std::vector<scenes::Scene> all = scenes::all();
  all.push_back({"3000 protein-like", bench::proteinLike(3000, 1)});
  for (const scenes::Scene& scene : all)
    for (const double spacing : {0.5, 0.3}) {
      CAPTURE(scene.name);
      CAPTURE(spacing);
      const auto balls = makeScene(scene.balls);
      const Vec3 origin = glm::round(balls->low_A());
      const SurfaceMesh mesh(*balls, scene.probe_A, spacing, origin);
      const Shape s = shapeOf(mesh, scene.balls, scene.probe_A, origin);
      CHECK(s.unpaired == 0);
      CHECK(s.lost == 0);
      CHECK(s.shortest > 1e-6);
      CHECK(s.farthest_off <= 1.8 * spacing);  // a cell's diagonal
      CHECK(s.volume > 0);
    }
}

TEST_CASE("a ray meets the triangle by the tree as by trying all, over 50 random balls") {
  const scenes::Scene scene = scenes::cluster(50, 3);
  const auto balls = makeScene(scene.balls);
  const SurfaceMesh mesh(*balls, scene.probe_A, 0.5, Vec3(0));
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
    "on one ball of 3 A the SCP on a mesh of 0.25 A lies at most 0.006 A under the sphere, and the force is off by "
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
    SasMeshTracker tracker(makeScene(scene.balls), scene.probe_A, 0.25);
    const test::Judged walk = test::judge(tracker, scene, scenes::walk(scene, 1000, seed++));
    CHECK(walk.both > 600);
    CHECK(walk.off(0.5) <= 0.05);
    CHECK(walk.turn(0.5) <= 5.0);
    CHECK(walk.deepest_A <= 0.25);
    CHECK(tracker.cutShort() == 0);
  }
}
