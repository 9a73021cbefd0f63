// A touch task in progress: a state machine that receives servo samples and reports the student's progress.
// Deterministic: the same samples give the same states. Window's thread. Samples may come at any rate from 30 Hz; at 1
// kHz no event is missed. Once done, a task stays done.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/haptics/guide/guide.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/language/units.h"
#include "engine/lesson/hand_plan.h"
#include "engine/lesson/lesson.h"
#include "engine/lesson/tasks/task_answer.h"
#include "engine/lesson/touch_sample.h"
#include "engine/molecule/molecule.h"

namespace moltact {

class SceneForces;

/// Samples farther apart than this leave the time between them undetermined; that time is not counted (unit: second).
inline constexpr double kLongestGap_s = 0.25;

/// Minimum duration of a touch that counts (unit: second): too short to notice, long enough to exclude a graze.
inline constexpr double kTouch_s = 0.1;

/// A slip shorter than this does not interrupt a touch, because hands tremble (unit: second).
inline constexpr double kSlip_s = 0.3;

/// A quantity that a task has measured. Name and unit outlive the task: "mean force", "N".
struct TaskFigure {
  std::string_view name;
  double value = 0.0;
  std::string_view unit;  ///< "s", "N", "Å", "%"; empty for a count
};

/// An answer that the student can give now, as a button.
struct TaskButton {
  std::string_view word;   ///< for TaskAnswer
  std::string_view label;  ///< shown on the button
  char key = '\n';         ///< the shortcut: a capital letter, or '\n' for Enter
};

/// The changes of the scene that a task requests while it is in progress. Members without a value leave the scene
/// unchanged.
struct TaskStage {
  bool dark = false;         ///< the molecule is not drawn: the way is found by touch alone
  bool unnamed = false;      ///< the question is what is touched, so nothing names its atoms or says how many block the
                             ///< probe
  bool force_meter = false;  ///< in the dark the force is shown
  TouchChange touch = {};    ///< changes of the touch settings
  std::vector<std::uint32_t> removed = {};  ///< atoms that are not felt, besides those of the scene; ascending
  std::optional<PointA> facing = {};        ///< a place to be turned to the front, in the middle of the view
  std::optional<PointA> close_to = {};      ///< a place that the view comes close to, once no hand presses
  std::optional<Quat> turned = {};          ///< the orientation of the view: the screen's axes in the molecule's
  std::optional<Quat> body_turned = {};     ///< a hand that has no orientation of its own (mouse, keys, fingers) begins
                                            ///< with it, also after the view was reset: of what it holds, relative to
                                            ///< the molecule's file
  std::optional<PointA> body_begins =
      {};  ///< such a hand begins there and waits for the press: the middle of what it holds
  std::vector<std::uint32_t> in_hand =
      {};                ///< atoms that the hand holds instead of the scene's, of which the scene draws
                         ///< and feels none; ascending; empty: those of the scene
  int presentation = 0;  ///< another number, or another turn, begins a new presentation: the hand lets go and starts
                         ///< outside again, so that nothing but the touch shows whether something has changed

  friend bool operator==(const TaskStage&, const TaskStage&) = default;
};

/// A number that the student sets with a slider.
struct TaskSlider {
  std::string_view name;  ///< "probe radius"
  double value = 0.0, min = 0.0, max = 1.0, step = 0.1;
  Dimension dimension = Dimension::Length;  ///< of all values, in the unit of the code
};

/// The results of a series of trials: how many there are and, of those judged so far, whether each was right.
struct TaskTrials {
  std::size_t of = 0;
  std::vector<bool> right;
};

/// A force curve that the student first draws and then feels. Both are sampled at equal distances from 0 to `x_max_A`,
/// including both ends; NaN where nothing has been drawn or felt.
struct TaskCurves {
  std::string_view x_name;          ///< "depth"
  double x_max_A = 1.0;             ///< unit: angstrom
  double max_N = 1.0;               ///< the upper end of the force axis
  bool drawing = true;              ///< the student is still drawing; what is felt does not count yet
  std::vector<double> drawn, felt;  ///< unit: newton; of the same length
  std::optional<double> agreement;  ///< share of common area, 0 to 1, once both are known
  bool complete = false;            ///< of a task without a drawn curve: what was felt is final
};

/// The guide that leads the hand in a try of a task (engine/haptics/guide/guide.h).
struct TaskGuide {
  std::shared_ptr<const GuidePath> path;  ///< never null or empty
  GuideKind kind = GuideKind::Tube;
  double radius_A = 1.0;           ///< of the tube
  double strength = 1.0;           ///< share of the full stiffness and force, above 0
  PointA ghost = {};               ///< where the probe is to go next
  bool ghost_with_device = false;  ///< the ghost is drawn also where a device guides the hand

