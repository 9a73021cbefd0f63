// fit: with a slider, find the largest probe that reaches a place or passes a ring, or the smallest that does not. The
// tracker decides whether the present probe reaches it. A search over the same surface gives the limit.
#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/passable.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/lesson/tasks/touch_limits.h"

namespace moltact {
namespace {

constexpr double kAlike_A = 0.011;  // the probe counts as grown to the slider's value within this
constexpr double kKeptOut_s = 1.0;  // a probe must be tried for this time before it may be called too large
constexpr double kThrough_A = 0.5;  // within this distance of the ring's plane, the probe is inside the ring

const TouchProperty& probeProperty() {
  for (const TouchProperty& p : touchProperties())
    if (p.key == "probe") return p;
  return touchProperties().front();
}

/// Places where a probe of this radius reaches the atoms, on the required side.
std::vector<SurfacePlace> waysTo(const SphereGrid& scene, std::span<const std::uint32_t> atoms,
                                 const TouchLimits& limits, double probe_A, bool first_only = false) {
  return reachablePlaces(scene, atoms, probe_A, first_only,
                         [&](const SurfacePlace& p) { return limits.allow(p.scp_A, probe_A); });
}

class Fit : public Task {
 public:
  Fit(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec),
        target_(spec.values["fit"].selection, molecule),
        name_(spec, "fit"),
        limits_(spec, "fit", molecule),
        scene_(std::make_shared<const SphereGrid>(molecule.spheres)),
        through_(spec.values["way"].text == "through"),
        largest_(spec.values["want"].text == "largest"),
        min_A_(spec.values["least"].number),
        max_A_(spec.values["most"].number),
        within_A_(spec.values["within"].number) {
    if (through_) ring_ = ringOf(*scene_, target_.atoms());
    begin();
  }

  void leaveOut(std::span<const std::uint32_t> untouchable) override {
    const std::span<const Sphere> spheres = scene_->spheres();
    scene_ = std::make_shared<const SphereGrid>(std::vector<Sphere>(spheres.begin(), spheres.end()), untouchable);
  }

  void reset() override {
    Task::reset();
    guesses_ = 0;
    begin();
  }

 private:
  void begin() {
    value_A_ = largest_ ? min_A_ : max_A_;
    proven_A_ = -1.0;
    tried_s_ = 0.0;
    there_ = touching_ = false;
    said_.clear();
  }

  std::optional<TaskSlider> currentSlider() const override {
    return TaskSlider{N_("Probe radius"), value_A_, min_A_, max_A_, 0.1, Dimension::Length};
  }

  TaskStage requestedStage() const override {
    TaskStage stage;
    stage.touch.set(probeProperty(), value_A_);
    return stage;
  }

  bool grown(const TouchSample& s) const { return std::abs(s.probe_A - value_A_) <= kAlike_A; }

  bool reached(const TouchSample& s) const {
    if (!through_) return target_.touchedBy(s.contact) && limits_.allow(s.contact, s.probe_A);
    if (!ring_ || s.contact.fault != Fault::None) return false;
    const Vec3 from = s.contact.scp.A - ring_->centre_A;
    const double height_A = glm::dot(from, ring_->axis);
    return std::abs(height_A) <= kThrough_A && glm::length(from - ring_->axis * height_A) < ring_->radius_A;
  }

  void onSample(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    there_ = grown(s) && reached(s);
    if (there_) proven_A_ = std::max(proven_A_, value_A_);
    if (touching_ && grown(s)) {
      tried_s_ += dt_s;
      if (tried_s_ > 0.3) said_.clear();
    }
  }

  // Whether this probe or a larger one has reached the place; a larger one proves it for all smaller ones.
  bool proven() const { return proven_A_ >= value_A_ - 1e-9; }

  std::vector<TaskButton> currentButtons() const override {
    const bool tried = largest_ ? proven() : tried_s_ >= kKeptOut_s && !proven();
    if (!tried) return {};
    return {{"this", largest_ ? N_("This is the largest") : N_("This is the smallest")}};
  }

  double limit_A() const {
    if (!limit_A_) {
      const std::vector<std::uint32_t> atoms = target_.atoms();
      limit_A_ = largestProbe(min_A_, max_A_, [&](double probe_A) {
                   if (!through_) return !waysTo(*scene_, atoms, limits_, probe_A, true).empty();
                   return ring_ && pathThrough(*scene_, *ring_, probe_A);
                 }).value_or(min_A_);
    }
    return std::max(*limit_A_, proven_A_);
  }

