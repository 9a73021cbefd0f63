// compare: touch several places, or touch with several haptic methods, each for a while and in any order.
#include <algorithm>

#include "engine/haptics/methods.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

class CompareMethods : public Task {
 public:
  explicit CompareMethods(const TaskSpec& spec) : Task(spec), time_s_(spec.values["for"].number) {
    for (const std::string& name : spec.values["compare"].words)
      if (std::none_of(parts_.begin(), parts_.end(), [&](const Part& p) { return p.method == name; }))
        parts_.push_back({name, 0.0});
  }

  void reset() override {
    Task::reset();
    for (Part& p : parts_) p.felt_s = 0.0;
    in_use_ = nullptr;
    touching_ = false;
  }

 private:
  struct Part {
    std::string method;
    double felt_s = 0.0;
  };

  void onSample(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    in_use_ = nullptr;
    double sum_s = 0.0;
    bool all = true;
    for (Part& p : parts_) {
      if (p.method == s.method) {
        in_use_ = &p;
        if (touching_) p.felt_s = std::min(time_s_, p.felt_s + dt_s);
      }
      sum_s += p.felt_s;
      all = all && p.felt_s >= time_s_;
    }
    setProgress(sum_s / (time_s_ * double(parts_.size())));
    if (all) finish();
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    const std::vector<SurfacePlace> places = openPlaces(view, everyAtom(view.spheres), Feature::Sphere);
    for (const Part& p : parts_) {
      const auto place = placeFor(view, places);
      if (p.felt_s >= time_s_ || !place) continue;
      const std::size_t begin = plan.size();
      comeTo(plan, *place, depthFor(view, 0.5), time_s_ + 0.2);
      plan[begin].method = p.method;
    }
    return plan;
  }

  std::string guidance() const override {
    if (in_use_ && in_use_->felt_s < time_s_) {
      const std::string with = methodTitle(in_use_->method);
      return touching_ ? trf("Keep touching with {0}: {1} of {2}.", with, timeText(in_use_->felt_s), timeText(time_s_))
                       : trf("Touch the surface with {0}.", with);
    }
    for (const Part& p : parts_)
      if (p.felt_s < time_s_) return trf("Now choose {0} in the panel Methods.", methodTitle(p.method));
    return {};
  }

  std::vector<Part> parts_;
  double time_s_ = 1.0;
  const Part* in_use_ = nullptr;
  bool touching_ = false;
};

class ComparePlaces : public Task {
 public:
  ComparePlaces(const TaskSpec& spec, const Molecule& molecule) : Task(spec), time_s_(spec.values["for"].number) {
    for (const Selection& part : spec.values["of"].path)
      places_.push_back({AtomSet(part, molecule), TargetName(part, molecule)});
  }

  void reset() override {
    Task::reset();
    for (Place& p : places_) p.felt_s = p.impulse_Ns = 0.0;
    here_ = nullptr;
    touching_ = false;
  }

 private:
  struct Place {
    AtomSet atoms;
    TargetName name;
    double felt_s = 0.0, impulse_Ns = 0.0;
    double mean_N() const { return felt_s > 0.0 ? impulse_Ns / felt_s : 0.0; }
  };

  void onSample(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    here_ = nullptr;
    double sum_s = 0.0;
    bool all = true;
    for (Place& p : places_) {
      if (p.atoms.touchedBy(s.contact)) {
        if (!here_ || p.felt_s < time_s_) here_ = &p;
        p.felt_s += dt_s;
        p.impulse_Ns += glm::length(s.force.N) * dt_s;
      }
      sum_s += std::min(time_s_, p.felt_s);
      all = all && p.felt_s >= time_s_;
    }
    setProgress(sum_s / (time_s_ * double(std::max<std::size_t>(1, places_.size()))));
    if (all) finish();
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    for (const Place& p : places_)
      if (p.felt_s < time_s_)
        if (const auto place = placeFor(view, placesToTouch(view, p.atoms)))
          comeTo(plan, *place, depthFor(view, 0.3), time_s_ + 0.2);
    return plan;
  }

