// pull: pull what the hand holds out of its place, without a jump, until its centre is a given distance away. The greatest
// force at each distance is kept as a curve. Who puts it down outside has not pulled it out.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/field/pair_model.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/pose_text.h"
#include "engine/lesson/tasks/curve_overlap.h"
#include "engine/lesson/tasks/held_way.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

constexpr std::size_t kPullPoints = 25;  // of the curve
constexpr double kBeyond_A = 3.0;        // of a demonstrated pull, past the distance that is asked for
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

PoseTolerance siteOf(const TaskSpec& spec) { return {spec.values["within"].number, std::numbers::pi}; }

class Pull : public Task {
 public:
  explicit Pull(const TaskSpec& spec)
      : Task(spec), spec_(spec), called_(spec.values["called"].text), draws_(spec.values["draw"].text == "yes") {
    curves_.x_name = N_("distance");
    curves_.x_max_A = spec.values["pull"].number;
    expectAgain();
    forget();
  }

  void takeInHand(std::shared_ptr<const HeldBody> body) override {
    const PoseA place = writtenGoal(spec_.values["from"].text, *body);
    place_.emplace(std::move(body), place);
  }

  void reset() override {
    Task::reset();
    way_.restart();
    expectAgain();
    forget();
    begun_ = false;
    off_A_ = 0.0;
    ++presentation_;
  }

  const TaskCurves* curves() const override { return &curves_; }

 private:
  struct Force {
    double hand_N = 0.0, atoms_pN = 0.0;
  };

  void expectAgain() {
    curves_.drawing = draws_;
    curves_.drawn.assign(kPullPoints, kNothing);
  }

  void forget() {
    curves_.felt.assign(kPullPoints, kNothing);
    curves_.complete = false;
    curves_.agreement.reset();
    curves_.max_N = draws_ ? spec_.values["most"].number : 1.0;
    between_pN_.fill(0.0);
    at_ = 0;
  }

  TaskStage requestedStage() const override {
    TaskStage stage{.presentation = presentation_};
    if (place_) {
      stage.body_turned = place_->goal().orientation;
      stage.body_begins = place_->goal().place;
    }
    return stage;
  }

  void onAnswer(const TaskAnswer& answer) override {
    curves_.drawn = answer.curve;
    curves_.drawing = false;
  }

  void onSample(const TouchSample& s, double dt_s) override {
    const bool continues = way_.tick(s, dt_s);
    if (curves_.drawing || !place_ || !s.body || s.contact.fault != Fault::None) return;
    const double within_A = spec_.values["within"].number;
    off_A_ = glm::distance(way_.pose().place.A, place_->goal().place.A);
    if (place_->rmsd_A(way_.pose()) <= within_A && !place_->stretched(s, within_A)) {
      begun_ = true;
    } else if (begun_ && !continues && dt_s > 0.0) {
      // The hand let go, or was put down elsewhere: another pull begins in the place.
      begun_ = false;
      forget();
      ++presentation_;
    }
    if (!begun_) return setProgress(0.0);
    record(s);
    setProgress(off_A_ / curves_.x_max_A);
    if (off_A_ < curves_.x_max_A) return;
    curves_.complete = true;
    if (draws_) curves_.agreement = curveOverlap(curves_.drawn, curves_.felt);
    finish();
  }

  // The curve of the last way out. What was felt farther out is forgotten when the body comes back; how hard it was
  // pressed in before it came off does not count.
  void record(const TouchSample& s) {
    const double at = std::clamp(off_A_ / curves_.x_max_A, 0.0, 1.0) * double(kPullPoints - 1);
    const auto k = std::size_t(std::lround(at));
    const Force now{
        glm::length(s.force.N),
        s.energy ? kForceUnit_pN * s.energy->coupling_kcal_mol_A2 * glm::length(s.contact.displacement_A) : 0.0};
    const bool anew = k < at_ || (k == 0 && s.contact.touching());
    for (std::size_t beyond = k + (anew ? 0 : 1); beyond < kPullPoints; ++beyond) {
      curves_.felt[beyond] = kNothing;
      between_pN_[beyond] = 0.0;
    }
    double& here = curves_.felt[k];
    here = std::isfinite(here) ? std::max(here, now.hand_N) : now.hand_N;
    between_pN_[k] = std::max(between_pN_[k], now.atoms_pN);
    at_ = k;
    if (!draws_) curves_.max_N = std::max(1.0, 1.1 * greatest_N());
  }

