#include "engine/lesson/tasks/sensitivity.h"
#include "engine/molecule/catalogue.h"
#include "engine/molecule/side_by_side.h"
#include "tests/lesson/task_hand.h"

using namespace moltact;

namespace {

const Keys kProbes{{"same", "anywhere"}, {"probe", "2 Å"}, {"trials", "8"}, {"for", "0.2 s"}};

/// The true values of one pair, which no student can see.
struct SamePair {
  bool differ = false;
  std::string order;
};

/// Feels one pair; says "different" as `say` makes of the truth. Gives the truth.
template <class Say>
SamePair feelPair(Task& task, Hand& hand, Say say) {
  SamePair pair;
  bool other[2] = {};
  for (int k = 0; k < 2; ++k) {
    REQUIRE(task.stage().dark);
    other[k] = task.stage().touch.has(&TouchSetup::probe_A);
    pair.order += other[k] ? 'B' : 'A';
    hand.away(0.01);
    CHECK(task.buttons().empty());
    hand.touch({0}, 0.21);
    if (k == 0) task.answer({"next"});
  }
  pair.differ = other[0] != other[1];
  REQUIRE(task.buttons().size() == 2);
  task.answer({say(pair.differ) ? "different" : "same"});
  return pair;
}

}  // namespace

TEST_CASE(
    "pairs follow from the number they are drawn by; the author's own number stands above it; answering rightly "
    "finishes with "
    "all marks right") {
  std::vector<std::string> orders;
  struct Drawn {
    std::uint64_t by;
    const char* seed;
  };
  for (const Drawn& drawn : {Drawn{1, ""}, Drawn{1, ""}, Drawn{2, ""}, Drawn{1, "5"}, Drawn{2, "5"}}) {
    Keys keys = kProbes;
    if (*drawn.seed) keys.emplace_back("seed", drawn.seed);
    auto t = task("same", keys);
    t->drawBy(drawn.by);
    Hand hand{*t};
    int differ = 0;
    orders.emplace_back();
    for (int k = 0; k < 8; ++k) {
      CHECK_FALSE(t->done());
      const SamePair p = feelPair(*t, hand, [](bool d) { return d; });
      differ += p.differ;
      orders.back() += p.order + " ";
    }
    CHECK(t->done());
    CHECK(figure(*t, "hits") == differ);
    CHECK(figure(*t, "false alarms") == 0.0);
    CHECK(figure(*t, "d'") == doctest::Approx(sensitivity(differ, differ, 0, 8 - differ)));
    CHECK(t->sentence() == "8 of 8 right. Done.");
    CHECK(t->trials().right == std::vector<bool>(8, true));
  }
  CHECK(orders[0] == orders[1]);
  CHECK(orders[0] != orders[2]);
  CHECK(orders[3] == orders[4]);
}

TEST_CASE("each pair is a coin for itself: over 500 draws of 8 pairs half differ, and of 2 neighbours half are alike") {
  int differ = 0, alike = 0;
  for (int k = 0; k < 500; ++k) {
    auto t = task("same", kProbes);
    t->drawBy(std::uint64_t(k));
    Hand hand{*t, 0.0, 0.01};
    bool last = false;
    for (int pair = 0; pair < 8; ++pair) {
      const SamePair p = feelPair(*t, hand, [](bool d) { return d; });
      differ += p.differ;
      alike += pair > 0 && p.differ == last;
      last = p.differ;
    }
  }
  // Four standard deviations of 4000 and of 3500 coins.
  CHECK(std::abs(differ - 2000) < 127);
  CHECK(std::abs(alike - 1750) < 119);
}

TEST_CASE("who answers 5 of 8 rightly feels another round of other pairs, and so does who begins the task again") {
  auto t = task("same", kProbes);
  Hand hand{*t};
  std::string first, second;
  int k = 0;
  for (; k < 8; ++k) first += feelPair(*t, hand, [&](bool d) { return k < 5 ? d : !d; }).order;
  CHECK_FALSE(t->done());
  CHECK(t->progress() == 0.0);
  CHECK(t->sentence() == "5 of 8 right; 6 are needed. Another round: Touch the first of pair 1 of 8.");
  CHECK(figure(*t, "rounds") == 2.0);
  // The marks of the round stay until the next begins.
  CHECK(t->trials().right == std::vector<bool>{true, true, true, true, true, false, false, false});
  t->reset();
  CHECK(t->trials().right.empty());
  for (int again = 0; again < 8; ++again) second += feelPair(*t, hand, [](bool d) { return d; }).order;
  CHECK(t->done());
  CHECK(first != second);
}

