// Wrapped text with bold, italic and code runs and links, as a lesson holds it. Window's thread.
#pragma once

#include <imgui.h>

#include <string>

#include "engine/lesson/lesson.h"

namespace moltact {

/// Plain text with line ends where it is to be broken to fit the width in the current font: only between words, and
/// never between a number and its unit. A word that is wider than the width stays whole.
std::string wrapped(const std::string& text, float width);

/// Draws the text from the cursor on, wrapped at `width` (0: the rest of the line), and moves the cursor below it.
/// Returns the link that was clicked, or an empty text. `name` records it and its links ("name/link text"). Numbers
/// outside code are written as the person prefers.
std::string drawRichText(const char* name, const RichText& text, ImU32 colour, float width = 0.0f);

}  // namespace moltact
