// dock: bring what the hand holds to a pose, from outside and without a jump, and keep it there. Where forces between
// atoms act, also until its energy is low enough, or to any pose of an energy that low. Who puts it down there, passes
// through it or turns it wrongly has not docked it. The hand begins in an orientation drawn at random, which the view's
// reset restores.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/pose_search.h"
#include "engine/lesson/pose_text.h"
#include "engine/lesson/scene_forces.h"
#include "engine/lesson/tasks/held_way.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

constexpr double kMinTurn_rad = std::numbers::pi / 3.0;  // of the drawn orientation off the goal's
constexpr int kFalls = 24;  // into wells that are tried: near the goal, or from anywhere on the surface
// Farther out than this the field is too weak to have drawn the body in (share of the limit of energy).
constexpr double kOutside = 0.1;
constexpr double kBesideWell_A = 0.4;  // how far a free pose beside a well's may be off it
constexpr std::string_view kAnywhere = "anywhere";

bool hasGoal(const TaskSpec& spec) { return spec.values["dock"].text != kAnywhere; }

std::optional<double> limitOf(const TaskSpec& spec) {
  return spec.values.has("energy") ? std::optional(spec.values["energy"].number) : std::nullopt;
}

PoseTolerance toleranceOf(const TaskSpec& spec) {
  return {spec.values["within"].number, glm::radians(spec.values["turned"].number)};
}

/// The poses of low energy that `spec` allows, the lowest first: found by falls from the goal and from beside it, or from
/// anywhere.
std::vector<Well> wellsFor(const TaskSpec& spec, const SceneForces& forces) {
  if (!hasGoal(spec)) return forces.wells(kFalls);
  return wellsBeside(PoseGoal(forces.body(), writtenGoal(spec.values["dock"].text, *forces.body())), toleranceOf(spec),
                     forces, kFalls);
}

class Dock : public Task {
 public:
  explicit Dock(const TaskSpec& spec)
      : Task(spec),
        spec_(spec),
        limit_kcal_mol_(limitOf(spec)),
        called_(spec.values["called"].text),
        tolerance_(toleranceOf(spec)),
        away_A_(spec.values["away"].number),
        for_s_(spec.values["for"].number),
        turns_(spec.values["turn"].text == "random") {}

  void takeInHand(std::shared_ptr<const HeldBody> body) override {
    const PoseA goal = writtenGoal(spec_.values["dock"].text, *body);
    goal_.emplace(std::move(body), goal);
    draw();
  }

  void takeForces(std::shared_ptr<const SceneForces> forces) override { forces_ = std::move(forces); }

  void drawBy(std::uint64_t seed) override {
    state_ = seed;
    draw();
  }

  void reset() override {
    Task::reset();
    way_.restart();
    watch_.restart();
    state_now_ = State::Away;
    led_ = stopped_ = false;
    nearest_A_ = -1.0;
    energy_kcal_mol_.reset();
    lowest_kcal_mol_.reset();
    ++presentation_;
    draw();
  }

 private:
  enum class State { Away, PutDown, Shallow, There };

  void draw() {
    if (!turns_ || !goal_) return;
    do turned_ = randomOrientation(state_);
    while (hasGoal(spec_) && goal_->turned_rad({goal_->goal().place, turned_}) < kMinTurn_rad);
  }

  TaskStage requestedStage() const override {
    TaskStage stage{.presentation = presentation_};
    if (turns_ && goal_) stage.body_turned = turned_;
    return stage;
  }

