// Three students who do not feel: a looker, who presses where the picture showed the place while there was light; a
// guesser, who answers by tossing a coin or by counting; a jabber, who is put down here and there without sliding.
// Against every task of the shipped lessons that is done in the dark or along a way none passes a round more often than
// chance has it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/core/random.h"
#include "engine/haptics/sweep.h"
#include "engine/lesson/scripted_learner/scripted_learner.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/render/camera.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr unsigned kSeed = 20261122;

struct Found {
  std::string lesson;
  const Step* step = nullptr;
  std::size_t index = 0;
  const TaskSpec& spec() const { return step->tasks[index]; }
  std::string name() const { return lesson + ", " + step->title + ", " + spec().kind; }
};

const std::vector<Lesson>& lessons() {
  static const std::vector<Lesson> all = [] {
    std::vector<Lesson> out;
    for (const char* name : {"first-touch", "bonds-and-creases", "the-probe-decides", "dna-grooves-blind",
                             "haemoglobin-and-haem", "how-touch-is-computed"})
      out.push_back(shippedLesson(name));
    return out;
  }();
  return all;
}

std::vector<Found> tasksOfKind(std::string_view kind) {
  std::vector<Found> out;
  for (const Lesson& lesson : lessons())
    for (const Step& step : lesson.steps)
      for (std::size_t k = 0; k < step.tasks.size(); ++k)
        if (step.tasks[k].kind == kind) out.push_back({lesson.title, &step, k});
  return out;
}

double figure(const Task& task, std::string_view name) {
  for (const TaskFigure& f : task.figures())
    if (f.name == name) return f.value;
  return std::nan("");
}

/// How often at least `needed` of `n` coins fall right.
double coins(int n, int needed) {
  double sum = 0.0, ways = 1.0;
  for (int k = 0; k <= n; ++k) {
    if (k >= needed) sum += ways;
    ways = ways * (n - k) / (k + 1);
  }
  return sum * std::pow(0.5, n);
}

/// Four standard deviations of a share that is counted in n trials.
double noise(double share, int n) { return 4.0 * std::sqrt(std::max(share * (1 - share), 1.0 / n) / n); }

/// A touch of atoms for a while, as the task is told of it; then the hand is away.
void touch(Task& task, double& time_s, const std::array<std::int32_t, 3>& atoms, const Vec3& scp_A, double probe_A,
           double for_s) {
  TouchSample s;
  s.contact.scp = {scp_A};
  s.contact.atoms = atoms;
  s.contact.feature = Feature::Sphere;
  s.probe_A = probe_A;
  s.force.N = {0, 0, 0.5};
  for (const double end_s = time_s + for_s; time_s < end_s;) {
    s.time_s = time_s += 0.02;
    task.feed(s);
  }
  s.contact = {};
  s.force = {};
  for (int k = 0; k < 25; ++k) {
    s.time_s = time_s += 0.02;
    task.feed(s);
  }
}

/// The molecule as it is seen in a step, and what a press at a place of the picture meets there.
struct Stage {
  explicit Stage(const Step& step)
      : scene(step.scene), molecule(*shippedMolecule(scene.molecule)), balls(molecule->balls()) {}

  static constexpr int kSize_px = 800;

  Camera camera(const std::optional<Quat>& turned) const {
    Camera c;
    if (turned)
      c.orientation = *turned;
    else if (scene.view.facing.given()) {
      c.fit(*molecule, 1.0);
      Vec3 middle(0.0);
      const auto atoms = scene.view.facing.select(*molecule);
      for (const std::uint32_t a : atoms) middle += molecule->atoms[a].position.A / double(atoms.size());
      c.face({middle});
    } else if (scene.view.side == "side") {
      c.lookSideOn(*molecule);
    }
    c.fit(*molecule, 1.0, 0.08, 1.5 * scene.touch.probe_A);
    return c;
  }

  Hit press(const Camera& c, double x_px, double y_px, Vec3& scp_A) const {
    const Ray ray = c.rayThrough(x_px, y_px, kSize_px, kSize_px);
    const Vec3 end = ray.origin.A + ray.direction * (2.0 * c.distance_A);
    const Hit hit = sweep(balls, scene.touch.probe_A, ray.origin.A, end);
    scp_A = ray.origin.A + (end - ray.origin.A) * hit.t;
    return hit;
  }

