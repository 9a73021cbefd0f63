// What stands at the two ends of a lesson: its goals before the first step, and the card that closes it. Window's
// thread.
#pragma once

namespace moltact {

class Application;
class LessonSession;

/// What a student can do afterwards, as the author wrote it.
void drawLessonGoals(Application& app, const LessonSession& session);

/// Below the last step, once all is done: the goals, what was done and felt, the way taken, and what comes next.
void drawLessonEnd(Application& app, const LessonSession& session);

}  // namespace moltact
