// find: on a dark screen, find a place on the surface by touch, or the place to which the forces between atoms pull most
// strongly, and report it with "here". The molecule is rotated at
// random, again after each look and when the guesses are used up, so that no position on the screen reveals the place.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/random.h"
#include "engine/core/units.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/scene_forces.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/lesson/tasks/touch_limits.h"

namespace moltact {
namespace {

constexpr double kStill_A = 0.4;   // a contact point that stays within this distance is at rest
constexpr double kStill_s = 2.0;   // resting for this time counts as "here" if the author chose this
constexpr double kWarmer_A = 1.0;  // minimum change of distance for "Warmer" and "Colder"
constexpr double kClose_A = 3.0;   // a wrong guess within this distance of the place is called close
// cosine of the largest angle between the place's direction and the viewer's, in every rotation
constexpr double kFront = 0.35;
constexpr std::string_view kLowest = "lowest-energy";
constexpr int kFindFalls = 60;     // of the probe into wells
constexpr double kAsLow = 0.9;     // a well with this share of the lowest energy is right too
constexpr double kBeside_A = 1.0;  // atoms within this distance of the probe show the place

bool seeksWell(const TaskSpec& spec) { return !spec.values["find"].words.empty(); }

/// The probe's wells of the lowest energy; empty without any attraction.
std::vector<Well> lowestWells(const SceneForces& forces) {
  std::vector<Well> wells = forces.wells(kFindFalls);
  std::erase_if(wells, [lowest = wells.empty() ? 0.0 : wells.front().energy.total_kcal_mol()](const Well& w) {
    return w.energy.total_kcal_mol() >= 0.0 || w.energy.total_kcal_mol() > kAsLow * lowest;
  });
  return wells;
}

class Find : public Task {
 public:
  Find(const TaskSpec& spec, const Molecule& molecule)
      : Task(spec),
        seeks_well_(seeksWell(spec)),
        target_(spec.values["find"].selection, molecule),
        name_(spec, "find"),
        limits_(spec, "find", molecule),
        wrong_(spec, molecule),
        within_A_(spec.values["within"].number),
        by_holding_(spec.values["by"].text == "hold"),
        warmer_(spec.values["hints"].text == "warmer"),
        meter_(spec.values["meter"].text == "on"),
        turns_(spec.values["turn"].text == "random"),
        guesses_(static_cast<int>(spec.values["guesses"].number)),
        looks_(static_cast<int>(spec.values["looks"].number)) {
    for (const Sphere& a : molecule.spheres) middle_A_ += a.centre_A / double(molecule.atoms.size());
    // The forces tell the place of a well.
    if (seeks_well_) return;
    for (const std::uint32_t i : spec.values["find"].selection.select(molecule))
      spheres_.push_back(molecule.spheres[i]);
    Vec3 target(0.0);
    for (const Sphere& b : spheres_) target += b.centre_A / double(spheres_.size());
    outward_ = target - middle_A_;
    turn();
  }

  // The place is computed here, once, from the scene as the lesson has it.
  void takeForces(std::shared_ptr<const SceneForces> forces) override {
    if (!seeks_well_) return;
    wells_ = lowestWells(*forces);
    if (wells_.empty()) return;
    const Vec3 place = wells_.front().pose.place.A;
    outward_ = place - middle_A_;
    const double reach_A = forces->touch().probe_A + kBeside_A;
    forces->spheres().visitNear(place, reach_A, [&](std::uint32_t i, const Sphere& s) {
      if (glm::distance(place, s.centre_A) <= s.radius_A + reach_A) well_atoms_.push_back(i);
    });
    std::sort(well_atoms_.begin(), well_atoms_.end());
    turn();
  }

  void drawBy(std::uint64_t seed) override {
    state_ = seed;
    turn();
  }

  void reset() override {
    Task::reset();
    now_ = {};
    again();
  }

 private:
  struct Now {
    double off_A = 0.0, first_off_A = -1.0, still_s = 0.0;
    Vec3 resting_A{0.0};
    double reported_A = -1.0;  // distance of the previous wrong guess in this search; negative: none
    int guesses = 0, looks = 0, rounds = 1;
    int left = 0;             // remaining guesses of this round
    std::string said;         // the reply to the last guess
    std::string author_says;  // the author's reply to what is touched
    bool touching = false, felt = false, right = false, lit = false, reported_here = false;
  };