  /// The guide as felt at this scale of the workspace.
  Guide felt(double A_per_mm) const {
    return {path, kind, radius_A, strength * kGuideStiffness_N_per_mm / A_per_mm, strength * kGuideMax_N};
  }
  /// Whether both are felt alike; the ghost may differ.
  bool feelsLike(const TaskGuide& other) const {
    return path == other.path && kind == other.kind && radius_A == other.radius_A && strength == other.strength;
  }
};

class Task {
 public:
  virtual ~Task() = default;

  /// Processes one tick. Ignores samples whose time does not advance, samples with a non-finite time, force,
  /// displacement or contact point, and all samples after the task is done.
  void feed(const TouchSample& sample);

  /// Seeds the task's random draws; call it before the task begins. The same seed gives the same draws.
  virtual void drawBy(std::uint64_t seed) { (void)seed; }

  /// Whether it is solved or its tries are used up.
  bool done() const { return done_; }
  bool solved() const { return done_ && !given_up_; }
  /// 0 to 1; 1 exactly when done.
  double progress() const { return done_ ? 1.0 : progress_; }
  /// One sentence for the student: the present state and what to do next. After success it includes the author's
  /// praise; when the tries are used up, the answer.
  std::string sentence() const;

  /// The answers that the student can give now, in the order of display; none once done.
  std::vector<TaskButton> buttons() const { return done_ ? std::vector<TaskButton>() : currentButtons(); }
  /// Takes an answer of the student. Words that are not offered and curves that are not requested are ignored.
  void answer(const TaskAnswer& answer);
  /// Null for a task without a curve to draw.
  virtual const TaskCurves* curves() const { return nullptr; }
  /// Empty for a task without a number to set, and once done.
  std::optional<TaskSlider> slider() const { return done_ ? std::nullopt : currentSlider(); }
  /// Atoms that show the answer once the tries are used up, ascending; empty if atoms cannot show it.
  virtual std::vector<std::uint32_t> answerAtoms() const { return {}; }
  /// Atoms at examples of the requested kind of place, for a student who has searched for long; empty before that.
  virtual std::vector<std::uint32_t> exampleAtoms() const { return {}; }
  /// Whether the task follows the path of the hand and includes the part since the surface was met, before its turn
  /// came.
  virtual bool takesUpSlide() const { return false; }
  /// The trials of a task that consists of several, as far as they may be revealed; otherwise `of` is 0.
  virtual TaskTrials trials() const { return {}; }
  /// Whether it waits for a larger force than the hand exerts now.
  bool wantsHarderPush() const { return !done_ && tooLight(); }
  /// The changes of the scene that it requests; none once done.
  TaskStage stage() const { return done_ ? TaskStage() : requestedStage(); }

  /// The quantities measured from the start until now or until done. These are time, time in contact, mean and largest
  /// force in contact, and path length of the contact point on the surface. Those of the kind of task follow.
  std::vector<TaskFigure> figures() const;
  /// Only the quantities of the kind of task.
  std::vector<TaskFigure> ownFigures() const {
    std::vector<TaskFigure> out;
    measure(out);
    return out;
  }

  /// The guide of the present try; none once done and in tries without one.
  virtual std::optional<TaskGuide> guide() const { return std::nullopt; }

  /// The plan by which a scripted hand carries the task out from its present state; empty if a probe from outside
  /// reaches no suitable place. It is requested again if the plan was followed and the task is not done.
  virtual HandPlan demonstrate(const HandPlanInput& view) const = 0;
  /// Why there is no plan, as a part of a sentence in English.
  virtual std::string_view noPlan() const { return N_("no place for it is open to the probe from outside"); }

  /// Returns to the initial state.
  virtual void reset();

