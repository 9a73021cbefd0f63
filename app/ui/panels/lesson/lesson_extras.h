// Extra steps, outside the core. Each step of the core offers the extra steps that belong to it; the lesson's end lists
// those that the student has not seen. Window's thread.
#pragma once

#include <string>

namespace moltact {

class LessonSession;

/// Draws "More on this:" with a link to each extra step, below the text of a step of the core. Returns the link that
/// was clicked, or an empty text.
std::string drawExtrasOffered(const LessonSession& session);
/// Draws the extra steps that were not seen, on the closing page. Returns the link that was clicked, or an empty text.
std::string drawExtrasLeft(const LessonSession& session);

}  // namespace moltact
