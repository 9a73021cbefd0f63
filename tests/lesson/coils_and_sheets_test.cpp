// The program's lesson on helices and sheets: turns, handedness, heights, and from where side chains can be touched. What
// stands here is no fact of the lesson: facts know no axis along or about which to measure, no share of directions and no
// hand that does a task.
#include <algorithm>

#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr const char* kCoils = "coils-and-sheets";

Vec3 placeOf(const ShippedScene& s, const std::string& atom) { return s.atom(atom).position.A; }

std::string caOf(int residue) { return "residue " + std::to_string(residue) + " and name CA"; }
std::string cbOf(int residue) { return "residue " + std::to_string(residue) + " and name CB"; }

}  // namespace

TEST_CASE(
    "coils-and-sheets.md has 8 steps, four ways to trace, one of them unseen, and eight trials in the dark that "
    "guessing passes once in 28") {
  const Lesson lesson = shippedLesson(kCoils);
  checkCare(lesson);
  CHECK(lesson.steps.size() == 8);
  CHECK(tasksOf(lesson, "trace") == 4);
  const TaskSpec& same = taskOf(lesson, "two-coils-in-the-dark", "same");
  REQUIRE(same.values["trials"].number == 8);
  REQUIRE(same.values["right"].number == 7);
  const std::string line = lineSaying(kCoils, "in 9 of 256 rounds, 3.5 %");
  CAPTURE(line);
  CHECK((8 + 1) / 256.0 == doctest::Approx(0.035).epsilon(0.01));
  const auto last = lesson.find("a-row-that-you-cannot-see");
  REQUIRE(last);
  CHECK(lesson.steps[*last].scene.hide.select(*ShippedScene("2beg").molecule).size() == 900);
}

TEST_CASE(
    "from knob 6 to knob 17 the helix winds round 3.04 times, 3.6 amino acids a turn, and the four knobs lie within 45 "
    "degrees of one line") {
  const std::string says =
      linesSaying(kCoils, {"goes on by 11 amino acids and has wound round three times: 3.6 amino acids make one turn",
                           "on by 99.6° and 1.50 Å, so 3.61 make a turn of 5.4 Å"});
  CAPTURE(says);
  const ShippedScene s("alpha-helix");
  double wound_deg = 0;
  const auto angle = [&](const std::string& atom) {
    const Vec3 p = placeOf(s, atom);
    return std::atan2(p.y, p.x) * 180 / std::numbers::pi;
  };
  const auto turned = [](double deg) { return deg - 360 * std::round(deg / 360); };
  for (int i = 6; i < 17; ++i) {
    const double step = turned(angle(caOf(i + 1)) - angle(caOf(i)));
    CHECK(step == doctest::Approx(99.6).epsilon(0.005));
    wound_deg += step;
  }
  CHECK(wound_deg / 360 == doctest::Approx(3.04).epsilon(0.005));
  CHECK(360 / 99.6 == doctest::Approx(3.61).epsilon(0.002));
  CHECK(3.61 * 1.50 == doctest::Approx(5.4).epsilon(0.005));
  for (const int i : {6, 10, 13, 17}) CHECK(std::abs(turned(angle(cbOf(i)) - angle(cbOf(6)) - 8)) < 45);
}

TEST_CASE(
    "in front of the right-handed coil knob 6 stands right of knob 5 and 1.5 A higher; chain B is its mirror image") {
  const std::string says = linesSaying(
      kCoils, {"In front, the chain climbs from left to right", "lie 1.50 Å apart along the axis and 5.3 Å in all",
               "1.5 Å higher or lower, and 4 to 5 Å to the side"});
  CAPTURE(says);
  const ShippedScene s("helix-pair");
  const Vec3 five = placeOf(s, "chain A and " + cbOf(5)), six = placeOf(s, "chain A and " + cbOf(6));
  // Who looks from +x has -z at the right.
  CHECK(five.z - six.z > 4.0);
  CHECK(five.z - six.z < 5.0);
  CHECK(six.y - five.y == doctest::Approx(1.50).epsilon(0.01));
  const auto a = s.select("chain A"), b = s.select("chain B");
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    CHECK(glm::distance(s.molecule->spheres[a[k]].centre_A * Vec3(-1, 1, 1), s.molecule->spheres[b[k]].centre_A) <
          0.001);
}

