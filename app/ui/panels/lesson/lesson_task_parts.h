// The parts of a task's card beside its text: the buttons for the student's answers, the number that is set, and the
// curve that is drawn and felt. Window's thread.
#pragma once

#include <cstddef>
#include <string>

#include "engine/lesson/tasks/task.h"

namespace moltact {

class Application;

/// The buttons of the current task, each with its key. True when one was pressed and its answer given to the task.
bool drawTaskButtons(Application& app, std::size_t index, const Task& task);

/// The number that the current task lets set.
void drawTaskSlider(Application& app, std::size_t index, const TaskSlider& asked);

/// The curves of a task; the current one's can be drawn with the mouse or the arrow keys.
void drawTaskCurve(Application& app, std::size_t index, const TaskCurves& curves, bool current);

}  // namespace moltact
