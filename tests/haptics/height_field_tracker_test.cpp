// Oracles: closed forms, and the nearest points of triangles found one by one.
#include "engine/haptics/height_field/height_field_tracker.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/bench/scenes.h"
#include "engine/haptics/height_field/scanning_tip.h"

using namespace moltact;

namespace {

std::shared_ptr<HeightField> fieldOf(int columns, int rows, double spacing_A,
                                     const std::function<double(double, double)>& height, ScanFrame frame = {}) {
  auto out = std::make_shared<HeightField>();
  out->frame = frame;
  out->columns = columns;
  out->rows = rows;
  out->spacing_A = spacing_A;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      out->heights_A.push_back(height(spacing_A * column, spacing_A * row));
  out->atoms.assign(out->heights_A.size(), 3);
  return out;
}

// The point of a triangle nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
Vec3 nearestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap), d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp),
               d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return a;
  if (d3 >= 0 && d4 <= d3) return b;
  if (const double vc = d1 * d4 - d3 * d2; vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
  if (d6 >= 0 && d5 <= d6) return c;
  if (const double vb = d5 * d2 - d1 * d6; vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  return a + ab * (vb / (va + vb + vc)) + ac * (vc / (va + vb + vc));
}

// Calls visit(nearest point to p) for each triangle of the raster that is within `within` of `at`.
template <class Visit>
void eachNearest(const HeightField& f, const Vec3& p, const Vec3& at, double within, Visit&& visit) {
  const auto node = [&](int c, int r) { return Vec3(f.spacing_A * c, f.spacing_A * r, f.at(c, r)); };
  for (int r = 0; r + 1 < f.rows; ++r)
    for (int c = 0; c + 1 < f.columns; ++c)
      for (int half = 0; half < 2; ++half) {
        const Vec3 a = node(c, r), b = half ? node(c + 1, r + 1) : node(c + 1, r),
                   d = half ? node(c, r + 1) : node(c + 1, r + 1);
        if (glm::distance(nearestOnTriangle(at, a, b, d), at) <= within) visit(nearestOnTriangle(p, a, b, d));
      }
}

}  // namespace

TEST_CASE("over a plane of any slope the SCP is the foot of the HIP to 1e-12 A, and the force its normal") {
  scenes::Random random(3);
  for (int round = 0; round < 20; ++round) {
    const double a = random.uniform(-2, 2), b = random.uniform(-2, 2);
    const ScanFrame frame{random.direction() * 40.0, glm::angleAxis(random.uniform(0, 3), random.direction())};
    const auto field = fieldOf(
        41, 41, 0.5, [&](double x, double y) { return a * x + b * y; }, frame);
    HeightFieldTracker tracker(field);
    const Vec3 normal = glm::normalize(Vec3(-a, -b, 1));
    CHECK_FALSE(tracker.step({frame.toMolecule(Vec3(10, 10, 10 * a + 10 * b) + 3.0 * normal)}).touching());
    for (int k = 0; k < 50; ++k) {
      const double x = random.uniform(5, 15), y = random.uniform(5, 15), deep = random.uniform(0.01, 2);
      const Vec3 foot(x, y, a * x + b * y);
      const Contact c = tracker.step({frame.toMolecule(foot - deep * normal)});
      REQUIRE(c.touching());
      CHECK(glm::distance(c.scp.A, frame.toMolecule(foot)) < 1e-12 * 100);
      CHECK(glm::distance(c.displacement_A, frame.orientation * (deep * normal)) < 1e-10);
      CHECK(glm::distance(c.normals[0], frame.orientation * normal) < 1e-10);
      CHECK(c.atoms[0] == 3);
    }
    CHECK_FALSE(tracker.step({frame.toMolecule(Vec3(10, 10, 10 * a + 10 * b) + 0.01 * normal)}).touching());
    CHECK(tracker.cutShort() == 0);
  }
}

TEST_CASE("in a valley of two planes the SCP lies in the crease; on a ridge it stays on the side from which it came") {
  const auto valley = fieldOf(21, 21, 1.0, [](double x, double) { return std::abs(x - 10); });
  HeightFieldTracker in(valley);
  in.step({{10.3, 8.3, 5}});
  const Contact crease = in.step({{10.4, 8.7, -2}});
  CHECK(glm::distance(crease.scp.A, Vec3(10, 8.7, 0)) < 1e-12);
  CHECK(in.step({{12, 8.7, 3}}).scp.A == Vec3(12, 8.7, 3));  // out again, over the slope of 45 degrees

  const auto ridge = fieldOf(21, 21, 1.0, [](double x, double) { return 10 - std::abs(x - 10); });
  for (const double side : {-1.0, 1.0}) {
    HeightFieldTracker on(ridge);
    on.step({{10 + side * 2, 8.3, 12}});
    on.step({{10 + side * 2, 8.3, 8 - 0.5}});
    // Pushed under the ridge it climbs its own slope, and leaves over the top where the HIP is outside.
    const Contact under = on.step({{10 - side * 1.5, 8.3, 8}});
    CHECK(glm::distance(under.scp.A, Vec3(10 + side * 0.25, 8.3, 9.75)) < 1e-12);
    CHECK_FALSE(on.step({{10 - side * 1.5, 8.3, 8.6}}).touching());
  }
}

