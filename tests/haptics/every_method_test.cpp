// The contract of every method: it reports faults, reset() clears all state, results are reproducible, and a tick
// allocates nothing.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <new>
#include <string>

#include "engine/bench/bodies/body_tasks.h"
#include "engine/bench/methods/bench_methods.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/body/rigid_body.h"
#include "engine/haptics/methods.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/haptics/touch_setup.h"
#include "tests/haptics/allocations.h"
#include "tests/haptics/body_paths.h"
#include "tests/haptics/walk.h"

using namespace moltact;
using bench::benchMethods;
using test::makeScene;
using test::walkTo;

namespace {
thread_local long allocated = 0;
}  // namespace

long test::allocations() { return allocated; }

// Replaced for the whole program: plain malloc, and a count.
void* operator new(std::size_t size) {
  ++allocated;
  if (void* p = std::malloc(size ? size : 1)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

TEST_CASE("no method allocates in 3000 ticks of walking, jumping out and changing the probe over 50 random spheres") {
  const scenes::Scene scene = scenes::cluster(50, 3);
  const scenes::Path path = scenes::jumps(scene, 3000, 8);
  for (const Method& method : benchMethods()) {
    CAPTURE(std::string(method.name));
    const auto tracker = method.make(makeScene(scene.spheres), scene.probe_A);
    int touching = 0;
    const long before = test::allocations();
    for (std::size_t k = 0; k < path.size(); ++k) {
      touching += tracker->step({path[k]}).touching();
      if (k % 100 == 99) tracker->setProbe(1.4 + 0.2 * std::sin(0.01 * double(k)));
      if (k % 1000 == 999) tracker->reset();
      tracker->memoryUsage();
    }
    CHECK(test::allocations() == before);
    CHECK(touching > 1000);
  }
}

TEST_CASE(
    "neither an answer nor its reactions allocate, over 2000 poses: each method, and a body of six atoms in both "
    "ways") {
  const scenes::Scene scene = scenes::cluster(50, 3);
  const auto spheres = makeScene(scene.spheres);
  const std::vector<Sphere> atoms{{{0, 0, 0}, 1.7},   {{1.5, 0, 0}, 1.7}, {{3, 0, 0}, 1.7},
                                  {{4.5, 0, 0}, 1.7}, {{6, 0, 0}, 1.7},   {{7.5, 0, 0}, 1.7}};
  const std::vector<std::uint32_t> all{0, 1, 2, 3, 4, 5};
  std::vector<std::unique_ptr<Interaction>> made;
  for (const Method& method : benchMethods()) made.push_back(method.make(spheres, scene.probe_A));
  made.push_back(std::make_unique<RigidBody>(
      heldBody(atoms, all), [&](double radius_A) { return referenceMethod().make(spheres, radius_A); }));
  made.push_back(std::make_unique<ExactBody>(spheres, heldBody(atoms, all)));
  const scenes::Path path = scenes::jumps(scene, 2000, 8);
  for (const auto& felt : made) {
    std::vector<AtomForce> room(felt->maxReactionCount());
    std::size_t count = 0;
    const long before = test::allocations();
    for (const Vec3& place : path) count += felt->reactions(felt->respond({{place}}), 2.0, 1.0, room);
    CHECK(test::allocations() == before);
    CHECK(count > 200);
  }
}

TEST_CASE(
    "the exact body allocates nothing: turned, in spheres that move, with more pairs than its lists hold, and with "
    "5000 "
    "spheres in the hand") {
  const auto free = [](const std::function<void()>& run) {
    const long before = test::allocations();
    run();
    CHECK(test::allocations() == before);
  };
  {
    const auto spheres = scenes::cluster(120, 4).spheres;
    std::vector<Sphere> swollen = spheres;
    for (Sphere& s : swollen) s.radius_A += 0.1;
    const auto body = test::chainBody(12, 4);
    ExactBody felt(makeScene(spheres), body);
    const auto path = test::bodyPath(spheres, body->reach_A, 1500, 4, 0.05, 0.01, 3.0, 97);
    const auto out = SphereMotion::make(spheres, swollen, 50), in = SphereMotion::after(**out, spheres, 50);
    REQUIRE(in);
    std::vector<AtomForce> room(felt.maxReactionCount());
    int pressed = 0, turned = 0;
    free([&] {
      for (std::size_t k = 0; k < path.size(); ++k) {
        if (k % 200 == 100) felt.setMotion(out->get());
        if (k % 200 == 150) felt.setMotion(in->get());
        if (k % 200 >= 100) felt.advanceTo(double(k % 50 + 1) / 50.0);
        if (k % 200 == 199) felt.setMotion(nullptr);
        const Response r = felt.respond(path[k]);
        felt.reactions(r, 1.0, 1.0, room);
        pressed += r.contact.touching(), turned += r.torque_A2 != Vec3(0.0);
      }
    });
    CHECK(pressed > 500);
    CHECK(turned > 500);
  }
  {
    // 300 spheres of the scene, nearly in one place, times 100 of the body.
    scenes::Random random(3);
    std::vector<Sphere> heap, body;
    for (int k = 0; k < 300; ++k) heap.push_back({0.1 * random.direction(), 2.0});
    for (int k = 0; k < 100; ++k) body.push_back({0.1 * random.direction(), 1.0});
    REQUIRE(heap.size() * body.size() > BodyPairs::kMaxFar);
    ExactBody felt(makeScene(heap), bodyOfSpheres(body));
    int pressed = 0;
    free([&] {
      for (int k = 0; k < 2000; ++k) {
        const double t = std::min(k, 300);
        const PoseA hand{{{0, 0.01 * t, 6.0 - 0.02 * t}}, glm::angleAxis(0.01 * t, Vec3(1, 0, 0))};
        pressed += felt.respond(hand).contact.touching();
      }
    });
    CHECK(pressed > 20);
  }
  {
    const auto task = bench::bodyTask("5000", [](const std::string&) -> Expected<Molecule> { return Molecule(); });
    REQUIRE(task);
    ExactBody felt(task->scene, task->body);
    const auto path = bench::pathOf(*task, 1000);
    int pressed = 0;
    free([&] {
      for (const PoseA& hand : path) pressed += felt.respond(hand).contact.touching();
    });
    CHECK(pressed > 500);
  }
}

TEST_CASE("every method gives no contact to a HIP that starts inside until it has been outside once") {
  for (const Method& method : benchMethods()) {
    CAPTURE(std::string(method.name));
    const auto tracker = method.make(makeScene({{{0, 0, 0}, 1.6}, {{2, 0, 0}, 1.6}}), 1.4);
    for (int round = 0; round < 2; ++round) {
      for (int k = 0; k < 4; ++k) {
        const Contact c = tracker->step({{0.1 * k, 0, 0.5}});
        CHECK(c.fault == Fault::StartedInside);
        CHECK_FALSE(c.touching());
      }
      CHECK(tracker->step({{0, 0, 4.5}}).fault == Fault::None);
      CHECK(walkTo(*tracker, {0, 0, 4.5}, {0, 0, 2.2}, 0.05).touching());
      tracker->reset();
    }
  }
}

TEST_CASE("every method refuses NaN, infinity and places beyond 1e9 A, and continues from where it was") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const Method& method : benchMethods()) {
    CAPTURE(std::string(method.name));
    const auto disturbed = method.make(makeScene({{{0, 0, 0}, 1.6}}), 1.4),
               calm = method.make(makeScene({{{0, 0, 0}, 1.6}}), 1.4);
    CHECK(disturbed->step({{0, 0, 6}}).fault == Fault::None);
    CHECK(disturbed->step({{0, nan, 6}}).fault == Fault::NotFinite);  // free, and then touching
    CHECK(disturbed->step({{0, 0, 6}}).fault == Fault::None);
    walkTo(*disturbed, {0, 0, 5}, {0, 0, 2.3}, 0.1);
    walkTo(*calm, {0, 0, 5}, {0, 0, 2.3}, 0.1);
    for (const Vec3& bad : {Vec3(nan, 0, 0), Vec3(0, inf, 0), Vec3(0, 0, -inf), Vec3(0, 2e9, 0)}) {
      const Contact c = disturbed->step({bad});
      CHECK(c.fault == Fault::NotFinite);
      CHECK_FALSE(c.touching());
      CHECK(std::isfinite(c.scp.A.x + c.scp.A.y + c.scp.A.z));
    }
    CHECK(disturbed->step({{0, 0.1, 2.3}}).scp.A == calm->step({{0, 0.1, 2.3}}).scp.A);
  }
}