TEST_CASE(
    "a task that is asked before is one round of 8 pairs, done with any answers, without feedback; "
    "its d' is that of hits and false alarms by the log-linear correction") {
  Keys keys = kProbes;
  keys.emplace_back("asked", "before");
  keys.emplace_back("praise", "Kept.");
  auto t = task("same", keys);
  Hand hand{*t};
  int differ = 0, alike = 0;
  for (int k = 0; k < 8; ++k) {
    CHECK_FALSE(t->done());
    const SamePair p = feelPair(*t, hand, [](bool d) { return !d; });
    (p.differ ? differ : alike) += 1;
    CHECK(t->trials().right.empty());
  }
  CHECK((t->done() && t->solved()));
  CHECK(t->sentence() == "Kept.");
  // All wrong: no hit, and every pair that was alike a false alarm.
  const double expected = normalQuantile(0.5 / (differ + 1.0)) - normalQuantile((alike + 0.5) / (alike + 1.0));
  CHECK(figure(*t, "d' in the first round") == doctest::Approx(expected).epsilon(1e-12));
  if (differ == 4) CHECK(expected == doctest::Approx(-2.5631031).epsilon(1e-7));  // -2 z(0.9)
}

TEST_CASE("of a task that is asked after, the first round counts, however many there are") {
  Keys keys = kProbes;
  keys.emplace_back("asked", "after");
  auto t = task("same", keys);
  Hand hand{*t};
  int differ = 0;
  for (int k = 0; k < 8; ++k) differ += feelPair(*t, hand, [](bool d) { return !d; }).differ;
  CHECK_FALSE(t->done());
  for (int k = 0; k < 8; ++k) feelPair(*t, hand, [](bool d) { return d; });
  REQUIRE(t->done());
  const int alike = 8 - differ;
  CHECK(figure(*t, "d' in the first round") ==
        doctest::Approx(normalQuantile(0.5 / (differ + 1.0)) - normalQuantile((alike + 0.5) / (alike + 1.0))));
  CHECK(figure(*t, "d'") > 2.0);
}

TEST_CASE("with a number of the author's, the pairs asked after are others than those asked before") {
  std::vector<std::string> orders;
  for (const char* asked : {"before", "after"}) {
    Keys keys = kProbes;
    keys.emplace_back("asked", asked);
    keys.emplace_back("seed", "5");
    auto t = task("same", keys);
    t->drawBy(3);
    Hand hand{*t};
    orders.emplace_back();
    for (int k = 0; k < 8; ++k) orders.back() += feelPair(*t, hand, [](bool d) { return d; }).order;
  }
  CHECK(orders[0] != orders[1]);
}

TEST_CASE("each answer is judged at once, unless the author says no") {
  for (const bool tell : {true, false}) {
    Keys keys = kProbes;
    keys.emplace_back("tell", tell ? "yes" : "no");
    auto t = task("same", keys);
    Hand hand{*t};
    const SamePair p = feelPair(*t, hand, [](bool d) { return !d; });
    const std::string reported = p.differ ? "No, they were different. " : "No, they were the same. ";
    CHECK(t->sentence() == (tell ? reported : "") + "Touch the first of pair 2 of 8.");
    CHECK(t->trials().right.size() == (tell ? 1 : 0));
  }
}

TEST_CASE("two places are turned to the front, each its own, and only a touch of it counts") {
  auto t = task("same", {{"same", "atom 0"}, {"place", "atom 4"}, {"trials", "2"}, {"for", "0.2 s"}});
  Hand hand{*t};
  REQUIRE(t->stage().facing);
  const bool other = t->stage().facing->A.x == 10.0;
  CHECK((other || t->stage().facing->A.x == 0.0));
  hand.touch({other ? 0 : 4}, 1.0, 0.5, {other ? 0.0 : 10.0, 0, 0});
  CHECK(t->buttons().empty());
  CHECK(t->sentence() == "You are beside the place. It lies in the middle of the view: let go, and push there.");
  hand.touch({other ? 4 : 0}, 0.21);
  CHECK(t->buttons().size() == 1);
}

TEST_CASE(
    "two molecules beside each other are compared by their chains: of each pair either is turned to the front, only a "
    "touch "
    "of that one counts, and who tells twice the first from both is done") {
  const auto read = [](const char* name) { return *openMolecule(name); };
  const Molecule both = sideBySide(read("alpha-helix"), read("beta-strand"));
  REQUIRE(both.beside_from > 0);
  const std::int32_t of_first = 3, of_second = std::int32_t(both.beside_from) + 3;
  double first_ends_A = -1e9;
  for (std::size_t i = 0; i < both.beside_from; ++i) first_ends_A = std::max(first_ends_A, both.spheres[i].centre_A.x);
  int pairs_that_differ = 0, seconds_felt = 0;
  for (std::uint64_t by = 0; by < 12; ++by) {
    auto t = task("same", {{"same", "chain A"}, {"place", "chain A2"}, {"trials", "2"}, {"for", "0.2 s"}}, both);
    t->drawBy(by);
    Hand hand{*t};
    for (int pair = 0; pair < 2; ++pair) {
      bool second[2] = {};
      for (int k = 0; k < 2; ++k) {
        REQUIRE(t->stage().dark);
        REQUIRE(t->stage().facing);
        second[k] = t->stage().facing->A.x > first_ends_A;
        hand.away(0.01);
        const std::int32_t wrong = second[k] ? of_first : of_second;
        hand.touch({wrong}, 0.5, 0.5, both.spheres[std::size_t(wrong)].centre_A);
        CHECK(t->buttons().empty());
        hand.away(0.01);
        hand.touch({second[k] ? of_second : of_first}, 0.21);
        CHECK_FALSE(t->buttons().empty());
        if (k == 0) t->answer({"next"});
      }
      seconds_felt += second[0] + second[1];
      pairs_that_differ += second[0] != second[1];
      t->answer({second[0] != second[1] ? "different" : "same"});
    }
    CHECK(t->done());
    CHECK(figure(*t, "false alarms") == 0.0);
  }
  CHECK(pairs_that_differ > 4);
  CHECK(pairs_that_differ < 20);
  CHECK(seconds_felt > 10);
  CHECK(seconds_felt < 38);
}