  void onAnswer(const TaskAnswer& answer) override {
    if (answer.number) {
      if (std::abs(*answer.number - value_A_) < 1e-9) return;
      value_A_ = *answer.number;
      tried_s_ = 0.0;
      said_.clear();
      return;
    }
    ++guesses_;
    const double over_A = largest_ ? limit_A() - value_A_ : value_A_ - limit_A();
    if (over_A >= -kAlike_A && over_A <= within_A_ + 1e-9) {
      finish();
      return;
    }
    if (missedLast()) return;
    const std::string size = sizeText(value_A_);
    if (largest_)
      said_ = trf("A probe of {0} gets there, but a larger one does too. Make it larger.", size);
    else if (over_A < 0.0)
      said_ = trf("A probe of {0} still gets there. Try it from another side, then make it larger.", size);
    else
      said_ = trf("A probe of {0} is kept out, but a smaller one is too. Make it smaller.", size);
  }

  static std::string sizeText(double probe_A) { return quantityText(probe_A, Dimension::Length, decimals(1)); }

  std::string guidance() const override {
    if (!said_.empty()) return said_;
    const std::string name = name_.text(), size = sizeText(value_A_);
    if (there_) return trf("A probe of {0} gets there.", size);
    if (proven() && largest_) return trf("A probe of {0} gets there. Is it the largest?", size);
    if (touching_)
      return through_ ? trf("Try whether a probe of {0} gets through {1}.", size, name)
                      : trf("Try whether a probe of {0} gets to {1}.", size, name);
    return through_ ? trf("Set the probe's radius, then push it through {0}.", name)
                    : trf("Set the probe's radius, then push it to {0}.", name);
  }

  std::string afterwards() const override { return trf("The tracker finds {0} as the limit.", sizeText(limit_A())); }
  std::string solution() const override { return afterwards(); }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    const double step_A = 0.5 * std::min(within_A_, 0.2);
    const double wanted_A =
        std::clamp(largest_ ? limit_A() - step_A * (1 + view.attempt % 2) : limit_A() + step_A, min_A_, max_A_);
    HandPlanInput grown{view.spheres, wanted_A, view.N_per_A, view.hip, view.attempt};
    const auto set = [&](PointA before) {
      plan.push_back({.to = before, .placed = true, .answer = TaskAnswer{.number = wanted_A}});
      plan.push_back({.wait_s = 0.3 + std::abs(wanted_A - view.probe_A) / 4.0});
    };
    const double far = glm::distance(view.spheres.low_A(), view.spheres.high_A()) + 2.0 * wanted_A + 1.0;
    if (through_) {
      if (!ring_) return plan;
      const auto at = pathThrough(*scene_, *ring_, largest_ ? wanted_A : limit_A() - step_A);
      const Vec3 way = at.value_or(ring_->centre_A);
      set({way + ring_->axis * far});
      const double before_A = ring_->radius_A + wanted_A + 1.5;
      plan.push_back({.to = PointA{way + ring_->axis * before_A}, .placed = true, .wait_s = 0.5});
      plan.push_back({.to = PointA{way - ring_->axis * (largest_ ? before_A : 0.0)}, .wait_s = 1.5});
    } else {
      std::vector<SurfacePlace> places =
          waysTo(*scene_, target_.atoms(), limits_, largest_ ? wanted_A : limit_A() - step_A);
      const auto place = placeFor(grown, places);
      if (!place) return plan;
      set({place->scp_A + place->outward * far});
      comeTo(plan, *place, depthFor(view, 0.3), largest_ ? 0.6 : 1.6);
    }
    plan.push_back({.answer = TaskAnswer{.word = "this"}});
    return plan;
  }

  void measure(std::vector<TaskFigure>& out) const override {
    out.push_back({N_("probe radius"), value_A_, "Å"});
    out.push_back({N_("guesses"), double(guesses_), ""});
  }

