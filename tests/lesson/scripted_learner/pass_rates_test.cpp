// How often students without touch get through the opening of a 'pass' task: the looker, who puts the hand down on either
// side of it; the guesser, who knows where the opening is and leads straight through its middle from any side, what the
// hand holds turned anyhow; and the jabber, who pushes at any place of the ring from any side and draws back. Molecules
// made by hand, because no lesson of the program has such a task.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>

#include "engine/core/even_directions.h"
#include "engine/core/random.h"
#include "engine/lesson/pose_search.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/scripted_learner/scripted_learner.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {

constexpr int kTries = 200;
constexpr double kFar_A = 14.0;

// Six spheres of 1.5 A, 3 A round the z axis, in `rings` planes 2.2 A apart; beside them a stick of three spheres 1.6 A
// apart, of 1.5 A (1 A as they are felt in the hand), which fits through lengthwise only.
Molecule tube(int rings) {
  MoleculeByHand b;
  b.made.id = "tube";
  b.residue("A", "ALA", 1, ResidueKind::AminoAcid);
  for (int ring = 0; ring < rings; ++ring)
    for (int k = 0; k < 6; ++k)
      b.atom("C", 6,
             {3.0 * std::cos(k * 1.0471975511965976), 3.0 * std::sin(k * 1.0471975511965976),
              2.2 * (ring - 0.5 * (rings - 1))},
             1.5);
  b.residue("B", "LIG", 1, ResidueKind::Ligand);
  for (int k = 0; k < 3; ++k) b.atom("C", 6, {20.0 + 1.6 * (k - 1), 0, 0}, 1.5);
  return b.molecule();
}

// One step with the task and a student who follows plans.
class Student {
 public:
  Student(int rings, bool body)
      : learner_(
            lesson(rings, body),
            [rings](const NamedMolecule&) -> Expected<std::shared_ptr<const Molecule>> {
              return std::make_shared<const Molecule>(tube(rings));
            },
            [](const LearnerEvent&) {}) {
    REQUIRE(learner_.enterStep());
  }
  bool passes(const HandPlan& plan) {
    learner_.follow(plan);
    return learner_.session().finished();
  }
  bool demonstrates() { return learner_.doTask(); }

 private:
  static std::shared_ptr<const Lesson> lesson(int rings, bool body) {
    LessonReading read = readLessonText(
        "l.md",
        "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: tube\nauthor: A\nlicence: L\n---\n## A\n```scene\nmolecule: "
        "tube\n" +
            std::string(body ? "in-hand: resname LIG\n" : "probe: 1 Å\n") + "```\n```touch\npass: atom 0-" +
            std::to_string(6 * rings - 1) + "\nsay: Go through.\n```\n");
    for (const Problem& p : read.errors) MESSAGE(p.text());
    REQUIRE(read.lesson);
    return std::make_shared<const Lesson>(*std::move(read.lesson));
  }
  ScriptedLearner learner_;
};

// Turned first, then straight from `from` to `to`, and back.
HandPlan lead(const Vec3& from, const Vec3& to, const Quat& turned, double wait_s) {
  return {{.to = PointA{from}, .placed = true, .wait_s = 0.05},
          {.turned_to = turned, .turn_deg_per_s = 720.0},
          {.to = PointA{to}, .speed_A_per_s = 40.0, .wait_s = wait_s},
          {.to = PointA{from}, .speed_A_per_s = 120.0}};
}

struct Rates {
  bool looker = false;
  double guesser = 0.0, jabber = 0.0;
};

Rates ratesOf(int rings, bool body) {
  Rates out;
  // Put down on one side, then on the other.
  for (const double far_A : {4.0, 8.0})
    out.looker = out.looker || Student(rings, body)
                                   .passes({{.to = PointA{{0, 0, far_A}}, .placed = true, .wait_s = 0.5},
                                            {.to = PointA{{0, 0, 0}}, .placed = true, .wait_s = 0.5},
                                            {.to = PointA{{0, 0, -far_A}}, .placed = true, .wait_s = 0.5}});
  std::uint64_t random = 20261127;
  for (int k = 0; k < kTries; ++k) {
    const Vec3 side = kFar_A * evenDirection(k, kTries);
    const Quat turned = body ? randomOrientation(random) : kNoRotation;
    out.guesser += Student(rings, body).passes(lead(side, -side, turned, 0.3)) / double(kTries);
    // Any place within the ring's outer radius, reached straight from that side and pressed by 2 A.
    const double r = 4.5 * std::sqrt(nextFraction(random)), angle = 6.283185307179586 * nextFraction(random);
    const Vec3 at(r * std::cos(angle), r * std::sin(angle), 0);
    out.jabber +=
        Student(rings, body).passes(lead(at + side, at - 2.0 * glm::normalize(side), turned, 0.3)) / double(kTries);
  }
  return out;
}

}  // namespace

TEST_CASE(
    "of 200 straight leads through the middle of an opening 25 to 75 % pass, fewer with a stick that must be turned "
    "and "
    "through a longer tube; of 200 pushes at any place up to 10 %; a hand put down on either side never passes") {
  std::string table;
  const auto row = [&](const char* name, int rings, bool body) {
    CAPTURE(name);
    CHECK(Student(rings, body).demonstrates());
    const Rates out = ratesOf(rings, body);
    char line[120];
    std::snprintf(line, sizeof line, "%6d %6.1f %6.1f  %s\n", int(out.looker), 100 * out.guesser, 100 * out.jabber,
                  name);
    table += line;
    CHECK_FALSE(out.looker);
    CHECK(out.guesser > 0.25);
    CHECK(out.guesser < 0.75);
    CHECK(out.jabber < 0.1);
    return out;
  };
  const Rates open = row("a ring, a sphere with 0.5 A to spare", 1, false);
  const Rates tube = row("a tube of three rings, the same sphere", 3, false);
  const Rates stick = row("a ring, a stick that fits lengthwise", 1, true);
  const Rates threaded = row("a tube of three rings, the same stick", 3, true);
  MESSAGE("passed, in % of 200:\nlooker guess.   jabs\n" << table);
  CHECK(open.guesser > tube.guesser);
  CHECK(open.guesser > stick.guesser);
  CHECK(stick.guesser > threaded.guesser);
}