TEST_CASE(
    "atoms that are taken out for the second thing are taken out for half of what is felt, and for nothing else") {
  auto t = task("same", {{"same", "anywhere"}, {"remove", "atom 3-4"}, {"trials", "100"}, {"for", "0.2 s"}});
  Hand hand{*t, 0.0, 0.01};
  int without = 0;
  for (int k = 0; k < 200; ++k) {
    const std::vector<std::uint32_t> removed = t->stage().removed;
    if (!removed.empty()) {
      CHECK(removed == std::vector<std::uint32_t>{3, 4});
      ++without;
    }
    hand.touch({0}, 0.21);
    hand.away(0.01);
    t->answer({k % 2 == 0 ? "next" : "same"});
  }
  CHECK(std::abs(without - 100) < 29);  // four standard deviations of 200 coins
}

TEST_CASE(
    "where atoms are taken out the view stays the scene's, and who is beside the place is not sent to its middle") {
  auto t = task("same", {{"same", "atom 0"}, {"remove", "atom 3-4"}, {"trials", "2"}, {"for", "0.2 s"}});
  Hand hand{*t};
  CHECK_FALSE(t->stage().facing);
  hand.touch({2}, 1.0, 0.5, {20, 20, 0});
  CHECK(t->buttons().empty());
  CHECK(t->sentence() == "You are beside the place: let go, and push elsewhere.");
}

TEST_CASE("a second thing of which nothing is left to be felt is no task") {
  const auto problemWithout = [](const Keys& keys, std::vector<std::uint32_t> untouchable = {}) {
    std::vector<Problem> problems;
    const TaskSpec spec = specOf("same", keys, problems);
    findTaskKind("same")->check_molecule(spec, mixedMolecule(), untouchable, problems);
    return problems.empty() ? std::string() : problems.front().message;
  };
  CHECK(problemWithout({{"same", "atom 3"}, {"remove", "atom 3-4"}}) ==
        "without these atoms nothing is left to be felt");
  CHECK(problemWithout({{"same", "anywhere"}, {"remove", "all"}}) == "without these atoms nothing is left to be felt");
  CHECK(problemWithout({{"same", "atom 2-3"}, {"remove", "atom 3-4"}}) == "");
  CHECK(problemWithout({{"same", "atom 2-3"}, {"remove", "atom 3-4"}}, {2}) ==
        "without these atoms nothing is left to be felt");
  CHECK(problemWithout({{"same", "anywhere"}, {"remove", "atom 3-4"}}) == "");
}

TEST_CASE("what differs must be named once") {
  CHECK(problemOf("same", {{"same", "anywhere"}}) == "nothing says how the second thing differs from the scene");
  CHECK(problemOf("same", {{"same", "anywhere"}, {"probe", "2 Å"}, {"method", "mesh80"}}) ==
        "the two things differ in one respect only");
  CHECK(problemOf("same", {{"same", "anywhere"}, {"place", "atom 3"}}) ==
        "two places are to be felt, but only one is named");
  CHECK(problemOf("same", {{"same", "anywhere"}, {"probe", "2 Å"}, {"trials", "4"}, {"right", "5"}}) ==
        "more right answers than there are trials");
}

TEST_CASE("z(0.975) is 1.95996, z(0.5) is 0; 9 of 10 hits and 2 of 10 false alarms give d' of 1.845") {
  CHECK(normalQuantile(0.975) == doctest::Approx(1.959964).epsilon(1e-6));
  CHECK(std::abs(normalQuantile(0.5)) < 1e-12);
  // z(9.5 / 11) + z(8.5 / 11) = 1.0968 + 0.7479, from tables of the normal distribution.
  CHECK(sensitivity(9, 10, 2, 10) == doctest::Approx(1.8447).epsilon(0.0005));
  CHECK(sensitivity(3, 10, 3, 10) == doctest::Approx(0.0));
}
