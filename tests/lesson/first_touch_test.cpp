// The program's first lesson: its steps keep the promises to a newcomer, its numbers follow from the molecules, and its
// tasks in the dark cannot be passed by looking, guessing or jabbing.
#include <algorithm>
#include <random>
#include <set>

#include "engine/core/random.h"
#include "engine/haptics/methods.h"
#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr const char* kFirstTouchLesson = "first-touch";
constexpr const char* kFiles[] = {"first-touch", "first-touch.de"};
constexpr double kWater_A = 1.4;

/// The number of 2000 even directions in which a probe touches the atom without overlapping any other.
int openDirections(const SphereGrid& spheres, std::uint32_t atom, double probe_A) {
  const std::uint32_t one[] = {atom};
  return static_cast<int>(facePlaces(spheres, one, probe_A, 2000).size());
}

/// What holds a probe that is pushed so deep from outside along a straight way (unit: angstrom).
Contact pushed(const ShippedScene& s, Vec3 from_A, Vec3 to_A) {
  const auto exact = findMethod("exact")->make(std::make_shared<const SphereGrid>(s.molecule->spheres), kWater_A);
  Contact contact;
  const int ticks = static_cast<int>(glm::distance(from_A, to_A) / 0.002);
  for (int k = 0; k <= ticks; ++k) contact = exact->step({from_A + (to_A - from_A) * (double(k) / ticks)});
  return contact;
}

Vec3 middleOf(const ShippedScene& s, const std::string& text) {
  Vec3 sum(0.0);
  const auto atoms = s.select(text);
  for (const std::uint32_t a : atoms) sum += s.molecule->spheres[a].centre_A / double(atoms.size());
  return sum;
}

}  // namespace

TEST_CASE(
    "first-touch.md, as in German, has 5 steps and 2 extra ones, from pentacene over argon to ubiquitin; each has a "
    "task, "
    "and three are done without seeing") {
  for (const char* file : kFiles) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(std::count_if(lesson.steps.begin(), lesson.steps.end(), [](const Step& s) { return s.extra; }) == 2);
    CHECK(lesson.goals.size() == 3);
    const char* expected[] = {"pentacene",   "argon-pair", "argon-triangle", "argon-shapes", "pentacene",
                              "alpha-helix", "1ubq"};
    REQUIRE(lesson.steps.size() == 7);
    std::set<std::string> used;
    for (std::size_t i = 0; i < 7; ++i) {
      CHECK(lesson.steps[i].scene.molecule == expected[i]);
      used.insert(lesson.steps[i].scene.molecule.name);
    }
    CHECK(used.size() == lesson.molecules.size());
    CHECK(tasksOf(lesson, "order") == 1);
    CHECK(tasksOf(lesson, "same") == 1);
    CHECK(tasksOf(lesson, "trace") == 3);
    CHECK(lesson.steps[4].scene.hide.given());
  }
}

TEST_CASE("every target of first-touch.md has an atom that the probe can touch from at least 1 in 100 directions") {
  for (const char* file : kFiles) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    int targets = 0;
    for (const Step& step : lesson.steps) {
      const ShippedScene scene(step.scene.molecule.name);
      for (const TaskSpec& task : step.tasks)
        for (const auto& [key, value] : task.values) {
          std::vector<Selection> asked = value.path;
          if (value.selection.given()) asked.push_back(value.selection);
          for (const Selection& selection : asked) {
            CAPTURE(selection.text());
            int most = 0;
            for (const std::uint32_t atom : selection.select(*scene.molecule))
              most = std::max(most, openDirections(scene.spheres, atom, step.scene.touch.probe_A));
            CHECK(most >= 20);
            ++targets;
          }
        }
    }
    CHECK(targets >= 27);
  }
}

TEST_CASE(
    "from the bond between two rings of pentacene the probe sinks in by 0.25 A, and in the middle of each it rests in "
    "a pit") {
  const std::string says =
      linesSaying(kFirstTouchLesson, {"the probe sinks in by 0.25 Å", "the bond lengths of benzene (C-C 1.397 Å"});
  CAPTURE(says);
  const ShippedScene s("pentacene");
  const auto height = [&](double x) { return pushed(s, Vec3(x, 0.003, 6), Vec3(x, 0.003, 2.4)).scp.A.z; };
  for (int ring = 0; ring < 5; ++ring) {
    CAPTURE(ring);
    const std::string of = "atom " + std::to_string(4 * ring) + "-" + std::to_string(4 * ring + 5);
    const Vec3 middle = middleOf(s, of);
    for (const std::uint32_t a : s.select(of))
      CHECK(glm::distance(s.molecule->spheres[a].centre_A, middle) == doctest::Approx(1.397).epsilon(0.001));
    CHECK(pushed(s, middle + Vec3(0.01, 0.02, 6), middle + Vec3(0.01, 0.02, 2)).feature == Feature::Point);
    if (ring == 4) break;
    const Vec3 next = middleOf(s, "atom " + std::to_string(4 * ring + 4) + "-" + std::to_string(4 * ring + 9));
    CHECK(height(0.5 * (middle.x + next.x)) - height(middle.x) == doctest::Approx(0.25).epsilon(0.03));
  }
}

