#include "tests/lesson/task_hand.h"

using namespace moltact;

namespace {

/// A straight line of force against depth: `at_end_N` at the axis's end.
TaskAnswer line(const Task& task, double at_end_N) {
  TaskAnswer answer;
  const std::size_t n = task.curves()->drawn.size();
  for (std::size_t k = 0; k < n; ++k) answer.curve.push_back(at_end_N * double(k) / double(n - 1));
  return answer;
}

/// Presses in to `deep_A` against a spring of 2 N/A.
void press(Hand& hand, double deep_A) {
  for (double d = 0.0; d <= deep_A; d += 0.001) hand.touch({0}, 0.001, 2.0 * d, {0, 0, 3.1}, d);
}

}  // namespace

TEST_CASE("a prediction of 2 N/A agrees by 100 % with a spring of 2 N/A, one of 1 N/A by 50 %, one of nothing by 0 %") {
  for (const auto& [at_end_N, agreement] : {std::pair(2.0, 1.0), std::pair(1.0, 0.5), std::pair(0.0, 0.0)}) {
    auto t = task("predict", {{"predict", "atom 0"}, {"deep", "1 Å"}});
    Hand hand{*t};
    REQUIRE(t->curves());
    CHECK(t->curves()->drawing);
    press(hand, 1.0);
    CHECK(t->progress() == 0.0);
    t->answer(line(*t, at_end_N));
    CHECK(t->progress() == 0.5);
    press(hand, 1.0);
    REQUIRE(t->done());
    REQUIRE(t->curves()->agreement);
    CHECK(*t->curves()->agreement == doctest::Approx(agreement).epsilon(0.01));
    CHECK(figure(*t, "agreement") == doctest::Approx(100 * agreement).epsilon(0.01));
    CHECK(t->curves()->felt[12] == doctest::Approx(1.0).epsilon(0.01));
  }
}

TEST_CASE("half of the depth is not yet felt; only contact with the named atom counts") {
  auto t = task("predict", {{"predict", "atom 0"}, {"deep", "2 Å"}});
  Hand hand{*t};
  t->answer(line(*t, 4.0));
  press(hand, 1.0);
  CHECK_FALSE(t->done());
  CHECK(t->progress() == doctest::Approx(0.5 + 0.5 * (13.0 / 25) / 0.9).epsilon(0.05));
  for (double d = 0.0; d <= 2.0; d += 0.001) hand.touch({4}, 0.001, 1.0, {0, 0, 3.1}, d);
  CHECK_FALSE(t->done());
  press(hand, 2.0);
  CHECK(t->done());
  CHECK(t->sentence() == "Your curve and the one that you felt agree by 100\u00a0%. Done.");
}

TEST_CASE("with 80 % asked for, a prediction of 50 % is to be drawn again and the first agreement is kept") {
  auto t = task("predict", {{"predict", "anywhere"}, {"agree", "80"}});
  Hand hand{*t};
  t->answer(line(*t, 1.0));
  press(hand, 1.0);
  CHECK_FALSE(t->done());
  CHECK(t->curves()->drawing);
  CHECK(t->sentence().starts_with("The two curves agree by 50\u00a0%; 80\u00a0% are asked for."));
  t->answer(line(*t, 2.0));
  press(hand, 1.0);
  CHECK(t->done());
  CHECK(figure(*t, "predictions") == 2.0);
  CHECK(figure(*t, "agreement of the first prediction") == doctest::Approx(50.0).epsilon(0.01));
}

TEST_CASE("against the way: sliding 2.9 of 3 A from atom 0 to atom 3 feels the force over the way") {
  auto t = task("predict", {{"predict", "atom 0"}, {"along", "atom 3"}});
  Hand hand{*t};
  CHECK(t->curves()->x_max_A == doctest::Approx(3.0));
  t->answer(line(*t, 0.5));
  hand.slide({0}, {0, 3.1, 0}, {2.9, 3.1, 0}, 0.5);
  CHECK(t->done());
  // A flat curve at 0.5 N over a line from 0 to 0.5 N: the areas have 1/2 in common.
  CHECK(*t->curves()->agreement == doctest::Approx(0.5).epsilon(0.03));
}

TEST_CASE("curves of another length, with holes or below zero are passed over") {
  auto t = task("predict", {{"predict", "anywhere"}});
  TaskAnswer bad = line(*t, 1.0);
  bad.curve[3] = -0.1;
  t->answer(bad);
  CHECK(t->curves()->drawing);
  bad.curve[3] = std::nan("");
  t->answer(bad);
  bad.curve.pop_back();
  t->answer(bad);
  CHECK(t->curves()->drawing);
  CHECK(problemOf("predict", {{"predict", "anywhere"}, {"along", "atom 3"}}) == "the way has no start");
  CHECK(problemOf("predict", {{"predict", "atom 0"}, {"along", "atom 3"}, {"deep", "1 Å"}}) ==
        "'deep' belongs to pressing in and 'along' to sliding");
}