  /// Sets the atoms that the scene excludes from touch (scene_atoms.h); called once, before the first tick.
  virtual void leaveOut(std::span<const std::uint32_t> /*untouchable*/) {}
  /// The lesson's file and the scene's molecule, for a file beside the lesson that the task names. Called once, before the
  /// first tick, after leaveOut().
  virtual void takeLesson(const std::filesystem::path& /*lesson_file*/, const Molecule& /*molecule*/) {}
  /// What the scene gives the hand to hold, in its pose of the molecule's file; never null. Called once, before the
  /// first tick; not called if the hand holds the probe.
  virtual void takeInHand(std::shared_ptr<const HeldBody> /*body*/) {}
  /// The forces between atoms of the scene. Called after takeInHand(); not called if the scene has none.
  virtual void takeForces(std::shared_ptr<const SceneForces> /*forces*/) {}

 protected:
  explicit Task(const TaskSpec& spec)
      : praise_(spec.values["praise"]), tries_(static_cast<int>(spec.values["attempts"].number)) {}

  /// Called with each valid sample; `dt_s` is the time since the previous one, 0 for the first and after a gap.
  virtual void onSample(const TouchSample& sample, double dt_s) = 0;
  /// The sentence while the task is in progress.
  virtual std::string guidance() const = 0;
  /// The sentence before the author's praise once it is done; may be empty.
  virtual std::string afterwards() const { return {}; }
  /// Called with a valid answer while the task is in progress: its word is offered, or its curve is finite and has the
  /// right length.
  virtual void onAnswer(const TaskAnswer&) {}
  virtual bool tooLight() const { return false; }
  virtual std::vector<TaskButton> currentButtons() const { return {}; }
  virtual TaskStage requestedStage() const { return {}; }
  virtual std::optional<TaskSlider> currentSlider() const { return std::nullopt; }
  /// Adds the quantities of the kind of task.
  virtual void measure(std::vector<TaskFigure>&) const {}

  /// The answer in a sentence, for a student whose tries are used up.
  virtual std::string solution() const { return {}; }

  /// Whether the hand holds a body, according to the last sample.
  bool holdsBody() const { return body_; }

  void setProgress(double progress);
  void finish() { done_ = true; }
  /// Counts a wrong try. Returns true if it was the last one allowed by the author; the task is then done but not
  /// solved.
  bool missedLast();

 private:
  friend class GuidedTask;  // which runs another task several times
  void measureTouch(const TouchSample& sample, double dt_s);

  AuthorsText praise_;
  double progress_ = 0.0, last_time_s_ = 0.0;
  double time_s_ = 0.0, contact_s_ = 0.0, felt_s_ = 0.0, impulse_Ns_ = 0.0, greatest_N_ = 0.0, path_A_ = 0.0;
  std::optional<Vec3> last_scp_A_;
  bool done_ = false, given_up_ = false, started_ = false, inside_ = false, body_ = false;
  int tries_ = 0, missed_ = 0;  // allowed tries (0: unlimited), and wrong ones so far
};

/// The key `attempts` of kinds whose tries can be wrong; `meaning` says what a try is.
KeySpec attemptsKey(std::string_view meaning);
/// The keys `dark` (yes) and `meter` (on) of kinds that are done by touch alone.
KeySpec darkKey();
KeySpec meterKey();

/// The atoms that a task is about.
class AtomSet {
 public:
  /// An absent selection selects every atom.
  AtomSet(const Selection& selection, const Molecule& molecule);
  bool has(std::int32_t atom) const {
    return all_ ? atom >= 0
                : atom >= 0 && static_cast<std::size_t>(atom) < in_.size() && in_[static_cast<std::size_t>(atom)];
  }
  /// Whether at least one of them is in the contact's active set.
  bool touchedBy(const Contact& contact) const;
  /// Whether the contact's active set contains only these atoms.
  bool holds(const Contact& contact) const;
  std::size_t count() const { return count_; }
  /// Their indices, ascending.
  std::vector<std::uint32_t> atoms() const;

