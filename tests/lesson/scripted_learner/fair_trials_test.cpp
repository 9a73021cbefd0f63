// Three students without touch: a looker, who presses where the picture shows the place; a guesser, who tosses a coin
// or counts; and a jabber, who touches here and there without sliding. In every task of the program's lessons that is
// done in the dark, along a path, or by size and distance, none passes more often than by chance. The test prints how
// often each passed.
#include <cmath>

#include "engine/core/random.h"
#include "tests/lesson/scripted_learner/unfeeling_students.h"

using namespace moltact;
using namespace moltact::test;

namespace {
constexpr unsigned kSeed = 20261122;
}  // namespace

TEST_CASE("answers to 'same' by a coin, always the same, or half of each pass a round as often as coins do") {
  std::vector<Found> found = tasksOfKind("same");
  // A task asked before is a measurement: one round without pass or fail.
  std::erase_if(found, [](const Found& f) { return f.spec().values["asked"].text == "before"; });
  REQUIRE(found.size() >= 8);
  std::mt19937 random(kSeed);
  CAPTURE(kSeed);
  Passes table;
  for (const Found& f : found) {
    CAPTURE(f.name());
    const auto molecule = *knownMolecule(f.step->scene.molecule);
    const int trials = int(f.spec().values["trials"].number);
    const int needed = f.spec().values.has("right") ? int(f.spec().values["right"].number) : (3 * trials + 3) / 4;
    const double chance = coins(trials, needed);
    // One right answer of several asks for no skill: such a task measures, and says so.
    CHECK((needed == 1 || chance < 0.15));
    // Whatever is touched, the answer does not follow from it here: an atom of either place is given.
    const auto here = f.spec().values["same"].selection.select(*molecule);
    const auto there = f.spec().values["place"].selection.select(*molecule);
    const std::array<std::int32_t, 3> both{here.empty() ? 0 : int(here[0]), there.empty() ? -1 : int(there[0]), -1};
    constexpr int kRounds = 1000;
    const auto task = makeTask(f.spec(), *molecule);
    const auto passedBy = [&](std::string_view way) {
      int passed = 0;
      for (int round = 0; round < kRounds; ++round) {
        task->reset();
        task->drawBy(mixedSeed(kSeed, std::uint64_t(round)));
        double time_s = 0.0;
        int said_different = 0;
        bool last = false;
        for (int k = 0; k < trials; ++k) {
          for (int thing = 0; thing < 2; ++thing) {
            touch(*task, time_s, both, Vec3(0.0), 1.4, f.spec().values["for"].number + 0.3, 0.2);
            if (thing == 0) task->answer({.word = "next"});
          }
          bool differ = random() % 2 == 0;
          if (way == "always alike") differ = false;
          if (way == "always different") differ = true;
          if (way == "so that half differ") differ = said_different < trials / 2;
          // What the card shows of the pairs before.
          const TaskTrials shown = task->trials();
          if (way == "as the last was" && !shown.right.empty()) differ = shown.right.back() == last;
          said_different += differ;
          last = differ;
          task->answer({.word = differ ? "different" : "same"});
        }
        passed += task->done();
      }
      CAPTURE(way);
      const double share = double(passed) / kRounds;
      CHECK(share <= chance + noise(chance, kRounds));
      return share;
    };
    // In the dark both are drawn alike: nothing. The guesser counts; the jabber tosses a coin.
    const double looker = passedBy("always alike");
    const double guesser =
        std::max({passedBy("always different"), passedBy("so that half differ"), passedBy("as the last was")});
    table.row(f, looker, guesser, passedBy("coin"), chance);
  }
  table.print();
}

