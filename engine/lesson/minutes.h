// Estimates the duration of a lesson from its text, questions and tasks (TaskKind::time). Pure functions; any thread but
// the haptic one. Units: minute, second.
#pragma once

#include "engine/lesson/lesson.h"

namespace moltact {

inline constexpr double kWordsAMinute = 130.0;
inline constexpr double kQuestion_s = 35.0;     ///< to think and to choose, in addition to reading
inline constexpr double kFreeAnswer_s = 150.0;  ///< to write two or three sentences
inline constexpr double kGuidedTry = 0.25;      ///< a try with a guide takes this share of the time of its task
inline constexpr double kMaxCoreMinutes = 20.0;
/// The relative difference that is accepted between an author's minutes and the estimate.
inline constexpr double kMinutesOff = 0.2;

/// The duration of one task, including the time that the hand must stay.
double taskTime_s(const TaskSpec& task);

/// The minutes of one step: reading, tasks and questions.
double minutesOf(const Step& step);

struct LessonMinutes {
  double core = 0.0, all = 0.0;
};
/// The minutes of the core, and of all steps. Hints, teachers' notes and the glossary do not count.
LessonMinutes minutesOf(const Lesson& lesson);

/// In whole minutes for a card: the author's value for the core, else the estimate; at least 1.
struct ShownMinutes {
  int core = 1, all = 1;
};
ShownMinutes shownMinutes(const Lesson& lesson);

}  // namespace moltact