  std::string guidance() const override {
    if (here_ && here_->felt_s < time_s_)
      return trf("Keep touching {0}: {1} of {2}.", here_->name.text(), timeText(here_->felt_s), timeText(time_s_));
    std::size_t felt = 0;
    const Place* missing = nullptr;
    for (const Place& p : places_)
      if (p.felt_s >= time_s_)
        ++felt;
      else if (!missing)
        missing = &p;
    if (!missing) return {};
    return touching_ && !here_
               ? trf("{0} of {1} places touched. Slide on to find {2}.", felt, places_.size(), missing->name.text())
               : trf("{0} of {1} places touched. Now touch {2}.", felt, places_.size(), missing->name.text());
  }

  void measure(std::vector<TaskFigure>& out) const override {
    if (places_.size() != 2) return;
    out.push_back({N_("mean force on the first place"), places_[0].mean_N(), "N"});
    out.push_back({N_("mean force on the second place"), places_[1].mean_N(), "N"});
  }

  std::vector<Place> places_;
  double time_s_ = 1.0;
  const Place* here_ = nullptr;
  bool touching_ = false;
};

constexpr std::string_view kPlaces = "places";

std::vector<std::string_view> thingsToCompare() {
  std::vector<std::string_view> words = methodNames();
  words.push_back(kPlaces);
  return words;
}

bool comparesPlaces(const TaskSpec& spec) {
  const std::vector<std::string>& words = spec.values["compare"].words;
  return std::find(words.begin(), words.end(), kPlaces) != words.end();
}

void checkCompare(const TaskSpec& spec, std::vector<Problem>& problems) {
  const Value &compare = spec.values["compare"], &of = spec.values["of"];
  if (!comparesPlaces(spec)) {
    if (of.place.line)
      problems.push_back(
          problemAt(of.place, tr("'of' belongs to 'compare: places'"), tr("take it out or write 'compare: places'")));
    return;
  }
  if (compare.words.size() > 1)
    problems.push_back(
        problemAt(compare.place, tr("'places' stands alone"), tr("write a touch block of its own for the methods")));
  if (of.path.size() < 2)
    problems.push_back(problemAt(of.place.line ? of.place : compare.place,
                                 tr("at least two places are needed to compare"),
                                 tr("write them parted by 'then': 'of: residue 4 then residue 9'")));
}

// Comparing methods requires that the student may switch between them.
void checkCompareScene(const TaskSpec& spec, const SceneSpec& scene, std::vector<Problem>& problems) {
  const Value& compare = spec.values["compare"];
  if (scene.locks("method") && !compare.words.empty() && !comparesPlaces(spec))
    problems.push_back(problemAt(compare.place, tr("the student cannot switch methods here, for they are locked"),
                                 tr("take 'method' out of 'locked', or this task")));
}

}  // namespace

TaskKind compareKind() {
  return {
      "compare",
      "Touch several places, or touch with several haptic methods, each for a while.",
      {.base_s = 10.0, .each_s = 12.0, .each = "of", .each_what = "place or method"},
      {{.name = "compare",
        .type = ValueType::WordList,
        .meaning = "The methods, between which the student switches in any order; or 'places'.",
        .required = true,
        .words = thingsToCompare()},
       {.name = "of", .type = ValueType::Path, .meaning = "For 'compare: places': the places, separated by 'then'."},
       {.name = "for",
        .type = ValueType::Quantity,
        .meaning = "The time to touch with each.",
        .fallback = "2 s",
        .dimension = Dimension::Time,
        .min = 0.1,
        .max = 600.0}},
      [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> {
        if (comparesPlaces(s)) return std::make_unique<ComparePlaces>(s, m);
        return std::make_unique<CompareMethods>(s);
      },
      &checkCompare,
      nullptr,
      &checkCompareScene,
      "`compare: places` alone. What counts are the atoms against which the body presses hardest, and the force on the "
      "whole "
      "body.",
      &comparesPlaces};
}

}  // namespace moltact