  AtomSet target_;
  TargetName name_;
  TouchLimits limits_;
  std::shared_ptr<const SphereGrid> scene_;
  std::optional<AtomRing> ring_;
  bool through_ = false, largest_ = true;
  double min_A_ = 0.0, max_A_ = 5.0, within_A_ = 0.2;
  mutable std::optional<double> limit_A_;  // computed when first requested
  double value_A_ = 0.0, proven_A_ = -1.0, tried_s_ = 0.0;
  bool there_ = false, touching_ = false;
  int guesses_ = 0;
  std::string said_;
};

void checkFit(const TaskSpec& spec, std::vector<Problem>& problems) {
  const Value &min = spec.values["least"], &max = spec.values["most"];
  if (min.number >= max.number)
    problems.push_back(problemAt((max.place.line ? max : min).place, tr("the slider's ends leave no probe to choose"),
                                 tr("make 'most' greater than 'least'")));
}

void checkLimit(const TaskSpec& spec, const Molecule& molecule, std::span<const std::uint32_t> untouchable,
                std::vector<Problem>& problems) {
  const Value& fit = spec.values["fit"];
  if (!fit.selection.given()) return;
  const SphereGrid scene(molecule.spheres, untouchable);
  const std::vector<std::uint32_t> atoms = fit.selection.select(molecule);
  if (atoms.empty()) return;
  const double min_A = spec.values["least"].number, max_A = spec.values["most"].number;
  const bool through = spec.values["way"].text == "through";
  const auto ring = through ? ringOf(scene, atoms) : std::nullopt;
  if (through && !ring) {
    problems.push_back(problemAt(fit.place, tr("three atoms at least make a ring to go through"),
                                 tr("name more of its atoms, or write 'way: into'")));
    return;
  }
  const TouchLimits limits(spec, "fit", molecule);
  if (through && limits.given()) {
    const Value& side = spec.values[spec.values.has("side") ? "side" : "region"];
    problems.push_back(problemAt(side.place, tr("a ring has no side: the probe goes through it"),
                                 tr("take the line out, or write 'way: into'")));
    return;
  }
  const auto fits = [&](double probe_A) {
    return through ? pathThrough(scene, *ring, probe_A).has_value()
                   : !waysTo(scene, atoms, limits, probe_A, true).empty();
  };
  if (!fits(min_A))
    problems.push_back(problemAt(fit.place,
                                 trf("not even a probe of {0} gets there", quantityText(min_A, Dimension::Length)),
                                 tr("choose another place, or a smaller 'least'")));
  else if (fits(max_A))
    problems.push_back(problemAt(fit.place,
                                 trf("every probe up to {0} gets there", quantityText(max_A, Dimension::Length)),
                                 tr("choose another place, or a greater 'most'")));
}

}  // namespace

TaskKind fitKind() {
  std::vector<KeySpec> keys{
      {.name = "fit",
       .type = ValueType::Selection,
       .meaning = "The atoms, one of which must be touched, or the atoms of the ring.",
       .required = true},
      {.name = "way",
       .type = ValueType::Word,
       .meaning = "Whether the probe must touch the atoms or pass through the ring that they form.",
       .fallback = "into",
       .words = {"into", "through"}},
      {.name = "want",
       .type = ValueType::Word,
       .meaning = "The largest probe that reaches the place, or the smallest that does not.",
       .fallback = "largest",
       .words = {"largest", "smallest"}},
      {.name = "least",
       .type = ValueType::Quantity,
       .meaning = "The lower end of the slider for the probe's radius.",
       .fallback = "0.2 Å",
       .dimension = Dimension::Length,
       .max = kMaxProbe_A},
      {.name = "most",
       .type = ValueType::Quantity,
       .meaning = "The upper end of the slider.",
       .fallback = "5 Å",
       .dimension = Dimension::Length,
       .max = kMaxProbe_A},
      {.name = "within",
       .type = ValueType::Quantity,
       .meaning = "The largest deviation from the limit found by the tracker that counts as right.",
       .fallback = "0.2 Å",
       .dimension = Dimension::Length,
       .min = 0.05,
       .max = 5.0},
      attemptsKey("How many answers the student may give; by default unlimited. After the last wrong one the limit is "
                  "shown, and the student continues.")};
  for (KeySpec& key : TouchLimits::keys()) keys.push_back(std::move(key));
  return {"fit",
          "Find the largest probe that reaches a place or passes through a ring, or the smallest that does not.",
          {.base_s = 180.0},
          std::move(keys),
          [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> { return std::make_unique<Fit>(s, m); },
          &checkFit,
          &checkLimit};
}

}  // namespace moltact
