// Students without touch at the tasks of the lesson with forces between atoms (tests/lesson/in_the_forces.md, with the
// drug and the protease of 1HPV): a looker, who goes where the picture shows oxygen; a guesser, who counts or draws; and
// a jabber. None passes more often than by chance. The test prints how often each passed.
#include <cmath>
#include <numeric>

#include "engine/core/even_directions.h"
#include "engine/core/random.h"
#include "engine/lesson/pose_search.h"
#include "engine/lesson/scene_forces.h"
#include "tests/lesson/scripted_learner/unfeeling_students.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr unsigned kSeed = 20261128;

const Lesson& lessonWithForces() {
  static const Lesson lesson = [] {
    LessonReading read = readLesson(MOLTACT_SOURCE_DIR "/tests/lesson/in_the_forces.md");
    REQUIRE(read.lesson);
    read.lesson->file = "in_the_forces.md";
    return *std::move(read.lesson);
  }();
  return lesson;
}

std::vector<Found> tasksInForces(std::string_view kind) {
  std::vector<Found> out;
  for (const Step& step : lessonWithForces().steps)
    for (std::size_t k = 0; k < step.tasks.size(); ++k)
      if (step.tasks[k].kind == kind) out.push_back({&lessonWithForces(), &step, k});
  // Lessons of the program, if one of their scenes has forces.
  for (const Found& f : tasksOfKind(kind))
    if (f.step->scene.touch.forces != "none") out.push_back(f);
  return out;
}

std::unique_ptr<Task> taskOf(const Found& f, const StepPicture& picture, std::shared_ptr<const SceneForces>& forces) {
  auto task = makeTask(f.spec(), *picture.molecule);
  if (!forces)
    forces = sceneForces(picture.scene, picture.molecule, untouchableAtoms(picture.scene, *picture.molecule), nullptr);
  REQUIRE(forces);
  task->takeForces(forces);
  return task;
}

// A touch in the forces, whatever they are; `atom` -1: without a contact.
void feel(Task& task, double& time_s, const Vec3& at, int atom, double energy_kcal_mol, double for_s) {
  TouchSample s;
  s.contact.scp = {at};
  s.probe_A = 1.4;
  s.force.N = {0, 0, 0.5};
  s.energy.emplace().parts[EnergyPart::Electrostatic] = energy_kcal_mol;
  if (atom >= 0) s.contact.atoms = {atom, -1, -1}, s.contact.feature = Feature::Sphere;
  for (const double end_s = time_s + for_s; time_s < end_s;) {
    s.time_s = time_s += 0.02;
    task.feed(s);
  }
}

constexpr double kPart = 0.02;  // of the picture: how far beside a place a student presses again

}  // namespace

TEST_CASE(
    "answers to 'same' with forces on and off by a coin, always the same, or half of each pass a round of eight as "
    "often as coins do, 14.5 %") {
  Passes table;
  std::vector<Found> found = tasksInForces("same");
  // A measurement is not passed or failed.
  std::erase_if(found, [](const Found& f) {
    return f.spec().values["asked"].text == "before" || f.spec().values["right"].number == 1.0;
  });
  REQUIRE_FALSE(found.empty());
  for (const Found& f : found) {
    const StepPicture picture(*f.step);
    std::shared_ptr<const SceneForces> forces;
    const auto task = taskOf(f, picture, forces);
    const int trials = int(f.spec().values["trials"].number);
    const int needed = f.spec().values.has("right") ? int(f.spec().values["right"].number) : (3 * trials + 3) / 4;
    const double chance = coins(trials, needed);
    CHECK(chance < 0.15);
    const auto atoms = f.spec().values["same"].selection.select(*picture.molecule);
    REQUIRE_FALSE(atoms.empty());
    const Vec3 at = picture.molecule->spheres[atoms[0]].centre_A + Vec3(0, 0, 3.0);
    std::mt19937 random(kSeed);
    constexpr int kRounds = 1000;
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
            feel(*task, time_s, at, int(atoms[0]), -5.0, f.spec().values["for"].number + 0.3);
            if (thing == 0) task->answer({.word = "next"});
          }
          bool differ = random() % 2 == 0;
          if (way == "always alike") differ = false;
          if (way == "always different") differ = true;
          if (way == "so that half differ") differ = said_different < trials / 2;
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
    const double looker = passedBy("always alike");
    const double guesser =
        std::max({passedBy("always different"), passedBy("so that half differ"), passedBy("as the last was")});
    const double coin = passedBy("coin");
    CHECK(coin > chance - noise(chance, kRounds));  // the trials are coins: a pass is possible
    table.row(f, looker, guesser, coin, chance);
  }
  table.print();
}

