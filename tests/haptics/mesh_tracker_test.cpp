// The god-object on triangles against the closed forms of its mesh, against the oracle within the mesh's accuracy, and
// in the failures caused by facets.
#include "engine/haptics/mesh/mesh_tracker.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/haptics/judge.h"
#include "tests/haptics/walk.h"

using namespace moltact;
using test::makeScene;
using test::walkTo;

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kCounts[] = {80, 320, 960, 1280, 5120};

MeshTracker make(const std::vector<Sphere>& spheres, int triangles, bool smooth = false, bool coherent = true) {
  return MeshTracker(makeScene(spheres), 1.4, {triangles, smooth, coherent});
}

double angle(const Vec3& a, const Vec3& b) {
  return std::acos(std::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0, 1.0));
}

}  // namespace

TEST_CASE("a mesh of 80 to 5120 triangles is closed, convex, and has all its corners on the sphere") {
  for (const int count : kCounts) {
    CAPTURE(count);
    const auto mesh = SphereMesh::ofTriangles(count);
    REQUIRE(mesh->faces().size() == std::size_t(count));
    CHECK(mesh->vertices().size() == std::size_t(count / 2 + 2));  // Euler: V - 3/2 F + F = 2
    double volume = 0, off_sphere = 0, over = -1;
    bool paired = true;
    for (std::size_t f = 0; f < mesh->faces().size(); ++f) {
      const SphereMesh::Face& face = mesh->faces()[f];
      const Vec3 &a = mesh->vertices()[std::size_t(face.corners[0])],
                 &b = mesh->vertices()[std::size_t(face.corners[1])],
                 &c = mesh->vertices()[std::size_t(face.corners[2])];
      volume += glm::dot(a, glm::cross(b, c)) / 6.0;
      for (const std::int32_t other : face.across) {
        const auto& back = mesh->faces()[std::size_t(other)].across;
        paired = paired && std::find(back.begin(), back.end(), std::int32_t(f)) != back.end();
      }
      for (const Vec3& v : mesh->vertices()) over = std::max(over, glm::dot(face.normal, v) - face.height);
    }
    for (const Vec3& v : mesh->vertices()) off_sphere = std::max(off_sphere, std::abs(glm::length(v) - 1.0));
    CHECK(paired);
    CHECK(off_sphere <= 1e-15);
    CHECK(over <= 1e-14);  // convex: no corner lies above any face
    const double whole = 4.0 / 3.0 * std::numbers::pi;
    CHECK(volume < whole);
    CHECK(volume > whole * (1.0 - 3.0 * mesh->sagitta()));
  }
}

TEST_CASE("a ray finds its face by the tree as by trying all 5120") {
  scenes::Random random(4);
  for (const int count : {80, 960, 5120}) {
    const auto mesh = SphereMesh::ofTriangles(count);
    for (int k = 0; k < 300; ++k) {
      const Vec3 u = random.direction();
      const SphereMesh::Face& face = mesh->faces()[std::size_t(mesh->faceToward(u))];
      double reaches = 1e300;  // of a convex mesh the ray leaves through the face that it reaches first
      for (const SphereMesh::Face& f : mesh->faces())
        if (glm::dot(f.normal, u) > 0) reaches = std::min(reaches, f.height / glm::dot(f.normal, u));
      CHECK(face.height / glm::dot(face.normal, u) == doctest::Approx(reaches).epsilon(1e-12));
      CHECK(angle(mesh->faces()[std::size_t(mesh->faceAbout(3.0 * u))].normal, u) <= 12 * kDegree + mesh->maxTilt());
    }
  }
}

