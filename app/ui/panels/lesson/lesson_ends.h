// The start and end of a lesson: its goals before the first step, and the closing page. Window's thread.
#pragma once

#include <string>

namespace moltact {

class Application;
class LessonSession;

/// Draws the author's goals: what a student can do afterwards.
void drawLessonGoals(Application& app, const LessonSession& session);
/// Called after the text was drawn once. Opens the goals at the lesson's start, before any work, unless they would push
/// its first task or question out of view. `width`, `text_height`: of the lesson's text (unit: pixel).
void settleLessonGoals(Application& app, const LessonSession& session, float width, float text_height);

/// Draws the page after the last step, at any progress. It lists the goals reached, links to the open tasks, the
/// student's predictions beside what was felt, the steps taken, and what comes next. Returns the link that was clicked,
/// or an empty text.
std::string drawLessonClosing(Application& app, const LessonSession& session);
/// Draws the foot of the closing page: Back, and the next lesson.
void drawClosingFoot(Application& app);

}  // namespace moltact
