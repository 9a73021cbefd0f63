// What a learning platform receives about an attempt: place, progress, score, objectives and interactions. SCORM 1.2,
// SCORM 2004 and cmi5 (docs/learning-platforms.md) report the same record. A pure computation; any thread but the haptic
// one. Units: second of use, UTC.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/results/attempt_file.h"

namespace moltact {

/// One of the lesson's goals. A task counts once it is solved, a marked question if its first answer was right;
/// predictions and free answers have no score.
struct LearningObjective {
  std::string id;    ///< "goal_1"
  std::string text;  ///< the goal
  std::size_t done = 0, of = 0;
  std::optional<double> score;  ///< 0 to 1; no value if nothing that serves the goal is scored
};

/// An answer, or the end of a task.
struct LearningInteraction {
  enum class Kind { Task, Choice, Typed };
  std::string id;  ///< interactionId()
  std::string text;
  Kind kind = Kind::Choice;
  AnswerKind judged = AnswerKind::Marked;
  bool right = false;
  int attempt = 1;                        ///< from 1
  std::vector<std::string> choices = {};  ///< texts of all choices
  std::vector<std::size_t> chosen = {}, right_choices = {};
  std::string written = {};
  std::vector<std::string> misconceptions = {};  ///< tags of the choices taken
  std::vector<std::size_t> goals = {};           ///< from 0
  double at_s = 0.0;                             ///< of use, since the attempt began
  std::string at_utc = {};
  double latency_s = 0.0;  ///< of a task since it began; of an answer since the step was entered, or the answer before
};

struct LearningRecord {
  std::string began;  ///< UTC
  double at_s = 0.0;  ///< time of use at the end
  std::string step;   ///< id of the student's step; empty before the first
  std::string place;  ///< "two", with a task under way "two/task 1"
  std::size_t done = 0, of = 0;
  std::optional<double> score;  ///< 0 to 1: see LearningObjective; no value if the lesson scores nothing
  std::vector<LearningObjective> objectives;
  std::vector<LearningInteraction> interactions;  ///< in order of time

  bool complete() const { return of > 0 && done >= of; }
};

/// The record of an attempt, or of its beginning. Steps that an answer skipped do not count for the score unless the
/// student entered them.
LearningRecord learningRecord(const Attempt& attempt);

/// "task_STEP_1" or "question_STEP_QUESTION", in printable ASCII without blanks: a byte other than a–z, 0–9 and - is
/// written as a dot and two hexadecimal digits. At most kMaxInteractionId characters; the end of a longer one is a hash.
std::string interactionId(std::string_view step, std::size_t task);
std::string interactionId(std::string_view step, std::string_view question);
inline constexpr std::size_t kMaxInteractionId = 250;

/// The same as JSON for app/web/platform.js, with the interactions from the index `from` on. ASCII without line ends.
std::string learningRecordJson(const LearningRecord& record, std::string_view suspended, std::size_t from = 0);

}  // namespace moltact