  SceneSpec scene;
  std::shared_ptr<const Molecule> molecule;
  BallScene balls;
};

/// Says "here" after pressing at places of the picture that `where` chooses, as often as a round lets. True: found.
template <class Where>
bool findBy(const Stage& stage, const TaskSpec& spec, std::uint64_t seed, Where where) {
  const auto task = makeTask(spec, *stage.molecule);
  task->drawBy(seed);
  double time_s = 0.0;
  const int guesses = int(spec.values["guesses"].number);
  for (int k = 0; k < guesses && !task->done(); ++k) {
    REQUIRE(task->stage().turned);
    const Camera c = stage.camera(task->stage().turned);
    Vec3 scp(0.0);
    Hit hit;
    for (int tries = 0; tries < 1000 && hit.ball < 0; ++tries) {
      const glm::dvec2 at = where(k);
      hit = stage.press(c, at.x, at.y, scp);
      if (tries > 0 && hit.ball < 0 && tries % 10 == 0) continue;
    }
    if (hit.ball < 0) return false;
    touch(*task, time_s, {hit.ball, -1, -1}, scp, stage.scene.touch.probe_A, 0.3);
    CHECK(task->done() == false);
    task->answer({.word = "here"});
  }
  CHECK((task->done() || figure(*task, "rounds") == 2.0));
  return task->done();
}

}  // namespace

TEST_CASE(
    "whoever answers 'same' by a coin, always alike, or so that half differ, passes a round as often as coins do") {
  const std::vector<Found> found = tasksOfKind("same");
  REQUIRE(found.size() >= 2);
  std::mt19937 random(kSeed);
  CAPTURE(kSeed);
  for (const Found& f : found) {
    CAPTURE(f.name());
    const auto molecule = *shippedMolecule(f.step->scene.molecule);
    const int trials = int(f.spec().values["trials"].number);
    const int needed = f.spec().values.has("right") ? int(f.spec().values["right"].number) : (3 * trials + 3) / 4;
    const double chance = coins(trials, needed);
    CHECK(chance < 0.15);
    // Whatever is touched, the answer does not follow from it here: an atom of either place is given.
    const auto here = f.spec().values["same"].selection.select(*molecule);
    const auto there = f.spec().values["place"].selection.select(*molecule);
    const std::array<std::int32_t, 3> both{here.empty() ? 0 : int(here[0]), there.empty() ? -1 : int(there[0]), -1};
    constexpr int kRounds = 3000;
    for (const char* way : {"coin", "always different", "so that half differ", "as the last was"}) {
      CAPTURE(way);
      int passed = 0;
      for (int round = 0; round < kRounds; ++round) {
        const auto task = makeTask(f.spec(), *molecule);
        task->drawBy(mixedSeed(kSeed, std::uint64_t(round)));
        double time_s = 0.0;
        int said_different = 0;
        bool last = false;
        for (int k = 0; k < trials; ++k) {
          for (int thing = 0; thing < 2; ++thing) {
            touch(*task, time_s, both, Vec3(0.0), 1.4, f.spec().values["for"].number + 0.1);
            if (thing == 0) task->answer({.word = "next"});
          }
          bool differ = random() % 2 == 0;
          if (std::string_view(way) == "always different") differ = true;
          if (std::string_view(way) == "so that half differ") differ = said_different < trials / 2;
          // What the card shows of the pairs before.
          const TaskTrials shown = task->trials();
          if (std::string_view(way) == "as the last was" && !shown.right.empty()) differ = shown.right.back() == last;
          said_different += differ;
          last = differ;
          task->answer({.word = differ ? "different" : "same"});
        }
        passed += task->done();
      }
      CHECK(double(passed) / kRounds <= chance + noise(chance, kRounds));
    }
  }
}

