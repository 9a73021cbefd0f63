// A touch task under way: a small state machine that is fed with servo samples and says how far the student has come.
// Deterministic: the same samples give the same states. Used on the screen's thread; samples may come at any rate from
// 30 Hz up (at 1 kHz nothing is missed). Once done, a task stays done.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/language/units.h"
#include "engine/lesson/hand_plan.h"
#include "engine/lesson/lesson.h"
#include "engine/lesson/tasks/task_answer.h"
#include "engine/lesson/touch_sample.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// Samples farther apart than this (unit: second) say nothing about the time between them, so that time is not counted.
inline constexpr double kLongestGap_s = 0.25;

/// How long a touch must last to count (unit: second): too short to notice, long enough that a graze does not count.
inline constexpr double kTouch_s = 0.1;

/// A slip shorter than this (unit: second) does not interrupt a touch: hands tremble.
inline constexpr double kSlip_s = 0.3;

/// Something that a task has measured. Name and unit outlive the task: "mean force", "N".
struct TaskFigure {
  std::string_view name;
  double value = 0.0;
  std::string_view unit;  ///< "s", "N", "Å", "%"; empty for a count
};

/// An answer that the student can give the task now.
struct TaskButton {
  std::string_view word;   ///< for TaskAnswer
  std::string_view label;  ///< as the button says it
  char key = '\n';         ///< that presses it: a capital letter, or '\n' for Enter
};

/// The changes of the scene that a task asks for while it is under way. Values that are not given stay as the lesson's
/// scene has them.
struct TaskStage {
  bool dark = false;         ///< the molecule is not drawn: the way is found by touch alone
  bool unnamed = false;      ///< what is touched is the question: nothing says its atoms or how many hold the probe
  bool force_meter = false;  ///< in the dark the force is shown
  TouchChange touch = {};    ///< felt with something else
  std::vector<std::uint32_t> removed = {};  ///< atoms that are not felt, besides those of the scene; ascending
  std::optional<PointA> facing = {};        ///< a place to be turned to the front, in the middle of the view
  std::optional<PointA> close_to = {};      ///< a place that the view comes close to, once no hand presses
  std::optional<Quat> turned = {};          ///< the molecule is seen turned so: the screen's axes in its own
  std::optional<Quat> body_turned = {};     ///< a hand that has no orientation of its own (mouse, keys, fingers) begins
                                            ///< with it, also after the view was reset: of what it holds, relative to
                                            ///< the molecule's file
  int presentation = 0;  ///< another number, or another turn, begins a new presentation: the hand lets go and starts
                         ///< outside again, so that nothing but the touch shows whether something has changed

  friend bool operator==(const TaskStage&, const TaskStage&) = default;
};

/// A number that the student sets.
struct TaskSlider {
  std::string_view name;  ///< "probe radius"
  double value = 0.0, least = 0.0, most = 1.0, step = 0.1;
  Dimension dimension = Dimension::Length;  ///< they are in its code's unit
};

/// How far several like trials have come: how many there are, and of those judged so far whether each was right.
struct TaskTrials {
  std::size_t of = 0;
  std::vector<bool> right;
};

/// A force curve that the student draws first and feels then. Both are values at even distances from 0 to `x_most`,
/// both ends included; NaN where nothing has been drawn or felt.
struct TaskCurves {
  std::string_view x_name;          ///< "depth"
  double x_most = 1.0;              ///< unit: angstrom
  double most_N = 1.0;              ///< the upper end of the force axis
  bool drawing = true;              ///< the student still draws; what is felt does not count yet
  std::vector<double> drawn, felt;  ///< unit: newton; of the same length
  std::optional<double> agreement;  ///< once both are known: 0 to 1
};

class Task {
 public:
  virtual ~Task() = default;

  /// One tick. Samples whose time does not advance, or with a time, force, displacement or contact point that is not
  /// finite, are passed over, as is everything after the task is done.
  void feed(const TouchSample& sample);

  /// What the task draws at random follows from this; to be called before it is begun. The same number draws the same.
  virtual void drawBy(std::uint64_t seed) { (void)seed; }

  /// Solved, or its tries are used up.
  bool done() const { return done_; }
  bool solved() const { return done_ && !given_up_; }
  /// 0 to 1; 1 exactly when done.
  double progress() const { return done_ ? 1.0 : progress_; }
  /// One sentence for the student: what is going on and what to do next. The author's praise when solved, the answer
  /// when the tries are used up.
  std::string sentence() const;