TEST_CASE(
    "who looked where the place was, and who presses anywhere, find it in the dark no more often than a blind press") {
  const std::vector<Found> found = tasksOfKind("find");
  REQUIRE(found.size() >= 8);
  CAPTURE(kSeed);
  Passes table;
  for (const Found& f : found) {
    CAPTURE(f.name());
    const StepPicture picture(*f.step);
    const auto task = makeTask(f.spec(), *picture.molecule);
    constexpr double kWide_px = StepPicture::kSize_px;
    // Fitting many atoms into the view takes long.
    const int rounds = picture.part || picture.molecule->atoms.size() < 20000 ? 400 : 100;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> pixel(0.0, kWide_px), beside(-60.0, 60.0);
    const auto around = [&](glm::dvec2 at, int guess) {
      return at + (guess ? glm::dvec2(beside(random), beside(random)) : glm::dvec2(0.0));
    };
    const auto share = [&](std::uint64_t row, auto where) {
      int passed = 0;
      for (int k = 0; k < rounds; ++k)
        passed += findBy(picture, f.spec(), *task, mixedSeed(kSeed, row + std::uint64_t(k)), where);
      return double(passed) / rounds;
    };
    const double jabbed = share(0, [&](int) { return glm::dvec2(pixel(random), pixel(random)); });
    // A blind press in the middle of the view meets the molecule more often than one at its edge.
    const double middled = share(2000, [&](int guess) { return around(glm::dvec2(0.5 * kWide_px), guess); });
    // Where it was seen in the light: the middle of the place, and beside it.
    const glm::dvec2 seen = picture.seen(atomsOf(picture, f.spec(), {"find"}));
    const double looked = share(1000, [&](int guess) { return around(seen, guess); });
    const double chance = std::max(jabbed, middled);
    // A place that three blind presses find more often is unsuitable for a search.
    CHECK(chance <= 0.2);
    CHECK(looked <= chance + std::sqrt(2.0) * noise(chance, rounds));
    table.row(f, looked, middled, jabbed, chance);
  }
  table.print();
}

TEST_CASE("who is put down at place after place of a way, without sliding, does not trace it; who slides along does") {
  const std::vector<Found> found = tasksOfKind("trace");
  REQUIRE(found.size() >= 12);
  Passes table;
  for (const Found& f : found) {
    CAPTURE(f.name());
    Alone looker(f, kSeed), jabber(f, kSeed), honest(f, kSeed);
    const HandPlanInput view = jabber.learner.view();
    HandPlan plan;
    for (const HandAct& act : jabber.task().demonstrate(view)) {
      if (!act.to || act.placed) continue;
      // From outside straight onto each place that a sliding hand would pass.
      Vec3 nearest(0.0);
      double least = 1e9;
      for (std::uint32_t a = 0; a < view.spheres.size(); ++a)
        if (const double d = glm::distance(view.spheres[a].centre_A, act.to->A) - view.spheres[a].radius_A; d < least)
          least = d, nearest = view.spheres[a].centre_A;
      const Vec3 out = glm::normalize(act.to->A - nearest);
      plan.push_back({.to = PointA{act.to->A + out * 3.0}, .placed = true, .wait_s = 0.4});
      plan.push_back({.to = act.to, .speed_A_per_s = 20.0, .wait_s = 0.15});
    }
    jabber.learner.follow(plan);
    CHECK_FALSE(jabber.done());
    const StepPicture picture(*f.step);
    std::vector<std::uint32_t> atoms = atomsOf(picture, f.spec(), {"of"});
    for (const Selection& part : f.spec().values["trace"].path)
      for (const std::uint32_t a : part.select(*picture.molecule)) atoms.push_back(a);
    REQUIRE_FALSE(atoms.empty());
    looker.jab(picture, picture.camera(), picture.seen(atoms), 1.0);
    CHECK_FALSE(looker.done());
    CHECK(honest.learner.doTask());
    table.row(f, looker.done(), kNone, jabber.done(), 0.0);
  }
  table.print();
}

