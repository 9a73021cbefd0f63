// What the teacher's page shows of a live class, as plain numbers. Pure; any one thread at a time but the haptic one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/classroom/class_room.h"
#include "engine/classroom/shared_scene.h"

namespace moltact {

/// A student whose page has not been heard for longer is away (unit: second). A page speaks every two seconds.
inline constexpr double kAwayAfter_s = 15.0;
/// Who joined so long ago (unit: second) and has no attempt is stuck, if three quarters of the others have begun, and at
/// least three of them.
inline constexpr double kUnbegunAfter_s = 60.0;
/// Fewer predictions are not shown to the class: a plot of one or two shows who made them.
inline constexpr std::size_t kShownFrom = 3;
inline constexpr std::size_t kMaxShownTitle = 200;  ///< characters of a title that a student's page sent

struct StudentRow {
  std::size_t student = 0;  ///< in ClassRoom::students()
  std::string name;
  std::string lesson;               ///< title; empty before an attempt
  std::string step;                 ///< title
  std::size_t step_number = 0;      ///< from 1; 0: none
  std::size_t task = 0, tasks = 0;  ///< the task under way, from 1, of all of the step; 0: all done or none
  std::size_t done = 0, of = 0, hints = 0;
  double on_step_s = 0.0;
  bool begun = false;  ///< has an attempt
  bool stuck = false, away = false, finished = false;
  bool may_ask_scene = false;  ///< the student can be asked to show the scene (addScene)
};

struct StepRow {
  std::string title;
  std::size_t here = 0;  ///< students whose present step it is and who are not away
  std::size_t reached = 0, hints = 0, stuck = 0;
  bool aside = false, held = false;
};

/// A misconception that wrong choices indicate, with the students whose latest answers do.
struct MisconceptionRow {
  std::string words;
  std::vector<std::string> students;
};

/// The predictions of the class at a question, before the touch.
struct PredictionPlot {
  std::size_t at_step = 0, at_question = 0;
  std::string step, question;
  std::vector<std::string> choices;
  std::vector<std::size_t> counts;   ///< students by choice
  std::vector<std::string> written;  ///< typed ones, without names
  std::size_t students = 0;
  std::size_t waiting = 0;  ///< students here who work on the lesson, or on none yet, and have not predicted
};

/// The force curves that the class drew before feeling them, over each other.
struct CurvePlot {
  std::size_t at_step = 0, at_task = 0;
  std::string step, task;
  std::vector<CurveKept> curves;
  std::size_t waiting = 0;  ///< as in PredictionPlot
};

struct LessonView {
  std::string id, title;
  std::size_t students = 0;
  std::optional<std::size_t> held;
  std::vector<StepRow> steps;
  std::vector<PredictionPlot> predictions;
  std::vector<CurvePlot> curves;
};

/// The scene that a student was asked for, or shows.
struct SceneRow {
  std::string student;
  bool agreed = false, named = false;
  SceneHidden hidden = SceneHidden::No;
  std::size_t waiting = 0;  ///< students for whom it would answer something
};

struct ClassView {
  std::vector<StudentRow> students;              ///< those who are stuck first, then by name
  std::vector<LessonView> lessons;               ///< the teacher's; those with students first
  std::vector<MisconceptionRow> misconceptions;  ///< the most frequent first
  std::optional<ShownPlot> shown;                ///< to the class
  std::optional<SceneRow> scene;                 ///< asked for, or on the projector (addScene)
  std::size_t here = 0, away = 0, stuck = 0, finished = 0;
  bool ended = false;
};

ClassView viewOf(const ClassRoom& room, double now_s);
/// Adds what a view shows of the students' scenes; after SharedScene::follow().
void addScene(ClassView& view, const ClassRoom& room, const SharedScene& scene, double now_s);

std::size_t studentsHere(const ClassRoom& room, double now_s);

/// A plot for the room, of a question or of a task: no name and nothing that a student typed. Neither, if fewer than
/// kShownFrom students have predicted or there is no such question or task.
struct BoardPlot {
  std::optional<PredictionPlot> prediction;
  std::optional<CurvePlot> curve;
  bool empty() const { return !prediction && !curve; }
};

BoardPlot boardPlotOf(const ClassRoom& room, const ShownPlot& shown);

}  // namespace moltact
