// cross: slide from one atom to another without leaving the surface, over the crease between them.
#include <utility>

#include "engine/lesson/tasks/kinds.h"

namespace moltact {
namespace {

class Cross : public Task {
 public:
  Cross(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec), from_(spec.values["cross"].selection, molecule), to_(spec.values["to"].selection, molecule),
        from_name_(targetName(spec, "cross")),
        to_name_(spec.values.has("arrival") ? spec.values["arrival"].text : spec.values["to"].selection.noun()),
        either_(spec.values["direction"].text == "either"), times_(static_cast<int>(spec.values["times"].number)) {
    if (either_) {
      from_name_ = "one atom";
      to_name_ = "the other atom";
    }
  }

  void reset() override {
    Task::reset();
    away_s_ = 0.0;
    crossed_ = 0;
    on_from_ = lost_ = touching_ = false;
  }

 private:
  void take(const TouchSample& s, double dt_s) override {
    touching_ = s.contact.touching();
    if (!touching_) {
      // A hand that hops for an instant at the crease has not let go.
      away_s_ += dt_s;
      if (on_from_ && away_s_ > kTouch_s) {
        on_from_ = false;
        lost_ = true;
      }
      return;
    }
    away_s_ = 0.0;
    // Where either direction counts, the side that the student touches first is the start.
    if (either_ && !on_from_ && to_.holds(s.contact)) std::swap(from_, to_);
    const bool from = from_.holds(s.contact), to = to_.holds(s.contact);
    if (on_from_ && to && !from) {
      ++crossed_;
      on_from_ = false;
    } else if (from) {
      on_from_ = true;
      lost_ = false;
    } else if (!from_.touchedBy(s.contact) && !to_.touchedBy(s.contact)) {
      on_from_ = false;
    }
    setProgress((crossed_ + (on_from_ ? 0.5 : 0.0)) / times_);
    if (crossed_ >= times_) finish();
  }

  std::string guidance() const override {
    const std::string count = times_ > 1 ? " (" + std::to_string(crossed_) + " of " + std::to_string(times_) + ")" : "";
    if (on_from_) return "Now slide to " + to_name_ + " without letting go" + count + ".";
    if (lost_) return "You left the surface. Start again on " + from_name_ + count + ".";
    return (touching_ ? "Slide to " : "Touch ") + from_name_ + " to begin" + count + ".";
  }

  AtomSet from_, to_;
  std::string from_name_, to_name_;
  double away_s_ = 0.0;
  bool either_ = false;
  int times_ = 1, crossed_ = 0;
  bool on_from_ = false, lost_ = false, touching_ = false;
};

}  // namespace

TaskKind crossKind() {
  return {"cross", "Slide from one atom to another without leaving the surface.",
          {{.name = "cross", .type = ValueType::Selection, .meaning = "The atoms to start on.", .required = true},
           {.name = "to", .type = ValueType::Selection, .meaning = "The atoms to arrive on; resting on them alone counts.",
            .required = true},
           {.name = "arrival", .type = ValueType::Text,
            .meaning = "What the atoms of 'to' are called in the middle of a sentence, as 'called' does for the start."},
           {.name = "direction", .type = ValueType::Word, .meaning = "Whether the way back counts as well; 'either' suits atoms that look the same.",
            .fallback = "forward", .words = {"forward", "either"}},
           {.name = "times", .type = ValueType::Count, .meaning = "How often.", .fallback = "1", .least = 1,
            .most = 100}},
          [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> { return std::make_unique<Cross>(s, m); }};
}

}  // namespace moltact