TEST_CASE("every method repeats a path of 1000 ticks to the last bit") {
  const scenes::Scene scene = scenes::cluster(20, 5);
  const scenes::Path path = scenes::walk(scene, 1000, 5);
  for (const Method& method : benchMethods()) {
    CAPTURE(std::string(method.name));
    const auto shared = makeScene(scene.spheres);
    const auto a = method.make(shared, scene.probe_A), b = method.make(shared, scene.probe_A);
    bool same = true;
    for (const Vec3& hip : path) {
      const Contact one = a->step({hip}), two = b->step({hip});
      same = same && one.scp.A == two.scp.A && one.atoms == two.atoms && one.feature == two.feature &&
             one.displacement_A == two.displacement_A && one.energy_A2 == two.energy_A2 && one.normals == two.normals;
    }
    CHECK(same);
  }
}

TEST_CASE(
    "every method's contact is whole: a unit normal outward for each atom, a displacement as long as SCP - HIP and "
    "along "
    "it unless it is shaded, the energy of its springs; and nothing of it without contact") {
  const scenes::Scene scene = scenes::cluster(20, 5);
  const scenes::Path path = scenes::walk(scene, 2000, 5);
  for (const Method& method : benchMethods()) {
    CAPTURE(std::string(method.name));
    const auto tracker = method.make(makeScene(scene.spheres), scene.probe_A);
    const bool penalty = method.summed, shaded = method.shaded;
    int touching = 0, left_over = 0, crooked = 0, inward = 0, wrong_length = 0, turned = 0, wrong_energy = 0;
    for (const Vec3& hip : path) {
      const Contact c = tracker->step({hip});
      const Vec3 straight = c.scp.A - hip;
      const double length = glm::length(straight);
      touching += c.touching();
      if (!c.touching()) left_over += c.displacement_A != Vec3(0.0) || c.energy_A2 != 0.0 || c.normals[0] != Vec3(0.0);
      double energy = c.touching() ? 0.5 * length * length : 0.0;
      if (penalty) {
        energy = 0;
        for (const Sphere& b : scene.spheres)
          if (const double deep = b.radius_A + scene.probe_A - glm::distance(hip, b.centre_A);
              c.touching() && deep > 0.0)
            energy += 0.5 * deep * deep;
      }
      wrong_energy += std::abs(c.energy_A2 - energy) > 1e-9 * (1.0 + energy);
      for (std::size_t k = 0; k < 3; ++k) {
        if (c.atoms[k] < 0) {
          left_over += c.normals[k] != Vec3(0.0);
          continue;
        }
        crooked += std::abs(glm::length(c.normals[k]) - 1.0) > 1e-9;
        inward +=
            glm::dot(c.normals[k], (penalty ? hip : c.scp.A) - scene.spheres[std::size_t(c.atoms[k])].centre_A) <= 0.0;
      }
      if (!c.touching()) continue;
      wrong_length += std::abs(glm::length(c.displacement_A) - length) > 1e-9;
      turned += glm::distance(c.displacement_A, straight) > 1e-9;
      if (!method.reference || length < 1e-3) continue;
      // What is felt leads along what holds: over one sphere along its normal, in a crease in the plane of both.
      const Vec3 way = c.displacement_A / length;
      if (c.feature == Feature::Sphere) crooked += glm::distance(way, c.normals[0]) > 1e-6;
      if (c.feature == Feature::Circle)
        crooked += std::abs(glm::dot(way, glm::normalize(glm::cross(c.normals[0], c.normals[1])))) > 1e-6;
    }
    CHECK(touching > 500);
    CHECK(left_over + crooked + inward + wrong_length + wrong_energy == 0);
    CHECK((shaded ? turned > 500 : turned == 0));
  }
}

