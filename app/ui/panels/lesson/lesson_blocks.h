// Draws the blocks of a lesson's step: text, lists, hints, tasks, questions. Window's thread.
#pragma once

#include <string>
#include <vector>

#include "engine/lesson/lesson.h"

namespace moltact {

class Application;

/// Draws the blocks below each other, recorded under names that begin with `prefix`. `hints_before`: the number of
/// hints above these blocks. Returns the link that was clicked, or an empty text.
std::string drawLessonBlocks(Application& app, const std::vector<Block>& blocks, const std::string& prefix,
                             std::size_t hints_before);

/// Draw a task or a question of the current step, by index. The question returns the link that was clicked.
void drawLessonTask(Application& app, std::size_t index);
std::string drawLessonQuestion(Application& app, std::size_t index);

}  // namespace moltact