TEST_CASE("of 2000 students who order four places by energy without feeling them one in 24 has them right at first") {
  std::vector<Found> found = tasksInForces("order");
  std::erase_if(found, [](const Found& f) { return f.spec().values["by"].text != "energy"; });
  REQUIRE_FALSE(found.empty());
  for (const Found& f : found) {
    CAPTURE(f.name());
    const StepPicture picture(*f.step);
    std::shared_ptr<const SceneForces> forces;
    const auto task = taskOf(f, picture, forces);
    const std::size_t places = f.spec().values["order"].path.size();
    double chance = 1.0;
    for (std::size_t k = 2; k <= places; ++k) chance /= double(k);
    std::mt19937 random(kSeed);
    constexpr int kRounds = 2000;
    const auto rightBy = [&](std::string_view way) {
      int right = 0;
      for (int round = 0; round < kRounds; ++round) {
        task->reset();
        task->drawBy(mixedSeed(kSeed + 1, std::uint64_t(round)));
        double time_s = 0.0;
        for (std::size_t k = 0; k < places; ++k) {
          REQUIRE(task->stage().facing);
          feel(*task, time_s, task->stage().facing->A + Vec3(0, 0, 3.3), -1, -5.0, f.spec().values["for"].number + 0.2);
          task->answer({.word = "next"});
        }
        std::vector<int> order(places);
        std::iota(order.begin(), order.end(), 1);
        if (way == "drawn") std::shuffle(order.begin(), order.end(), random);
        if (way == "backwards") std::reverse(order.begin(), order.end());
        // The last place is the one that is left.
        for (std::size_t k = 0; k + 1 < places; ++k) task->answer({.word = "place-" + std::to_string(order[k])});
        right += task->done();
      }
      CAPTURE(way);
      const double share = double(right) / kRounds;
      MESSAGE(f.name(), ", ", way, ": ", 100.0 * share, " % right at first; chance ", 100.0 * chance, " %");
      CHECK(share <= chance + noise(chance, kRounds));
      return share;
    };
    CHECK(rightBy("drawn") > chance - noise(chance, kRounds));  // the orders are drawn
    rightBy("as they come");
    rightBy("backwards");
  }
}

TEST_CASE(
    "who presses three times anywhere, in the middle, or on oxygen atoms of the picture finds the place of lowest "
    "energy "
    "of 1HPV in less than a fifth of the rounds") {
  Passes table;
  const std::vector<Found> found = tasksInForces("find");
  REQUIRE_FALSE(found.empty());
  for (const Found& f : found) {
    CAPTURE(f.name());
    const StepPicture picture(*f.step);
    std::shared_ptr<const SceneForces> forces;
    const auto task = taskOf(f, picture, forces);
    std::mt19937 random(kSeed);
    const double wide_px = StepPicture::kSize_px;
    std::uniform_real_distribution<double> pixel(0.0, wide_px), beside(-kPart * wide_px, kPart * wide_px),
        angle(-std::numbers::pi, std::numbers::pi);
    std::vector<std::uint32_t> oxygens;
    for (std::uint32_t i = 0; i < picture.molecule->atoms.size(); ++i)
      if (picture.molecule->atoms[i].atomic_number == 8) oxygens.push_back(i);
    constexpr int kRounds = 300;
    // A student turns the view as they like and presses at a place of it.
    const auto share = [&](auto where) {
      int passed = 0;
      for (int round = 0; round < kRounds; ++round) {
        task->reset();
        task->drawBy(mixedSeed(kSeed + 2, std::uint64_t(round)));
        double time_s = 0.0;
        const int guesses = int(f.spec().values["guesses"].number);
        for (int guess = 0; guess < guesses && !task->done(); ++guess) {
          Vec3 scp(0.0);
          Hit hit;
          for (int tries = 0; tries < 1000 && hit.sphere < 0; ++tries) {
            Camera view = picture.camera();
            view.orbit(angle(random), angle(random));
            hit = picture.press(view, where(view), picture.scene.touch.probe_A, scp);
          }
          REQUIRE(hit.sphere >= 0);
          feel(*task, time_s, scp, hit.sphere, -5.0, 0.4);
          task->answer({.word = "here"});
        }
        passed += task->done();
      }
      return double(passed) / kRounds;
    };
    const double jabbed = share([&](const Camera&) { return glm::dvec2(pixel(random), pixel(random)); });
    const double middled = share(
        [&](const Camera&) { return glm::dvec2(0.5 * wide_px + beside(random), 0.5 * wide_px + beside(random)); });
    // The colours show elements: the oxygens of acids are among those of the backbone.
    const double looked = share([&](const Camera& view) {
      const std::uint32_t atom = oxygens[random() % oxygens.size()];
      const Vec3 at =
          view.project({picture.molecule->spheres[atom].centre_A}, StepPicture::kSize_px, StepPicture::kSize_px);
      return glm::dvec2(at.x, at.y);
    });
    // Who is at the well has found it.
    const std::vector<Well> wells = forces->wells(40);
    REQUIRE_FALSE(wells.empty());
    task->reset();
    double time_s = 0.0;
    feel(*task, time_s, wells.front().pose.place.A, int(oxygens[0]), -5.0, 0.4);
    task->answer({.word = "here"});
    CHECK(task->done());
    CHECK(jabbed < 0.2);
    CHECK(middled < 0.2);
    CHECK(looked < 0.2);
    table.row(f, looked, middled, jabbed, kNone);
  }
  table.print();
}