  /// The answers that the student can give now, in the order in which they are shown; none once done.
  std::vector<TaskButton> buttons() const { return done_ ? std::vector<TaskButton>() : currentButtons(); }
  /// Takes an answer of the student. Words that are not offered and curves that are not asked for are passed over.
  void answer(const TaskAnswer& answer);
  /// Null for a task without a curve to draw.
  virtual const TaskCurves* curves() const { return nullptr; }
  /// Nothing for a task without a number to set, and once done.
  std::optional<TaskSlider> slider() const { return done_ ? std::nullopt : currentSlider(); }
  /// Atoms that show the answer once the tries are used up, ascending; empty where atoms cannot.
  virtual std::vector<std::uint32_t> answerAtoms() const { return {}; }
  /// Atoms that show places of the kind that is asked for, to a student who has tried for long; empty before that.
  virtual std::vector<std::uint32_t> exampleAtoms() const { return {}; }
  /// It looks at the way of the hand, and takes up the part that was gone before its turn came, since the surface was met.
  virtual bool takesUpSlide() const { return false; }
  /// Of a task of several trials, as far as it may be told; else `of` is 0.
  virtual TaskTrials trials() const { return {}; }
  /// It waits for a harder push than the hand gives now.
  bool wantsHarderPush() const { return !done_ && tooLight(); }
  /// The changes of the scene that it asks for; none once done.
  TaskStage stage() const { return done_ ? TaskStage() : requestedStage(); }

  /// The figures measured from the start until now or until done: time, time in contact, mean and greatest force in
  /// contact, the way of the contact point over the surface; then those of the kind itself.
  std::vector<TaskFigure> figures() const;
  /// Those of the kind itself alone.
  std::vector<TaskFigure> ownFigures() const {
    std::vector<TaskFigure> out;
    measure(out);
    return out;
  }

  /// The plan by which a hand carries it out from here; empty where no place for it is open to a probe from outside. It
  /// is asked for again when the plan has been followed and the task is not done.
  virtual HandPlan demonstrate(const HandPlanInput& view) const = 0;
  /// Why there is no plan, as a part of a sentence in English.
  virtual std::string_view noPlan() const { return N_("no place for it is open to the probe from outside"); }

  /// Forgets everything, as at the start.
  virtual void reset();

  /// Atoms of the molecule that the scene takes from the hand (scene_atoms.h), told once, before the first tick.
  virtual void leaveOut(std::span<const std::uint32_t> /*untouchable*/) {}
  /// What the scene gives the hand to hold, in its pose of the molecule's file; never null. Told like the above, and
  /// not at all where the hand holds the probe.
  virtual void takeInHand(std::shared_ptr<const HeldBody> /*body*/) {}

 protected:
  explicit Task(const TaskSpec& spec)
      : praise_(spec.values["praise"]), tries_(static_cast<int>(spec.values["attempts"].number)) {}

  /// One good tick; `dt_s` is the time since the last one, 0 for the first and after a gap.
  virtual void onSample(const TouchSample& sample, double dt_s) = 0;
  /// The sentence while the task is under way.
  virtual std::string guidance() const = 0;
  /// The text before the author's praise once it is done; may be empty.
  virtual std::string afterwards() const { return {}; }
  /// A good answer while the task is under way: its word is offered, or its curve is of the right length and finite.
  virtual void onAnswer(const TaskAnswer&) {}
  virtual bool tooLight() const { return false; }
  virtual std::vector<TaskButton> currentButtons() const { return {}; }
  virtual TaskStage requestedStage() const { return {}; }
  virtual std::optional<TaskSlider> currentSlider() const { return std::nullopt; }
  /// The kind's own figures.
  virtual void measure(std::vector<TaskFigure>&) const {}

  /// The answer in a sentence, for who has used up the tries.
  virtual std::string solution() const { return {}; }

  /// The hand holds a body, as far as the last sample says.
  bool holdsBody() const { return body_; }

  void setProgress(double progress);
  void finish() { done_ = true; }
  /// A try was wrong. True where the author gives no more: the task is done then, and not solved.
  bool missedLast();

 private:
  void measureTouch(const TouchSample& sample, double dt_s);

  AuthorsText praise_;
  double progress_ = 0.0, last_time_s_ = 0.0;
  double time_s_ = 0.0, contact_s_ = 0.0, felt_s_ = 0.0, impulse_Ns_ = 0.0, greatest_N_ = 0.0, way_A_ = 0.0;
  std::optional<Vec3> last_scp_A_;
  bool done_ = false, given_up_ = false, started_ = false, inside_ = false, body_ = false;
  int tries_ = 0, missed_ = 0;  // how many there are (0: as many as need be); wrong ones so far
};

