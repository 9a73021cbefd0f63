#include "tests/lesson/task_hand.h"

using namespace moltact;

namespace {

bool offers(const Task& task, std::string_view word) {
  for (const TaskButton& b : task.buttons())
    if (b.word == word) return true;
  return false;
}

}  // namespace

// Atom 0 has 1.7 A and the probe 1.4 A: a contact point y A from its centre is y - 3.1 A from its surface.
TEST_CASE(
    "find is dark until 'here' is said 0.9 A from the atom; 2.9 A away is wrong and kept as the error of the first "
    "guess") {
  auto t = task("find", {{"find", "atom 0"}});
  Hand hand{*t};
  CHECK(t->stage().dark);
  CHECK(t->stage().force_meter);
  CHECK_FALSE(offers(*t, "here"));
  t->answer({"here"});
  CHECK(figure(*t, "guesses") == 0.0);
  hand.touch({4}, 0.1, 0.5, {0, 6, 0});
  CHECK(t->sentence() == "Slide to atom 0, then say that it is here.");
  t->answer({"here"});
  CHECK_FALSE(t->done());
  CHECK(t->sentence() == "That is not atom 0. Feel on.");
  hand.touch({4}, 0.1, 0.5, {0, 4, 0});
  // A mouse lets go before it clicks.
  hand.away(1.0);
  CHECK(t->sentence() == "Say whether it was there, or feel on to find atom 0.");
  CHECK(offers(*t, "here"));
  t->answer({"here"});
  CHECK(t->done());
  CHECK_FALSE(t->stage().dark);
  CHECK(t->buttons().empty());
  CHECK(figure(*t, "guesses") == 2.0);
  CHECK(figure(*t, "error of the first guess") == doctest::Approx(2.9));
}

TEST_CASE("told by resting: 1.9 s in one place says nothing, 2.0 s says here once") {
  auto t = task("find", {{"find", "atom 0"}, {"by", "hold"}, {"meter", "off"}});
  Hand hand{*t};
  CHECK_FALSE(t->stage().force_meter);
  hand.touch({4}, 1.9, 0.5, {0, 6, 0});
  CHECK(figure(*t, "guesses") == 0.0);
  hand.touch({4}, 5.0, 0.5, {0, 6, 0});
  CHECK(figure(*t, "guesses") == 1.0);
  CHECK_FALSE(offers(*t, "here"));
  hand.touch({0}, 2.1, 0.5, {0, 3.1, 0});
  CHECK(t->done());
}

TEST_CASE("warmer and colder are said at a change of 1 A and only where the author asks") {
  for (const bool asked : {true, false}) {
    auto t = task("find", {{"find", "atom 0"}, {"hints", asked ? "warmer" : "none"}});
    Hand hand{*t};
    hand.touch({4}, 0.1, 0.5, {0, 9, 0});
    CHECK(t->sentence() == "Slide to atom 0, then say that it is here.");
    hand.touch({4}, 0.1, 0.5, {0, 7.9, 0});
    CHECK(t->sentence().ends_with(asked ? "here. Warmer." : "here."));
    hand.touch({4}, 0.1, 0.5, {0, 8.5, 0});
    CHECK(t->sentence().ends_with(asked ? "here. Warmer." : "here."));
    hand.touch({4}, 0.1, 0.5, {0, 9.0, 0});
    CHECK(t->sentence().ends_with(asked ? "here. Colder." : "here."));
  }
}

TEST_CASE("a look makes it light, counts, and what is touched meanwhile does not") {
  auto t = task("find", {{"find", "atom 0"}, {"by", "hold"}});
  Hand hand{*t};
  t->answer({"light"});
  CHECK_FALSE(t->stage().dark);
  hand.touch({0}, 5.0, 0.5, {0, 3.1, 0});
  CHECK_FALSE(t->done());
  t->answer({"dark"});
  CHECK(t->stage().dark);
  CHECK(figure(*t, "looks") == 1.0);
  hand.touch({0}, 2.1, 0.5, {0, 3.1, 0});
  CHECK(t->done());
}