  void onSample(const TouchSample& s, double dt_s) override {
    const bool continues = way_.tick(s, dt_s);
    if (!goal_ || !s.body) return;
    const double off_A = goal_->rmsd_A(way_.pose());
    const std::optional<double> energy = energyOf(s);
    const bool outside =
        hasGoal(spec_) ? off_A >= away_A_ : energy && std::abs(*energy) <= kOutside * -*limit_kcal_mol_;
    led_ = (led_ && continues) || outside;
    if (led_ && (nearest_A_ < 0.0 || off_A < nearest_A_)) nearest_A_ = off_A;
    if (led_ && energy && (!lowest_kcal_mol_ || *energy < *lowest_kcal_mol_)) lowest_kcal_mol_ = energy;
    energy_kcal_mol_ = energy;
    const bool low = !limit_kcal_mol_ || (energy && *energy <= *limit_kcal_mol_);
    const bool there = s.contact.fault == Fault::None && !goal_->stretched(s, tolerance_.within_A) &&
                       (hasGoal(spec_) ? tolerance_.allows(*goal_, way_.pose()) : low);
    state_now_ = !there ? State::Away : !led_ ? State::PutDown : low ? State::There : State::Shallow;
    stopped_ = s.contact.touching();
    watch_.tick(state_now_ == State::There, dt_s, kSlip_s);
    setProgress(watch_.elapsed_s() / for_s_);
    if (watch_.elapsed_s() >= for_s_) finish();
  }

  // Of a body that rests: where its springs are stretched its atoms are elsewhere, and so is their energy.
  static std::optional<double> energyOf(const TouchSample& s) {
    if (!s.energy || s.contact.fault != Fault::None) return std::nullopt;
    const double energy = s.energy->total_kcal_mol();
    return std::isfinite(energy) ? std::optional(energy) : std::nullopt;
  }

  // Into the wells in turn, and out of each by a free path, the other way round.
  HandPlan demonstrateEnergy(const HandPlanInput& view) const {
    if (!forces_) return {};
    const PoseSpace space(view.spheres, *view.body);
    std::vector<Well> wells = wellsFor(spec_, *forces_);
    std::erase_if(wells, [&](const Well& w) { return w.energy.total_kcal_mol() > *limit_kcal_mol_; });
    for (std::size_t k = 0; k < wells.size(); ++k) {
      const Well& well = wells[(k + std::size_t(view.attempt)) % wells.size()];
      const PoseGoal goal(forces_->body(), well.pose);
      const auto end = freePoseAt(goal, PoseTolerance{kBesideWell_A, kBesideWell_A}, space);
      if (!end) continue;
      std::vector<PoseA> way = freePath(
          space, *end, {.reach_A = searchReach_A(view.spheres, *view.body), .seed = std::uint64_t(view.attempt) + 1});
      if (way.empty()) continue;
      std::reverse(way.begin(), way.end());
      return planAlong(way, -1.0, for_s_ + 0.5);
    }
    return {};
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    if (!goal_ || !view.body) return {};
    if (limit_kcal_mol_) return demonstrateEnergy(view);
    std::vector<StructureChoice> choices = view.structures;
    choices.insert(choices.begin(), {-1.0, &view.spheres});
    for (const StructureChoice& choice : choices) {
      const PoseSpace space(*choice.spheres, *view.body);
      const auto end = freePoseAt(*goal_, tolerance_, space);
      if (!end) continue;
      std::vector<PoseA> way =
          freePath(space, *end,
                   {.reach_A = searchReach_A(*choice.spheres, *view.body), .seed = std::uint64_t(view.attempt) + 1});
      if (way.empty()) continue;
      std::reverse(way.begin(), way.end());
      return planAlong(way, choice.share, for_s_ + 0.5);
    }
    return {};
  }

  std::string guidance() const override {
    const std::string held = called_.empty() ? std::string(tr("what you hold")) : called_;
    switch (state_now_) {
      case State::There:
        return trf("Hold it there: {0} of {1}.", timeText(watch_.elapsed_s()), timeText(for_s_));
      case State::PutDown:
        return tr("It was put down there. Draw it out, then lead it in.");
      case State::Shallow:
        return tr("It is in its place, but not deep enough in the well. Give way, and let the forces draw it in.");
      case State::Away:
        break;
    }
    if (stopped_) return tr("Something stops it. Draw it back a little, turn it, and try again.");
    return hasGoal(spec_) ? trf("Lead {0} to its place, turned the right way.", held)
                          : trf("Lead {0} to where the forces hold it most firmly, and give way to them.", held);
  }

