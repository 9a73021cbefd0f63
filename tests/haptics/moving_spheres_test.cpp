// Spheres that move during contact. Oracles: closed forms, the equilibrium condition, and a brute-force flow with a
// hundred substeps per tick.
#include <doctest/doctest.h>

#include <limits>
#include <memory>
#include <vector>

#include "engine/bench/oracle.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/methods.h"
#include "engine/haptics/sphere_motion.h"
#include "tests/haptics/walk.h"

using namespace moltact;
using test::makeScene;

namespace {

using Frames = std::vector<std::unique_ptr<const SphereMotion>>;

std::unique_ptr<const SphereMotion> frame(const std::vector<Sphere>& from, const std::vector<Sphere>& to,
                                          int ticks = 33) {
  auto made = SphereMotion::make(from, to, ticks);
  REQUIRE(made);
  return *std::move(made);
}

// Frames in which every sphere oscillates in its own direction by up to `way_A`, and its radius by a tenth of that.
Frames shaken(const std::vector<Sphere>& spheres, int count, double way_A, std::uint64_t seed) {
  scenes::Random random(seed);
  std::vector<Vec3> way(spheres.size());
  std::vector<double> phase(spheres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    way[i] = random.direction() * way_A;
    phase[i] = random.uniform(0.0, 6.28);
  }
  const auto at = [&](int k) {
    std::vector<Sphere> out = spheres;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double s = std::sin(phase[i] + 0.4 * k);
      out[i].centre_A += way[i] * s;
      out[i].radius_A *= 1.0 + 0.1 * way_A * s;
    }
    return out;
  };
  Frames out;
  out.push_back(frame(at(0), at(1)));
  for (int k = 1; k < count; ++k) {
    auto next = SphereMotion::after(*out.back(), at(k + 1), 33);
    REQUIRE(next);
    out.push_back(*std::move(next));
  }
  return out;
}

}  // namespace

TEST_CASE("a sphere that moves evenly by 0.02 A a tick under a still HIP carries the SCP as geometry says, to 1e-9 A") {
  const std::vector<Sphere> from{{Vec3(0.0), 1.7}}, to{{Vec3(0.66, 0.1, 0.0), 1.9}};
  const auto moves = frame(from, to);
  ExactTracker tracker(makeScene(from), 1.4);
  tracker.step({Vec3(0, 0, 9)});
  const Vec3 hip(0.2, 0.0, 2.5);
  REQUIRE(tracker.step({hip}).touching());
  REQUIRE(tracker.setMotion(moves.get()));
  for (int tick = 1; tick <= 33; ++tick) {
    tracker.advanceTo(tick / 33.0);
    const Contact c = tracker.step({hip});
    const Sphere sphere = (*moves)[0].at(tick / 33.0);
    REQUIRE(c.feature == Feature::Sphere);
    CHECK(glm::distance(c.scp.A, sphere.centre_A + glm::normalize(hip - sphere.centre_A) * (sphere.radius_A + 1.4)) <
          1e-9);
  }
}

TEST_CASE(
    "two spheres that part by 0.03 A a tick let the SCP sink between them, and let it through where they no longer "
    "meet") {
  // The inflated spheres of radius 3.1 meet while their centres are less than 6.2 A apart.
  const auto pair = [](double apart) {
    return std::vector<Sphere>{{Vec3(-0.5 * apart, 0, 0), 1.7}, {Vec3(0.5 * apart, 0, 0), 1.7}};
  };
  Frames frames;
  frames.push_back(frame(pair(4.0), pair(5.0)));
  for (int k = 2; k <= 4; ++k) frames.push_back(*SphereMotion::after(*frames.back(), pair(4.0 + k), 33));
  ExactTracker tracker(makeScene(pair(4.0)), 1.4);
  tracker.step({Vec3(0, 0, 9)});
  const Vec3 hip(0.0, 0.0, 0.4);
  tracker.step({hip});
  for (int tick = 0; tick < 4 * 33; ++tick) {
    const double fraction = (tick % 33 + 1) / 33.0, apart = 4.0 + (tick + 1) / 33.0;
    if (tick % 33 == 0) tracker.setMotion(frames[std::size_t(tick / 33)].get());
    tracker.advanceTo(fraction);
    const Contact c = tracker.step({hip});
    CAPTURE(apart);
    if (apart < 6.14) {
      REQUIRE(c.feature == Feature::Circle);
      CHECK(glm::distance(c.scp.A, Vec3(0, 0, std::sqrt(3.1 * 3.1 - 0.25 * apart * apart))) < 1e-9);
    } else if (apart > 6.16) {
      REQUIRE(!c.touching());
      CHECK(c.fault == Fault::None);
      CHECK(c.scp.A == hip);
    }
  }
}

