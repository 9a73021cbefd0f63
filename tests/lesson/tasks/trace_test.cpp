// Paths along atoms on the x axis and around the crease of two equal spheres, where coverage and deviation have closed
// forms.
#include <numbers>

#include "tests/lesson/task_hand.h"

using namespace moltact;

namespace {

/// Two spheres of 1.88 A, 3.76 A apart on the x axis.
Molecule pair() {
  MoleculeByHand b;
  b.atom("AR", 18, {-1.88, 0, 0}, 1.88).atom("AR", 18, {1.88, 0, 0}, 1.88);
  return b.molecule();
}

constexpr double kCrease_A = 2.68775;  // sqrt((1.88 + 1.4)^2 - 1.88^2)

/// Round the crease, from one angle to another, on a circle of some radius.
void round(Hand& hand, double from_deg, double to_deg, double radius_A = kCrease_A) {
  for (double a = from_deg; a <= to_deg; a += 0.1) {
    const double turn = a * std::numbers::pi / 180.0;
    hand.touch({0, 1}, 0.001, 0.5, {0, radius_A * std::cos(turn), radius_A * std::sin(turn)});
  }
}

}  // namespace

TEST_CASE(
    "tracing half of the crease between two spheres covers 50 % without deviation, and all but 30 degrees is enough "
    "for "
    "90 %") {
  auto t = task("trace", {{"trace", "crease"}, {"of", "all"}, {"within", "0.3 Å"}}, pair());
  Hand hand{*t};
  CHECK(t->sentence() == "Touch the crease to begin.");
  round(hand, 0, 180);
  CHECK(figure(*t, "coverage") == doctest::Approx(50.0).epsilon(0.07));
  CHECK(figure(*t, "greatest deviation") < 0.01);
  CHECK_FALSE(t->done());
  round(hand, 180, 330);
  CHECK(t->done());
}

TEST_CASE("a circle 0.5 A outside the crease is off by 0.5 A, covers nothing within 0.3 A and is reported") {
  auto t = task("trace", {{"trace", "crease"}, {"of", "all"}, {"within", "0.3 Å"}}, pair());
  Hand hand{*t};
  round(hand, 0, 20);
  const double covered = figure(*t, "coverage");
  round(hand, 40, 340, kCrease_A + 0.5);
  CHECK(figure(*t, "coverage") == covered);
  CHECK(figure(*t, "greatest deviation") == doctest::Approx(0.5).epsilon(0.02));
  CHECK(t->sentence().starts_with("You are off the way. Go back to where you left it"));
}

TEST_CASE(
    "along four atoms of 1.7 A a contact point 3.6 A from their line is 0.5 A off, and 2 of 3 A are 67 % of the way") {
  auto t = task("trace", {{"trace", "atom 0-3"}, {"called", "the backbone"}, {"within", "0.6 Å"}});
  Hand hand{*t};
  hand.touch({9}, 0.1, 0.5, {3, 3.6, 0});
  CHECK(t->sentence() == "You are on the surface. Slide to the start of the backbone to begin.");
  hand.slide({0}, {0, 3.6, 0}, {2, 3.6, 0});
  CHECK(figure(*t, "coverage") == doctest::Approx(200.0 / 3).epsilon(0.01));
  CHECK(figure(*t, "mean deviation") == doctest::Approx(0.5));
  CHECK(figure(*t, "greatest deviation") == doctest::Approx(0.5));
  CHECK(t->sentence() == "Follow the backbone: 66\u00a0% of the way.");
  hand.slide({0}, {2, 4.1, 0}, {3, 4.1, 0});
  CHECK(figure(*t, "greatest deviation") == doctest::Approx(1.0));
  CHECK_FALSE(t->done());
  hand.slide({0}, {2, 3.1, 0}, {2.8, 3.1, 0});
  CHECK(t->done());
  CHECK(figure(*t, "coverage") == doctest::Approx(90.0).epsilon(0.01));
}

TEST_CASE("touching the start, lifting and touching the end does not trace the path; the lift is counted") {
  auto t = task("trace", {{"trace", "atom 0-3"}});
  Hand hand{*t};
  hand.touch({0}, 0.1, 0.5, {0, 3, 0});
  hand.away(0.5);
  CHECK(t->sentence().starts_with("You let go. Touch the way where you left it"));
  hand.touch({3}, 0.5, 0.5, {3, 3, 0});
  CHECK(figure(*t, "coverage") < 30.0);
  CHECK(figure(*t, "lifts") == 1.0);
  hand.slide({0}, {0, 3, 0}, {3, 3, 0});
  CHECK(t->done());
}

TEST_CASE("with no lift allowed a lift of 0.35 s begins the way again and a hop of 0.25 s does not") {
  auto t = task("trace", {{"trace", "atom 0-3"}, {"lifts", "0"}});
  Hand hand{*t};
  hand.slide({0}, {0, 3, 0}, {2, 3, 0});
  hand.away(0.25);
  hand.touch({2}, 0.01, 0.5, {2, 3, 0});
  CHECK(figure(*t, "coverage") > 60.0);
  hand.away(0.35);
  CHECK(t->sentence() == "You let go too often. Begin again at the start of the way.");
  CHECK(t->progress() == 0.0);
  hand.slide({2}, {2, 3, 0}, {3, 3, 0});
  CHECK_FALSE(t->done());
  hand.slide({0}, {0, 3, 0}, {3, 3, 0});
  CHECK(t->done());
}