TEST_CASE(
    "who looked where the place was, and who presses anywhere, find it in the dark no more often than a blind press") {
  const std::vector<Found> found = tasksOfKind("find");
  REQUIRE(found.size() >= 3);
  CAPTURE(kSeed);
  for (const Found& f : found) {
    CAPTURE(f.name());
    const Stage stage(*f.step);
    const int guesses = int(f.spec().values["guesses"].number);
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> pixel(0.0, Stage::kSize_px);
    const auto anywhere = [&](int) { return glm::dvec2(pixel(random), pixel(random)); };
    constexpr int kRounds = 600;
    int jabbed = 0;
    for (int k = 0; k < kRounds; ++k) jabbed += findBy(stage, f.spec(), mixedSeed(kSeed, std::uint64_t(k)), anywhere);
    // A blind press in the middle of the view meets the molecule more often than one at its edge.
    std::uniform_real_distribution<double> beside(-60.0, 60.0);
    int middled = 0;
    for (int k = 0; k < kRounds; ++k)
      middled += findBy(stage, f.spec(), mixedSeed(kSeed, std::uint64_t(2000 + k)), [&](int guess) {
        return glm::dvec2(0.5 * Stage::kSize_px) +
               (guess ? glm::dvec2(beside(random), beside(random)) : glm::dvec2(0.0));
      });
    const double chance = double(std::max(jabbed, middled)) / kRounds;
    MESSAGE(f.name() << ": pressed anywhere " << 100.0 * jabbed / kRounds << " %, in the middle "
                     << 100.0 * middled / kRounds << " % of rounds of " << guesses << " guesses");

    // Where it was seen in the light: the middle of the place, and beside it.
    const Camera lit = stage.camera(std::nullopt);
    Vec3 middle(0.0);
    const auto atoms = f.spec().values["find"].selection.select(*stage.molecule);
    for (const std::uint32_t a : atoms) middle += stage.molecule->atoms[a].position.A / double(atoms.size());
    const Vec3 seen = lit.project({middle}, Stage::kSize_px, Stage::kSize_px);
    int looked = 0;
    for (int k = 0; k < kRounds; ++k)
      looked += findBy(stage, f.spec(), mixedSeed(kSeed, std::uint64_t(1000 + k)), [&](int guess) {
        return glm::dvec2(seen.x, seen.y) + (guess ? glm::dvec2(beside(random), beside(random)) : glm::dvec2(0.0));
      });
    MESSAGE(f.name() << ": looked " << 100.0 * looked / kRounds << " %");
    CHECK(double(looked) / kRounds <= chance + std::sqrt(2.0) * noise(chance, kRounds));
  }
}

TEST_CASE("who is put down at place after place of a way, without sliding, does not trace it; who slides along does") {
  const std::vector<Found> found = tasksOfKind("trace");
  REQUIRE(found.size() >= 4);
  for (const Found& f : found) {
    CAPTURE(f.name());
    const auto lesson =
        std::find_if(lessons().begin(), lessons().end(), [&](const Lesson& l) { return l.title == f.lesson; });
    for (const bool jabs : {true, false}) {
      auto alone = std::make_shared<Lesson>(*lesson);
      alone->steps = {*f.step};
      alone->steps[0].tasks = {f.spec()};
      alone->steps[0].questions.clear();
      ScriptedLearner learner(alone, shippedMolecule, [](const LearnerEvent&) {});
      REQUIRE(learner.enterStep());
      if (!jabs) {
        CHECK(learner.doTask());
        continue;
      }
      const HandPlanInput view = learner.view();
      HandPlan plan;
      for (const HandAct& act : learner.session().taskAt(0)->demonstrate(view)) {
        if (!act.to || act.placed) continue;
        // From outside straight onto each place that a sliding hand would pass.
        Vec3 nearest(0.0);
        double least = 1e9;
        for (std::uint32_t a = 0; a < view.balls.size(); ++a)
          if (const double d = glm::distance(view.balls[a].centre_A, act.to->A) - view.balls[a].radius_A; d < least)
            least = d, nearest = view.balls[a].centre_A;
        const Vec3 out = glm::normalize(act.to->A - nearest);
        plan.push_back({.to = PointA{act.to->A + out * 3.0}, .placed = true, .wait_s = 0.4});
        plan.push_back({.to = act.to, .speed_A_per_s = 20.0, .wait_s = 0.15});
      }
      learner.follow(plan);
      CHECK_FALSE(learner.session().finished());
    }
  }
}
