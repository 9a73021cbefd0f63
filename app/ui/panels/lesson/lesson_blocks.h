// The blocks of a lesson's step: text, lists, hints, tasks, questions. Window's thread.
#pragma once

#include <string>
#include <vector>

#include "engine/lesson/lesson.h"

namespace moltact {

class Application;

/// Draws the blocks below each other, recorded under names that begin with `prefix`. `hints_before`: so many hints stand
/// above them. Returns a link that was clicked.
std::string drawLessonBlocks(Application& app, const std::vector<Block>& blocks, const std::string& prefix,
                             std::size_t hints_before);

/// A task and a question of the current step, by index.
void drawLessonTask(Application& app, std::size_t index);
std::string drawLessonQuestion(Application& app, std::size_t index);

}  // namespace moltact
