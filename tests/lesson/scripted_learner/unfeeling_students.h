// Students without touch, for tests of fairness: the information that a looker, a guesser and a jabber have, and how
// often they pass. Shared by tests of the lessons' tasks.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <random>

#include "engine/lesson/lesson_files.h"
#include "engine/lesson/scripted_learner/scripted_learner.h"
#include "engine/lesson/tasks/registry.h"
#include "tests/lesson/scripted_learner/step_picture.h"

namespace moltact::test {

/// A touch task of one of the program's lessons.
struct Found {
  const Lesson* lesson = nullptr;
  const Step* step = nullptr;
  std::size_t index = 0;
  const TaskSpec& spec() const { return step->tasks[index]; }
  std::string name() const {
    return lesson->file + ":" + std::to_string(spec().place.line) + ", " + step->title + ", " + spec().kind;
  }
};

/// Every lesson of lessons/ in English.
inline const std::vector<Lesson>& lessons() {
  static const std::vector<Lesson> all = [] {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(MOLTACT_SOURCE_DIR "/lessons"))
      if (looksLikeLesson(entry.path()) && entry.path().stem().extension().empty())
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    std::vector<Lesson> out;
    for (const std::string& name : names) {
      out.push_back(shippedLesson(name));
      out.back().file = name + ".md";
    }
    return out;
  }();
  return all;
}

inline std::vector<Found> tasksOfKind(std::string_view kind) {
  std::vector<Found> out;
  for (const Lesson& lesson : lessons())
    for (const Step& step : lesson.steps)
      for (std::size_t k = 0; k < step.tasks.size(); ++k)
        if (step.tasks[k].kind == kind) out.push_back({&lesson, &step, k});
  return out;
}

inline double figure(const Task& task, std::string_view name) {
  for (const TaskFigure& f : task.figures())
    if (f.name == name) return f.value;
  return std::nan("");
}

/// The probability that at least `needed` of `n` fair coins show heads.
inline double coins(int n, int needed) {
  double sum = 0.0, ways = 1.0;
  for (int k = 0; k <= n; ++k) {
    if (k >= needed) sum += ways;
    ways = ways * (n - k) / (k + 1);
  }
  return sum * std::pow(0.5, n);
}

/// Four standard deviations of a share counted in n trials.
inline double noise(double share, int n) { return 4.0 * std::sqrt(std::max(share * (1 - share), 1.0 / n) / n); }

/// The share of rounds that each of the three passed, in percent; NaN if the task gives one of them nothing to try.
class Passes {
 public:
  void row(const Found& f, double looker, double guesser, double jabber, double chance) {
    char numbers[80];
    const auto text = [](double share) {
      char out[16];
      std::snprintf(out, sizeof out, std::isnan(share) ? "     -" : "%6.1f", 100.0 * share);
      return std::string(out);
    };
    std::snprintf(numbers, sizeof numbers, "%s %s %s  %s  ", text(looker).c_str(), text(guesser).c_str(),
                  text(jabber).c_str(), text(chance).c_str());
    text_ += numbers + f.name() + '\n';
  }
  void print() const { MESSAGE("passed, in % of the rounds:\nlooker guess.   jabs  chance\n" << text_); }

 private:
  std::string text_;
};

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Reports a touch of atoms for a while to the task, then releases.
inline void touch(Task& task, double& time_s, const std::array<std::int32_t, 3>& atoms, const Vec3& scp_A,
                  double probe_A, double for_s, double tick_s = 0.02) {
  TouchSample s;
  s.contact.scp = {scp_A};
  s.contact.atoms = atoms;
  s.contact.feature = Feature::Sphere;
  s.probe_A = probe_A;
  s.force.N = {0, 0, 0.5};
  for (const double end_s = time_s + for_s; time_s < end_s;) {
    s.time_s = time_s += tick_s;
    task.feed(s);
  }
  s.contact = {};
  s.force = {};
  for (const double end_s = time_s + 0.5; time_s < end_s;) {
    s.time_s = time_s += tick_s;
    task.feed(s);
  }
}