TEST_CASE(
    "of two attempts with no lift allowed the second lift ends the trace unsolved, with the way's atoms as the answer; "
    "a "
    "way that is followed at the second try is solved; begun again there are two once more") {
  const Keys keys{{"trace", "atom 0-3"}, {"lifts", "0"}, {"attempts", "2"}};
  auto t = task("trace", keys);
  Hand hand{*t};
  hand.slide({0}, {0, 3, 0}, {2, 3, 0});
  hand.away(0.35);
  CHECK_FALSE(t->done());
  CHECK(t->sentence() == "You let go too often. Begin again at the start of the way.");
  hand.slide({0}, {0, 3, 0}, {2, 3, 0});
  hand.away(0.35);
  REQUIRE(t->done());
  CHECK_FALSE(t->solved());
  CHECK(t->progress() == 1.0);
  CHECK(t->sentence() == "That was the last try. The way is marked in the view.");
  CHECK(t->answerAtoms() == std::vector<std::uint32_t>{0, 1, 2, 3});
  t->reset();
  CHECK_FALSE(t->done());

  auto second = task("trace", keys);
  Hand other{*second};
  other.slide({0}, {0, 3, 0}, {2, 3, 0});
  other.away(0.35);
  other.slide({0}, {0, 3, 0}, {3, 3, 0});
  CHECK(second->solved());
}

TEST_CASE("round a crease a trace's last attempt ends it too; without 'lifts' there is no try that could be wrong") {
  auto t = task("trace", {{"trace", "crease"}, {"of", "all"}, {"within", "0.3 Å"}, {"lifts", "0"}, {"attempts", "1"}},
                pair());
  Hand hand{*t};
  round(hand, 0, 90);
  hand.away(0.35);
  CHECK(t->done());
  CHECK_FALSE(t->solved());
  CHECK(t->sentence() == "That was the last try.");
  CHECK(problemOf("trace", {{"trace", "atom 0-3"}, {"attempts", "2"}}) ==
        "without 'lifts' there is no wrong try at a way");
  CHECK(problemOf("trace", {{"trace", "atom 0-3"}, {"attempts", "2"}, {"lifts", "1"}}) == "");
}

TEST_CASE("in either direction the way may begin at its end; forward it may not") {
  for (const char* direction : {"either", "forward"}) {
    auto t = task("trace", {{"trace", "atom 0 then atom 3"}, {"direction", direction}});
    Hand hand{*t};
    hand.slide({3}, {3, 3, 0}, {0.4, 3, 0});
    CAPTURE(direction);
    CHECK(figure(*t, "coverage") ==
          doctest::Approx(std::string_view(direction) == "either" ? 86.7 : 0.0).epsilon(0.01));
  }
}

TEST_CASE("keys of a trace that do not go together are reported") {
  CHECK(problemOf("trace", {{"trace", "atom 0-3"}, {"of", "all"}}) == "'of' belongs to 'trace: crease'");
  CHECK(problemOf("trace", {{"trace", "crease"}}) == "nothing says between which atoms the creases lie");
  CHECK(problemOf("trace", {{"trace", "crease"}, {"of", "all"}, {"direction", "either"}}) ==
        "a crease has no direction");
  CHECK(problemOf("trace", {{"trace", "atom 0 then"}}) != "");
  CHECK(problemOf("trace", {{"trace", "atom 0 then then atom 1"}}) == "a place is missing beside 'then'");
}

TEST_CASE(
    "a place of several atoms is reached at the first of its atoms that is touched, though its middle is 2 A farther "
    "on") {
  // Three rows of three atoms, 2 A apart, round x = 0, 10 and 20 A.
  MoleculeByHand b;
  for (const double x : {0.0, 10.0, 20.0})
    for (const double by : {-2.0, 0.0, 2.0}) b.atom("C", 6, {x + by, 0, 0});
  auto t =
      task("trace", {{"trace", "atom 0-2 then atom 3-5 then atom 6-8"}, {"within", "0.5 Å"}, {"direction", "either"}},
           b.molecule());
  Hand hand{*t};
  // The near side of the last place is all that the hand comes to; the far side of the first is where it begins.
  hand.touch({2}, 0.05, 0.5, {2.0, 3.1, 0});
  CHECK(t->sentence() == "Follow the way: 10\u00a0% of the way.");
  hand.slide({4}, {2.0, 3.1, 0}, {17.0, 3.1, 0});
  CHECK_FALSE(t->done());
  hand.touch({6}, 0.05, 0.5, {18.0, 3.1, 0});
  CHECK(t->done());
}

TEST_CASE("touching the last of the places does not finish a way whose middle was left out") {
  MoleculeByHand b;
  for (const double x : {0.0, 20.0, 40.0})
    for (const double by : {-1.0, 1.0}) b.atom("C", 6, {x + by, 0, 0});
  auto t = task("trace", {{"trace", "atom 0-1 then atom 2-3 then atom 4-5"}}, b.molecule());
  Hand hand{*t};
  hand.touch({0}, 0.1, 0.5, {0, 3.1, 0});
  hand.away(0.5);
  hand.touch({4}, 0.5, 0.5, {39, 3.1, 0});
  CHECK_FALSE(t->done());
  CHECK(figure(*t, "coverage") < 1.0);
}
