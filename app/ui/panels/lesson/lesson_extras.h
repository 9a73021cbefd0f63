// Extra steps, beside the core: each step of the core offers those that belong to it, and the lesson's end lists all that
// the student has not seen. Window's thread.
#pragma once

#include <string>

namespace moltact {

class LessonSession;

/// "More on this:" and a link to each, below the text of a step of the core. Gives the link that was clicked, or nothing.
std::string drawExtrasOffered(const LessonSession& session);
/// On the closing page, those that were not seen. Gives the link that was clicked, or nothing.
std::string drawExtrasLeft(const LessonSession& session);

}  // namespace moltact