TEST_CASE("every method handles a scene without spheres, one sphere, and a probe that is not a number") {
  for (const Method& method : benchMethods()) {
    CAPTURE(std::string(method.name));
    const auto empty = method.make(makeScene({}), 1.4);
    for (double z = 3; z > -3; z -= 0.5) CHECK_FALSE(empty->step({{0, 0, z}}).touching());
    const auto one = method.make(makeScene({{{0, 0, 0}, 1.6}}), 1.4);
    CHECK(one->memoryUsage().bytes > 0);
    one->setProbe(std::nan(""));
    CHECK(one->probe_A() == 1.4);
    if (bench::limitsOf(method).one_probe) {
      one->setProbe(2.0);
      CHECK(one->probe_A() == 1.4);
      continue;
    }
    one->setProbe(-1);
    CHECK(one->probe_A() == 0.0);
    one->setProbe(1e9);
    CHECK(one->probe_A() == kMaxProbe_A);
  }
}

TEST_CASE("methods in the window and in lessons handle any scene and probe; others are only in the bench") {
  CHECK(benchMethods().size() > methods().size());
  for (const Method& method : methods()) CHECK(bench::limitsOf(method).none());
  for (const Method& method : benchMethods()) {
    CAPTURE(std::string(method.name));
    CHECK(motionSentence(method).empty() == method.follows_motion);
    CHECK(bench::findBenchMethod(method.name) == &method);
  }
  CHECK(findMethod("sasmesh05") == nullptr);
  CHECK(bench::limitsOf(*bench::findBenchMethod("sasmesh05")).one_probe);
  CHECK(methods().front().name == TouchSetup().method);
}

TEST_CASE("a method that files of earlier versions name is read as the one that answers alike, and never written") {
  const Method* method = findMethod("mesh960-tree");
  REQUIRE(method != nullptr);
  CHECK(method->name == "mesh960");
  for (const std::string_view name : methodNames()) CHECK(name != "mesh960-tree");
  const scenes::Scene scene = scenes::cluster(50, 3);
  const auto shared = makeScene(scene.spheres);
  const auto now = method->make(shared, scene.probe_A),
             then = bench::findBenchMethod("mesh960-tree")->make(shared, scene.probe_A);
  int touching = 0, other = 0;
  for (const Vec3& hip : scenes::walk(scene, 2000, 8)) {
    const Contact one = now->step({hip}), two = then->step({hip});
    touching += one.touching();
    other += one != two;
  }
  CHECK(touching > 500);
  CHECK(other == 0);
}

TEST_CASE("one method is the reference, and only a variant that is not plain stands in a title") {
  int references = 0;
  for (const Method& method : benchMethods()) references += isReference(method);
  CHECK(references == 1);
  CHECK(referenceMethod().name == "exact");
  CHECK(methodTitle("mesh960") == "Mesh 960");
  CHECK(methodTitle("mesh960-smooth") == "Mesh 960, Smooth");
  CHECK(methodTitle("no such method") == "no such method");
}
