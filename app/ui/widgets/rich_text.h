// Draws wrapped text with bold, italic and code runs, sub- and superscripts and links, as in lessons. Window's thread.
// Unit: pixel.
#pragma once

#include <imgui.h>

#include <string>

#include "engine/lesson/lesson.h"

namespace moltact {

/// Inserts line ends into plain text so that it fits the width in the current font. Lines break only between words,
/// never between a number and its unit. A word wider than the width stays whole.
std::string wrapped(const std::string& text, float width);

/// Draws plain text at the cursor in the current font, wrapped as by wrapped() at the end of the line, and records it as
/// `name`.
void drawWrapped(const char* name, const std::string& text);

/// Draws the text at the cursor, wrapped at `width` (0: the rest of the line), and moves the cursor below it. Returns
/// the link that was clicked, or an empty text. The widget map records the text as `name` and its links as "name/link
/// text". Numbers outside code follow the user's choice of the decimal sign. Glossary words are underlined with dots,
/// other links with a line.
std::string drawRichText(const char* name, const RichText& text, ImU32 colour, float width = 0.0f);

/// Paints a label at a place, without links, ImGui item or record in the widget map.
void paintRichText(ImDrawList* draw, ImVec2 at, const RichText& text, ImU32 colour, float width);
/// The height from the top of the first line's letters to the bottom of the last line's.
float richTextHeight(const RichText& text, float width);

/// The width of the text on one line (`whole`) and of its widest word (`min`). Below `min`, words are broken.
struct RichTextWidths {
  float min = 0.0f, whole = 0.0f;
};
RichTextWidths richTextWidths(const RichText& text);

/// Draws a table; its columns have the widths of their texts, which wrap if `width` (0: the rest of the line) is too
/// small. Returns the link that was clicked. Cells are recorded as "name/row/column".
std::string drawRichTable(const char* name, const Table& table, ImU32 colour, float width = 0.0f);

}  // namespace moltact