 private:
  std::vector<char> in_;
  std::size_t count_ = 0;
  bool all_ = false;
};

/// The space at the surface of some atoms, for tasks in scenes with forces between atoms: these may hold a probe off the
/// surface. Whether the probe is there depends neither on a contact nor on a force, so it reveals neither.
class AtSurface {
 public:
  static constexpr double kNear_A = 2.0;
  /// An absent selection selects every atom.
  AtSurface(const Selection& selection, const Molecule& molecule);
  /// Whether the probe's surface is within kNear_A of that of one of the atoms.
  bool near(const Vec3& probe, double probe_A) const;
  /// The same, for a hand that does not hover.
  bool has(const TouchSample& s) const { return !s.hovering && near(s.contact.scp.A, s.probe_A); }

 private:
  SphereGrid atoms_;
};

/// Measures how long a condition has lasted; short slips do not interrupt it.
class Stopwatch {
 public:
  /// Adds a tick; a break longer than `slip_s` restarts the count. Returns true if that has just happened.
  bool tick(bool lasting, double dt_s, double slip_s);
  double elapsed_s() const { return elapsed_s_; }
  void restart() { elapsed_s_ = away_s_ = 0.0; }

 private:
  double elapsed_s_ = 0.0, away_s_ = 0.0;
};

/// An uninterrupted slide of the contact point over the surface. A slip shorter than kSlip_s does not interrupt it if
/// the surface is met again within kHop_A; a hand that comes down elsewhere begins another slide.
class Slide {
 public:
  static constexpr double kHop_A = 0.5;
  /// Processes one tick. Returns true if another slide began with it.
  bool tick(const Contact& contact, double dt_s);
  double pathLength_A() const { return path_A_; }  ///< path length so far in this slide
  void restart() { *this = Slide(); }

 private:
  std::optional<Vec3> last_A_;
  double path_A_ = 0.0, away_s_ = 0.0;
};

/// A point on a path of atoms: one atom, or the sphere around the atoms of one part of the key. Unit: angstrom.
struct PathPlace {
  Vec3 centre_A{0.0};
  double reach_A = 0.0;  ///< distance from the centre to the surface of the farthest atom
  std::vector<std::uint32_t> atoms;
};

/// The points of a path. A single part gives one point per atom, in the order of the file; several parts give one each.
std::vector<PathPlace> pathPlaces(const std::vector<Selection>& path, const Molecule& molecule);

/// The name of a task's target inside a sentence, in the language in use at the time of the call. It is the author's,
/// or one made from the selection or the kind of place.
class TargetName {
 public:
  /// `called`: the key by which the author may name it.
  TargetName(const TaskSpec& spec, std::string_view key, std::string_view called = "called");
  explicit TargetName(Selection selection) : selection_(std::move(selection)) {}
  /// The atoms of one residue are named after it: "Ile 50 (chain A)".
  TargetName(Selection selection, const Molecule& molecule);
  std::string text() const;

 private:
  std::string called_, word_;
  Selection selection_;
};

/// The words for "sphere" ("the round face of one atom"), "crease" ("a crease between two atoms") and "pit" ("a pit
/// between three atoms"); otherwise "the surface".
const char* placeName(std::string_view word);

/// Whether a target is a kind of place: "sphere", "crease" or "pit". False for atoms and for "anywhere".
bool isKindOfPlace(const Value& target);

/// Places at which a hand can touch these atoms or, if `feature` names a kind ("sphere", "crease", "pit"), a place of
/// that kind formed by these atoms.
std::vector<SurfacePlace> placesToTouch(const HandPlanInput& view, const AtomSet& atoms, std::string_view feature = {});

/// Whether the feature has this name: "sphere" is Feature::Sphere, "crease" Feature::Circle, "pit" Feature::Point.
bool isFeature(std::string_view word, Feature feature);

/// A kind of place formed by certain atoms. In the middle of a ring of equal atoms, it depends on chance whether two or
/// three of them block the probe. There it counts as a pit as soon as three atoms are within kAlike_A.
class PlaceKind {
 public:
  static constexpr double kAlike_A = 0.1;
  PlaceKind(std::string_view word, const AtomSet& atoms, const Molecule& molecule);
  /// Whether the contact is at such a place and its active set contains only these atoms.
  bool at(const Contact& contact, const AtomSet& atoms, double probe_A) const;

 private:
  std::string word_;
  std::vector<Sphere> spheres_;  // of the atoms; empty if there are many
};

/// "0.35 N", "1.2 s" and, for a share from 0 to 1, "83 %".
std::string forceText(double force_N);
std::string timeText(double time_s);
std::string percentText(double share);

}  // namespace moltact
