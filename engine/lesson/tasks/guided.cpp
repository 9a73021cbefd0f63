#include "engine/lesson/tasks/guided.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/guide_file.h"
#include "engine/lesson/source_text.h"

namespace moltact {
namespace {

constexpr double kLead_A = 2.0;        // the ghost is so far ahead of the hand
constexpr int kComparedWays = 12;      // ways that are compared with the hand's place
constexpr double kSameProbe_A = 0.01;  // a probe that differs by less has the same way

}  // namespace

void addGuideKeys(std::vector<KeySpec>& keys) {
  keys.push_back({.name = "guide",
                  .type = ValueType::Word,
                  .meaning = "What leads the hand in tries before the one that counts: `spring` draws it softly to the "
                             "way, `tube` only from `guide-width` on. Mouse and keys get a ghost of the probe instead.",
                  .fallback = "none",
                  .words = {"none", "spring", "tube"}});
  keys.push_back({.name = "guide-path",
                  .type = ValueType::Text,
                  .meaning = "The guide's way: `way` is the task's own; or a recorded hand beside the lesson, a "
                             "recording or rows of places in angstrom.",
                  .fallback = "way"});
  keys.push_back({.name = "guide-width",
                  .type = ValueType::Quantity,
                  .meaning = "The radius of the tube; farther away the hand counts as off the way.",
                  .fallback = "1 Å",
                  .dimension = Dimension::Length,
                  .min = 0.1,
                  .max = 20.0});
  keys.push_back({.name = "guide-fade",
                  .type = ValueType::Count,
                  .meaning = "The number of tries with a guide. Its strength fades evenly, with 3 from full to 2/3 and "
                             "1/3; the try after them is without it and counts.",
                  .fallback = "3",
                  .min = 1,
                  .max = 9});
  keys.push_back({.name = "guide-ghost",
                  .type = ValueType::Word,
                  .meaning = "Where the ghost of the probe is drawn ahead of the hand: with `mouse` and keys only, or "
                             "`always`.",
                  .fallback = "mouse",
                  .words = {"mouse", "always"}});
}

bool hasGuide(const TaskSpec& spec) {
  const std::string& word = spec.values["guide"].text;
  return !word.empty() && word != "none";
}

int guidedTries(const TaskSpec& spec) { return hasGuide(spec) ? int(spec.values["guide-fade"].number) : 0; }

std::string guideFile(const TaskSpec& spec) {
  const std::string& path = spec.values["guide-path"].text;
  return hasGuide(spec) && path != "way" ? path : std::string();
}

void checkGuideKeys(const TaskSpec& spec, std::vector<Problem>& problems) {
  if (hasGuide(spec)) return;
  for (const char* key : {"guide-path", "guide-width", "guide-fade", "guide-ghost"})
    if (const Place place = spec.values[key].place; place.line)
      problems.push_back(problemAt(place, trf("'{0}' needs a guide", key),
                                   tr("add a line 'guide: tube' or 'guide: spring', or leave it out")));
}

GuidePath wayOfTask(const Task& task, const SphereGrid& spheres, double probe_A, const std::optional<Vec3>& hand_A) {
  GuidePath best({});
  double least_A = 0.0;
  for (int attempt = 0; attempt < (hand_A ? kComparedWays : 1); ++attempt) {
    std::vector<std::vector<Vec3>> parts;
    // A spring without stiffness: the plan does not press.
    for (const HandAct& act :
         task.demonstrate({.spheres = spheres, .probe_A = probe_A, .N_per_A = 0.0, .attempt = attempt})) {
      if (!act.to) continue;
      if (act.placed || parts.empty()) parts.emplace_back();
      if (!act.placed) parts.back().push_back(act.to->A);
    }
    GuidePath way(parts);
    if (way.empty()) continue;
    double mean_A = 0.0;
    constexpr int kPlaces = 16;
    for (int k = 0; hand_A && k <= kPlaces; ++k)
      mean_A += glm::distance(*hand_A, way.at(way.length_A() * k / kPlaces)) / (kPlaces + 1);
    if (!best.empty() && mean_A >= least_A) continue;
    least_A = mean_A;
    best = std::move(way);
  }
  return best;
}

class GuidedTask final : public Task {
 public:
  GuidedTask(const TaskSpec& spec, std::unique_ptr<Task> inner, const Molecule& molecule)
      : Task(spec),
        inner_(std::move(inner)),
        spheres_(molecule.spheres),
        file_(guideFile(spec)),
        kind_(spec.values["guide"].text == "spring" ? GuideKind::Spring : GuideKind::Tube),
        radius_A_(spec.values["guide-width"].number),
        tries_with_(guidedTries(spec)),
        either_(spec.values["direction"].text == "either"),
        ghost_with_device_(spec.values["guide-ghost"].text == "always") {}

