// Every text and picture of a lesson that a student or teacher may see, for checks that look at all of them.
// Pure functions; any thread but the haptic one.
#pragma once

#include <functional>

#include "engine/lesson/lesson.h"

namespace moltact {

/// Each text in the blocks, in their order; not those of tasks and questions.
void forEachText(const std::vector<Block>& blocks, const std::function<void(const RichText&)>& visit);

/// Each text of a step: its blocks, then its questions with choices and feedback.
void forEachText(const Step& step, const std::function<void(const RichText&)>& visit);

/// Each text of the lesson: the introduction, then step by step, then the meanings of its words.
void forEachText(const Lesson& lesson, const std::function<void(const RichText&)>& visit);

/// Each picture of the lesson.
void forEachImage(const Lesson& lesson, const std::function<void(const Image&)>& visit);

}  // namespace moltact
