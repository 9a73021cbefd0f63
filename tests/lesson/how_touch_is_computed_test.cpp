// The program's lesson on methods: it is read without a problem, and the failures that it announces happen. None of this is
// a fact of the lesson: facts are computed from a molecule, these numbers from methods and the hands that they lead.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

#include "engine/core/random.h"
#include "engine/haptics/interactions.h"
#include "engine/haptics/methods.h"
#include "engine/lesson/check.h"
#include "engine/lesson/pose_search.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/molecule/reader.h"
#include "tests/language/in_german.h"
#include "tests/lesson/shipped_hand.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using moltact::test::lineSaying;
using moltact::test::linesSaying;

namespace {

constexpr const char* kHowTouchIsComputedLesson = MOLTACT_SOURCE_DIR "/lessons/how-touch-is-computed.md";
constexpr const char* kGermanLesson = MOLTACT_SOURCE_DIR "/lessons/how-touch-is-computed.de.md";

std::string contentsOf(const char* file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

Expected<std::shared_ptr<const Molecule>> shipped(const NamedMolecule& named) {
  const std::string& name = named.name;
  auto molecule = readMolecule(std::string(MOLTACT_SOURCE_DIR "/molecules/") + name + ".pdb", named.reading);
  if (!molecule) return molecule.problem();
  return std::make_shared<const Molecule>(*std::move(molecule));
}

/// Leads a hand along a polyline at 2 A/s and feeds the task with what the scene's method makes of it.
bool doneAlong(const Step& step, std::size_t task, std::string_view method, const std::vector<Vec3>& way_A) {
  const auto molecule = shipped(step.scene.molecule);
  REQUIRE(molecule);
  const auto spheres = std::make_shared<const SphereGrid>((*molecule)->spheres);
  const auto tracker = findMethod(method)->make(spheres, step.scene.touch.probe_A);
  const auto exact = findMethod("exact")->make(spheres, step.scene.touch.probe_A);
  const auto t = makeTask(step.tasks[task], **molecule);
  TouchSample s;
  s.method = method;
  for (std::size_t k = 0; k + 1 < way_A.size(); ++k) {
    const int ticks = int(glm::distance(way_A[k], way_A[k + 1]) / 0.002) + 1;
    for (int i = 0; i < ticks; ++i) {
      s.time_s += 0.001;
      s.hip.A = way_A[k] + (way_A[k + 1] - way_A[k]) * (double(i) / ticks);
      s.contact = tracker->step(s.hip);
      s.exact = exact->step(s.hip);
      t->feed(s);
    }
  }
  return t->done();
}

const Step& stepOf(const Lesson& lesson, std::string_view id) {
  const auto at = lesson.find(id);
  REQUIRE_MESSAGE(at, id);
  return lesson.steps[*at];
}

}  // namespace

TEST_CASE(
    "how-touch-is-computed.md reads without errors or warnings into 11 steps, each with a task and, but for the key, "
    "the methods panel, "
    "which is shut and locked in the dark") {
  const LessonReading read = readLesson(kHowTouchIsComputedLesson);
  for (const Problem& p : read.errors) MESSAGE(p.text());
  for (const Problem& p : read.warnings) MESSAGE(p.text());
  REQUIRE(read.lesson);
  CHECK(read.warnings.empty());
  CHECK(read.lesson->steps.size() == 11);
  std::set<std::string> used, failures;
  for (const Step& s : read.lesson->steps) {
    CHECK_FALSE(s.tasks.empty());
    // The plots would reveal the method.
    const bool dark = s.tasks.empty() || s.tasks[0].kind == "same";
    const bool body = s.scene.in_hand.given();
    CHECK(s.scene.panels == std::vector<std::string>{dark ? "none" : body ? "touch" : "methods"});
    if (dark) CHECK((s.scene.locks("panels") && s.scene.locks("method")));
    used.insert(s.scene.molecule.name);
    for (const TaskSpec& t : s.tasks)
      if (t.kind == "meet") failures.insert(t.values["meet"].words.at(0));
  }
  CHECK(used.size() == read.lesson->molecules.size());
  CHECK(failures == std::set<std::string>{"jump", "lost", "off", "wrong-side"});
  for (const Problem& p : checkAgainstMolecules(*read.lesson, shipped)) FAIL_CHECK(p.text());
}

TEST_CASE("on the lesson's atom a slide 1 A deep meets a jerk with 80 triangles and none with the exact method") {
  const LessonReading read = readLesson(kHowTouchIsComputedLesson);
  REQUIRE(read.lesson);
  const Step& step = read.lesson->steps[0];
  const std::vector<Vec3> slide{{0.1, 0.2, 4}, {0.1, 0.2, 2.2}, {2.0, 0.4, 1.0}, {1.0, 1.8, 1.0}};
  CHECK(step.scene.touch.method == "mesh80");
  CHECK(doneAlong(step, 0, "mesh80", slide));
  CHECK_FALSE(doneAlong(step, 0, "exact", slide));
}

TEST_CASE(
    "slid round the lesson's atom the force turns in one tick by 42 degrees with 80 triangles, 21 with 320, 5 with "
    "5120 and under 1 with the exact method") {
  const LessonReading read = readLesson(kHowTouchIsComputedLesson);
  REQUIRE(read.lesson);
  const Step& step = stepOf(*read.lesson, "what-a-hand-can-tell");
  const auto molecule = shipped(step.scene.molecule);
  REQUIRE(molecule);
  const auto spheres = std::make_shared<const SphereGrid>((*molecule)->spheres);
  const auto largestTurn = [&](std::string_view method) {
    const auto tracker = findMethod(method)->make(spheres, step.scene.touch.probe_A);
    const double r = 1.88 + step.scene.touch.probe_A - 0.6;
    double most_deg = 0;
    // Great circles in many planes, 0.02 A a tick.
    for (int plane = 0; plane < 60; ++plane) {
      const double a = 0.7 * plane, b = 1.3 * plane;
      const Vec3 u(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)),
          w = glm::normalize(glm::cross(u, Vec3(0.3, 0.9, 0.31 + 0.01 * plane)));
      tracker->reset();
      for (double out = 1.0; out > 0; out -= 0.02) tracker->step({u * (r + out)});
      Vec3 last(0.0);
      for (double t = 0; t < 6.2832; t += 0.02 / r) {
        const Vec3 hip = (u * std::cos(t) + w * std::sin(t)) * r, pull = tracker->step({hip}).scp.A - hip;
        if (last != Vec3(0.0))
          most_deg =
              std::max(most_deg, std::atan2(glm::length(glm::cross(last, pull)), glm::dot(last, pull)) * 57.29578);
        last = pull;
      }
    }
    return most_deg;
  };
  const std::string says =
      linesSaying("how-touch-is-computed", {"at a corner by up to 42; with 5120 triangles by about 5 at most",
                                            "try Mesh 320, whose corners turn the force by up to 21 degrees"});
  CAPTURE(says);
  CHECK(largestTurn("mesh80") == doctest::Approx(42).epsilon(0.02));
  CHECK(largestTurn("mesh320") == doctest::Approx(21).epsilon(0.04));
  CHECK(largestTurn("mesh5120") == doctest::Approx(5).epsilon(0.1));
  CHECK(largestTurn("exact") < 1);
}