TEST_CASE(
    "no sphere of 0.5 A passes straight into the middle of the helix, wherever within 1 A of the axis it begins") {
  const std::string line = lineSaying(kCoils, "nowhere within 1 Å of the middle does the ball go in");
  CAPTURE(line);
  const ShippedScene s("alpha-helix");
  for (double x = -1; x <= 1; x += 0.1)
    for (double y = -1; y <= 1; y += 0.1) {
      if (std::hypot(x, y) > 1) continue;
      double room_A = 1e9;
      for (double z = -22; z <= 0; z += 0.05)
        for (const Sphere& b : s.molecule->spheres)
          room_A = std::min(room_A, glm::distance(Vec3(x, y, z), b.centre_A) - b.radius_A);
      CHECK(room_A < 0.5);
    }
}

TEST_CASE(
    "the helix is 28 A long, 1.5 A for each amino acid, of which the strand's 3.45 A are 2.3 times; its side chains "
    "stand up and down in turn") {
  const std::string says = linesSaying(kCoils, {"The coil was 28 Å long, from the height of its first",
                                                "each amino acid takes 1.5 Å, in the strand 3.45 Å", "Yes, 2.3 times"});
  CAPTURE(says);
  const ShippedScene strand("beta-strand"), helix("alpha-helix");
  CHECK(placeOf(helix, caOf(20)).z - placeOf(helix, caOf(1)).z == doctest::Approx(28.4).epsilon(0.01));
  const double rise_A = (placeOf(helix, caOf(20)).z - placeOf(helix, caOf(1)).z) / 19;
  CHECK(rise_A == doctest::Approx(1.50).epsilon(0.005));
  CHECK(glm::distance(placeOf(strand, caOf(9)), placeOf(strand, caOf(11))) / 2 / rise_A ==
        doctest::Approx(2.3).epsilon(0.005));
  for (int i = 8; i <= 12; ++i) CHECK((placeOf(strand, cbOf(i)).y > 2.0) == (i % 2 == 0));
  for (int i = 8; i <= 12; ++i) CHECK(std::abs(placeOf(strand, cbOf(i)).y) > 2.0);
}

TEST_CASE(
    "on the three inner pieces of the fibril a probe touches side chains 18, 20, 22 and 24 from every sixth direction, "
    "19, 21 and 23 from fewer than one in thirty") {
  SAYS(linesSaying(kCoils, {"Every second one. Numbers 19, 21 and 23 lie on the other side",
                            "On the three inner pieces a probe of 1.4 Å touches side chains 18, 20, 22 and 24"}));
  const ShippedScene s("2beg");
  for (const char* chain : {"B", "C", "D"}) {
    CAPTURE(chain);
    const auto open = [&](int residue) {
      return s.openPlaces(std::string("chain ") + chain + " and sidechain and residue " + std::to_string(residue), 1.4);
    };
    for (const int out : {18, 20, 22, 24}) CHECK(open(out) > 500);
    for (const int in : {19, 21, 23}) CHECK(open(in) < 100);
  }
}

TEST_CASE(
    "the row of methionines, unseen, is passed by a hand that slides along it, not by one that jabs at it or stays in "
    "the middle") {
  const Lesson lesson = shippedLesson(kCoils);
  const ShippedScene s("2beg");
  const TaskSpec& row = taskOf(lesson, "a-row-that-you-cannot-see", "trace");
  std::vector<std::string> along;
  for (const char* chain : {"A", "B", "C", "D", "E"})
    along.push_back(std::string("chain ") + chain + " and residue 35 and name CE");
  const Vec3 out(0, -1, 0);
  CHECK(passes(row, s, along, out, false));
  std::reverse(along.begin(), along.end());
  CHECK(passes(row, s, along, out, false));
  CHECK_FALSE(passes(row, s, along, out, true));
  CHECK_FALSE(passes(row, s, {"chain C and residue 35 and name CE", "chain C and residue 35 and name SD"}, out, false));
}

TEST_CASE(
    "up, down, up is passed by a hand that goes from knob to knob, not by one that keeps to the upper side or jabs") {
  const Lesson lesson = shippedLesson(kCoils);
  const ShippedScene s("beta-strand");
  // The try that counts, which has no guide.
  TaskSpec way = taskOf(lesson, "up-down-up", "trace");
  Value none = way.values["guide"];
  CHECK(none.text == "spring");
  none.text = "none";
  way.values.set("guide", none);
  const Vec3 front(0, 0, 1);
  std::vector<std::string> knobs;
  for (int i = 8; i <= 12; ++i) {
    if (i > 8) knobs.push_back(caOf(i));
    knobs.push_back(cbOf(i));
    if (i < 12) knobs.push_back(caOf(i));
  }
  CHECK(passes(way, s, knobs, front, false));
  CHECK_FALSE(passes(way, s, knobs, front, true));
  CHECK_FALSE(passes(way, s, {cbOf(8), cbOf(10), cbOf(12)}, front, false));
}
