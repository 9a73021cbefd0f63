// dock: bring what the hand holds to a pose, from outside and without a jump, and keep it there. Who puts it down in the
// pose, passes through it or turns it wrongly has not docked it. The hand begins in an orientation drawn at random,
// which the view's reset restores.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/pose_search.h"
#include "engine/lesson/pose_text.h"
#include "engine/lesson/tasks/held_way.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

constexpr double kLeastTurn_rad = std::numbers::pi / 3.0;  // of the drawn orientation off the goal's
constexpr int kNear = 4000;                                // poses near the goal that are tried
constexpr double kPart = 0.6;  // of what is allowed, at most, off the goal when demonstrated

/// The goal that `spec` names for this body.
PoseA goalOf(const TaskSpec& spec, const HeldBody& body) {
  const auto written = parsePose(spec.values["dock"].text);
  return written ? PoseA{written->place, written->orientation.value_or(kNoRotation)} : PoseA{body.middle, kNoRotation};
}

struct Tolerance {
  explicit Tolerance(const TaskSpec& spec)
      : within_A(spec.values["within"].number), turned_rad(glm::radians(spec.values["turned"].number)) {}
  double within_A, turned_rad;

  bool allows(const PoseGoal& goal, const PoseA& pose, double part = 1.0) const {
    return goal.rmsd_A(pose) <= part * within_A && goal.turned_rad(pose) <= part * turned_rad;
  }
};

/// The goal, or else a pose well within the tolerance in which the body overlaps nothing.
std::optional<PoseA> freePoseAt(const PoseGoal& goal, const Tolerance& tolerance, const PoseSpace& space) {
  if (space.isFree(goal.goal())) return goal.goal();
  std::uint64_t random = 1;
  for (int k = 0; k < kNear; ++k) {
    const double size = kPart * tolerance.within_A * (k + 1) / kNear;
    const auto any = [&] { return Vec3(nextFraction(random), nextFraction(random), nextFraction(random)) * 2.0 - 1.0; };
    PoseA pose = goal.goal();
    pose.place.A += any() * size;
    const Vec3 turn = any() * (size / space.gyration_A());
    pose.orientation = glm::normalize(glm::angleAxis(glm::length(turn), glm::normalize(turn)) * pose.orientation);
    if (tolerance.allows(goal, pose, kPart) && space.isFree(pose)) return pose;
  }
  return std::nullopt;
}

class Dock : public Task {
 public:
  explicit Dock(const TaskSpec& spec)
      : Task(spec),
        spec_(spec),
        called_(spec.values["called"].text),
        tolerance_(spec),
        away_A_(spec.values["away"].number),
        for_s_(spec.values["for"].number),
        turns_(spec.values["turn"].text == "random") {}

  void takeInHand(std::shared_ptr<const HeldBody> body) override {
    const PoseA goal = goalOf(spec_, *body);
    goal_.emplace(std::move(body), goal);
    draw();
  }

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
    ++presentation_;
    draw();
  }

 private:
  enum class State { Away, PutDown, There };

  void draw() {
    if (!turns_ || !goal_) return;
    do turned_ = randomOrientation(state_);
    while (goal_->turned_rad({goal_->goal().place, turned_}) < kLeastTurn_rad);
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
    led_ = (led_ && continues) || off_A >= away_A_;
    if (led_ && (nearest_A_ < 0.0 || off_A < nearest_A_)) nearest_A_ = off_A;
    const bool there = s.contact.fault == Fault::None && tolerance_.allows(*goal_, way_.pose()) &&
                       !goal_->stretched(s, tolerance_.within_A);
    state_now_ = !there ? State::Away : led_ ? State::There : State::PutDown;
    stopped_ = s.contact.touching();
    watch_.tick(state_now_ == State::There, dt_s, kSlip_s);
    setProgress(watch_.elapsed_s() / for_s_);
    if (watch_.elapsed_s() >= for_s_) finish();
  }

  HandPlan demonstrate(const HandPlanInput& view) const override {
    if (!goal_ || !view.body) return {};
    std::vector<StructureChoice> choices = view.structures;
    choices.insert(choices.begin(), {-1.0, &view.spheres});
    for (const StructureChoice& choice : choices) {
      const PoseSpace space(*choice.spheres, *view.body);
      const auto end = freePoseAt(*goal_, tolerance_, space);
      if (!end) continue;
      std::vector<PoseA> way = freePath(
          space, *end, {.reach_A = reach(*choice.spheres, *view.body), .seed = std::uint64_t(view.attempt) + 1});
      if (way.empty()) continue;
      std::reverse(way.begin(), way.end());
      return planAlong(way, choice.share);
    }
    return {};
  }

  static double reach(const SphereGrid& spheres, const HeldBody& body) {
    constexpr double kMost_A = 40.0;
    return std::min(kMost_A, 0.5 * glm::distance(spheres.low_A(), spheres.high_A()) + body.reach_A);
  }

  HandPlan planAlong(const std::vector<PoseA>& way, double share) const {
    constexpr double kOutside_A_per_s = 30.0, kInside_A_per_s = 5.0;
    HandPlan plan{{.to = way.front().place, .placed = true, .wait_s = 0.3}};
    if (share >= 0.0) plan.push_back({.share = share});
    plan.push_back({.turned_to = way.front().orientation});
    for (std::size_t k = 1; k < way.size(); ++k)
      plan.push_back({.to = way[k].place,
                      .speed_A_per_s = k == 1 ? kOutside_A_per_s : kInside_A_per_s,
                      .turned_to = way[k].orientation});
    plan.back().wait_s = for_s_ + 0.5;
    return plan;
  }

  std::string guidance() const override {
    const std::string held = called_.empty() ? std::string(tr("what you hold")) : called_;
    switch (state_now_) {
      case State::There:
        return trf("Hold it there: {0} of {1}.", timeText(watch_.elapsed_s()), timeText(for_s_));
      case State::PutDown:
        return tr("It was put down there. Draw it out, then lead it in.");
      case State::Away:
        break;
    }
    if (stopped_) return tr("Something stops it. Draw it back a little, turn it, and try again.");
    return trf("Lead {0} to its place, turned the right way.", held);
  }

  std::string_view noPlan() const override { return N_("no free path was found on which the body gets there"); }

  void measure(std::vector<TaskFigure>& out) const override {
    if (nearest_A_ >= 0.0) out.push_back({N_("nearest"), nearest_A_, "Å"});
  }

  TaskSpec spec_;
  std::string called_;
  Tolerance tolerance_;
  double away_A_ = 5.0, for_s_ = 1.0;
  bool turns_ = true;
  std::optional<PoseGoal> goal_;
  HeldWay way_;
  Stopwatch watch_;
  State state_now_ = State::Away;
  bool led_ = false;      // from far enough away, without a jump since
  bool stopped_ = false;  // it touches something
  double nearest_A_ = -1.0;
  std::uint64_t state_ = 0;  // of the random row
  Quat turned_ = kNoRotation;
  int presentation_ = 1;
};