TEST_CASE(
    "who presses into the middle of either side, or jabs here and there forty times, does not slide across; who slides "
    "does") {
  const std::vector<Found> found = tasksOfKind("cross");
  REQUIRE(found.size() >= 8);
  Passes table;
  for (const Found& f : found) {
    CAPTURE(f.name());
    const StepPicture picture(*f.step);
    const auto both = atomsOf(picture, f.spec(), {"cross", "to"});
    REQUIRE_FALSE(both.empty());
    Alone looker(f, kSeed);
    for (const auto& atoms : {atomsOf(picture, f.spec(), {"cross"}), atomsOf(picture, f.spec(), {"to"}), both})
      looker.jab(picture, picture.camera(), picture.seen(atoms), 0.6);
    CHECK_FALSE(looker.done());
    constexpr int kRounds = 2, kJabs = 40;
    int jabbed = 0;
    for (int round = 0; round < kRounds; ++round) {
      Alone jabber(f, mixedSeed(kSeed, std::uint64_t(round)));
      Camera from = picture.camera();
      for (int k = 0; k < kJabs && !jabber.done(); ++k) {
        if (k % 8 == 0) from = jabber.someView(picture, both);
        jabber.jab(picture, from, jabber.somewhere(picture, from, both));
      }
      jabbed += jabber.done();
    }
    CHECK(jabbed == 0);
    Alone honest(f, kSeed);
    CHECK(honest.learner.doTask());
    table.row(f, looker.done(), kNone, double(jabbed) / kRounds, 0.0);
  }
  table.print();
}

TEST_CASE(
    "a size that is set by chance is taken no more often than it is right, four in less than a quarter of the rounds, "
    "and none that has not been there") {
  const std::vector<Found> found = tasksOfKind("fit");
  REQUIRE(found.size() >= 2);
  Passes table;
  for (const Found& f : found) {
    CAPTURE(f.name());
    const StepPicture picture(*f.step);
    const auto place = atomsOf(picture, f.spec(), {"fit"});
    const bool largest = f.spec().values["want"].text == "largest";
    const double least_A = f.spec().values["least"].number, most_A = f.spec().values["most"].number;
    constexpr int kSizes = 4, kJabs = 6;
    // Among few atoms a round is short.
    const int rounds = picture.spheres.size() < 100 ? 100 : 8;
    const double one = (f.spec().values["within"].number + 0.1) / (most_A - least_A + 0.1),
                 chance = 1.0 - std::pow(1.0 - one, kSizes);
    // A slider of which four sizes often hold the right one asks for no skill.
    CHECK(chance < 0.25);
    // The looker takes the size that is set at first, the guesser any, and neither tries it.
    Alone looker(f, kSeed), guesser(f, kSeed);
    looker.jab(picture, picture.camera(), picture.seen(place), 1.5);
    looker.learner.tell({.word = "this"});
    CHECK_FALSE(looker.done());
    for (int k = 0; k < 100 && !guesser.done(); ++k) {
      guesser.learner.tell({.number = least_A + guesser.fraction() * (most_A - least_A)});
      guesser.learner.tell({.word = "this"});
    }
    CHECK_FALSE(guesser.done());
    int jabbed = 0;
    for (int round = 0; round < rounds; ++round) {
      Alone jabber(f, mixedSeed(kSeed, std::uint64_t(round)));
      for (int size = 0; size < kSizes && !jabber.done(); ++size) {
        const double steps = std::floor((most_A - least_A) / 0.1 * jabber.fraction());
        jabber.learner.tell({.number = least_A + 0.1 * steps});
        jabber.learner.follow({{.wait_s = 1.5}});
        for (int k = 0; k < kJabs && !jabber.offers("this"); ++k)
          jabber.jab(picture, picture.camera(),
                     k == 0 ? picture.seen(place) : jabber.somewhere(picture, picture.camera(), place),
                     largest ? 0.2 : 1.2);
        if (jabber.offers("this")) jabber.learner.tell({.word = "this"});
      }
      jabbed += jabber.done();
    }
    CHECK(double(jabbed) / rounds <= chance + noise(chance, rounds));
    table.row(f, looker.done(), guesser.done(), double(jabbed) / rounds, chance);
  }
  table.print();
}