  // A uniformly distributed rotation (Shoemake 1992) among those in which the place faces the viewer.
  void turn() {
    now_.left = guesses_;
    if (!turns_) return;
    const double far = glm::length(outward_);
    for (int tries = 0; tries < 64; ++tries) {
      const double u = nextFraction(state_), a = kTwoPi * nextFraction(state_), b = kTwoPi * nextFraction(state_);
      turned_ = Quat(std::sqrt(u) * std::cos(b), std::sqrt(1.0 - u) * std::sin(a), std::sqrt(1.0 - u) * std::cos(a),
                     std::sqrt(u) * std::sin(b));
      if (far < 1.0 || glm::dot(turned_ * Vec3(0, 0, 1), outward_) >= kFront * far) return;
    }
  }

  // Restarts the search: the hand begins outside the molecule, which may be rotated, so earlier contacts are discarded.
  void again() {
    turn();
    ++presentation_;
    now_.touching = now_.felt = now_.right = now_.reported_here = false;
    now_.still_s = 0.0;
    now_.reported_A = -1.0;
    now_.author_says.clear();
  }

  void onSample(const TouchSample& s, double dt_s) override {
    // The reply to a guess stays until the next touch.
    if (s.meets() && !now_.touching && !by_holding_) now_.said.clear();
    now_.touching = s.meets();
    if (!now_.touching || now_.lit) {
      now_.still_s = 0.0;
      return;
    }
    now_.felt = true;
    now_.off_A = distance(s.contact.scp.A, s.probe_A);
    const bool touched = !seeks_well_ && target_.touchedBy(s.contact);
    now_.right = (touched || now_.off_A <= within_A_) && limits_.allow(s.contact, s.probe_A);
    now_.author_says = now_.right ? std::string() : wrong_.about(s.contact);
    if (glm::distance(s.contact.scp.A, now_.resting_A) > kStill_A) {
      now_.resting_A = s.contact.scp.A;
      now_.still_s = 0.0;
      now_.reported_here = false;
      now_.said.clear();
    } else {
      now_.still_s += dt_s;
    }
    if (!by_holding_) return;
    setProgress(now_.reported_here ? 0.0 : now_.still_s / kStill_s);
    if (now_.still_s >= kStill_s && !now_.reported_here) {
      now_.reported_here = true;
      here();
    }
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    HandPlan plan;
    if (seeks_well_) return toWell(view);
    std::vector<SurfacePlace> places = placesToTouch(view, target_);
    std::erase_if(places, [&](const SurfacePlace& p) { return !limits_.allow(p.scp_A, view.probe_A); });
    const auto place = placeFor(view, places);
    if (!place) return plan;
    comeTo(plan, *place, depthFor(view, 0.3), by_holding_ ? kStill_s + 0.3 : 0.3);
    if (!by_holding_) plan.push_back({.answer = TaskAnswer{.word = "here"}});
    return plan;
  }

  // From an open place beside the well into it.
  HandPlan toWell(const HandPlanInput& view) const {
    HandPlan plan;
    if (wells_.empty()) return plan;
    const Vec3 well = wells_.front().pose.place.A;
    std::vector<SurfacePlace> places;
    for (const Feature f : {Feature::Sphere, Feature::Circle, Feature::Point})
      for (const SurfacePlace& p : openPlaces(view, well_atoms_, f)) places.push_back(p);
    std::stable_sort(places.begin(), places.end(), [&](const SurfacePlace& a, const SurfacePlace& b) {
      return glm::distance(a.scp_A, well) < glm::distance(b.scp_A, well);
    });
    const auto place = placeFor(view, places);
    if (!place) return plan;
    comeTo(plan, *place, 0.0, 0.2);
    plan.push_back({.to = PointA{well}, .wait_s = by_holding_ ? kStill_s + 0.5 : 1.0});
    if (!by_holding_) plan.push_back({.answer = TaskAnswer{.word = "here"}});
    return plan;
  }

  // Distance of the probe's surface from that of the nearest atom; of its centre from the nearest well.
  double distance(const Vec3& scp, double probe_A) const {
    double min = std::numeric_limits<double>::max();
    for (const Well& w : wells_) min = std::min(min, glm::distance(scp, w.pose.place.A));
    for (const Sphere& b : spheres_) min = std::min(min, glm::distance(scp, b.centre_A) - b.radius_A - probe_A);
    return std::max(0.0, min);
  }

