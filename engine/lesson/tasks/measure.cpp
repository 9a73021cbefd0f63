// measure: touch two places in turn, mark each, and read the distance between the two points on the surface.
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/lesson/tasks/touch_limits.h"

namespace moltact {
namespace {

class Measure : public Task {
 public:
  Measure(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec),
        from_(spec.values["measure"].selection, molecule),
        to_(spec.values["to"].selection, molecule),
        from_name_(spec, "measure"),
        to_name_(spec, "to", "arrival"),
        wrong_(spec, molecule) {
    if (!spec.values.has("between")) return;
    low_A_ = spec.values["between"].low;
    high_A_ = spec.values["between"].high;
  }

  void reset() override {
    Task::reset();
    first_A_.reset();
    touch_.reset();
    distance_A_ = -1.0;
    measured_ = 0;
    touching_ = false;
    said_.clear();
  }

 private:
  struct Touch {
    Vec3 surface_A{0.0};  // the contact point on the surface
    bool on_from = false, on_to = false;
    std::string author_says;
  };

  void onSample(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    if (!touching_) {
      held_s_ = 0.0;
      return;
    }
    held_s_ += dt_s;
    // With a mouse the student has to let go before clicking, so the place touched last counts.
    if (held_s_ < kTouch_s) return;
    touch_ = Touch{s.contact.scp.A - s.contact.outward() * s.probe_A, from_.touchedBy(s.contact),
                   to_.touchedBy(s.contact), wrong_.about(s.contact)};
    said_.clear();
  }

  std::vector<TaskButton> currentButtons() const override {
    if (!touch_) return {};
    return {{"mark", first_A_ ? N_("Mark the second place") : N_("Mark the first place")}};
  }

  void onAnswer(const TaskAnswer&) override {
    const Touch marked = *touch_;
    touch_.reset();
    const bool right = first_A_ ? marked.on_to : marked.on_from;
    if (!right) {
      if (missedLast()) return;
      said_ = !marked.author_says.empty() ? marked.author_says
                                          : trf("That was not {0}. Touch it and mark again.", wanted().text());
      return;
    }
    if (!first_A_) {
      first_A_ = marked.surface_A;
      setProgress(0.5);
      return;
    }
    distance_A_ = glm::distance(*first_A_, marked.surface_A);
    ++measured_;
    if (distance_A_ >= low_A_ - 1e-9 && distance_A_ <= high_A_ + 1e-9) {
      finish();
      return;
    }
    if (missedLast()) return;
    said_ = distance_A_ > high_A_
                ? trf("You measured {0}: that is farther than from one to the other. Mark both anew, where they are "
                      "nearer.",
                      lengthText())
                : trf("You measured {0}: that is nearer than from one to the other. Mark both anew, farther apart.",
                      lengthText());
    first_A_.reset();
    setProgress(0.0);
  }

  const TargetName& wanted() const { return first_A_ ? to_name_ : from_name_; }
  std::string lengthText() const { return quantityText(distance_A_, Dimension::Length, decimals(1)); }

  std::string guidance() const override {
    if (!said_.empty()) return said_;
    const std::string name = wanted().text();
    if (touch_) {
      const bool right = first_A_ ? touch_->on_to : touch_->on_from;
      if (right) return trf("You touch {0}. Mark it, or slide to the point that you mean.", name);
      if (!touch_->author_says.empty()) return touch_->author_says;
      return trf("You are on the surface. Slide on to find {0}.", name);
    }
    return first_A_ ? trf("The first place is marked. Now touch {0}.", name) : trf("Touch {0} and mark it.", name);
  }

  std::string solution() const override {
    if (high_A_ == std::numeric_limits<double>::infinity()) return tr("The places are marked in the view.");
    return trf("It is {0} to {1} from one place to the other; they are marked in the view.",
               quantityText(low_A_, Dimension::Length, decimals(1)),
               quantityText(high_A_, Dimension::Length, decimals(1)));
  }
  std::vector<std::uint32_t> answerAtoms() const override {
    std::vector<std::uint32_t> out = from_.atoms();
    for (const std::uint32_t a : to_.atoms()) out.push_back(a);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }
  std::string afterwards() const override { return trf("You measured {0} from surface to surface.", lengthText()); }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    const std::vector<SurfacePlace> ones = placesToTouch(view, from_), others = placesToTouch(view, to_);
    // The pairs of points with the required distance; another attempt uses another pair.
    std::vector<std::pair<const SurfacePlace*, const SurfacePlace*>> pairs;
    for (const SurfacePlace& a : ones)
      for (const SurfacePlace& b : others) {
        const double grid_spacing_A =
            glm::distance(a.scp_A - a.outward * view.probe_A, b.scp_A - b.outward * view.probe_A);
        if (grid_spacing_A >= low_A_ && grid_spacing_A <= high_A_) pairs.emplace_back(&a, &b);
      }
    if (pairs.empty()) return plan;
    const auto& [one, other] = pairs[static_cast<std::size_t>(view.attempt) % pairs.size()];
    const double depth_A = depthFor(view, 0.3);
    if (!first_A_) {
      comeTo(plan, *one, depth_A, 0.3);
      plan.push_back({.answer = TaskAnswer{.word = "mark"}});
    }
    comeTo(plan, *other, depth_A, 0.3);
    plan.push_back({.answer = TaskAnswer{.word = "mark"}});
    return plan;
  }

  void measure(std::vector<TaskFigure>& out) const override {
    if (distance_A_ >= 0.0) out.push_back({N_("distance"), distance_A_, "Å"});
    out.push_back({N_("measurements"), double(measured_), ""});
  }

  AtomSet from_, to_;
  TargetName from_name_, to_name_;
  WrongTouches wrong_;
  double low_A_ = 0.0, high_A_ = std::numeric_limits<double>::infinity(), distance_A_ = -1.0, held_s_ = 0.0;
  std::optional<Vec3> first_A_;
  std::optional<Touch> touch_;
  std::string said_;
  int measured_ = 0;
  bool touching_ = false;
};

}  // namespace

TaskKind measureKind() {
  return {
      "measure",
      "Measure a distance by touching two places and marking them.",
      {.base_s = 60.0},
      {{.name = "measure",
        .type = ValueType::Selection,
        .meaning = "The atoms, one of which is touched first.",
        .required = true},
       {.name = "to",
        .type = ValueType::Selection,
        .meaning = "The atoms, one of which is touched second.",
        .required = true},
       {.name = "arrival",
        .type = ValueType::Text,
        .meaning = "The name of the atoms of 'to' inside a sentence, like 'called' for the first."},
       {.name = "between",
        .type = ValueType::Range,
        .meaning = "The permitted result, from surface to surface; otherwise both places must be marked again. By "
                   "default any two touches of the places count.",
        .dimension = Dimension::Length,
        .max = 1000.0},
       WrongTouches::key(),
       attemptsKey("How many wrong marks and measurements are permitted; by default unlimited. After the last one the "
                   "answer is shown, and the student continues.")},
      [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> { return std::make_unique<Measure>(s, m); }};
}

}  // namespace moltact