TEST_CASE("marking what was not touched, the same place twice, or places met by jabs does not measure anything") {
  const std::vector<Found> found = tasksOfKind("measure");
  Passes table;
  for (const Found& f : found) {
    CAPTURE(f.name());
    const StepPicture picture(*f.step);
    const auto from = atomsOf(picture, f.spec(), {"measure"}), to = atomsOf(picture, f.spec(), {"to"});
    const auto mark = [](Alone& who) {
      if (who.offers("mark")) who.learner.tell({.word = "mark"});
    };
    // The looker clicks what the picture shows in its middle; the guesser marks without a touch, then one place twice.
    Alone looker(f, kSeed), guesser(f, kSeed);
    for (const glm::dvec2 at : {picture.seen(everyAtom(picture.spheres)), picture.seen(everyAtom(picture.spheres))}) {
      looker.jab(picture, picture.camera(), at, 0.6);
      mark(looker);
    }
    CHECK_FALSE(looker.done());
    guesser.learner.tell({.word = "mark"});
    guesser.learner.tell({.word = "mark"});
    guesser.jab(picture, picture.camera(), picture.seen(from), 0.6);
    mark(guesser), mark(guesser);
    CHECK_FALSE(guesser.done());
    // Two jabs anywhere, each marked: one in as many as the molecule's faces are larger than the places.
    constexpr int kRounds = 40;
    int jabbed = 0;
    for (int round = 0; round < kRounds; ++round) {
      Alone jabber(f, mixedSeed(kSeed, std::uint64_t(round)));
      const auto all = everyAtom(picture.spheres);
      for (int k = 0; k < 2; ++k) {
        jabber.jab(picture, picture.camera(), jabber.somewhere(picture, picture.camera(), all));
        mark(jabber);
      }
      jabbed += jabber.done();
    }
    const double chance = double(from.size()) / double(picture.spheres.size());
    CHECK(double(jabbed) / kRounds <= chance + noise(chance, kRounds));
    table.row(f, looker.done(), guesser.done(), double(jabbed) / kRounds, chance);
  }
  table.print();
}

TEST_CASE("places that are put in order without a feeling for them are in order as often as chance has it") {
  Passes table;
  for (const Found& f : tasksOfKind("order")) {
    CAPTURE(f.name());
    const auto molecule = *knownMolecule(f.step->scene.molecule);
    const auto task = makeTask(f.spec(), *molecule);
    std::vector<std::int32_t> one_of_each;
    double chance = 1.0;
    for (const Selection& place : f.spec().values["order"].path) {
      one_of_each.push_back(int(place.select(*molecule).at(0)));
      chance /= double(one_of_each.size());
    }
    const int places = int(one_of_each.size());
    std::mt19937 random(kSeed);
    constexpr int kRounds = 1000;
    // The looker takes the order in which they are met, the guesser the other way round, the jabber any.
    const auto passedBy = [&](int way) {
      int passed = 0;
      for (int round = 0; round < kRounds; ++round) {
        task->reset();
        task->drawBy(mixedSeed(kSeed, std::uint64_t(round)));
        double time_s = 0.0;
        for (int k = 0; k < places; ++k) {
          for (const std::int32_t a : one_of_each)
            if (task->buttons().empty())
              touch(*task, time_s, {a, -1, -1}, Vec3(0.0), 1.4, f.spec().values["for"].number + 0.3, 0.2);
          task->answer({.word = "next"});
        }
        for (int k = 0; k + 1 < places; ++k) {
          std::vector<TaskButton> left = task->buttons();
          REQUIRE(left.size() >= 2);
          left.pop_back();  // to feel them once more
          const std::size_t pick = way == 0 ? 0 : way == 1 ? left.size() - 1 : random() % left.size();
          task->answer({.word = std::string(left[pick].word)});
        }
        passed += task->done();
      }
      const double share = double(passed) / kRounds;
      CHECK(share <= chance + noise(chance, kRounds));
      return share;
    };
    CHECK(chance < 0.2);
    const double looker = passedBy(0), guesser = passedBy(1);
    table.row(f, looker, guesser, passedBy(2), chance);
  }
  table.print();
}