  void here() {
    ++now_.guesses;
    if (now_.guesses == 1) now_.first_off_A = now_.off_A;
    if (now_.right) {
      finish();
      return;
    }
    now_.said = withHeat(why());
    now_.reported_A = now_.off_A;
    if (--now_.left > 0) {
      now_.said +=
          ' ' + trnf("{0} guess is left.", "{0} guesses are left.", static_cast<std::size_t>(now_.left), now_.left);
      return;
    }
    if (missedLast()) return;
    ++now_.rounds;
    again();
    now_.said += ' ' + std::string(turns_ ? tr("That was the last guess: the molecule has been turned. Search again.")
                                          : tr("That was the last guess: come from outside and search again."));
  }

  std::string solution() const override { return trf("It is marked in the view: {0}.", name_.text()); }
  std::vector<std::uint32_t> answerAtoms() const override { return seeks_well_ ? well_atoms_ : target_.atoms(); }

  // How the last touch differs from the requested place.
  std::string why() const {
    if (!now_.author_says.empty()) return now_.author_says;
    const std::string name = name_.text();
    return now_.off_A <= within_A_ + kClose_A ? trf("That is not {0}, but close to it.", name)
                                              : trf("That is not {0}: it lies elsewhere.", name);
  }

  void onAnswer(const TaskAnswer& answer) override {
    if (answer.word == "here") {
      here();
      return;
    }
    now_.lit = answer.word == "light";
    now_.said.clear();
    if (now_.lit) {
      ++now_.looks;
    } else {
      const int left = now_.left;
      again();
      now_.left = left;
    }
  }

  std::vector<TaskButton> currentButtons() const override {
    if (now_.lit) return {{"dark", N_("Make it dark again"), 'L'}};
    std::vector<TaskButton> out;
    // With a mouse the student has to let go before clicking, so the place touched last counts.
    if (!by_holding_ && now_.felt) out.push_back({"here", N_("Here it is")});
    if (now_.looks < looks_) out.push_back({"light", N_("Look for a moment"), 'L'});
    return out;
  }

  TaskStage requestedStage() const override {
    TaskStage stage{.dark = !now_.lit, .unnamed = !now_.lit, .force_meter = meter_, .presentation = presentation_};
    if (turns_) stage.turned = turned_;
    return stage;
  }

  std::string guidance() const override {
    const std::string name = name_.text();
    if (now_.lit)
      return turns_ ? trf("Look what lies round {0}. In the dark the molecule will be turned anew.", name)
                    : trf("Look where {0} is. The search goes on when it is dark again.", name);
    if (!now_.said.empty()) return now_.said;
    if (!now_.touching && now_.felt && !by_holding_)
      return trf("Say whether it was there, or feel on to find {0}.", name);
    if (!now_.touching) return trf("Push until you touch the surface, then feel your way to {0}.", name);
    return by_holding_ ? trf("Slide to {0}, then rest there for {1}.", name, timeText(kStill_s))
                       : trf("Slide to {0}, then say that it is here.", name);
  }

  // Compares a wrong guess with the previous one. Nothing is said while the hand slides; otherwise the words alone
  // would lead to the place.
  std::string withHeat(std::string sentence) const {
    if (!warmer_ || now_.reported_A < 0.0 || std::abs(now_.off_A - now_.reported_A) < kWarmer_A) return sentence;
    return sentence + " " + (now_.off_A < now_.reported_A ? tr("Warmer.") : tr("Colder."));
  }

  void measure(std::vector<TaskFigure>& out) const override {
    out.push_back({N_("guesses"), double(now_.guesses), ""});
    if (now_.first_off_A >= 0.0) out.push_back({N_("error of the first guess"), now_.first_off_A, "Å"});
    out.push_back({N_("looks"), double(now_.looks), ""});
    out.push_back({N_("rounds"), double(now_.rounds), ""});
  }

