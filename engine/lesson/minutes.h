// How long a lesson takes a student, worked out from its text, its tasks and its questions by one table. Pure functions;
// any thread but the haptic one. Units: minute, second.
#pragma once

#include <span>
#include <string_view>

#include "engine/lesson/lesson.h"

namespace moltact {

inline constexpr double kWordsAMinute = 130.0;
inline constexpr double kQuestion_s = 35.0;     ///< to think and to choose, beside the reading
inline constexpr double kFreeAnswer_s = 150.0;  ///< to write two or three sentences
inline constexpr double kMaxCoreMinutes = 20.0;
/// The share by which an author's minutes may differ from those worked out.
inline constexpr double kMinutesOff = 0.2;

/// What a kind of task takes: `base_s`, and `each_s` for each of what the key `each` counts or lists.
struct TaskTime {
  std::string_view kind;
  double base_s = 0.0, each_s = 0.0;
  std::string_view each = {};       ///< empty: nothing is counted
  std::string_view each_what = {};  ///< in an author's words: "pair"
};
/// One row for each kind of task, in the order of taskKinds().
std::span<const TaskTime> taskTimes();

/// Seconds for one task, with the time for which it asks the hand to stay.
double taskTime_s(const TaskSpec& task);

struct LessonMinutes {
  double core = 0.0, all = 0.0;
};
/// Of the steps of the core, and of all steps. Hints, teacher's notes and the glossary do not count.
LessonMinutes minutesOf(const Lesson& lesson);

/// In whole minutes, as a card shows them: of the core what the author states, else what is worked out; at least 1.
struct ShownMinutes {
  int core = 1, all = 1;
};
ShownMinutes shownMinutes(const Lesson& lesson);

}  // namespace moltact