TEST_CASE(
    "on one sphere of 3 A the SCP lies on the mesh: never above the sphere, at most a sagitta under it, along "
    "a face's normal") {
  for (const int count : kCounts) {
    CAPTURE(count);
    const auto mesh = SphereMesh::ofTriangles(count);
    MeshTracker tracker = make({{{0, 0, 0}, 1.6}}, count);
    tracker.step({{0, 0, 5}});
    scenes::Random random(9);
    double high = 0, low = 9, tilt = 0, off = 0;
    Vec3 u(0, 0, 1);
    for (int k = 0; k < 3000; ++k) {
      u = glm::normalize(u + 0.05 * random.direction());
      const Vec3 h = 2.4 * u;
      const Contact c = tracker.step({h});
      REQUIRE(c.feature == Feature::Sphere);
      REQUIRE(c.atoms[0] == 0);
      high = std::max(high, glm::length(c.scp.A));
      low = std::min(low, glm::length(c.scp.A));
      tilt = std::max(tilt, angle(c.scp.A - h, c.scp.A));
      const SphereMesh::Face& face = mesh->faces()[std::size_t(mesh->faceToward(c.scp.A))];
      off = std::max(off, std::abs(glm::dot(face.normal, c.scp.A) - 3.0 * face.height));
    }
    CHECK(high <= 3.0 + 1e-12);
    CHECK(low >= 3.0 * (1.0 - mesh->sagitta()) - 1e-12);
    CHECK(off <= 1e-12);
    CHECK(tilt <= mesh->maxTilt() + 1e-9);
    CHECK(tilt >= 0.5 * mesh->maxTilt());
    CHECK(tracker.cutShort() == 0);
  }
}

TEST_CASE("the sagitta falls by about 4 with each subdivision, the tilt of the faces by about 2") {
  const int levels[] = {80, 320, 1280, 5120};
  for (int k = 1; k < 4; ++k) {
    const auto coarse = SphereMesh::ofTriangles(levels[k - 1]), fine = SphereMesh::ofTriangles(levels[k]);
    CHECK(coarse->sagitta() / fine->sagitta() == doctest::Approx(4.0).epsilon(0.15));
    CHECK(coarse->maxTilt() / fine->maxTilt() == doctest::Approx(2.0).epsilon(0.1));
  }
}

TEST_CASE("sliding over one sphere the error of the SCP falls by 3 to 5 with each subdivision") {
  const scenes::Scene scene = scenes::oneSphere();
  const scenes::Path path = scenes::walk(scene, 1500, 7);
  double before = 0;
  for (const int count : {80, 320, 1280, 5120}) {
    CAPTURE(count);
    MeshTracker tracker = make(scene.spheres, count);
    // The depth under the sphere alone: the SCP's place along the surface is off by depth times tilt, which
    // falls by 2.
    double deep = 0;
    int n = 0;
    for (const Vec3& hip : path)
      if (const Contact c = tracker.step({hip}); c.touching()) deep += 3.1 - glm::length(c.scp.A), ++n;
    REQUIRE(n > 500);
    deep /= n;
    if (before > 0) CHECK((before / deep > 3.0 && before / deep < 5.0));
    before = deep;
  }
}

TEST_CASE(
    "over every scene 960 triangles keep the SCP outside all meshes, and off by less than 0.1 A and 10 "
    "degrees in 9 of 10 ticks") {
  const double sagitta = SphereMesh::ofTriangles(960)->sagitta();
  std::uint64_t seed = 300;
  for (const scenes::Scene& scene : scenes::all()) {
    CAPTURE(scene.name);
    CAPTURE(seed);
    double largest = 0;
    for (const Sphere& b : scene.spheres) largest = std::max(largest, b.radius_A + scene.probe_A);
    MeshTracker tracker(makeScene(scene.spheres), scene.probe_A, {960, false, true});
    const test::Judged walk = test::judge(tracker, scene, scenes::walk(scene, 1000, seed));
    CHECK(walk.both > 700);
    CHECK(walk.lost == 0);
    CHECK(walk.off(0.9) <= 0.1);
    CHECK(walk.turn(0.9) <= 10.0);
    tracker.reset();
    const test::Judged passes = test::judge(tracker, scene, scenes::passes(scene, 400, seed++));
    CHECK(std::max(walk.deepest_A, passes.deepest_A) <= largest * sagitta + 1e-9);
    CHECK(tracker.cutShort() == 0);
  }
}