  std::string_view noPlan() const override { return N_("no free path was found on which the body gets there"); }

  void measure(std::vector<TaskFigure>& out) const override {
    if (hasGoal(spec_) && nearest_A_ >= 0.0) out.push_back({N_("nearest"), nearest_A_, "Å"});
    if (lowest_kcal_mol_) out.push_back({N_("lowest energy"), *lowest_kcal_mol_, "kcal/mol"});
    if (done() && energy_kcal_mol_) out.push_back({N_("energy"), *energy_kcal_mol_, "kcal/mol"});
  }

  TaskSpec spec_;
  std::optional<double> limit_kcal_mol_;
  std::shared_ptr<const SceneForces> forces_;
  std::string called_;
  PoseTolerance tolerance_;
  double away_A_ = 5.0, for_s_ = 1.0;
  bool turns_ = true;
  std::optional<PoseGoal> goal_;
  HeldWay way_;
  Stopwatch watch_;
  State state_now_ = State::Away;
  bool led_ = false;      // from far enough away, without a jump since
  bool stopped_ = false;  // it touches something
  double nearest_A_ = -1.0;
  std::optional<double> energy_kcal_mol_, lowest_kcal_mol_;  // of the last sample; while it was led
  std::uint64_t state_ = 0;                                  // of the random row
  Quat turned_ = kNoRotation;
  int presentation_ = 1;
};

void checkDock(const TaskSpec& spec, std::vector<Problem>& problems) {
  const Value &dock = spec.values["dock"], &within = spec.values["within"], &away = spec.values["away"];
  if (!hasGoal(spec)) {
    if (!spec.values.has("energy"))
      problems.push_back(problemAt(dock.place, tr("without a pose the energy must say where the body is docked"),
                                   tr("add a line 'energy: …' with a number in kcal/mol, as '-20'")));
    for (const std::string_view key : {"within", "turned", "away"})
      if (const Value& value = spec.values[key]; value.place.line)
        problems.push_back(problemAt(value.place, trf("'{0}' belongs to a pose, and 'dock: anywhere' has none", key),
                                     tr("take this line out")));
    return;
  }
  if (dock.text != "file")
    if (const auto pose = parsePose(dock.text); !pose)
      problems.push_back(problemAt({dock.place.line, dock.place.column + pose.problem().column - 1},
                                   pose.problem().message,
                                   trf("{0}; or write 'dock: file' or 'dock: anywhere'", pose.problem().remedy)));
  if (away.number < 2.0 * within.number)
    problems.push_back(problemAt((away.place.line ? away : within).place,
                                 tr("the body would begin nearly where it is to be docked"),
                                 tr("make 'away' at least twice 'within'")));
}

void checkDockScene(const TaskSpec& spec, const SceneSpec& scene, std::vector<Problem>& problems) {
  if (!scene.in_hand.given())
    problems.push_back(problemAt(spec.place, tr("'dock' needs a body in the hand"),
                                 tr("write 'in-hand: …' with its atoms in this step's scene")));
  else if (spec.values.has("energy") && !forceChoice(scene.touch.forces).any())
    problems.push_back(problemAt(spec.values["energy"].place,
                                 tr("no forces between atoms act in this scene, so the body has no energy"),
                                 tr("write 'forces: all' in this step's scene, or take this line out")));
}

// Whether a path leads there is found out by 'check --play'.
void checkDockBody(const TaskSpec& spec, const std::shared_ptr<const HeldBody>& body,
                   std::span<const StructureChoice> structures, std::vector<Problem>& problems) {
  if (!hasGoal(spec)) return;
  const PoseGoal goal(body, writtenGoal(spec.values["dock"].text, *body));
  for (const StructureChoice& s : structures)
    if (freePoseAt(goal, toleranceOf(spec), PoseSpace(*s.spheres, *body))) return;
  problems.push_back(problemAt(spec.values["dock"].place,
                               tr("the body overlaps other atoms there, and no hand can bring it so far"),
                               tr("choose another pose, or a greater 'within'")));
}