TEST_CASE(
    "neighbouring triangles of a sphere of 80, an icosahedron's faces halved once, lie at 18 to 22.5 degrees to each "
    "other; of 320 at 7 to 11.5, of 5120 at 1.5 to 3") {
  const std::string
      edge = lineSaying("how-touch-is-computed", "At an edge of Mesh 80 the force turns by about 20 degrees at once"),
      neighbours =
          lineSaying("how-touch-is-computed",
                     "Mesh 80 lie at 18 to 22 degrees to each other, of Mesh 320 at 7 to 11, of Mesh 5120 at 1.5 to 3");
  CAPTURE(edge);
  CAPTURE(neighbours);
  using Triangle = std::array<Vec3, 3>;
  // The twelve corners of an icosahedron, and as faces all threes of them that are neighbours.
  std::vector<Vec3> corners;
  const double golden = (1 + std::sqrt(5.0)) / 2;
  for (const double a : {1.0, -1.0})
    for (const double b : {golden, -golden})
      for (const Vec3& c : {Vec3(0, a, b), Vec3(a, b, 0), Vec3(b, 0, a)}) corners.push_back(glm::normalize(c));
  std::vector<Triangle> faces;
  const auto near = [&](std::size_t i, std::size_t j) { return glm::dot(corners[i], corners[j]) > 0.4; };
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = j + 1; k < 12; ++k)
        if (near(i, j) && near(j, k) && near(i, k)) faces.push_back({corners[i], corners[j], corners[k]});
  REQUIRE(faces.size() == 20);
  const auto normal = [](const Triangle& t) {
    const Vec3 n = glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
    return glm::dot(n, t[0]) < 0 ? -n : n;
  };
  const auto angles_deg = [&] {
    double least = 180, most = 0;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t j = i + 1; j < faces.size(); ++j) {
        int shared = 0;
        for (const Vec3& p : faces[i])
          for (const Vec3& q : faces[j]) shared += glm::distance(p, q) < 1e-9;
        if (shared != 2) continue;
        const double angle = std::acos(std::min(1.0, glm::dot(normal(faces[i]), normal(faces[j])))) * 57.29578;
        least = std::min(least, angle);
        most = std::max(most, angle);
      }
    return std::pair(least, most);
  };
  for (int halved = 1; halved <= 4; ++halved) {
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : faces) {
      const Vec3 ab = glm::normalize(a + b), bc = glm::normalize(b + c), ca = glm::normalize(c + a);
      for (const Triangle& t : {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
        finer.push_back(t);
    }
    faces = finer;
    if (halved == 3) continue;
    const auto [least, most] = angles_deg();
    CAPTURE(faces.size());
    CAPTURE(least);
    CAPTURE(most);
    const double low = halved == 1   ? 17.5
                       : halved == 2 ? 6.5
                                     : 1.45,
                 high = halved == 1   ? 22.6
                        : halved == 2 ? 11.6
                                      : 3.0;
    CHECK(least > low);
    CHECK(least < low + 1);
    CHECK(most < high);
    CHECK(most > high - 1);
  }
}

