// What stands at the two ends of a lesson: its goals before the first step, and the card that closes it. Window's
// thread.
#pragma once

namespace moltact {

class Application;
class LessonSession;

/// What a student can do afterwards, as the author wrote it.
void drawLessonGoals(Application& app, const LessonSession& session);
/// Opens them at the lesson's start, as long as nothing is done, unless that would push its first task or question out of
/// sight. `width`, `text_height`: of the lesson's text (unit: pixel). After the text was drawn once.
void settleLessonGoals(Application& app, const LessonSession& session, float width, float text_height);

/// Below the last step, once all is done: the goals, what was done and felt, the way taken, and what comes next.
void drawLessonEnd(Application& app, const LessonSession& session);

}  // namespace moltact