/// Presses at places of the picture that `where` chooses and says "here", as often as a round permits; or rests there
/// if the task asks for that. Returns whether it was found.
template <class Where>
bool findBy(const StepPicture& picture, const TaskSpec& spec, Task& task, std::uint64_t seed, Where where) {
  task.reset();
  task.drawBy(seed);
  double time_s = 0.0;
  const int guesses = int(spec.values["guesses"].number);
  const bool rests = spec.values["by"].text == "hold";
  const double probe_A = picture.scene.touch.probe_A;
  for (int k = 0; k < guesses && !task.done(); ++k) {
    REQUIRE(task.stage().turned);
    const Camera& c = picture.camera(task.stage().turned);
    Vec3 scp(0.0);
    Hit hit;
    for (int tries = 0; tries < 1000 && hit.sphere < 0; ++tries) hit = picture.press(c, where(k), probe_A, scp);
    if (hit.sphere < 0) return false;
    touch(task, time_s, {hit.sphere, -1, -1}, scp, probe_A, rests ? 2.2 : 0.3, 0.1);
    if (rests) continue;
    CHECK(task.done() == false);
    task.answer({.word = "here"});
  }
  // Resting at the same place twice counts as one guess.
  if (!rests) CHECK((task.done() || figure(task, "rounds") == 2.0));
  return task.done();
}

/// A single task of a lesson, with a student who follows plans.
struct Alone {
  explicit Alone(const Found& f, std::uint64_t seed) : random(seed), learner(lessonOf(f), knownMolecule, ignore) {
    REQUIRE(learner.enterStep());
  }
  static std::shared_ptr<Lesson> lessonOf(const Found& f) {
    auto alone = std::make_shared<Lesson>(*f.lesson);
    alone->steps = {*f.step};
    alone->steps[0].tasks = {f.spec()};
    alone->steps[0].questions.clear();
    alone->steps[0].aside = false;  // asides are optional for a lesson
    return alone;
  }
  static void ignore(const LearnerEvent&) {}

  bool done() const { return learner.session().finished(); }
  const Task& task() const { return *learner.session().taskAt(0); }
  bool offers(std::string_view word) const {
    if (done()) return false;
    const auto buttons = task().buttons();
    return std::any_of(buttons.begin(), buttons.end(), [&](const TaskButton& b) { return b.word == word; });
  }

  /// A press with 0.6 N straight from outside at a place of the picture; it passes through if nothing is there.
  void jab(const StepPicture& picture, const Camera& camera, glm::dvec2 at_px, double wait_s = 0.2) {
    if (done()) return;
    Vec3 scp(0.0);
    const double probe_A = learner.view().probe_A, out_A = 2.0 * probe_A + 2.0;
    const Hit hit = picture.press(camera, at_px, probe_A, scp);
    const Ray ray = camera.rayThrough(at_px.x, at_px.y, StepPicture::kSize_px, StepPicture::kSize_px);
    if (hit.sphere < 0) {
      const double to_A = camera.distance_A;
      learner.follow({{.to = PointA{ray.origin.A + ray.direction * (0.5 * to_A)}, .placed = true, .wait_s = 0.05},
                      {.to = PointA{ray.origin.A + ray.direction * (1.5 * to_A)}, .speed_A_per_s = 60.0}});
      return;
    }
    learner.follow(
        {{.to = PointA{scp - ray.direction * out_A}, .placed = true, .wait_s = 0.35},
         {.to = PointA{scp + ray.direction * (0.6 / learner.view().N_per_A)}, .speed_A_per_s = 20.0, .wait_s = wait_s},
         {.to = PointA{scp - ray.direction * out_A}, .speed_A_per_s = 60.0}});
  }

  double fraction() { return std::uniform_real_distribution<double>(0.0, 1.0)(random); }

  /// A random place on the picture of these atoms.
  glm::dvec2 somewhere(const StepPicture& picture, const Camera& camera, std::span<const std::uint32_t> atoms) {
    const PlacedAtom a = picture.molecule->at(atoms[std::size_t(fraction() * double(atoms.size()))]);
    const Vec3 at = camera.project(a.position, StepPicture::kSize_px, StepPicture::kSize_px);
    const double reach_px = a.radius_A / camera.pixel_A(std::abs(at.z), StepPicture::kSize_px);
    return glm::dvec2(at.x, at.y) + reach_px * glm::dvec2(2.0 * fraction() - 1.0, 2.0 * fraction() - 1.0);
  }

  /// The step's own view, or another one for jabbing.
  Camera someView(const StepPicture& picture, std::span<const std::uint32_t> atoms) {
    Camera c = picture.camera();
    c.target = {picture.middle(atoms)};
    if (fraction() < 0.5) c.orbit(2.0 * std::numbers::pi * fraction(), 2.0 * std::numbers::pi * fraction());
    return c;
  }

  std::mt19937_64 random;
  ScriptedLearner learner;
};

inline std::vector<std::uint32_t> atomsOf(const StepPicture& picture, const TaskSpec& spec,
                                          std::initializer_list<std::string_view> keys) {
  std::vector<std::uint32_t> out;
  for (const std::string_view key : keys)
    for (const std::uint32_t a : presentAtoms(spec.values[key].selection, picture.scene, *picture.molecule))
      out.push_back(a);
  return out;
}

}  // namespace moltact::test
