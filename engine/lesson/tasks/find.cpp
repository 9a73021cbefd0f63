// find: with the screen dark, go over the surface to a place and say "here".
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/language/catalogue.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

constexpr double kStill_A = 0.4;   // a contact point that stays within this rests
constexpr double kStill_s = 2.0;   // resting for so long says "here" where the author wants it so
constexpr double kWarmer_A = 1.0;  // a change of distance that is worth a word

class Find : public Task {
 public:
  Find(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec),
        target_(spec.values["find"].selection, molecule),
        name_(spec, "find"),
        within_A_(spec.values["within"].number),
        by_holding_(spec.values["by"].text == "hold"),
        warmer_(spec.values["hints"].text == "warmer"),
        meter_(spec.values["meter"].text == "on") {
    for (const std::uint32_t i : spec.values["find"].selection.select(molecule))
      balls_.push_back({molecule.atoms[i].position.A, molecule.atoms[i].radius_A});
  }

  void reset() override {
    Task::reset();
    now_ = {};
  }

 private:
  enum class Heat { None, Warmer, Colder };

  struct Now {
    double off_A = 0.0, told_A = -1.0, first_off_A = -1.0, still_s = 0.0;
    Vec3 resting_A{0.0};
    int guesses = 0, looks = 0;
    bool touching = false, felt = false, right = false, wrong = false, lit = false, told_here = false;
    Heat heat = Heat::None;
  };

  void onSample(const TouchSample& s, double dt_s) override {
    now_.touching = s.contact.touching();
    if (!now_.touching || now_.lit) {
      now_.still_s = 0.0;
      return;
    }
    now_.felt = true;
    now_.off_A = distance(s.contact.scp.A, s.probe_A);
    now_.right = target_.touchedBy(s.contact) || now_.off_A <= within_A_;
    if (now_.told_A < 0.0) now_.told_A = now_.off_A;
    if (std::abs(now_.off_A - now_.told_A) >= kWarmer_A) {
      now_.heat = now_.off_A < now_.told_A ? Heat::Warmer : Heat::Colder;
      now_.told_A = now_.off_A;
    }
    if (glm::distance(s.contact.scp.A, now_.resting_A) > kStill_A) {
      now_.resting_A = s.contact.scp.A;
      now_.still_s = 0.0;
      now_.told_here = now_.wrong = false;
    } else {
      now_.still_s += dt_s;
    }
    if (!by_holding_) return;
    setProgress(now_.told_here ? 0.0 : now_.still_s / kStill_s);
    if (now_.still_s >= kStill_s && !now_.told_here) {
      now_.told_here = true;
      here();
    }
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    const auto place = placeFor(view, placesToTouch(view, target_));
    if (!place) return plan;
    comeTo(plan, *place, depthFor(view, 0.3), by_holding_ ? kStill_s + 0.3 : 0.3);
    if (!by_holding_) plan.push_back({.answer = TaskAnswer{.word = "here"}});
    return plan;
  }

  // From the surface of the nearest atom, as the probe's centre sees it.
  double distance(const Vec3& scp, double probe_A) const {
    double least = std::numeric_limits<double>::max();
    for (const Ball& b : balls_) least = std::min(least, glm::distance(scp, b.centre_A) - b.radius_A - probe_A);
    return std::max(0.0, least);
  }

  void here() {
    ++now_.guesses;
    if (now_.guesses == 1) now_.first_off_A = now_.off_A;
    now_.wrong = !now_.right;
    if (now_.right) finish();
  }

  void onAnswer(const TaskAnswer& answer) override {
    if (answer.word == "here") {
      here();
      return;
    }
    now_.lit = answer.word == "light";
    now_.wrong = false;
    if (now_.lit) ++now_.looks;
  }

  std::vector<TaskButton> currentButtons() const override {
    if (now_.lit) return {{"dark", N_("Make it dark again"), 'L'}};
    std::vector<TaskButton> out;
    // A mouse lets go before it clicks: the place that was touched last is meant.
    if (!by_holding_ && now_.felt) out.push_back({"here", N_("Here it is")});
    out.push_back({"light", N_("Look for a moment"), 'L'});
    return out;
  }

  TaskStage requestedStage() const override { return {.dark = !now_.lit, .force_meter = meter_}; }

  std::string guidance() const override {
    const std::string name = name_.text();
    if (now_.lit) return trf("Look where {0} is. The search goes on when it is dark again.", name);
    if (!now_.touching && now_.felt && !by_holding_ && !now_.wrong)
      return withHeat(trf("Say whether it was there, or feel on to find {0}.", name));
    if (!now_.touching) return trf("Push until you touch the surface, then feel your way to {0}.", name);
    if (now_.wrong) return withHeat(trf("That is not {0}. Feel on.", name));
    return withHeat(by_holding_ ? trf("Slide to {0}, then rest there for {1}.", name, timeText(kStill_s))
                                : trf("Slide to {0}, then say that it is here.", name));
  }

  std::string withHeat(std::string sentence) const {
    if (!warmer_ || now_.heat == Heat::None) return sentence;
    return sentence + " " + (now_.heat == Heat::Warmer ? tr("Warmer.") : tr("Colder."));
  }

  void measure(std::vector<TaskFigure>& out) const override {
    out.push_back({N_("guesses"), double(now_.guesses), ""});
    if (now_.first_off_A >= 0.0) out.push_back({N_("error of the first guess"), now_.first_off_A, "Å"});
    out.push_back({N_("looks"), double(now_.looks), ""});
  }

  AtomSet target_;
  TargetName name_;
  std::vector<Ball> balls_;
  double within_A_ = 3.0;
  bool by_holding_ = false, warmer_ = false, meter_ = true;
  Now now_;
};

}  // namespace

TaskKind findKind() {
  return {"find",
          "Find a place by touch alone, with the screen dark.",
          {{.name = "find",
            .type = ValueType::Selection,
            .meaning = "The atoms of which one is to be found.",
            .required = true},
           {.name = "within",
            .type = ValueType::Quantity,
            .meaning = "A contact point so near to the surface of a selected atom is right as well.",
            .fallback = "1 Å",
            .dimension = Dimension::Length,
            .most = 100.0},
           {.name = "by",
            .type = ValueType::Word,
            .meaning = "How the student tells: with a button (here), or by resting for 2 s (hold).",
            .fallback = "here",
            .words = {"here", "hold"}},
           {.name = "hints",
            .type = ValueType::Word,
            .meaning = "Whether the program says 'warmer' and 'colder'.",
            .fallback = "none",
            .words = {"none", "warmer"}},
           {.name = "meter",
            .type = ValueType::Word,
            .meaning = "Whether the force is shown in the dark, how great and whereto; without a force-feedback device "
                       "it is all there is to feel.",
            .fallback = "on",
            .words = {"on", "off"}}},
          [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> { return std::make_unique<Find>(s, m); }};
}

}  // namespace moltact