TEST_CASE(
    "what is remembered from tick to tick, on faces, seams and points, changes no place by one bit in 60 000 ticks") {
  std::uint64_t seed = 400;
  int on_points = 0;
  for (const int triangles : {80, 960, 5120})
    for (const scenes::Scene& scene :
         {scenes::bond(), scenes::pit(), scenes::nested(), scenes::cluster(50, 3), scenes::cluster(20, 5)}) {
      CAPTURE(triangles);
      CAPTURE(scene.name);
      CAPTURE(seed);
      MeshTracker a(makeScene(scene.spheres), scene.probe_A, {triangles, false, true}),
          b(makeScene(scene.spheres), scene.probe_A, {triangles, false, false});
      int different = 0;
      std::array<int, 4> on{};
      for (const Vec3& hip : scenes::walk(scene, 4000, seed++)) {
        const Contact quick = a.step({hip}), slow = b.step({hip});
        different += quick.scp.A != slow.scp.A || quick.atoms != slow.atoms || quick.feature != slow.feature;
        ++on[std::size_t(quick.feature)];
      }
      CHECK(different == 0);
      CHECK(on[1] > 100);
      if (scene.spheres.size() >= 20) {
        CHECK(on[2] > 100);
        on_points += on[3];
      }
    }
  CHECK(on_points > 500);
}

TEST_CASE("where two meshes cross two faces hold the SCP, in the pit of three spheres three") {
  const std::vector<Sphere> two{{{-1, 0, 0}, 1.6}, {{1, 0, 0}, 1.6}};
  MeshTracker crease = make(two, 5120);
  const Contact c = walkTo(crease, {0.01, 0.02, 6}, {0.05, 0.02, 2.0}, 0.01);
  CHECK(c.feature == Feature::Circle);
  CHECK(c.atoms == std::array<std::int32_t, 3>{0, 1, -1});
  CHECK(glm::distance(c.scp.A, {0, 0.02 * std::sqrt(2.0), std::sqrt(8.0)}) <= 0.06);
  const double d = 2.0;
  MeshTracker pit = make({{{0, 0, 0}, 1.6}, {{d, 0, 0}, 1.6}, {{d / 2, d * std::sqrt(3.0) / 2, 0}, 1.6}}, 5120);
  const Vec3 foot(d / 2, d * std::sqrt(3.0) / 6, 0);
  const Contact p = walkTo(pit, foot + Vec3(0.02, 0.01, 5), foot + Vec3(0.02, 0.01, 1.5), 0.02);
  CHECK(p.feature == Feature::Point);
  CHECK(p.atoms == std::array<std::int32_t, 3>{0, 1, 2});
  CHECK(glm::distance(p.scp.A, foot + Vec3(0, 0, std::sqrt(9.0 - d * d / 3.0))) <= 0.05);
}

TEST_CASE(
    "when the probe swells by 1 A in one call the SCP is carried out with the mesh, and falls back when it "
    "shrinks") {
  MeshTracker tracker = make({{{0, 0, 0}, 1.6}}, 1280);
  const double sagitta = SphereMesh::ofTriangles(1280)->sagitta();
  walkTo(tracker, {0.1, 0.2, 5}, {0.1, 0.2, 2}, 0.1);
  for (const double probe : {2.4, 1.4, 0.9}) {
    tracker.setProbe(probe);
    const Contact c = tracker.step({{0.1, 0.2, 2}});
    const double r = 1.6 + probe;
    CHECK(c.touching());
    CHECK(glm::length(c.scp.A) <= r + 1e-9);
    CHECK(glm::length(c.scp.A) >= r * (1 - sagitta) - 1e-9);
  }
}