  std::optional<TaskGuide> guide() const override {
    if (done() || !guided()) return std::nullopt;
    return TaskGuide{path_, kind_, radius_A_, 1.0 - double(try_) / tries_with_, ghost(), ghost_with_device_};
  }

  void drawBy(std::uint64_t seed) override { inner_->drawBy(seed); }
  const TaskCurves* curves() const override { return inner_->curves(); }
  std::vector<std::uint32_t> answerAtoms() const override { return inner_->answerAtoms(); }
  std::vector<std::uint32_t> exampleAtoms() const override { return inner_->exampleAtoms(); }
  TaskTrials trials() const override { return inner_->trials(); }
  HandPlan demonstrate(const HandPlanInput& view) const override { return inner_->demonstrate(view); }
  std::string_view noPlan() const override { return inner_->noPlan(); }

  void leaveOut(std::span<const std::uint32_t> untouchable) override {
    untouchable_.assign(untouchable.begin(), untouchable.end());
    inner_->leaveOut(untouchable);
  }
  void takeLesson(const std::filesystem::path& lesson_file, const Molecule& molecule) override {
    inner_->takeLesson(lesson_file, molecule);
    if (file_.empty()) return;
    Expected<GuidePath> read = readGuidePath(lesson_file.parent_path() / file_, molecule);
    if (read)
      path_ = std::make_shared<const GuidePath>(*std::move(read));
    else
      fault_ = read.problem().message;
  }
  void takeForces(std::shared_ptr<const SceneForces> forces) override { inner_->takeForces(std::move(forces)); }

  void reset() override {
    Task::reset();
    inner_->reset();
    try_ = 0;
    leaned_s_ = off_s_ = lean_Ns_ = 0.0;
    felt_ = false;
    beginTry();
  }

 private:
  bool guided() const { return try_ < tries_with_ && path_ && !path_->empty(); }

  void beginTry() {
    begun_ = backward_ = false;
    along_A_ = 0.0;
  }

  // The task's own way depends on the probe; it stays while a try is in progress.
  void makeWay(double probe_A, const Vec3& hand_A) {
    if (!file_.empty() || std::abs(probe_A - probe_A_) < kSameProbe_A || begun_) return;
    probe_A_ = probe_A;
    path_ = std::make_shared<const GuidePath>(wayOfTask(*inner_, SphereGrid(spheres_, untouchable_), probe_A, hand_A));
  }

  void onSample(const TouchSample& s, double dt_s) override {
    if (try_ < tries_with_) makeWay(s.probe_A, s.hip.A);
    const bool with_guide = guided();
    // The judged try begins when the hand is free.
    if (!with_guide && try_ > 0 && s.field_N) return;
    inner_->feed(s);
    if (with_guide) lean(s, dt_s);
    if (inner_->done()) return endTry(with_guide);
    setProgress((try_ + inner_->progress()) / ((guided() ? tries_with_ : try_) + 1));
  }