TEST_CASE(
    "pushed 3 A through the pit with the lesson's probe, paper loses the surface and penalty throws the hand out; "
    "exact does neither") {
  const LessonReading read = readLesson(kHowTouchIsComputedLesson);
  REQUIRE(read.lesson);
  const Step& lost = stepOf(*read.lesson, "the-papers-method-loses-the-surface");
  const Step& thrown = stepOf(*read.lesson, "penalty-throws-you-out-of-the-far-side");
  CHECK(lost.scene.touch.method == "paper");
  CHECK(thrown.scene.touch.method == "penalty");
  // The pit's height above the plane of the atoms; a mouse pushes at most 3 A below the surface.
  const double pit_A = std::sqrt(std::pow(1.88 + lost.scene.touch.probe_A, 2) - std::pow(3.76, 2) / 3.0);
  for (const Vec3& aside : {Vec3(0.02, 0.01, 0), Vec3(0.2, -0.1, 0), Vec3(-0.1, 0.25, 0)}) {
    const std::vector<Vec3> through{aside + Vec3(0, 0, 4), aside + Vec3(0, 0, pit_A), aside + Vec3(0, 0, pit_A - 3.0),
                                    aside + Vec3(0.01, 0, pit_A - 3.0), aside + Vec3(0.3, 0, pit_A - 3.0)};
    CAPTURE(aside.x);
    CHECK(doneAlong(lost, 0, "paper", through));
    CHECK_FALSE(doneAlong(lost, 0, "exact", through));
    CHECK(doneAlong(thrown, 0, "penalty", through));
    CHECK_FALSE(doneAlong(thrown, 0, "exact", through));
  }
}

TEST_CASE("in the lesson's crease the grid of 0.8 A is off by 0.03 A, the one of 0.2 A and the exact method are not") {
  const LessonReading read = readLesson(kHowTouchIsComputedLesson);
  REQUIRE(read.lesson);
  const Step& step = stepOf(*read.lesson, "a-grid-rounds-the-crease");
  SAYS(lineSaying("how-touch-is-computed", "until the contact point lies 0.03 Å or more off the true one"));
  CHECK(step.scene.touch.method == "grid08");
  // Radius of the circle where the grown spheres meet; the pair lies along x.
  const double circle_A = std::sqrt(std::pow(1.88 + 1.4, 2) - 1.88 * 1.88);
  const std::vector<Vec3> push{{0.03, 0.02, 5}, {0.03, 0.02, circle_A - 1.0}, {0.1, 0.3, circle_A - 1.0}};
  CHECK(doneAlong(step, 0, "grid08", push));
  CHECK_FALSE(doneAlong(step, 0, "grid02", push));
  CHECK_FALSE(doneAlong(step, 0, "exact", push));
}

