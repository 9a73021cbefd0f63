// hold: stay in contact with atoms or with a kind of place for a time, within a range of force if the author gives one.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/haptics/methods.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

// Tolerance at the ends of the range of force for tremor (share of the end's value).
constexpr double kForceSlack = 0.05;

class Hold : public Task {
 public:
  Hold(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec), target_(spec.values["hold"].selection, molecule), name_(spec, "hold") {
    const Value& place = spec.values["hold"];
    if (!place.words.empty()) feature_ = place.words[0];
    if (spec.values["of"].selection.given()) target_ = AtomSet(spec.values["of"].selection, molecule);
    kind_.emplace(feature_, target_, molecule);
    time_s_ = spec.values["for"].number;
    if (spec.values.has("force")) {
      low_N_ = spec.values["force"].low;
      high_N_ = spec.values["force"].high;
    }
  }

  void reset() override {
    Task::reset();
    watch_.restart();
    state_ = State::Away;
    slipped_ = false;
    slips_ = 0;
  }

 private:
  enum class State { Away, Elsewhere, TooLight, TooHard, Good };

  void onSample(const TouchSample& s, double dt_s) override {
    state_ = stateOf(s);
    if (watch_.tick(state_ == State::Good, dt_s, kSlip_s)) {
      slipped_ = true;
      ++slips_;
    }
    if (state_ == State::Good) slipped_ = false;
    setProgress(watch_.elapsed_s() / time_s_);
    if (watch_.elapsed_s() >= time_s_) finish();
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    const double wanted_N = high_N_ < 1e6 ? std::sqrt(std::max(low_N_, 0.05) * high_N_) : std::max(0.3, 1.5 * low_N_);
    HandPlan plan;
    const std::string kind = feature_ == "anywhere" ? "" : feature_;
    if (const auto place = placeFor(view, placesToTouch(view, target_, kind))) {
      comeTo(plan, *place, depthFor(view, wanted_N), time_s_ + 0.5);
      // Replaces a method that loses the surface by the reference method.
      if (view.attempt >= 3) plan.front().method = referenceMethod().name;
    }
    return plan;
  }

  bool tooLight() const override { return state_ == State::TooLight; }

  State stateOf(const TouchSample& s) const {
    if (!s.contact.touching()) return State::Away;
    const bool here = feature_.empty() || feature_ == "anywhere" ? target_.touchedBy(s.contact)
                                                                 : kind_->at(s.contact, target_, s.probe_A);
    if (!here) return State::Elsewhere;
    const double force = glm::length(s.force.N);
    if (force < low_N_ * (1.0 - kForceSlack)) return State::TooLight;
    if (force > high_N_ * (1.0 + kForceSlack)) return State::TooHard;
    return State::Good;
  }

  std::string guidance() const override {
    switch (state_) {
      case State::Good:
        return trf("Hold it: {0} of {1}.", timeText(watch_.elapsed_s()), timeText(time_s_));
      case State::TooLight:
        return trf("Push a little further in: {0} is enough.", forceText(low_N_));
      case State::TooHard:
        return trf("Ease off a little: stay below {0}.", forceText(high_N_));
      case State::Elsewhere:
        return trf("You are on the surface. Slide on to find {0}.", name_.text());
      case State::Away:
        break;
    }
    if (slipped_) return trf("You slipped off. Touch {0} again and hold for {1}.", name_.text(), timeText(time_s_));
    return trf("Touch {0} and hold for {1}.", name_.text(), timeText(time_s_));
  }

  void measure(std::vector<TaskFigure>& out) const override { out.push_back({N_("slips"), double(slips_), ""}); }

  AtomSet target_;
  TargetName name_;
  std::string feature_;
  std::optional<PlaceKind> kind_;
  double time_s_ = 1.0, low_N_ = 0.0, high_N_ = std::numeric_limits<double>::infinity();
  Stopwatch watch_;
  State state_ = State::Away;
  bool slipped_ = false;
  int slips_ = 0;
};

bool namesAtomsOrAnywhere(const TaskSpec& spec) { return !isKindOfPlace(spec.values["hold"]); }

void checkHold(const TaskSpec& spec, std::vector<Problem>& problems) {
  const Value &hold = spec.values["hold"], &of = spec.values["of"];
  if (of.place.line && hold.selection.given())
    problems.push_back(
        problemAt(of.place, tr("'of' belongs to a kind of place"), tr("take it out, or write 'hold: pit'")));
}

}  // namespace

TaskKind holdKind() {
  return {"hold",
          "Stay in contact for a time.",
          {.base_s = 25.0},
          {{.name = "hold",
            .type = ValueType::Target,
            .meaning = "Where to stay: atoms, a kind of place, or anywhere on the surface.",
            .required = true,
            .words = {"sphere", "crease", "pit", "anywhere"}},
           {.name = "of",
            .type = ValueType::Selection,
            .meaning = "For a kind of place: only contacts with these atoms alone count."},
           {.name = "for",
            .type = ValueType::Quantity,
            .meaning = "The time to stay; interruptions shorter than 0.3 s are ignored.",
            .fallback = "2 s",
            .dimension = Dimension::Time,
            .min = 0.1,
            .max = 600.0},
           {.name = "force",
            .type = ValueType::Range,
            .meaning = "The permitted range of the force, with a tolerance of 5 % at each end.",
            .dimension = Dimension::Force,
            .max = 20.0}},
          [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> { return std::make_unique<Hold>(s, m); },
          &checkHold,
          nullptr,
          nullptr,
          "what counts are the atoms against which the body presses hardest, and the force on the whole body. A kind "
          "of place is "
          "for the probe.",
          &namesAtomsOrAnywhere};
}

}  // namespace moltact