void checkDock(const TaskSpec& spec, std::vector<Problem>& problems) {
  const Value &dock = spec.values["dock"], &within = spec.values["within"], &away = spec.values["away"];
  if (dock.text != "file")
    if (const auto pose = parsePose(dock.text); !pose)
      problems.push_back(problemAt({dock.place.line, dock.place.column + pose.problem().column - 1},
                                   pose.problem().message, trf("{0}; or write 'dock: file'", pose.problem().remedy)));
  if (away.number < 2.0 * within.number)
    problems.push_back(problemAt((away.place.line ? away : within).place,
                                 tr("the body would begin nearly where it is to be docked"),
                                 tr("make 'away' at least twice 'within'")));
}

void checkDockScene(const TaskSpec& spec, const SceneSpec& scene, std::vector<Problem>& problems) {
  if (!scene.in_hand.given())
    problems.push_back(problemAt(spec.place, tr("'dock' needs a body in the hand"),
                                 tr("write 'in-hand: …' with its atoms in this step's scene")));
}

// Whether a path leads there is found out by 'check --play'.
void checkDockBody(const TaskSpec& spec, const std::shared_ptr<const HeldBody>& body,
                   std::span<const StructureChoice> structures, std::vector<Problem>& problems) {
  const PoseGoal goal(body, goalOf(spec, *body));
  for (const StructureChoice& s : structures)
    if (freePoseAt(goal, Tolerance(spec), PoseSpace(*s.spheres, *body))) return;
  problems.push_back(problemAt(spec.values["dock"].place,
                               tr("the body overlaps other atoms there, and no hand can bring it so far"),
                               tr("choose another pose, or a greater 'within'")));
}

}  // namespace

TaskKind dockKind() {
  return {.name = "dock",
          .meaning = "Bring what the hand holds to a pose, from outside and without a jump, and keep it there.",
          .time = {.base_s = 150.0},
          .keys = {{.name = "dock",
                    .type = ValueType::Text,
                    .meaning = "The pose: `file`, that of the molecule's file; or X, Y, Z, QW, QX, QY, QZ, the place "
                               "of the body's middle in angstroms and a quaternion relative to the file.",
                    .required = true},
                   {.name = "within",
                    .type = ValueType::Quantity,
                    .meaning = "How far the body's atoms may be off their places in the pose (root mean square).",
                    .fallback = "1 Å",
                    .dimension = Dimension::Length,
                    .min = 0.1,
                    .max = 20.0},
                   {.name = "turned",
                    .type = ValueType::Quantity,
                    .meaning = "How far the body may be turned off the pose, in degrees.",
                    .fallback = "20",
                    .min = 1.0,
                    .max = 180.0},
                   {.name = "for",
                    .type = ValueType::Quantity,
                    .meaning = "How long it must stay there; slips under 0.3 s are forgiven.",
                    .fallback = "1 s",
                    .dimension = Dimension::Time,
                    .min = 0.1,
                    .max = 600.0},
                   {.name = "away",
                    .type = ValueType::Quantity,
                    .meaning = "So far off the pose the body must have been since the hand was last put down.",
                    .fallback = "5 Å",
                    .dimension = Dimension::Length,
                    .min = 0.5,
                    .max = 1000.0},
                   {.name = "turn",
                    .type = ValueType::Word,
                    .meaning = "Whether a mouse's hand begins turned at random, by 60° or more off the pose, another "
                               "way for each student; a stylus begins as it is held.",
                    .fallback = "random",
                    .words = {"random", "none"}}},
          .make = [](const TaskSpec& s, const Molecule&) -> std::unique_ptr<Task> { return std::make_unique<Dock>(s); },
          .check = &checkDock,
          .check_scene = &checkDockScene,
          .of_body = "its place and orientation relative to the molecule count, however the view is turned.",
          .check_body = &checkDockBody};
}

}  // namespace moltact
