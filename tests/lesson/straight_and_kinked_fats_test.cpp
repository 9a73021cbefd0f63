// The program's lesson on fatty acids: bends, and the hands that pass its tasks.
#include <algorithm>

#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr const char* kFats = "straight-and-kinked-fats";

std::string carbon(char chain, int i) { return std::string("chain ") + chain + " and name C" + std::to_string(i); }

/// The angle between the first half of the chain and the second (unit: degree).
double bend_deg(const ShippedScene& s, char chain) {
  const auto half = [&](int from, int to) {
    const auto middle = [&](int i) {
      return 0.5 * (s.atom(carbon(chain, i)).position.A + s.atom(carbon(chain, i + 1)).position.A);
    };
    return glm::normalize(middle(to) - middle(from));
  };
  return std::acos(std::min(1.0, glm::dot(half(1, 7), half(11, 17)))) * 180 / std::numbers::pi;
}

}  // namespace

TEST_CASE(
    "straight-and-kinked-fats.md has 8 steps, six ways to trace, one of them unseen, eight trials of which seven must "
    "be right and six that only measure") {
  const Lesson lesson = shippedLesson(kFats);
  checkCare(lesson);
  CHECK(lesson.steps.size() == 8);
  CHECK(tasksOf(lesson, "trace") == 6);
  const TaskSpec& judged = taskOf(lesson, "two-fats-in-the-dark", "same");
  CHECK(judged.values["trials"].number == 8);
  CHECK(judged.values["right"].number == 7);
  CHECK(taskOf(lesson, "can-you-tell-them-apart", "same").values["right"].number == 1);
  const auto unseen = lesson.find("a-chain-that-you-cannot-see");
  REQUIRE(unseen);
  CHECK(lesson.steps[*unseen].scene.hide.select(*ShippedScene("stearic-oleic").molecule).size() == 110);
}

TEST_CASE("oleic acid alone is bent, by 76 degrees") {
  SAYS(lineSaying(kFats, "which bends it by 76°"));
  const ShippedScene oleic("stearic-oleic"), elaidic("stearic-elaidic");
  CHECK(bend_deg(oleic, 'A') < 0.5);
  CHECK(bend_deg(elaidic, 'B') < 0.5);
  CHECK(bend_deg(oleic, 'B') == doctest::Approx(76).epsilon(0.005));
}

TEST_CASE("the hydrogens at the double bond lie on one side in oleic and on two in elaidic acid") {
  const ShippedScene oleic("stearic-oleic"), elaidic("stearic-elaidic");
  const auto side = [](const ShippedScene& s) {
    const auto at = [&](const char* name) { return s.atom(std::string("chain B and name ") + name).position.A; };
    return glm::dot(at("H91") - at("C9"), at("H101") - at("C10"));
  };
  CHECK(side(oleic) > 0.3);
  CHECK(side(elaidic) < -0.9);
}

TEST_CASE("a chain of carbons at 112 degrees that lies flat and has a cis bond at 125 degrees is bent by 42 degrees") {
  const std::string line = lineSaying(kFats, "by 30° to 45°: 42° with these lengths and angles");
  CAPTURE(line);
  // In the plane: a zigzag whose bonds turn by +-68 degrees, but by 55 and 55 degrees to the same side at the double bond.
  double heading_deg = 0, side = 1;
  std::vector<glm::dvec2> c{{0, 0}};
  for (int i = 1; i < 18; ++i) {
    const double length_A = i == 9 ? 1.35 : i == 8 || i == 10 ? 1.51 : 1.53;
    c.push_back(c.back() + length_A * glm::dvec2(std::cos(heading_deg * std::numbers::pi / 180),
                                                 std::sin(heading_deg * std::numbers::pi / 180)));
    const int next = i + 1;  // the carbon at which the way turns
    if (next != 10) side = -side;
    heading_deg += side * (next == 9 || next == 10 ? 180 - 125 : 180 - 112);
  }
  const auto middle = [&](int i) { return 0.5 * (c[std::size_t(i - 1)] + c[std::size_t(i)]); };
  const auto up = glm::normalize(middle(7) - middle(1)), down = glm::normalize(middle(17) - middle(11));
  CHECK(std::acos(glm::dot(up, down)) * 180 / std::numbers::pi == doctest::Approx(42).epsilon(0.02));
}

TEST_CASE(
    "the unseen chain is passed by a hand that goes from the acid to its other end, not by one that goes straight "
    "down, jabs or begins at the wrong end") {
  const Lesson lesson = shippedLesson(kFats);
  const ShippedScene s("stearic-oleic");
  const TaskSpec& chain = taskOf(lesson, "a-chain-that-you-cannot-see", "trace");
  std::vector<std::string> along;
  for (int i = 1; i <= 18; ++i) along.push_back(carbon('B', i));
  const Vec3 front(-1, 0, 0);
  CHECK(passes(chain, s, along, front, false));
  CHECK_FALSE(passes(chain, s, along, front, true));
  CHECK_FALSE(passes(chain, s, {along[0], along[4], along[8]}, front, false));
  CHECK_FALSE(passes(chain, s, {along[8]}, front, false));
  std::reverse(along.begin(), along.end());
  CHECK_FALSE(passes(chain, s, along, front, false));
}

TEST_CASE(
    "the furrow between straight neighbours is passed by a hand that slides between the facing hydrogens of both, not "
    "by one that slides down the other side of a chain or over its carbons, or that jabs") {
  const Lesson lesson = shippedLesson(kFats);
  const ShippedScene s("straight-neighbours");
  const TaskSpec& furrow = taskOf(lesson, "side-by-side", "trace");
  const auto down = [&](const char* chain, const std::string& before, const std::string& after) {
    std::vector<std::string> out;
    for (int i = 2; i <= 18; ++i)
      out.push_back(std::string("chain ") + chain + " and name " + before + std::to_string(i) + after);
    return out;
  };
  const Vec3 front(1, 0, 0);
  std::vector<std::string> both = down("A", "H", "1"), other = down("B", "H", "2"), between;
  for (std::size_t k = 0; k < both.size(); ++k) {
    between.push_back(both[k]);
    between.push_back(other[k]);
  }
  CHECK(passes(furrow, s, between, front, false));
  CHECK_FALSE(passes(furrow, s, between, front, true));
  for (const Vec3& outside : {Vec3(-1, 0, 0), Vec3(0, 0, 1)}) {
    CHECK_FALSE(passes(furrow, s, down("A", "H", "2"), outside, false));
    CHECK_FALSE(passes(furrow, s, down("A", "C", ""), outside, false));
  }
}