  double greatest_N() const {
    double out = 0.0;
    for (const double f : curves_.felt)
      if (std::isfinite(f)) out = std::max(out, f);
    return out;
  }
  double greatest_pN() const { return *std::max_element(between_pN_.begin(), between_pN_.end()); }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    if (!place_ || !view.body) return {};
    const PoseSpace space(view.spheres, *view.body);
    const auto start = freePoseAt(*place_, siteOf(spec_), space);
    if (!start) return {};
    const Vec3 from = place_->goal().place.A;
    const double far_A = curves_.x_max_A + kBeyond_A;
    const std::vector<PoseA> way =
        freePath(space, *start,
                 {.reached = [&](const PoseA& p) { return glm::distance(p.place.A, from) >= far_A; },
                  .reach_A = std::max(far_A + 3.0, searchReach_A(view.spheres, *view.body)),
                  .seed = std::uint64_t(view.attempt) + 1});
    if (way.empty()) return {};
    HandPlan plan;
    if (curves_.drawing)
      plan.push_back({.answer = TaskAnswer{.curve = std::vector<double>(kPullPoints, 0.25 * curves_.max_N)}});
    plan.push_back({.to = start->place, .turned_to = start->orientation, .placed = true, .wait_s = 0.5});
    for (std::size_t k = 1; k < way.size(); ++k)
      plan.push_back({.to = way[k].place, .speed_A_per_s = 4.0, .turned_to = way[k].orientation});
    plan.back().wait_s = 0.5;
    return plan;
  }

  std::string_view noPlan() const override { return N_("no free path was found on which the body gets out"); }

  std::string guidance() const override {
    const std::string held = called_.empty() ? std::string(tr("what you hold")) : called_;
    if (curves_.drawing) return trf("First draw the force that you expect while you pull {0} out of its place.", held);
    if (!begun_) return trf("Lead {0} into its place first.", held);
    if (off_A_ < 0.1 * curves_.x_max_A) return trf("Pull {0} out of its place, without letting go.", held);
    return trf("Pull on: {0} of {1}.", lengthText(off_A_), lengthText(curves_.x_max_A));
  }

  std::string afterwards() const override {
    const std::string hand = forceText(greatest_N());
    return greatest_pN() > 0.0 ? trf("The greatest force on the way was {0} in the hand, {1} between the atoms.", hand,
                                     quantityIn(greatest_pN(), "pN", decimals(0)))
                               : trf("The greatest force on the way was {0} in the hand.", hand);
  }

  static std::string lengthText(double length_A) { return quantityText(length_A, Dimension::Length, decimals(1)); }

  void measure(std::vector<TaskFigure>& out) const override {
    out.push_back({N_("greatest force of the pull"), greatest_N(), "N"});
    if (greatest_pN() > 0.0) out.push_back({N_("greatest force between the atoms"), greatest_pN(), "pN"});
    if (curves_.agreement) out.push_back({N_("agreement"), 100.0 * *curves_.agreement, "%"});
  }

  TaskSpec spec_;
  std::string called_;
  bool draws_ = false;  // the student first draws what they expect
  std::optional<PoseGoal> place_;
  HeldWay way_;
  TaskCurves curves_;
  bool begun_ = false;  // it was in its place, and came from there without a jump
  double off_A_ = 0.0;
  std::array<double, kPullPoints> between_pN_{};  // the greatest force between the atoms, at the points of the curve
  std::size_t at_ = 0;                            // the point of the last sample
  int presentation_ = 1;
};