TEST_CASE("a sphere that grows over a free HIP by 0.05 A a tick pushes the SCP before it, and is felt") {
  const std::vector<Sphere> from{{Vec3(0.0), 1.0}}, to{{Vec3(0.0), 2.65}};
  const auto grows = frame(from, to);
  ExactTracker tracker(makeScene(from), 1.4);
  const Vec3 hip(0, 0, 3.0);
  REQUIRE(!tracker.step({hip}).touching());
  tracker.setMotion(grows.get());
  for (int tick = 1; tick <= 33; ++tick) {
    tracker.advanceTo(tick / 33.0);
    const Contact c = tracker.step({hip});
    const double radius = 2.4 + 1.65 * tick / 33.0;
    if (radius < 3.0 - 1e-9) CHECK(!c.touching());
    if (radius > 3.0 + 1e-9) {
      REQUIRE(c.touching());
      CHECK(glm::distance(c.scp.A, Vec3(0, 0, radius)) < 1e-9);
    }
  }
}

TEST_CASE(
    "clusters of 12 spheres shaken by 0.6 A: at rest and outside in every tick, and where a flow through every "
    "hundredth "
    "of a tick is") {
  int ticks = 0, agree = 0, touching = 0, closed = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    const scenes::Scene scene = scenes::cluster(12, seed);
    const Frames frames = shaken(scene.spheres, 6, 0.6, seed);
    scenes::Random random(seed + 100);
    const Vec3 direction = random.direction();
    ExactTracker tracker(makeScene(frames[0]->at(0.0)), scene.probe_A);
    tracker.step({direction * 30.0});
    tracker.setMotion(frames[0].get());
    Vec3 at = direction * 30.0;
    const auto flow = [&](const std::vector<Sphere>& spheres, const Vec3& hip) {
      oracle::Oracle finer(spheres, scene.probe_A, false);
      finer.place(at);
      const oracle::Oracle::Answer right = finer.step(hip);
      at = right.scp_A;
      return right.contact;
    };
    bool in_step = true;
    for (std::size_t k = 0; k < frames.size(); ++k) {
      if (k > 0) tracker.setMotion(frames[k].get());
      for (int tick = 1; tick <= 33; ++tick) {
        const double fraction = tick / 33.0, deep = 1.6 - 0.2 * double(k);
        const Vec3 hip = direction * deep + 0.2 * Vec3(std::sin(0.05 * tick), std::cos(0.05 * tick), 0.0);
        tracker.advanceTo(fraction);
        const Contact c = tracker.step({hip});
        const std::vector<Sphere> spheres = frames[k]->at(fraction);
        if (c.fault == Fault::StartedInside) {  // the place has closed over the SCP
          ++closed;
          in_step = false;
          continue;
        }
        ++ticks;
        touching += c.touching();
        REQUIRE(test::deepest_A(spheres, scene.probe_A, c.scp.A) < 1e-9);
        if (c.touching()) CHECK(oracle::atRest(spheres, scene.probe_A, c.scp.A, hip, 1e-6));
        if (!in_step) continue;
        for (int part = 1; part < 100; part += k < 2 ? 1 : 20)
          flow(frames[k]->at(fraction - (1.0 - 0.01 * part) / 33.0), hip);
        const bool contact = flow(spheres, hip);
        // Both rest in the same local minimum of |x - h|, wherever it has moved.
        const bool same = contact == c.touching() && glm::distance(at, c.scp.A) < 1e-6;
        agree += same;
        if (!same) at = c.scp.A;
      }
    }
  }
  MESSAGE(ticks, " ticks, ", touching, " in contact, ", agree, " where the finer flow is, ", closed,
          " after a place had closed");
  CHECK(touching > 1000);
  CHECK(agree > 0.99 * ticks);
}