TEST_CASE(
    "a push of 0.5 N is 5 thousand million times a force of 0.1 nN, and the probe is about as large as an oxygen") {
  const std::string says =
      linesSaying(kFirstTouchLesson, {"Your probe has a radius of 1.4 Å, about that of the oxygen atom",
                                      "push of 0.5 N on the hand is 5 thousand million times as much"});
  CAPTURE(says);
  CHECK(kWater_A / ShippedScene("water").atom("element O").radius_A > 0.9);
  CHECK(0.5 / 0.1e-9 == doctest::Approx(5e9));
}

TEST_CASE("the argon triangle has two pits, one on either side, each where a water-sized probe rests 2.46 A above it") {
  const std::string line = lineSaying(kFirstTouchLesson, "This triangle has two pits, one on either side");
  CAPTURE(line);
  const ShippedScene s("argon-triangle");
  const double z = std::sqrt(std::pow(1.88 + kWater_A, 2) - std::pow(3.76, 2) / 3.0);
  CHECK(z == doctest::Approx(2.46).epsilon(0.002));
  std::set<int> sides;
  for (const SurfacePlace& p : pitPlaces(s.spheres, s.select("all"), kWater_A)) {
    CHECK(std::abs(std::abs(p.scp_A.z) - z) < 0.003);
    sides.insert(p.scp_A.z > 0 ? 1 : -1);
  }
  CHECK(sides.size() == 2);
}

TEST_CASE(
    "of the four groups in the dark one has no crease, one has one, the row two, and the triangle three that meet in a "
    "pit; a straight press in the middle meets a face, a crease, a face and a pit, and a probe passes between any "
    "two") {
  const std::string says =
      linesSaying(kFirstTouchLesson, {"The single atom has no crease, the pair has one, the row has two",
                                      "In the middle of the row you are on a face, with a crease above and"});
  CAPTURE(says);
  const ShippedScene s("argon-shapes");
  const Feature met[] = {Feature::Sphere, Feature::Circle, Feature::Sphere, Feature::Point};
  const int joined[] = {0, 1, 2, 3};
  for (int g = 0; g < 4; ++g) {
    const std::string chain = std::string("chain ") + static_cast<char>('A' + g);
    CAPTURE(chain);
    const auto atoms = s.select(chain);
    int pairs = 0;
    for (std::size_t a = 0; a < atoms.size(); ++a)
      for (std::size_t b = a + 1; b < atoms.size(); ++b) {
        const double grid_spacing_A =
            glm::distance(s.molecule->spheres[atoms[a]].centre_A, s.molecule->spheres[atoms[b]].centre_A);
        pairs += grid_spacing_A < 2 * (1.88 + kWater_A);
        if (grid_spacing_A < 4) CHECK(grid_spacing_A == doctest::Approx(3.76).epsilon(0.001));
      }
    CHECK(pairs == joined[g]);
    const Vec3 middle = middleOf(s, chain), out = glm::normalize(middle);
    CHECK(pushed(s, middle + out * 8.0, middle + out * 1.5).feature == met[g]);
    for (const std::uint32_t a : atoms)
      for (std::size_t b = 0; b < s.molecule->atoms.size(); ++b)
        if (std::find(atoms.begin(), atoms.end(), b) == atoms.end())
          CHECK(glm::distance(s.molecule->spheres[a].centre_A, s.molecule->spheres[b].centre_A) >
                2 * (1.88 + kWater_A));
  }
}

TEST_CASE(
    "who feels the four groups and guesses, or names them as they come, puts them in order once in 24 rounds; who jabs "
    "is not asked") {
  const std::string line = lineSaying(kFirstTouchLesson, "An order of four is guessed once in 24 rounds");
  CAPTURE(line);
  const Lesson lesson = shippedLesson(kFirstTouchLesson);
  const TaskSpec& spec = taskOf(lesson, "eyes-closed", "order");
  const ShippedScene s("argon-shapes");
  constexpr unsigned kSeed = 20261123;
  CAPTURE(kSeed);
  std::mt19937 random(kSeed);
  // An atom of every group: whichever is shown, it is touched, and nothing of the answer follows.
  const std::vector<std::int32_t> any = {0, 1, 3, 6};
  const auto feelAll = [&](Task& task, double seconds) {
    Hand hand{task, 0.0, 0.02};
    for (int k = 0; k < 4; ++k) {
      for (int n = 0; n < static_cast<int>(seconds / 0.02); ++n)
        for (const std::int32_t a : any) hand.touch({a}, 0.02);
      hand.away(0.1);
      task.answer({.word = "next"});
    }
  };
  constexpr int kRounds = 2400;
  for (const bool as_they_come : {true, false}) {
    CAPTURE(as_they_come);
    int passed = 0;
    for (int round = 0; round < kRounds; ++round) {
      const auto task = makeTask(spec, *s.molecule);
      task->drawBy(mixedSeed(kSeed, std::uint64_t(round)));
      feelAll(*task, 2.1);
      std::vector<std::string> names = {"place-1", "place-2", "place-3", "place-4"};
      if (!as_they_come) std::shuffle(names.begin(), names.end(), random);
      for (int k = 0; k < 3; ++k) task->answer({.word = names[static_cast<std::size_t>(k)]});
      passed += task->done();
    }
    CHECK(double(passed) / kRounds == doctest::Approx(1.0 / 24).epsilon(0.4));
  }
  const auto jabbed = makeTask(spec, *s.molecule);
  Hand hand{*jabbed};
  for (int k = 0; k < 20; ++k) {
    hand.touch({any[static_cast<std::size_t>(k) % 4]}, 0.2);
    hand.away(0.2);
  }
  for (const TaskButton& b : jabbed->buttons()) CHECK(b.word == "next");
  CHECK_FALSE(jabbed->done());
}