TEST_CASE("the lesson calls the methods and the plot of turns what the panel calls them, in English and in German") {
  int named = 0;
  for (const bool in_german : {false, true}) {
    CAPTURE(in_german);
    const char* file = in_german ? kGermanLesson : kHowTouchIsComputedLesson;
    const LessonReading read = readLesson(file);
    REQUIRE(read.lesson);
    std::optional<InGerman> german;
    if (in_german) german.emplace(MOLTACT_TRANSLATIONS);
    const std::string text = contentsOf(file);
    CHECK(text.find("*" + std::string(tr("Largest turn in a tick")) + "*") != std::string::npos);
    for (const std::string_view name : {"exact", "paper", "mesh80", "grid08", "penalty"})
      CHECK_MESSAGE(text.find(tr(findMethod(name)->family.name)) != std::string::npos, name);
    for (const Step& step : read.lesson->steps)
      for (const TaskSpec& task : step.tasks) {
        // More than three would make no sentence.
        if (task.kind != "compare" || task.values["compare"].words.size() > 3) continue;
        for (const std::string& method : task.values["compare"].words) {
          std::string title = methodTitle(method);
          for (std::size_t at; (at = title.find("\u00a0")) != std::string::npos;) title.replace(at, 2, " ");
          CHECK_MESSAGE(task.values["say"].text.find(title) != std::string::npos, title);
          ++named;
        }
      }
  }
  CHECK(named == 16);
}

TEST_CASE(
    "the key comes out of its lock by a free path; of 400 000 poses within 0.5 A of its place those that are free are "
    "turned by less than 25 degrees") {
  SAYS(lineSaying("how-touch-is-computed", "fits there in one orientation only, within 25°"));
  const moltact::test::ShippedScene s("key-and-lock");
  const std::vector<std::uint32_t> key = s.select("chain B");
  const auto body = heldBody(s.molecule->spheres, key);
  const SphereGrid lock(s.molecule->spheres, key);
  const PoseSpace space(lock, *body);
  CHECK(freePath(space, {body->middle}, {.max_tests = 50'000}).size() >= 2);
  std::uint64_t random = 1;
  int free = 0;
  double farthest_deg = 0.0;
  for (int k = 0; k < 400'000; ++k) {
    const Vec3 off = Vec3(nextFraction(random), nextFraction(random), nextFraction(random)) - 0.5;
    // Half of them turned anyhow, half by up to 45 degrees.
    Quat q = randomOrientation(random);
    if (k % 2) q = glm::angleAxis(glm::radians(45.0) * nextFraction(random), glm::normalize(Vec3(q.x, q.y, q.z)));
    if (!space.isFree({{body->middle.A + off}, q})) continue;
    ++free;
    farthest_deg = std::max(farthest_deg, glm::degrees(glm::length(rotationBetween(kNoRotation, q))));
  }
  CHECK(free > 50);
  CHECK(farthest_deg < 25.0);
}

TEST_CASE(
    "a key that is led straight along its slot, held 25 degrees askew about each of three axes, 45 about the slot, "
    "slides into its lock; held 80 times as stiffly it stays 0.9 A outside, and a sixth as stiffly it is turned away") {
  const moltact::test::ShippedScene s("key-and-lock");
  const std::vector<std::uint32_t> key = s.select("chain B");
  const auto body = heldBody(s.molecule->spheres, key);
  const auto lock = std::make_shared<const SphereGrid>(s.molecule->spheres, key);
  // The distance of the key from its place after the hand was led to 1 A behind it.
  const auto led = [&](const Vec3& axis, double askew_deg, double rotational_N_A) {
    InteractionInput input{.spheres = lock, .body = body};
    input.touch.interaction = "exact-body";
    input.rotational_stiffness_N_A = rotational_N_A;
    const auto felt = makeInteraction(input);
    PoseA hand{body->middle, glm::angleAxis(glm::radians(askew_deg), axis)};
    for (int k = 0; k <= 4400; ++k) {
      hand.place.A.z = body->middle.A.z + std::max(-1.0, 20.0 - 21.0 * k / 4000.0);
      const Response r = felt->respond(hand);
      if (k == 4400) return glm::distance(r.shownBody(hand).place.A, body->middle.A);
    }
    return 0.0;
  };
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
    for (const double side : {-1.0, 1.0}) {
      CAPTURE(axis.x);
      CAPTURE(axis.y);
      CAPTURE(side);
      CHECK(led(axis, side * 25.0, 0.0) < 0.6);
      CHECK(led(axis, side * 25.0, 1000.0) > 0.9);
    }
  CHECK(led({0, 0, 1}, 45.0, 0.0) < 0.6);
  CHECK(led({1, 0, 0}, 25.0, 2.0) > 1.5);
}