  void lean(const TouchSample& s, double dt_s) {
    const GuidePath::Nearest near = path_->nearest(s.contact.touching() ? s.contact.scp.A : s.hip.A);
    along_A_ = near.along_A;
    if (!begun_) backward_ = either_ && 2.0 * along_A_ > path_->length_A();
    begun_ = inner_->progress() > 0.0;
    if (!s.contact.touching()) return;
    leaned_s_ += dt_s;
    if (near.distance_A > radius_A_) off_s_ += dt_s;
    felt_ = felt_ || s.field_N;
    lean_Ns_ += s.field_N.value_or(0.0) * dt_s;
  }

  void endTry(bool with_guide) {
    if (!with_guide) {
      if (inner_->solved()) return finish();
      while (!missedLast()) {
      }
      return;
    }
    inner_->reset();
    // The common figures are those of the judged try.
    Task::reset();
    ++try_;
    beginTry();
    setProgress(double(try_) / (tries_with_ + 1));
  }

  PointA ghost() const {
    if (!begun_) return {path_->at(backward_ ? path_->length_A() : 0.0)};
    return {path_->at(along_A_ + (backward_ ? -kLead_A : kLead_A))};
  }

  std::string guidance() const override {
    const std::string next = inner_->guidance();
    if (!fault_.empty()) return trf("There is no guide: {0}. {1}", fault_, next);
    if (guided()) return trf("Try {0} of {1}, with the guide. {2}", try_ + 1, tries_with_ + 1, next);
    return try_ > 0 ? trf("Now the try that counts, without the guide. {0}", next) : next;
  }
  std::string afterwards() const override {
    if (!(leaned_s_ > 0.0)) return {};
    const std::string off = percentText(off_s_ / leaned_s_);
    if (felt_)
      return trf(
          "With the guide you were off the way {0} of the time and leaned on it with {1} on average. The last "
          "try was without it.",
          off, forceText(lean_Ns_ / leaned_s_));
    return trf("While the ghost led, you were off the way {0} of the time. The last try was without it.", off);
  }
  std::string solution() const override { return inner_->solution(); }
  void onAnswer(const TaskAnswer& given) override { inner_->answer(given); }
  bool tooLight() const override { return inner_->wantsHarderPush(); }
  std::vector<TaskButton> currentButtons() const override { return inner_->buttons(); }
  TaskStage requestedStage() const override { return inner_->stage(); }
  std::optional<TaskSlider> currentSlider() const override { return inner_->slider(); }

  void measure(std::vector<TaskFigure>& out) const override {
    inner_->measure(out);
    out.push_back({N_("guided tries"), double(try_), ""});
    if (!(leaned_s_ > 0.0)) return;
    out.push_back({N_("off the guided way"), 100.0 * off_s_ / leaned_s_, "%"});
    if (felt_) out.push_back({N_("mean force of the guide"), lean_Ns_ / leaned_s_, "N"});
  }

  std::unique_ptr<Task> inner_;
  SharedArray<Sphere> spheres_;
  std::vector<std::uint32_t> untouchable_;
  std::string file_, fault_;
  std::shared_ptr<const GuidePath> path_;
  GuideKind kind_ = GuideKind::Tube;
  double radius_A_ = 1.0, probe_A_ = -1.0;
  int tries_with_ = 0, try_ = 0;  // tries with a guide: all of the task, and those done
  bool either_ = false, ghost_with_device_ = false;
  bool begun_ = false, backward_ = false;  // of the present try
  double along_A_ = 0.0;
  // Of all tries with a guide, in contact.
  double leaned_s_ = 0.0, off_s_ = 0.0, lean_Ns_ = 0.0;
  bool felt_ = false;  // a device gave the guide's force
};

std::unique_ptr<Task> makeGuided(const TaskSpec& spec, std::unique_ptr<Task> inner, const Molecule& molecule) {
  return std::make_unique<GuidedTask>(spec, std::move(inner), molecule);
}

}  // namespace moltact
