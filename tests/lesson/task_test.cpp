// Tasks with synthetic samples, at 1 kHz unless a test says otherwise.
#include <doctest/doctest.h>

#include <random>

#include "tests/lesson/task_hand.h"

using namespace moltact;

TEST_CASE("reach is done after 0.1 s on the oxygen, not after 0.05 s, and stays done") {
  auto t = task("reach", {{"reach", "element O"}});
  Hand hand{*t};
  CHECK(t->sentence() == "Move the probe to an oxygen atom until it stops you.");
  hand.touch({1}, 1.0);
  CHECK(t->sentence() == "You are on the surface. Slide on to find an oxygen atom.");
  CHECK_FALSE(t->done());
  hand.touch({3}, 0.05);
  CHECK_FALSE(t->done());
  CHECK(t->progress() == doctest::Approx(0.5).epsilon(0.05));
  hand.away(0.01);
  CHECK(t->progress() == 0.0);
  hand.touch({1, 3}, 0.102);
  CHECK(t->done());
  CHECK(t->progress() == 1.0);
  CHECK(t->sentence() == "Done.");
  hand.away(5.0);
  CHECK(t->done());
}

TEST_CASE("reach near 4 Å counts a contact point 3.9 Å from the atom's centre and not one 4.1 Å away") {
  auto t = task("reach", {{"reach", "atom 0"}, {"near", "4 Å"}});
  Hand hand{*t};
  hand.touch({2}, 0.2, 0.5, {0, 4.1, 0});
  CHECK_FALSE(t->done());
  hand.touch({2}, 0.2, 0.5, {0, 3.9, 0});
  CHECK(t->done());
}

TEST_CASE("hold for 2 s forgives a slip of 0.25 s and starts again after one of 0.35 s") {
  auto t = task("hold", {{"hold", "ligand"}, {"for", "2 s"}});
  Hand hand{*t};
  hand.touch({6}, 1.2);
  CHECK(t->sentence() == "Hold it: 1.2\u00a0s of 2.0\u00a0s.");
  hand.away(0.25);
  hand.touch({7}, 0.4);
  CHECK(t->sentence() == "Hold it: 1.6\u00a0s of 2.0\u00a0s.");
  hand.away(0.35);
  CHECK(t->progress() == 0.0);
  CHECK(t->sentence() == "You slipped off. Touch the ligand again and hold for 2.0\u00a0s.");
  hand.touch({7}, 1.9);
  CHECK_FALSE(t->done());
  hand.touch({7}, 0.2);
  CHECK(t->done());
}

TEST_CASE("hold between 0.2 N and 0.6 N asks for more at 0.1 N and for less at 0.8 N, and takes 0.62 N") {
  auto t = task("hold", {{"hold", "crease"}, {"for", "1 s"}, {"force", "0.2 N to 0.6 N"}});
  Hand hand{*t};
  hand.touch({0, 1}, 0.1, 0.1);
  CHECK(t->sentence() == "Push a little further in: 0.20\u00a0N is enough.");
  hand.touch({0, 1}, 0.1, 0.8);
  CHECK(t->sentence() == "Ease off a little: stay below 0.60\u00a0N.");
  hand.touch({0}, 2.0, 0.4);
  CHECK(t->sentence() == "You are on the surface. Slide on to find a crease between two atoms.");
  CHECK_FALSE(t->done());
  hand.touch({0, 1}, 1.05, 0.62);
  CHECK(t->done());
}

TEST_CASE("one noisy sample of 5 N does not finish a press until 0.8 N, 0.1 s of 0.9 N does") {
  auto t = task("press", {{"press", "anywhere"}, {"until", "0.8 N"}});
  Hand hand{*t};
  hand.touch({0}, 0.1, 0.4);
  CHECK(t->progress() == doctest::Approx(0.5));
  CHECK(t->sentence() == "You push with 0.40\u00a0N of 0.80\u00a0N. Push further in.");
  hand.touch({0}, 0.001, 5.0);
  CHECK_FALSE(t->done());
  hand.touch({0}, 1.0, 0.4);
  CHECK_FALSE(t->done());
  hand.touch({0}, 0.11, 0.9);
  CHECK(t->done());
}

