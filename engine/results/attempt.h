// An attempt: one student's work on one lesson, as its file stores it, in order. Plain data, any thread but the haptic
// one. attempt_lines.h converts it to and from lines; docs/results.md describes the format. Units: angstrom, newton,
// second of use. `t_s` counts time of use since the attempt began, without time when the program was closed.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/core/content_hash.h"
#include "engine/core/units.h"
#include "engine/haptics/contact.h"
#include "engine/haptics/touch_setup.h"
#include "engine/lesson/lesson.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

/// The input that moved the probe or gave an answer.
enum class InputKind : std::uint8_t { Device, Mouse, Keyboard };
/// "device", "mouse" or "keyboard".
std::string_view nameOf(InputKind input);
/// The same in the language in use.
std::string shownName(InputKind input);

/// The kinds of answers: right or wrong (Marked), expectations before the touch (Prediction), or unassessed (Free).
/// Only the first kind is scored.
enum class AnswerKind : std::uint8_t { Marked, Prediction, Free };

struct QuestionOutline {
  std::string id, text;              ///< plain text
  std::vector<std::string> choices;  ///< plain text; empty if the answer is typed
  std::vector<std::size_t> right;    ///< indices of the right choices
  AnswerKind kind = AnswerKind::Marked;
  std::vector<std::string> tags = {};   ///< the misconception that each choice indicates; empty if none has one
  std::vector<std::size_t> goals = {};  ///< indices of the lesson's goals, from 0
};

struct TaskOutline {
  std::string kind, say;
  std::vector<std::size_t> goals = {};  ///< indices of the lesson's goals, from 0
  std::string asked = {};               ///< "before" or "after" for a task that is asked twice; otherwise empty
};

struct StepOutline {
  std::string id, title;
  std::vector<TaskOutline> tasks;
  std::vector<QuestionOutline> questions;
  bool aside = false;  ///< outside the core: asides and extra steps
};

/// The structure of a lesson, so that an attempt can be read without the lesson's file.
struct LessonOutline {
  std::string file;  ///< file name without folders: "first-touch.md"
  std::string title;
  std::string hash;  ///< of the file's bytes, from contentHash()
  std::vector<StepOutline> steps;
  std::vector<std::string> goals = {};
  bool test = false;  ///< the last answer to a question counts, not the first
  Condition condition = Condition::Touch;
  StudyPart study = {};

  /// The number of tasks and questions in all steps of the core.
  std::size_t parts() const;
};

LessonOutline outlineOf(const Lesson& lesson, std::string hash);

/// "2026-11-21T10:58:14Z".
std::string utcText(std::chrono::system_clock::time_point when);

/// The newest version of the format. A reader accepts every version and ignores unknown parts of a newer one.
inline constexpr int kAttemptFormat = 1;

struct AttemptHeader {
  int format = kAttemptFormat;
  std::string program;  ///< version of the program
  std::string began;    ///< "2026-11-21T10:58:14Z"
  std::string student;  ///< a name or code; empty if none was given
  std::string device;   ///< name of the device at the start
  bool gives_force = false;
  LessonOutline lesson;
};

/// The seed for the order of a question's choices (LessonSession::setOrderSeed). It differs between students and
/// attempts, and stays the same when an attempt is resumed. Never 0.
std::uint64_t orderSeed(const AttemptHeader& header);

/// A measured value of a solved task, "peak force 1.32 N".
struct LoggedFigure {
  std::string name;
  double value = 0.0;
  std::string unit;
};

struct StepEntered {
  std::string step;  ///< id
};
struct Answered {
  std::string step, question;       ///< ids
  int attempt = 1;                  ///< 1 for the first answer to this question
  std::vector<std::size_t> chosen;  ///< indices of choices
  std::string written;              ///< the text of a typed answer
  bool right = false;
  InputKind by = InputKind::Mouse;
};
struct HintOpened {
  std::string step;
};
struct TaskBegun {
  std::string step;
  std::size_t task = 0;  ///< index in the step
};
struct TaskDone {
  std::string step;
  std::size_t task = 0;
  double took_s = 0.0;  ///< since the task began
  InputKind by = InputKind::Mouse;
  std::vector<LoggedFigure> figures;
  bool solved = true;  ///< false: its tries were used up
};
/// A force curve of a task in which the student draws a curve before feeling it: the drawn one or the felt one. Values
/// at equal distances from 0 to `to_A` inclusive; NaN where nothing was felt.
struct CurveKept {
  std::string step;
  std::size_t task = 0;
  bool felt = false;               ///< false: drawn
  std::string axis;                ///< "depth" or "way"
  double to_A = 1.0, max_N = 1.0;  ///< the ends of the axes
  std::vector<double> force_N;
};
/// A contact begins. Gaps shorter than kTouchGap_s do not end it.
struct TouchBegan {
  std::vector<std::int32_t> atoms;
};
struct TouchEnded {
  double from_s = 0.0;
  std::vector<std::int32_t>
      atoms;                  ///< every atom that held the probe, in the order of first contact; at most kMaxTouched
  std::size_t crossings = 0;  ///< how often the set of contacting atoms changed to another one
  double peak_N = 0.0, mean_N = 0.0;
  double path_A = 0.0;  ///< length of the SCP's path
  InputKind by = InputKind::Mouse;
};
/// Figures of a touch in progress, which remain if the program is killed. A later TouchEnded with the same `from_s`
/// replaces it.
struct TouchSoFar {
  double from_s = 0.0;
  std::size_t crossings = 0;
  double peak_N = 0.0, mean_N = 0.0, path_A = 0.0;
  InputKind by = InputKind::Mouse;
};
inline constexpr double kTouchGap_s = 0.1;
inline constexpr std::size_t kMaxTouched = 256;