void checkPull(const TaskSpec& spec, std::vector<Problem>& problems) {
  const Value &from = spec.values["from"], &pull = spec.values["pull"], &within = spec.values["within"];
  if (from.text != "file")
    if (const auto pose = parsePose(from.text); !pose)
      problems.push_back(problemAt({from.place.line, from.place.column + pose.problem().column - 1},
                                   pose.problem().message, trf("{0}; or write 'from: file'", pose.problem().remedy)));
  if (spec.values["most"].place.line && spec.values["draw"].text != "yes")
    problems.push_back(problemAt(spec.values["most"].place, tr("no curve is drawn here, so its axis has no end"),
                                 tr("add a line 'draw: yes', or take this line out")));
  if (pull.number < 2.0 * within.number)
    problems.push_back(problemAt((within.place.line ? within : pull).place,
                                 tr("the body would be out nearly where it begins"),
                                 tr("make the distance of 'pull' at least twice 'within'")));
}

void checkPullScene(const TaskSpec& spec, const SceneSpec& scene, std::vector<Problem>& problems) {
  if (!scene.in_hand.given())
    problems.push_back(problemAt(spec.place, tr("'pull' needs a body in the hand"),
                                 tr("write 'in-hand: …' with its atoms in this step's scene")));
  else if (!forceChoice(scene.touch.forces).any())
    problems.push_back(problemAt(spec.place, tr("nothing holds the body: no forces between atoms act in this scene"),
                                 tr("write 'forces: all' in this step's scene")));
}

// Whether a path leads out is found out by 'check --play'.
void checkPullBody(const TaskSpec& spec, const std::shared_ptr<const HeldBody>& body,
                   std::span<const StructureChoice> structures, std::vector<Problem>& problems) {
  const PoseGoal place(body, writtenGoal(spec.values["from"].text, *body));
  for (const StructureChoice& s : structures)
    if (freePoseAt(place, siteOf(spec), PoseSpace(*s.spheres, *body))) return;
  problems.push_back(problemAt((spec.values["from"].place.line ? spec.values["from"] : spec.values["pull"]).place,
                               tr("the body overlaps other atoms in its place, so no hand can hold it there"),
                               tr("choose another pose, or a greater 'within'")));
}

}  // namespace

TaskKind pullKind() {
  return {
      .name = "pull",
      .meaning = "Pull what the hand holds out of its place, without a jump. The force on the way is kept as a curve.",
      .time = {.base_s = 60.0},
      .keys = {{.name = "pull",
                .type = ValueType::Quantity,
                .meaning = "The distance that the centre of the body must reach from its place.",
                .required = true,
                .dimension = Dimension::Length,
                .min = 1.0,
                .max = 1000.0},
               {.name = "from",
                .type = ValueType::Text,
                .meaning = "The place: `file`, that of the molecule's file; or a pose as for `dock`. A mouse's hand "
                           "begins there; a stylus leads the body there first.",
                .fallback = "file"},
               {.name = "within",
                .type = ValueType::Quantity,
                .meaning = "Within this distance of its place (root mean square over the atoms) the body is in it, and "
                           "a pull begins.",
                .fallback = "1.5 Å",
                .dimension = Dimension::Length,
                .min = 0.1,
                .max = 20.0},
               {.name = "draw",
                .type = ValueType::Word,
                .meaning = "Whether the student first draws the curve of the force that they expect on the way out. It "
                           "is then shown beside the felt one; any curve counts.",
                .fallback = "no",
                .words = {"yes", "no"}},
               {.name = "most",
                .type = ValueType::Quantity,
                .meaning = "For `draw: yes`: the upper end of the force axis.",
                .fallback = "3.3 N",
                .dimension = Dimension::Force,
                .min = 0.1,
                .max = 20.0}},
      .make = [](const TaskSpec& s, const Molecule&) -> std::unique_ptr<Task> { return std::make_unique<Pull>(s); },
      .check = &checkPull,
      .check_scene = &checkPullScene,
      .of_body = "its centre leaves its place, however it is turned.",
      .check_body = &checkPullBody};
}

}  // namespace moltact
