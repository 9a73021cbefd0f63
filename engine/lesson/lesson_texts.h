// Visits every text and picture of a lesson, for checks of all of them. Pure functions; any thread but the haptic one.
#pragma once

#include <functional>

#include "engine/lesson/lesson.h"

namespace moltact {

/// Visits each text in the blocks, in order, without those of tasks and questions.
void forEachText(const std::vector<Block>& blocks, const std::function<void(const RichText&)>& visit);

/// Visits each text of a step: its blocks, then its questions with choices and feedback.
void forEachText(const Step& step, const std::function<void(const RichText&)>& visit);

/// Visits each text of the lesson: the introduction, the steps, then the meanings of its words.
void forEachText(const Lesson& lesson, const std::function<void(const RichText&)>& visit);

/// Visits each picture of the lesson.
void forEachImage(const Lesson& lesson, const std::function<void(const Image&)>& visit);

}  // namespace moltact
