// Wrapped text with bold, italic and code runs, scripts and links, as a lesson holds it. Window's thread. Unit: pixel.
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
/// outside code are written as the person prefers. Words of a glossary have a dotted line, other links a whole one.
std::string drawRichText(const char* name, const RichText& text, ImU32 colour, float width = 0.0f);

/// The same for a label: painted at a place, without links, item or record.
void paintRichText(ImDrawList* draw, ImVec2 at, const RichText& text, ImU32 colour, float width);
/// From the top of its first line's letters to the bottom of the last one's.
float richTextHeight(const RichText& text, float width);

/// How wide it is on one line, and its widest word, below which it is broken within words.
struct RichTextWidths {
  float least = 0.0f, whole = 0.0f;
};
RichTextWidths richTextWidths(const RichText& text);

/// A table in columns as wide as their texts need, wrapped where the width (0: the rest of the line) does not hold them.
/// Returns the link that was clicked. Cells are recorded as "name/row/column".
std::string drawRichTable(const char* name, const Table& table, ImU32 colour, float width = 0.0f);

}  // namespace moltact