TEST_CASE(
    "0.3 A under the scan of an atom the SCP is as near as the nearest point of all triangles to 0.0001 A, and within "
    "0.001 A of the cap of radius R + r") {
  auto tip = ScanningTip::over(std::vector<Sphere>{{{0, 0, 0}, 1.7}}, {.tip_A = 5, .spacing_A = 0.1, .margin_A = 3});
  REQUIRE(tip);
  tip->scanAll();
  const auto field = std::make_shared<const HeightField>(tip->field());
  HeightFieldTracker tracker(field);
  tracker.step({{0, 0, 4}});
  const Vec3 centre(0, 0, -5);  // of the apex's cap
  scenes::Random random(5);
  for (int k = 0; k < 100; ++k) {
    const double tilt = random.uniform(0, 0.5), round = random.uniform(0, kTwoPi);
    const Vec3 way(std::sin(tilt) * std::cos(round), std::sin(tilt) * std::sin(round), std::cos(tilt));
    const Vec3 hip = centre + 6.4 * way;
    const Contact c = tracker.step({hip});
    REQUIRE(c.touching());
    double nearest = 1e9;
    const Vec3 local = field->frame.toScan(hip);
    eachNearest(*field, local, local, 1e9,
                [&](const Vec3& p) { nearest = std::min(nearest, glm::distance(p, local)); });
    CHECK(std::abs(glm::length(c.displacement_A) - nearest) < 1e-4);  // every facet of a cap has a foot
    CHECK(std::abs(glm::distance(c.scp.A, centre) - 6.7) < 1e-3);
    CHECK(c.atoms[0] == 0);
  }
}

TEST_CASE(
    "over five rough fields, in 4000 ticks of slow and fast motion each, the SCP is never under the surface, no point "
    "of "
    "the triangles at it is nearer to the HIP, and a HIP under the surface always touches") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    scenes::Random random(seed);
    const double rough = random.uniform(0.3, 3.0);
    const auto field = fieldOf(30, 24, 0.8, [&](double, double) { return random.uniform(0, rough); });
    HeightFieldTracker tracker(field);
    Vec3 h(12, 9, 8);
    tracker.step({h});
    int under = 0, nearer = 0, missed = 0, floating = 0, touching = 0;
    Vec3 target = h;
    for (int k = 0; k < 4000; ++k) {
      if (k % 40 == 0) target = {random.uniform(2, 21), random.uniform(2, 16), random.uniform(-3, rough + 2)};
      const double step = k % 400 < 300 ? 0.05 : 12.0;
      const Vec3 to_go = target - h;
      if (glm::length(to_go) > 0) h += to_go * std::min(1.0, step / glm::length(to_go));
      const Contact c = tracker.step({h});
      const double height = tracker.heightAt(c.scp.A.x, c.scp.A.y);
      under += c.scp.A.z < height - 1e-8;
      missed += !c.touching() && h.z < tracker.heightAt(h.x, h.y) - 1e-8;
      if (!c.touching()) continue;
      ++touching;
      floating += c.scp.A.z > height + 1e-8;
      const double far = glm::distance(c.scp.A, h);
      double nearest = far;
      eachNearest(*field, h, c.scp.A, 1e-9, [&](const Vec3& p) { nearest = std::min(nearest, glm::distance(p, h)); });
      nearer += nearest < far - 1e-7;
    }
    CHECK(touching > 1500);
    CHECK(under == 0);
    CHECK(missed == 0);
    CHECK(floating == 0);
    CHECK(nearer == 0);
    CHECK(tracker.cutShort() == 0);
  }
}

TEST_CASE(
    "a HIP that jumps through a wall one cell thick in one tick is held before it, at any of 200 speeds and heights") {
  const auto wall = fieldOf(41, 11, 0.5, [](double x, double) { return x == 10.0 ? 9.0 : 0.0; });
  scenes::Random random(9);
  for (int k = 0; k < 200; ++k) {
    HeightFieldTracker tracker(wall);
    const double z = random.uniform(0.2, 8), from = random.uniform(1, 9), to = random.uniform(11, 19),
                 y = random.uniform(1, 4);
    tracker.step({{from, y, z}});
    const Contact c = tracker.step({{to, y, z}});
    CHECK(c.touching());
    CHECK(c.scp.A.x <= 10.0);
  }
}

TEST_CASE(
    "beyond its border the surface goes on level for 10 000 A; farther out, and without a field, nothing is felt") {
  const auto field = fieldOf(5, 5, 1.0, [](double x, double) { return x < 4 ? 0.0 : 2.0; });
  HeightFieldTracker tracker(field);
  tracker.step({{500, 2, 5}});
  const Contact beyond = tracker.step({{500, 2, 1}});
  CHECK(glm::distance(beyond.scp.A, Vec3(500, 2, 2)) < 1e-9);
  CHECK_FALSE(tracker.step({{30'000, 2, 1}}).touching());
  CHECK(tracker.step({{500, 2, 1}}).fault == Fault::StartedInside);
  CHECK(tracker.step({{500, std::nan(""), 1}}).fault == Fault::NotFinite);
  HeightFieldTracker none(nullptr);
  CHECK_FALSE(none.step({{0, 0, -5}}).touching());
}

TEST_CASE("a surface that rises over the SCP, free or in contact, carries it up") {
  auto field = fieldOf(11, 11, 1.0, [](double, double) { return 1.0; });
  HeightFieldTracker tracker(field);
  tracker.step({{5, 5, 1.5}});
  std::fill(field->heights_A.begin(), field->heights_A.end(), 2.0);
  tracker.surfaceChanged(0.0);
  CHECK(tracker.step({{5, 5, 1.5}}).scp.A.z == doctest::Approx(2.0));
  std::fill(field->heights_A.begin(), field->heights_A.end(), 1.0);
  tracker.surfaceChanged(0.25);
  CHECK(tracker.step({{5, 5, 1.0}}).scp.A.z == doctest::Approx(1.25));
}
