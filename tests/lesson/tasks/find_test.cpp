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
  CHECK(t->sentence() == "That is not atom 0, but close to it. 2 guesses are left.");
  hand.touch({4}, 0.1, 0.5, {0, 4, 0});
  // With a mouse the hand has to let go before clicking.
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

TEST_CASE("answering by resting: 1.9 s in one place says nothing, 2.0 s says here once") {
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

TEST_CASE(
    "a wrong guess is warmer or colder than the one before by 1 A if the author requests it; a "
    "sliding hand gets no hint") {
  for (const bool asked : {true, false}) {
    auto t = task("find", {{"find", "atom 0"}, {"hints", asked ? "warmer" : "none"}, {"guesses", "9"}});
    Hand hand{*t};
    const auto guessAt = [&](double y_A) {
      hand.touch({4}, 0.1, 0.5, {0, y_A, 0});
      CHECK(t->sentence() == "Slide to atom 0, then say that it is here.");
      t->answer({"here"});
      return t->sentence();
    };
    const auto tells = [](const std::string& said, const char* word) { return said.find(word) != std::string::npos; };
    CHECK_FALSE((tells(guessAt(9.0), "Warmer") || tells(t->sentence(), "Colder")));
    CHECK(tells(guessAt(7.9), "Warmer.") == asked);
    CHECK_FALSE(tells(guessAt(8.5), "Colder."));
    CHECK(tells(guessAt(9.6), "Colder.") == asked);
  }
}

TEST_CASE(
    "after 3 wrong guesses, and after each of 2 looks, the molecule lies turned another way and is met from outside") {
  auto t = task("find", {{"find", "atom 0"}});
  t->drawBy(7);
  Hand hand{*t};
  std::vector<TaskStage> stages{t->stage()};
  REQUIRE(stages[0].turned);
  for (int k = 0; k < 3; ++k) {
    hand.touch({9}, 0.1, 0.5, {40, 3.1, 0});
    hand.away(0.5);
    t->answer({"here"});
    CHECK(t->sentence().starts_with("That is not atom 0: it lies elsewhere."));
  }
  CHECK(t->sentence().ends_with("That was the last guess: the molecule has been turned. Search again."));
  CHECK_FALSE(offers(*t, "here"));
  stages.push_back(t->stage());
  for (int k = 0; k < 2; ++k) {
    t->answer({"light"});
    CHECK(t->stage().turned == stages.back().turned);
    t->answer({"dark"});
    stages.push_back(t->stage());
  }
  CHECK_FALSE(offers(*t, "light"));
  for (std::size_t k = 1; k < stages.size(); ++k) {
    CHECK(stages[k].turned != stages[k - 1].turned);
    CHECK(stages[k].presentation != stages[k - 1].presentation);
  }
  // The place looks to the person in each: within 70 degrees of the line of sight.
  const Vec3 outward = Vec3(0.0) - Vec3(11.9, 0, 0);
  for (const TaskStage& s : stages)
    CHECK(glm::dot(*s.turned * Vec3(0, 0, 1), glm::normalize(outward)) > std::cos(70.0 * 3.14159265 / 180.0));
  auto as_written = task("find", {{"find", "atom 0"}, {"turn", "none"}});
  CHECK_FALSE(as_written->stage().turned);
}

TEST_CASE(
    "what the author says to a touch of other atoms is said to the guess there; a side and a region limit what "
    "counts") {
  auto t = task("find", {{"find", "atom 0"}, {"wrong", "element Zn -> That is the zinc."}, {"within", "0 Å"}});
  Hand hand{*t};
  hand.touch({9}, 0.1, 0.5, {40, 3.1, 0});
  t->answer({"here"});
  CHECK(t->sentence() == "That is the zinc. 2 guesses are left.");

  auto side = task("find", {{"find", "atom 3"}, {"side", "atom 4"}, {"within", "0 Å"}});
  Hand other{*side};
  other.touch({3}, 0.1, 0.5, {2.5, 3.0, 0});
  side->answer({"here"});
  CHECK_FALSE(side->done());
  other.touch({3}, 0.1, 0.5, {3.5, 3.0, 0});
  side->answer({"here"});
  CHECK(side->done());
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
