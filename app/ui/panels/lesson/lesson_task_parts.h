// Controls on a task's card: buttons for answers, a slider for a number, and curves that are drawn and felt. Window's
// thread.
#pragma once

#include <cstddef>
#include <string>

#include "engine/lesson/tasks/task.h"

namespace moltact {

class Application;

/// Draws the buttons of the current task, each with its key. Returns true if one was pressed; its answer has then been
/// given to the task.
bool drawTaskButtons(Application& app, std::size_t index, const Task& task);

/// Draws the slider for the number that the current task asks for.
void drawTaskSlider(Application& app, std::size_t index, const TaskSlider& asked);

/// Draws the curves of a task. The student can draw the current task's curve with the mouse or the arrow keys.
void drawTaskCurve(Application& app, std::size_t index, const TaskCurves& curves, bool current);

}  // namespace moltact