  bool seeks_well_ = false;
  AtomSet target_;
  TargetName name_;
  TouchLimits limits_;
  WrongTouches wrong_;
  std::vector<Sphere> spheres_;
  std::vector<Well> wells_;                // the places, where forces are sought
  std::vector<std::uint32_t> well_atoms_;  // beside the lowest one
  double within_A_ = 3.0;
  bool by_holding_ = false, warmer_ = false, meter_ = true, turns_ = true;
  int guesses_ = 3, looks_ = 2, presentation_ = 1;
  std::uint64_t state_ = 0;  // of the random generator
  Vec3 middle_A_{0.0};
  Vec3 outward_{0.0};  // direction from the molecule's centre to the place's centre
  Quat turned_ = kNoRotation;
  Now now_;
};

void checkFind(const TaskSpec& spec, std::vector<Problem>& problems) {
  if (!seeksWell(spec)) return;
  for (const std::string_view key : {"side", "region"})
    if (const Value& value = spec.values[key]; value.place.line)
      problems.push_back(problemAt(value.place, trf("'{0}' belongs to atoms, and here a place is sought", key),
                                   tr("take this line out, or name the atoms in 'find'")));
}

void checkFindScene(const TaskSpec& spec, const SceneSpec& scene, std::vector<Problem>& problems) {
  if (seeksWell(spec) && !forceChoice(scene.touch.forces).any())
    problems.push_back(problemAt(spec.values["find"].place, tr("no forces between atoms act in this scene"),
                                 tr("write 'forces: all' in this step's scene, or name atoms")));
}

void checkFindForces(const TaskSpec& spec, const SceneForces& forces, std::vector<Problem>& problems) {
  if (seeksWell(spec) && !forces.body() && lowestWells(forces).empty())
    problems.push_back(problemAt(spec.values["find"].place, tr("nothing attracts the probe in this scene"),
                                 tr("give the probe another charge: 'probe-charge: 1'")));
}

}  // namespace

TaskKind findKind() {
  std::vector<KeySpec> keys{
      {.name = "find",
       .type = ValueType::Target,
       .meaning =
           "The atoms, one of which must be found; or, in a scene with `forces`, the place to which they pull the "
           "probe most strongly, which the program computes.",
       .required = true,
       .words = {kLowest}},
      {.name = "within",
       .type = ValueType::Quantity,
       .meaning =
           "A contact point within this distance of a selected atom's surface also counts; of the place of lowest "
           "energy, the probe's centre.",
       .fallback = "1 Å",
       .dimension = Dimension::Length,
       .max = 100.0},
      {.name = "by",
       .type = ValueType::Word,
       .meaning = "How the student answers: with a button (here), or by resting for 2 s (hold).",
       .fallback = "here",
       .words = {"here", "hold"}},
      {.name = "hints",
       .type = ValueType::Word,
       .meaning = "Whether a wrong guess is called warmer or colder than the previous one.",
       .fallback = "none",
       .words = {"none", "warmer"}},
      {.name = "meter",
       .type = ValueType::Word,
       .meaning = "Whether magnitude and direction of the force are displayed in the dark. Without a force-feedback "
                  "device this display is the only information.",
       .fallback = "on",
       .words = {"on", "off"}},
      {.name = "turn",
       .type = ValueType::Word,
       .meaning = "Whether the molecule is rotated at random in the dark: differently for each student, after each "
                  "look and when the guesses are used up. The place always faces the student.",
       .fallback = "random",
       .words = {"random", "none"}},
      {.name = "guesses",
       .type = ValueType::Count,
       .meaning = "The number of guesses before the search restarts.",
       .fallback = "3",
       .min = 1,
       .max = 100},
      attemptsKey("The number of searches, each with its guesses; by default unlimited. After the last one the place "
                  "is shown, and the student continues."),
      {.name = "looks",
       .type = ValueType::Count,
       .meaning = "How often the student may look for a moment.",
       .fallback = "2",
       .max = 100}};
  for (KeySpec& key : TouchLimits::keys()) keys.push_back(std::move(key));
  keys.push_back(WrongTouches::key());
  return {"find",
          "Find a place by touch alone, with the screen dark.",
          {.base_s = 150.0},
          std::move(keys),
          [](const TaskSpec& s, const Molecule& m) -> std::unique_ptr<Task> { return std::make_unique<Find>(s, m); },
          &checkFind,
          nullptr,
          &checkFindScene,
          {},
          nullptr,
          nullptr,
          &checkFindForces};
}

}  // namespace moltact
