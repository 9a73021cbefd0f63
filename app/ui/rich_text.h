// Wrapped text with bold, italic and code runs and links, as a lesson holds it. Window's thread.
#pragma once

#include <string>

#include <imgui.h>

#include "engine/lesson/lesson.h"

namespace moltact {

/// Draws the text from the cursor on, wrapped at `width` (0: the rest of the line), and moves the cursor below it.
/// Returns the link that was clicked, or an empty text. `name` records it and its links ("name/link text").
std::string drawRichText(const char* name, const RichText& text, ImU32 colour, float width = 0.0f);

}  // namespace moltact