TEST_CASE(
    "the drug that is put down in its site, led straight in from 16 sides in orientations drawn evenly, or jabbed at "
    "it "
    "for 0.3 s does not dock, and put down outside or jabbed it is not pulled out") {
  Passes table;
  constexpr int kTries = 16;
  const auto outside = [](const HandPlanInput& view, int k) {
    const double far_A = glm::distance(view.spheres.low_A(), view.spheres.high_A()) + 2.0 * view.body->reach_A;
    return PointA{view.body->middle.A + evenDirection(k, kTries) * far_A};
  };
  const auto passes = [](const Found& f, const auto& plan) {
    Alone student(f, 1);
    REQUIRE(student.learner.view().body);
    student.learner.follow(plan(student.learner.view()));
    return student.done();
  };
  std::vector<Found> found = tasksInForces("dock");
  REQUIRE_FALSE(found.empty());
  const std::vector<Found> pulls = tasksInForces("pull");
  REQUIRE_FALSE(pulls.empty());
  found.insert(found.end(), pulls.begin(), pulls.end());
  for (const Found& f : found) {
    CAPTURE(f.name());
    const bool docks = f.spec().kind == "dock";
    // An atom has no orientation: who leads it straight in does what the task asks.
    const bool turns = Alone(f, 1).learner.view().body->atoms.size() > 1;
    // A looker knows the place, and puts the body down there; or, to pull it out, outside.
    const bool looker = passes(f, [&](const HandPlanInput& view) -> HandPlan {
      if (!docks) return {{.to = outside(view, 0), .placed = true, .wait_s = 3.0}};
      return {{.to = outside(view, 0), .placed = true, .wait_s = 0.1},
              {.turned_to = kNoRotation, .turn_deg_per_s = 360.0},
              {.to = view.body->middle, .placed = true, .wait_s = 3.0}};
    });
    CHECK_FALSE(looker);
    int guessed = 0, jabbed = 0;
    std::uint64_t random = kSeed;
    for (int k = 0; k < kTries; ++k) {
      const Quat turned = randomOrientation(random);
      const auto straight = [&](double wait_s) {
        return [&, wait_s](const HandPlanInput& view) -> HandPlan {
          return {{.to = outside(view, k), .placed = true, .wait_s = 0.05},
                  {.turned_to = turned, .turn_deg_per_s = 360.0},
                  {.to = view.body->middle, .speed_A_per_s = 60.0, .wait_s = wait_s}};
        };
      };
      // To have pulled the body out it must have been in its place.
      if (docks && turns) guessed += passes(f, straight(2.0));
      jabbed += passes(f, straight(0.3));
    }
    CHECK(guessed == 0);
    CHECK(jabbed == 0);
    table.row(f, looker, docks && turns ? double(guessed) / kTries : kNone, double(jabbed) / kTries, kNone);
  }
  table.print();
}
