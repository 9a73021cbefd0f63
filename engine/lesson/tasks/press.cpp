// press: push against atoms or anywhere until the reaction reaches a force.
#include "engine/language/catalogue.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

class Press : public Task {
 public:
  Press(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec), target_(spec.values["press"].selection, molecule), name_(spec, "press") {
    const Value& place = spec.values["press"];
    if (!place.words.empty()) feature_ = place.words[0];
    until_N_ = spec.values["until"].number;
  }

  void reset() override {
    Task::reset();
    watch_.restart();
    force_N_ = 0.0;
    touching_ = here_ = false;
  }

 private:
  void onSample(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    here_ = feature_.empty() || feature_ == "anywhere" ? target_.touchedBy(s.contact)
                                                       : isFeature(feature_, s.contact.feature);
    force_N_ = here_ ? glm::length(s.force.N) : 0.0;
    // Requires the full force for a time, so that a single noisy sample does not finish the task.
    watch_.tick(force_N_ >= until_N_, dt_s, kSlip_s);
    setProgress(force_N_ / until_N_);
    if (watch_.elapsed_s() >= kTouch_s) finish();
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    const std::string kind = feature_ == "anywhere" ? "" : feature_;
    if (const auto place = placeFor(view, placesToTouch(view, target_, kind)))
      comeTo(plan, *place, 1.1 * depthFor(view, until_N_), 0.5);
    return plan;
  }

  bool tooLight() const override { return here_ && force_N_ < until_N_; }

  std::string guidance() const override {
    if (here_) {
      if (force_N_ >= until_N_) return trf("That is {0}. Stay there a moment.", forceText(force_N_));
      return trf("You push with {0} of {1}. Push further in.", forceText(force_N_), forceText(until_N_));
    }
    if (touching_) return trf("You are on the surface. Slide on to find {0}.", name_.text());
    return trf("Touch {0}, then push in.", name_.text());
  }

  AtomSet target_;
  TargetName name_;
  std::string feature_;
  double until_N_ = 1.0, force_N_ = 0.0;
  Stopwatch watch_;
  bool touching_ = false, here_ = false;
};

}  // namespace

TaskKind pressKind() {
  return {"press",
          "Push until the reaction of the surface reaches a force.",
          {.base_s = 25.0},
          {{.name = "press",
            .type = ValueType::Target,
            .meaning = "Where to push: atoms, a kind of place, or anywhere on the surface.",
            .required = true,
            .words = {"sphere", "crease", "pit", "anywhere"}},
           {.name = "until",
            .type = ValueType::Quantity,
            .meaning = "The required force.",
            .required = true,
            .dimension = Dimension::Force,
            .min = 0.01,
            .max = 20.0}},
          [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> { return std::make_unique<Press>(s, m); },
          nullptr,
          nullptr,
          nullptr,
          "what counts are the atoms against which the body presses hardest, and the force on the whole body. A kind "
          "of place is "
          "for the probe.",
          [](const TaskSpec& s) { return !isKindOfPlace(s.values["press"]); }};
}

}  // namespace moltact
