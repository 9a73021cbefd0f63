// Parses Markdown into a small tree with md4c. Pure function; any thread but the haptic one.
#pragma once

#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/key_lines.h"
#include "engine/lesson/lesson.h"

namespace moltact {

/// One block of the document. Its kind determines which members are used.
struct MarkdownBlock {
  enum class Kind : std::uint8_t { Root, Heading, Paragraph, Code, List, Item, Quote, Html, Rule, Table, Row, Cell };
  Kind kind = Kind::Root;
  Place place;                           ///< place of its first text
  int level = 0;                         ///< Heading: 1 to 6
  bool ordered = false;                  ///< List
  int start = 1;                         ///< List, if ordered
  bool is_task = false, ticked = false;  ///< Item of a task list: "- [x]"
  Table::Side side = Table::Side::Left;  ///< Cell
  std::string info;                      ///< Code: the word after the opening fence
  std::vector<BlockLine> lines;          ///< Code: its lines; Root: HTML tags that were removed from the text
  std::vector<Problem> slips;            ///< Root: faulty scripts and formulas in the text
  RichText text;                         ///< Heading, Paragraph, Cell, and an Item's own text; Html: as written
  std::vector<Image> images;             ///< pictures in `text`
  std::vector<MarkdownBlock> children;
};

/// The maximum nesting of quotes and lists.
inline constexpr int kDeepestMarkdown = 16;

/// The tree of the text from byte `from` on. Deeper nesting returns a Problem with its place.
Expected<MarkdownBlock> parseMarkdown(const SourceText& source, std::size_t from);

}  // namespace moltact