TEST_CASE(
    "the row that is not drawn falls from the upper left to the lower right, and a hand that goes level leaves it") {
  const std::string line = lineSaying(kFirstTouchLesson, "[x] Falling, from upper left to lower right");
  CAPTURE(line);
  const Lesson lesson = shippedLesson(kFirstTouchLesson);
  const Step& step = lesson.steps[*lesson.find("a-molecule-that-you-cannot-see")];
  const ShippedScene s("pentacene");
  REQUIRE(step.scene.view.turned_deg);
  const auto [to_right, above, round_deg] = *step.scene.view.turned_deg;
  REQUIRE(to_right == 0.0);
  REQUIRE(above == 0.0);
  // Seen from the front, rotated counter-clockwise by this many degrees.
  const double turned = round_deg * std::numbers::pi / 180;
  const auto seen = [&](const Vec3& p) {
    return Vec3(p.x * std::cos(turned) - p.y * std::sin(turned), p.x * std::sin(turned) + p.y * std::cos(turned), p.z);
  };
  const Vec3 one = seen(middleOf(s, "atom 0-5")), other = seen(middleOf(s, "atom 16-21"));
  const Vec3 left = one.x < other.x ? one : other, far = one.x < other.x ? other : one;
  CHECK(left.x < -2);
  CHECK(left.y > 2);
  CHECK(far.y < -2);

  // Level on the screen, over the middle: in the molecule's plane that crosses the row.
  const TaskSpec& spec = taskOf(lesson, "a-molecule-that-you-cannot-see", "trace");
  const auto task = makeTask(spec, *s.molecule);
  const auto exact = findMethod("exact")->make(std::make_shared<const SphereGrid>(s.molecule->spheres), kWater_A);
  double time_s = 0.0;
  for (double way_A = -8.0; way_A <= 8.0; way_A += 0.005) {
    TouchSample sample;
    sample.hip.A = Vec3(way_A * std::cos(turned), -way_A * std::sin(turned), 2.6);
    sample.contact = exact->step(sample.hip);
    sample.probe_A = kWater_A;
    sample.time_s = time_s += 0.001;
    sample.force.N = sample.contact.displacement_A;
    task->feed(sample);
  }
  CHECK_FALSE(task->done());
  CHECK(figure(*task, "coverage") < 90);
}

TEST_CASE("of the helix's 21 oxygens sixteen hold on to a nitrogen of the next turn, and those at the end to none") {
  const std::string line = lineSaying(kFirstTouchLesson, "Sixteen of these oxygens hold on to the next turn");
  CAPTURE(line);
  const ShippedScene s("alpha-helix");
  int held = 0;
  for (const std::uint32_t o : s.select("element O"))
    for (const std::uint32_t n : s.select("element N")) {
      const PlacedAtom oxygen = s.molecule->at(o), nitrogen = s.molecule->at(n);
      // The fourth nitrogen on is 2.88 A away, the third 3.14 A and far off the line of C=O; nearer ones are neighbours.
      held += nitrogen.residue >= oxygen.residue + 3 && glm::distance(oxygen.position.A, nitrogen.position.A) < 3.0;
    }
  CHECK(held == 16);
}

TEST_CASE("a turn of the helix has 3.6 amino acids; it has 20, more than five turns") {
  const std::string says = linesSaying(
      kFirstTouchLesson, {"3.6 amino acids make one turn", "You have gone over 20 amino acids, more than five turns"});
  CAPTURE(says);
  const ShippedScene s("alpha-helix");
  double sum_deg = 0.0;
  for (int i = 1; i < 20; ++i) {
    const Vec3 a = s.atom("residue " + std::to_string(i) + " and name CA").position.A,
               b = s.atom("residue " + std::to_string(i + 1) + " and name CA").position.A;
    double turn_deg = (std::atan2(b.y, b.x) - std::atan2(a.y, a.x)) * 180 / std::numbers::pi;
    sum_deg += turn_deg < 0 ? turn_deg + 360 : turn_deg;
  }
  CHECK(360.0 / (sum_deg / 19) == doctest::Approx(3.6).epsilon(0.01));
  CHECK(20 / 3.6 > 5);
  CHECK(s.select("name CA").size() == 20);
}
