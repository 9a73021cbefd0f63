// What stands at the two ends of a lesson: its goals before the first step, and the page that closes it. Window's
// thread.
#pragma once

#include <string>

namespace moltact {

class Application;
class LessonSession;

/// What a student can do afterwards, as the author wrote it.
void drawLessonGoals(Application& app, const LessonSession& session);
/// Opens them at the lesson's start, as long as nothing is done, unless that would push its first task or question out of
/// sight. `width`, `text_height`: of the lesson's text (unit: pixel). After the text was drawn once.
void settleLessonGoals(Application& app, const LessonSession& session, float width, float text_height);

/// The page after the last step, however much was done: the goals with what is reached of them, what is left with a
/// button to each, the student's predictions beside what was felt, the way taken, and what comes next.
/// Gives the link that was clicked, or nothing.
std::string drawLessonClosing(Application& app, const LessonSession& session);
/// Its foot: back, and the lesson that comes next.
void drawClosingFoot(Application& app);

}  // namespace moltact