TEST_CASE("changing the probe every tick over 50 random spheres never puts the SCP deeper than the sagitta in any") {
  const scenes::Scene scene = scenes::cluster(50, 3);
  MeshTracker tracker(makeScene(scene.spheres), 1.4, {960, false, true});
  const double sagitta = SphereMesh::ofTriangles(960)->sagitta();
  double probe = 1.4, over = -1;
  int k = 0, touching = 0;
  for (const Vec3& hip : scenes::walk(scene, 3000, 12)) {
    tracker.setProbe(probe = 1.4 + 0.3 * std::sin(0.02 * k++));
    const Contact c = tracker.step({hip});
    touching += c.touching();
    if (c.touching()) over = std::max(over, oracle::deepest(scene.spheres, probe, c.scp.A) - (2.0 + probe) * sagitta);
  }
  CHECK(touching > 1500);
  CHECK(over <= 1e-9);
}

TEST_CASE(
    "known failure: over one sphere the force of 80, 960 and 5120 flat triangles leaps by more than 15, 6 and "
    "3 degrees in a step of 0.02 A") {
  const auto worst = [](int count, bool smooth) {
    MeshTracker tracker = make({{{0, 0, 0}, 1.6}}, count, smooth);
    tracker.step({{0, 0, 5}});
    double leap = 0;
    Vec3 last(0.0);
    for (int k = 0; k < 2000; ++k) {  // a great circle oblique to the mesh
      const double t = 0.02 / 2.4 * k;
      const Vec3 h = 2.4 * (Vec3(0.36, 0.48, 0.8) * std::cos(t) + Vec3(0.8, -0.6, 0.0) * std::sin(t));
      const Contact c = tracker.step({h});
      const Vec3 force = c.displacement_A;
      if (k > 0) leap = std::max(leap, angle(force, last));
      last = force;
    }
    return leap / kDegree;
  };
  CHECK(worst(80, false) > 15);
  CHECK(worst(960, false) > 6);
  CHECK(worst(5120, false) > 3);
  // The true surface turns by 0.48 degrees a step; force shading comes near it except where the SCP leaps
  // over an edge.
  CHECK(worst(960, true) < 0.5 * worst(960, false));
}

TEST_CASE(
    "with force shading on one sphere the force points along the sphere's own normal at the SCP, as long as "
    "the depth") {
  MeshTracker tracker = make({{{1, 2, 3}, 1.6}}, 960, true);
  const Contact c = walkTo(tracker, {1.3, 2.2, 8}, {1.3, 2.2, 5}, 0.05);
  CHECK(angle(c.displacement_A, c.scp.A - Vec3(1, 2, 3)) <= 1e-7);
  CHECK(glm::length(c.displacement_A) == doctest::Approx(glm::distance(c.scp.A, {1.3, 2.2, 5})));
}

TEST_CASE(
    "known failure: a HIP pressed through the centre within a facet's width stays held on the far side, "
    "where a sphere lets it round") {
  MeshTracker tracker = make({{{0, 0, 0}, 1.6}}, 80);
  const SphereMesh::Face& face = SphereMesh::ofTriangles(80)->faces()[0];
  const Vec3 aside = 0.1 * face.out[0];
  const Contact c = walkTo(tracker, 5.0 * face.normal + aside, -4.0 * face.normal + aside, 0.02);
  CHECK(c.touching());  // the HIP has come out on the other side by now
  CHECK(glm::dot(c.scp.A, face.normal) > 2.5);
}

TEST_CASE(
    "known failure: 80 triangles a sphere open a ring, askew to the mesh, whose hole is 0.01 A too small for "
    "the probe") {
  scenes::Scene scene = scenes::ring(12, -0.01);
  const Vec3 axis = glm::normalize(Vec3(1, 2, 3)), x = glm::normalize(glm::cross(axis, Vec3(0, 0, 1))),
             y = glm::cross(axis, x);
  for (Sphere& b : scene.spheres) b.centre_A = x * b.centre_A.x + y * b.centre_A.y;
  const Vec3 from = 6.0 * axis + 0.02 * x, to = -6.0 * axis + 0.02 * x;
  MeshTracker coarse(makeScene(scene.spheres), scene.probe_A, {80, false, true}),
      fine(makeScene(scene.spheres), scene.probe_A, {5120, false, true});
  CHECK_FALSE(walkTo(coarse, from, to, 0.02).touching());
  CHECK(walkTo(fine, from, to, 0.02).touching());
}