TEST_CASE("a frame that continues from the last one gives what one made again gives: the same contacts in every tick") {
  const scenes::Scene scene = scenes::cluster(60, 5);
  const Frames frames = shaken(scene.spheres, 12, 0.5, 5);
  ExactTracker kept(makeScene(frames[0]->at(0.0)), 1.4), anew(makeScene(frames[0]->at(0.0)), 1.4);
  Frames copies;
  for (const auto& f : frames) copies.push_back(frame(f->at(0.0), f->at(1.0)));
  for (ExactTracker* t : {&kept, &anew}) t->step({Vec3(0, 0, 30)});
  int touching = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    kept.setMotion(frames[k].get());
    anew.setMotion(copies[k].get());
    for (int tick = 1; tick <= 33; ++tick) {
      const Vec3 hip(0.03 * (33.0 * double(k) + tick) - 6.0, 0.3, 4.0);
      kept.advanceTo(tick / 33.0);
      anew.advanceTo(tick / 33.0);
      const Contact a = kept.step({hip}), b = anew.step({hip});
      touching += a.touching();
      REQUIRE(a.feature == b.feature);
      REQUIRE(glm::distance(a.scp.A, b.scp.A) < 1e-9);
    }
  }
  CHECK(touching > 200);
}

TEST_CASE("a sphere that leaps by 3 A within a tick over the hand ends in a contact outside it, or in none at all") {
  const std::vector<Sphere> from{{Vec3(0.0), 1.7}, {Vec3(0, 0, 9), 1.7}}, to{{Vec3(0.0), 1.7}, {Vec3(0, 0, 6), 1.7}};
  const auto leaps = frame(from, to, 1);
  for (const std::string_view name : {"exact", "mesh960", "penalty"}) {
    CAPTURE(name);
    const auto tracker = findMethod(name)->make(makeScene(from), 1.4);
    tracker->step({Vec3(20, 0, 0)});
    const Vec3 hip(0, 0.5, 3.0);
    tracker->step({hip});
    REQUIRE(tracker->setMotion(leaps.get()));
    tracker->advanceTo(1.0);
    const Contact c = tracker->step({hip});
    CHECK(finite(c.scp.A));
    if (c.touching() && name != "penalty") CHECK(test::deepest_A(leaps->at(1.0), 1.4, c.scp.A) < 0.01);
  }
}

TEST_CASE(
    "every method says whether it follows: exact, penalty and the meshes of single spheres do, and continue with the "
    "spheres "
    "of the frame") {
  const std::vector<Sphere> from{{Vec3(0.0), 1.7}}, to{{Vec3(0, 0, 1.0), 1.7}};
  const auto moves = frame(from, to);
  for (const Method& method : methods()) {
    CAPTURE(method.name);
    const auto tracker = method.make(makeScene(from), 1.4);
    tracker->step({Vec3(0, 0, 9)});
    const bool follows = tracker->setMotion(moves.get());
    CHECK(follows == method.follows_motion);
    tracker->advanceTo(1.0);
    Contact c;
    for (double z = 9.0; z > 3.5; z -= 0.02) c = tracker->step({Vec3(0, 0, z)});
    CHECK(c.touching() == follows);
  }
}

TEST_CASE("a frame that cannot be is refused with what is wrong: another count, no number, no radius, no ticks") {
  const std::vector<Sphere> one{{Vec3(0.0), 1.7}}, two{{Vec3(0.0), 1.7}, {Vec3(1.0), 1.7}};
  CHECK(SphereMotion::make(one, two, 33).problem().message == "a motion begins with 1 spheres and ends with 2");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(SphereMotion::make(one, std::vector<Sphere>{{Vec3(0, nan, 0), 1.7}}, 33));
  CHECK_FALSE(SphereMotion::make(one, std::vector<Sphere>{{Vec3(0.0), -1.0}}, 33));
  CHECK_FALSE(SphereMotion::make(one, std::vector<Sphere>{{Vec3(1e10, 0, 0), 1.0}}, 33));
  CHECK_FALSE(SphereMotion::make(one, one, 0));
  CHECK(SphereMotion::make(one, one, 1));
}