TEST_CASE("feel sphere, crease, pit takes the three in any order and names what is missing") {
  auto t = task("feel", {{"feel", "sphere, crease, pit"}});
  Hand hand{*t};
  hand.touch({0, 1, 2}, 0.11);
  CHECK(t->progress() == doctest::Approx(1.0 / 3));
  hand.touch({0}, 0.11);
  hand.away(0.5);
  CHECK(t->sentence() == "Touch the surface, then slide until you feel a crease between two atoms.");
  hand.touch({2, 3}, 0.11);
  CHECK(t->done());
}

TEST_CASE(
    "after 5 presses without a pit a hint explains how to find one, and at the 9th press three atoms "
    "of one are shown") {
  // Three spheres of 1.7 A whose centres are 3.4 A apart: a probe of 1.4 A rests on all three, 2.40 A above their plane.
  MoleculeByHand b;
  const double side = 3.4;
  b.atom("A", 18, {0, 0, 0}).atom("B", 18, {side, 0, 0}).atom("C", 18, {0.5 * side, std::sqrt(0.75) * side, 0});
  auto t = task("feel", {{"feel", "pit"}}, b.molecule());
  Hand hand{*t};
  const Vec3 beside{0, 0, 3.1};
  std::string reported;
  for (int press = 1; press <= 9; ++press) {
    CAPTURE(press);
    hand.touch({0}, 0.2, 0.5, beside);
    CHECK(t->stage().close_to.has_value() == (press >= 5));
    CHECK(t->exampleAtoms().empty() == (press < 9));
    reported = t->sentence();
    CHECK(((reported.find("dent between three balls") != std::string::npos) == (press >= 5 && press < 9)));
    hand.away(0.5);
  }
  CHECK(t->exampleAtoms() == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(reported.find("marked") != std::string::npos);
  CHECK_FALSE(t->done());
  hand.touch({0, 1, 2}, 0.2);
  CHECK(t->done());
  CHECK(t->stage() == TaskStage());
}

TEST_CASE("the task to touch five places names the next one and counts those that were touched") {
  auto t = task("compare", {{"compare", "places"},
                            {"of", "(chain A and residue 52 and name N) then (chain B and residue 1)"},
                            {"for", "0.5 s"}});
  Hand hand{*t};
  CHECK(t->sentence() == "0 of 2 places touched. Now touch Asp 52 (chain A).");
  hand.touch({0}, 0.6);
  hand.away(0.5);
  CHECK(t->sentence() == "1 of 2 places touched. Now touch haem 1 (chain B).");
}

TEST_CASE("feel 3 atoms of the protein does not count the ligand or one atom twice") {
  auto t = task("feel", {{"feel", "atoms"}, {"count", "3"}, {"of", "protein"}});
  Hand hand{*t};
  for (const std::int32_t a : {0, 6, 0, 7, 1}) hand.touch({a}, 0.12);
  CHECK(t->sentence() == "2 of 3 atoms felt. Slide on to the next one.");
  hand.touch({2}, 0.12);
  CHECK(t->done());
}

TEST_CASE("feel atoms asks for no more atoms than there are: 100 of a ligand of 2 are 2") {
  auto t = task("feel", {{"feel", "atoms"}, {"count", "100"}, {"of", "ligand"}});
  Hand hand{*t};
  hand.touch({6, 7}, 0.12);
  CHECK(t->done());
}

TEST_CASE("cross counts sphere 0, crease, sphere 1, but not a hop through the air or a way over atom 2") {
  auto t = task("cross", {{"cross", "atom 0"}, {"to", "atom 1"}});
  Hand hand{*t};
  hand.touch({1}, 0.2);
  CHECK(t->sentence() == "Slide to atom 0 to begin.");
  hand.touch({0}, 0.2);
  CHECK(t->sentence() == "Now slide to atom 1 without letting go.");
  hand.away(0.2);
  CHECK(t->sentence() == "You left the surface. Start again on atom 0.");
  hand.touch({1}, 0.2);
  CHECK_FALSE(t->done());
  hand.touch({0}, 0.2);
  hand.touch({2}, 0.2);
  hand.touch({1}, 0.2);
  CHECK_FALSE(t->done());
  hand.touch({0}, 0.2);
  hand.touch({0, 1}, 0.2);
  CHECK_FALSE(t->done());
  hand.touch({1}, 0.01);
  CHECK(t->done());
}

TEST_CASE("a press that comes down on atom 0 and glances off to atom 1 within 0.1 s has not slid across") {
  for (const char* direction : {"forward", "either"}) {
    auto t = task("cross", {{"cross", "atom 0"}, {"to", "atom 1"}, {"direction", direction}});
    Hand hand{*t};
    for (int press = 0; press < 5; ++press) {
      hand.touch({0}, 0.06);
      hand.touch({0, 1}, 0.02);
      hand.touch({1}, 0.3);
      hand.away(0.5);
    }
    CHECK_FALSE(t->done());
    hand.touch({0}, 0.12);
    hand.touch({1}, 0.05);
    CHECK(t->done());
  }
}

TEST_CASE("cross in either direction may begin on the second atom, and there and back is 2 times") {
  auto t = task("cross", {{"cross", "atom 0"}, {"to", "atom 1"}, {"direction", "either"}, {"times", "2"}});
  Hand hand{*t};
  CHECK(t->sentence() == "Touch one atom to begin (0 of 2).");
  hand.touch({1}, 0.2);
  hand.touch({0, 1}, 0.1);
  hand.touch({0}, 0.2);
  CHECK_FALSE(t->done());
  CHECK(t->sentence() == "Now slide to the other atom without letting go (1 of 2).");
  hand.touch({1}, 0.2);
  CHECK(t->done());
}

TEST_CASE("cross in either direction keeps the names that its author gives, on whichever side the student begins") {
  auto t = task("cross", {{"cross", "atom 0"},
                          {"called", "the knob"},
                          {"to", "atom 1"},
                          {"arrival", "the stem"},
                          {"direction", "either"}});
  Hand hand{*t};
  CHECK(t->sentence() == "Touch the knob or the stem to begin.");
  hand.touch({1}, 0.2);
  CHECK(t->sentence() == "Now slide to the knob without letting go.");
  hand.away(0.5);
  CHECK(t->sentence().starts_with("You left the surface. Start again on "));
  hand.touch({0}, 0.2);
  CHECK(t->sentence() == "Now slide to the stem without letting go.");
  hand.touch({1}, 0.2);
  CHECK(t->done());
}

TEST_CASE("the one crease between start and end is found among more than 400 roomier ones") {
  MoleculeByHand b;
  for (int k = 0; k < 60; ++k) b.atom("C", 6, {4.0 * k, 0, 0});
  b.atom("O", 8, {122, 3.5, 0});
  auto t = task("cross", {{"cross", "element C"}, {"to", "element O"}}, b.molecule());
  const SphereGrid spheres(b.molecule().spheres);
  CHECK_FALSE(t->demonstrate({.spheres = spheres}).empty());
}

TEST_CASE("avoid counts 3 s on the rest of the surface, begins again at a touch, and does not count the air") {
  auto t = task("avoid", {{"avoid", "ligand"}, {"for", "3 s"}});
  Hand hand{*t};
  hand.away(10.0);
  CHECK(t->progress() == 0.0);
  hand.touch({0}, 2.0);
  hand.touch({0, 6}, 0.001);
  CHECK(t->sentence() == "That is the ligand. Move away from it; the time starts again.");
  hand.touch({0}, 2.0);
  CHECK_FALSE(t->done());
  hand.touch({1}, 1.01);
  CHECK(t->done());
}

TEST_CASE("hold in a pit of some atoms does not take a pit that another atom helps to make") {
  auto t = task("hold", {{"hold", "pit"}, {"of", "chain A"}, {"for", "1 s"}});
  Hand hand{*t};
  hand.touch({0, 1, 6}, 1.5);
  CHECK_FALSE(t->done());
  hand.touch({0, 1, 2}, 1.1);
  CHECK(t->done());
  CHECK(problemOf("hold", {{"hold", "chain A"}, {"of", "chain B"}}) == "'of' belongs to a kind of place");
}

TEST_CASE("samples at 30 Hz finish a hold of 2 s after 2.0 to 2.1 s; a gap of 10 s between samples counts nothing") {
  auto t = task("hold", {{"hold", "anywhere"}, {"for", "2 s"}});
  Hand slow{*t, 0.0, 1.0 / 30};
  slow.touch({0}, 1.9);
  slow.time_s += 10.0;
  slow.touch({0}, 0.03);
  CHECK_FALSE(t->done());
  slow.touch({0}, 0.3);
  CHECK(t->done());
}

TEST_CASE("a start inside the molecule is explained") {
  auto t = task("reach", {{"reach", "all"}});
  TouchSample s;
  s.time_s = 1.0;
  s.contact.fault = Fault::StartedInside;
  t->feed(s);
  CHECK(t->sentence() == "The probe began inside the molecule. Draw it back until it is outside, then touch again.");
}

TEST_CASE("100000 random samples of every kind keep progress within 0 to 1 and rising to done once") {
  const unsigned seed = 5;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const std::vector<std::pair<std::string, std::vector<std::pair<std::string, std::string>>>> all{
      {"reach", {{"reach", "ion"}}},
      {"hold", {{"hold", "pit"}}},
      {"press", {{"press", "pit"}, {"until", "3 N"}}},
      {"feel", {{"feel", "atoms"}, {"count", "9"}}},
      {"cross", {{"cross", "atom 0"}, {"to", "atom 9"}}},
      {"avoid", {{"avoid", "ion"}}},
      {"compare", {{"compare", "places"}, {"of", "atom 0 then atom 1"}}},
      {"meet", {{"meet", "lost"}}},
      {"trace", {{"trace", "atom 0-5"}}},
      {"find", {{"find", "atom 5"}, {"hints", "warmer"}}},
      {"predict", {{"predict", "anywhere"}}},
      {"same", {{"same", "anywhere"}, {"probe", "2 Å"}, {"for", "0.1 s"}}},
      {"fit", {{"fit", "atom 5"}}},
      {"measure", {{"measure", "atom 0"}, {"to", "atom 9"}}},
      {"order", {{"order", "atom 0 then atom 4 then atom 9"}, {"first", "the left one"}, {"for", "0.1 s"}}},
      {"rank", {{"rank", "atom 0 then atom 4"}, {"first", "the firmest"}}},
      {"dock", {{"dock", "file"}}},
      {"pull", {{"pull", "5 Å"}}},
      {"pass", {{"pass", "atom 0-5"}}},
      {"contacts", {{"contacts", "anywhere"}, {"count", "1"}}}};
  CHECK(all.size() == taskKinds().size());
  for (const auto& [kind, keys] : all) {
    auto t = task(kind, keys);
    const std::uint32_t held[] = {0, 4};
    const bool holds = kind == "dock" || kind == "pull" || kind == "contacts";
    if (holds) t->takeInHand(heldBody(mixedMolecule().spheres, held));
    bool was_done = false;
    double time = 0.0;
    for (int i = 0; i < 100000; ++i) {
      TouchSample s;
      time += static_cast<double>(random() % 1000) * 1e-6 - (random() % 50 == 0 ? 0.01 : 0.0);
      s.time_s = random() % 100 == 0 ? std::numeric_limits<double>::quiet_NaN() : time;
      s.contact.feature = static_cast<Feature>(random() % 4);
      for (auto& a : s.contact.atoms) a = static_cast<std::int32_t>(random() % 14) - 2;
      s.exact.feature = static_cast<Feature>(random() % 4);
      s.exact.scp.A.x = static_cast<double>(random() % 400) * 0.01;
      s.method = random() % 2 ? "exact" : "paper";
      s.force.N.x =
          random() % 50 == 0 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(random() % 400) * 0.01;
      s.contact.scp.A = s.exact.scp.A;
      if (holds) s.body = PoseA{s.contact.scp, kNoRotation};
      t->feed(s);
      // A person who presses whatever button there is, and draws whatever is asked for.
      if (const std::vector<TaskButton> buttons = t->buttons(); !buttons.empty() && random() % 20 == 0)
        t->answer({std::string(buttons[random() % buttons.size()].word), {}});
      if (t->curves() && random() % 1000 == 0) t->answer({"", std::vector<double>(t->curves()->drawn.size(), 0.1)});
      if (t->slider() && random() % 1000 == 0) t->answer({.number = double(random() % 60) * 0.1});
      for (const TaskFigure& f : t->figures()) REQUIRE(std::isfinite(f.value));
      REQUIRE((t->progress() >= 0.0 && t->progress() <= 1.0));
      REQUIRE((t->done() || !was_done));
      REQUIRE_FALSE(t->sentence().empty());
      was_done = t->done();
    }
  }
}