/// The key of kinds whose tries can be wrong; `meaning` says what a try is.
KeySpec attemptsKey(std::string_view meaning);

/// The atoms that a task is about.
class AtomSet {
 public:
  /// An absent selection stands for every atom.
  AtomSet(const Selection& selection, const Molecule& molecule);
  bool has(std::int32_t atom) const {
    return all_ ? atom >= 0
                : atom >= 0 && static_cast<std::size_t>(atom) < in_.size() && in_[static_cast<std::size_t>(atom)];
  }
  /// Whether the contact rests on at least one of them.
  bool touchedBy(const Contact& contact) const;
  /// Whether every atom that holds the contact is one of them.
  bool holds(const Contact& contact) const;
  std::size_t count() const { return count_; }
  /// Their indices, ascending.
  std::vector<std::uint32_t> atoms() const;

 private:
  std::vector<char> in_;
  std::size_t count_ = 0;
  bool all_ = false;
};

/// Counts how long something has lasted, forgiving short slips.
class Stopwatch {
 public:
  /// Adds a tick; a break longer than `slip_s` starts the count again. Gives true when that happened now.
  bool tick(bool lasting, double dt_s, double slip_s);
  double elapsed_s() const { return elapsed_s_; }
  void restart() { elapsed_s_ = away_s_ = 0.0; }

 private:
  double elapsed_s_ = 0.0, away_s_ = 0.0;
};

/// A stretch of the surface that the contact point goes over without a break. A slip shorter than kSlip_s is none, if
/// the surface is met again within kHop_A of where it was left: a hand that is put down elsewhere begins another.
class Slide {
 public:
  static constexpr double kHop_A = 0.5;
  /// One tick. Gives true where another stretch began with it.
  bool tick(const Contact& contact, double dt_s);
  double way_A() const { return way_A_; }  ///< so far in this stretch
  void restart() { *this = Slide(); }

 private:
  std::optional<Vec3> last_A_;
  double way_A_ = 0.0, away_s_ = 0.0;
};

/// A place on a path of atoms: one atom, or the sphere round the atoms of one part. Units: angstrom.
struct PathPlace {
  Vec3 centre_A{0.0};
  double reach_A = 0.0;  ///< from the centre to the surface of the atom, or of the farthest atom
  std::vector<std::uint32_t> atoms;
};

/// The places of a path: one part stands for its atoms in the order of the file, each of several parts for one place.
std::vector<PathPlace> pathPlaces(const std::vector<Selection>& path, const Molecule& molecule);

/// The name of a task's target in the middle of a sentence: as the author called it, or made from the selection or the
/// kind of place in a key, in the language in use when it is asked for.
class TargetName {
 public:
  /// `called`: the key with which the author may name it.
  TargetName(const TaskSpec& spec, std::string_view key, std::string_view called = "called");
  explicit TargetName(Selection selection) : selection_(std::move(selection)) {}
  /// Atoms of one residue are called by it: "Ile 50 (chain A)".
  TargetName(Selection selection, const Molecule& molecule);
  std::string text() const;

 private:
  std::string called_, word_;
  Selection selection_;
};

/// "the round face of one atom" of "sphere", "a crease between two atoms", "a pit between three atoms"; else "the
/// surface".
const char* placeName(std::string_view word);

/// A target is a kind of place: "sphere", "crease" or "pit". False for atoms and for "anywhere".
bool isKindOfPlace(const Value& target);

/// Places that a hand can take to touch these atoms, or a kind of place where `feature` names one ("sphere", "crease",
/// "pit") that these atoms make.
std::vector<SurfacePlace> placesToTouch(const HandPlanInput& view, const AtomSet& atoms, std::string_view feature = {});

/// "sphere" -> a single atom's sphere, "crease" -> a circle, "pit" -> a point.
bool isFeature(std::string_view word, Feature feature);

/// The kind of place that a task asks for by a word, made by some atoms. In the middle of a ring of like atoms the
/// contact point rests on two or three of them by chance; there a pit counts as soon as three are as near as kAlike_A.
class PlaceKind {
 public:
  static constexpr double kAlike_A = 0.1;
  PlaceKind(std::string_view word, const AtomSet& atoms, const Molecule& molecule);
  /// Whether the contact is at such a place and these atoms alone hold it.
  bool at(const Contact& contact, const AtomSet& atoms, double probe_A) const;

 private:
  std::string word_;
  std::vector<Sphere> spheres_;  // of the atoms, where they are few
};

/// "0.35 N", "1.2 s" and, of a share from 0 to 1, "83 %".
std::string forceText(double force_N);
std::string timeText(double time_s);
std::string percentText(double share);

}  // namespace moltact