// Falls find wells and cannot prove that no deeper one exists; the limit must be one that they reach.
void checkDockEnergy(const TaskSpec& spec, const SceneForces& forces, std::vector<Problem>& problems) {
  const std::optional<double> limit = limitOf(spec);
  if (!limit || !forces.body()) return;
  const std::vector<Well> wells = wellsFor(spec, forces);
  if (!wells.empty() && wells.front().energy.total_kcal_mol() <= *limit) return;
  const Place place = spec.values["energy"].place;
  const std::string wanted = energyText(*limit);
  if (wells.empty()) {
    problems.push_back(problemAt(
        place,
        trf("no pose was found in which the body is free and the forces reach it; 'energy' asks for {0}", wanted),
        tr("choose another pose, or a greater 'within'")));
    return;
  }
  const double lowest = wells.front().energy.total_kcal_mol();
  problems.push_back(
      problemAt(place,
                trf("the lowest energy found in {0} searches is {1}, and 'energy' asks for {2}", wells.size(),
                    energyText(lowest), wanted),
                trf("write 'energy: {0}' or a higher number; a deeper well may exist, but no search found it",
                    numberText(std::ceil(lowest), decimals(0)))));
}

}  // namespace

TaskKind dockKind() {
  return {
      .name = "dock",
      .meaning =
          "Bring what the hand holds to a pose, from outside and without a jump, and keep it there. Where "
          "forces between atoms act, also to a low energy.",
      .time = {.base_s = 150.0},
      .keys = {{.name = "dock",
                .type = ValueType::Text,
                .meaning = "The pose: `file`, that of the molecule's file; or X, Y, Z, QW, QX, QY, QZ, the position "
                           "of the body's centre in angstroms and a quaternion relative to the file. Or `anywhere`, "
                           "with `energy`: any pose with an energy that low.",
                .required = true},
               {.name = "energy",
                .type = ValueType::Quantity,
                .meaning = "For a scene with `forces`: the body's energy must be this or less, in kcal/mol. `check` "
                           "searches for a pose with such an energy by falls into wells.",
                .min = -1e4,
                .max = -0.1},
               {.name = "within",
                .type = ValueType::Quantity,
                .meaning = "The largest permitted distance of the body's atoms from their positions in the pose (root "
                           "mean square).",
                .fallback = "1 Å",
                .dimension = Dimension::Length,
                .min = 0.1,
                .max = 20.0},
               {.name = "turned",
                .type = ValueType::Quantity,
                .meaning = "The largest permitted rotation from the pose, in degrees.",
                .fallback = "20",
                .min = 1.0,
                .max = 180.0},
               {.name = "for",
                .type = ValueType::Quantity,
                .meaning = "How long it must stay there; interruptions shorter than 0.3 s are ignored.",
                .fallback = "1 s",
                .dimension = Dimension::Time,
                .min = 0.1,
                .max = 600.0},
               {.name = "away",
                .type = ValueType::Quantity,
                .meaning = "The minimum distance that the body must have had from the pose since the hand last entered "
                           "the scene or jumped.",
                .fallback = "5 Å",
                .dimension = Dimension::Length,
                .min = 0.5,
                .max = 1000.0},
               {.name = "turn",
                .type = ValueType::Word,
                .meaning = "With a mouse, `random` starts the body rotated at random by at least 60° from the pose, "
                           "differently for each student; `none` does not rotate it. With a stylus, the body starts "
                           "in the orientation of the stylus.",
                .fallback = "random",
                .words = {"random", "none"}}},
      .make = [](const TaskSpec& s, const Molecule&) -> std::unique_ptr<Task> { return std::make_unique<Dock>(s); },
      .check = &checkDock,
      .check_scene = &checkDockScene,
      .of_body = "its place and orientation relative to the molecule count, however the view is turned.",
      .check_body = &checkDockBody,
      .check_forces = &checkDockEnergy};
}

}  // namespace moltact