struct InputChanged {
  InputKind by = InputKind::Mouse;
  std::string device;
  bool gives_force = false;
  friend bool operator==(const InputChanged&, const InputChanged&) = default;
};
/// The part of the scene that a playback needs.
struct StageChanged {
  std::string molecule;  ///< id
  std::string file;      ///< file name without folders
  std::size_t atoms = 0;
  Workspace workspace{};
  TouchSetup touch{};
  ReadOptions reading{};              ///< how the file was read
  std::vector<std::uint32_t> held{};  ///< atoms held as a rigid body, ascending; empty: the hand has a probe
  friend bool operator==(const StageChanged&, const StageChanged&) = default;
};
/// The camera (engine/render/camera.h).
struct ViewChanged {
  std::array<double, 4> orientation{1, 0, 0, 0};  ///< quaternion: w, x, y, z
  Vec3 target_A{0.0};
  double distance_A = 50.0;
};
/// The position of the scene's atoms in the terms of whatever moved them (app/ui/extensions/atom_mover.h), which restores
/// the atoms from it. The meaning of `detail` and `position` is that of the mover.
struct AtomsMoved {
  std::string by;         ///< AtomMover::kind(): "states"
  std::string file;       ///< from which the mover takes the coordinates, without folders; empty: none
  std::string detail;     ///< how it takes them, such as a selection; may be empty
  double position = 0.0;  ///< in the mover's own parameter: a fraction, a frame, a time
  /// What computed the motion, with its version, step and seed; empty: a file, or as in the line before.
  std::string engine = {};
  friend bool operator==(const AtomsMoved&, const AtomsMoved&) = default;
};
/// The mover between the two structures of a scene: `file` is the second structure's, and `detail` the selection by
/// which it is superposed on the first (empty: the default atoms). `position` is the fraction of the path (0: first
/// structure, 1: second).
inline constexpr std::string_view kMovedByStates = "states";
/// The additional data of a HipSample with a held body.
struct HeldSample {
  Quat orientation = kNoRotation;  ///< of the hand, in the molecule's axes
  PoseA body;                      ///< pose of the drawn body: the place of its centre and its orientation
};
struct HipSample {
  double t_s = 0.0;
  PointA hip, scp;
  ForceN force;              ///< in the device's space
  Vec3 displacement_A{0.0};  ///< of the spring that was felt; zero without contact
  Feature feature = Feature::Free;
  std::array<std::int32_t, 3> atoms{-1, -1, -1};
  std::optional<HeldSample> held = std::nullopt;  ///< empty: the hand has a probe
  /// Where a field acts, the force of contact and field before limits, in the molecule's axes; empty: the force has the
  /// direction of the displacement.
  std::optional<Vec3> wanted_N = std::nullopt;

  /// The pose of a body that is drawn at the hand because none was recorded.
  PoseA bodyAtHand(const Quat& orientation) const { return {feature == Feature::Free ? hip : scp, orientation}; }
};
/// The HIP's path for up to kHipChunk_s, either completely with a body or completely without one. The hand was at rest
/// during a gap between two samples.
struct HipChunk {
  std::vector<HipSample> samples;
};
struct LessonReread {
  LessonOutline lesson;
};
/// An answer has changed the order of the steps.
struct OrderChanged {
  std::string step, question;      ///< ids
  std::string rule;                ///< the author's text: "after 2 wrong"
  bool skips = false;              ///< false: goes to `steps`
  std::vector<std::string> steps;  ///< ids
};
/// The attempt was resumed after the program had been closed.
struct Resumed {
  std::string at;  ///< UTC
  std::string program, device;
  bool gives_force = false;
};
struct ProgressMade {
  std::string step;              ///< the student's step
  std::size_t done = 0, of = 0;  ///< tasks and questions; if the lesson has none, steps seen
};
/// A prediction written while waiting for a turn at the device.
struct Predicted {
  std::string student;
  std::string step;  ///< the step of the class
  std::string question, text;
};
/// The program or the lesson was closed, or the turn ended.
struct SessionClosed {
  std::string at;  ///< UTC
};

/// The lesson is open. Written if no other event has given the time for kHeartbeat_s.
struct Heartbeat {};
/// The end of a killed program's attempt is known with this accuracy (unit: second of use).
inline constexpr double kHeartbeat_s = 0.9;

using AttemptFact =
    std::variant<StepEntered, Answered, HintOpened, TaskBegun, TaskDone, CurveKept, TouchBegan, TouchEnded,
                 InputChanged, StageChanged, ViewChanged, HipChunk, LessonReread, Resumed, ProgressMade, Predicted,
                 SessionClosed, TouchSoFar, Heartbeat, AtomsMoved, OrderChanged>;

struct AttemptEvent {
  double t_s = 0.0;
  AttemptFact what;
};

}  // namespace moltact
