// A Markdown text as a small tree, parsed by md4c. Pure function; any thread but the haptic one.
#pragma once

#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/key_lines.h"
#include "engine/lesson/lesson.h"

namespace moltact {

/// One block of the document. Which members are filled follows from its kind.
struct MarkdownBlock {
  enum class Kind : std::uint8_t { Root, Heading, Paragraph, Code, List, Item, Quote, Html, Rule, Table, Row, Cell };
  Kind kind = Kind::Root;
  Place place;                           ///< of its first text
  int level = 0;                         ///< Heading: 1 to 6
  bool ordered = false;                  ///< List
  int start = 1;                         ///< List, where ordered
  bool is_task = false, ticked = false;  ///< Item of a task list: "- [x]"
  Table::Side side = Table::Side::Left;  ///< Cell
  std::string info;                      ///< Code: the word after the fence
  std::vector<BlockLine> lines;          ///< Code: its lines; Root: tags of HTML within the text, which are not in it
  std::vector<Problem> slips;            ///< Root: what in the text was meant for a script or a formula and is none
  RichText text;                         ///< Heading, Paragraph, Cell, and an Item's own text; Html: as written
  std::vector<Image> images;             ///< pictures in `text`
  std::vector<MarkdownBlock> children;
};

/// The deepest nesting of quotes and lists that is read.
inline constexpr int kDeepestMarkdown = 16;

/// The tree of the text from byte `from` on. A text that is nested deeper gives a problem with its place.
Expected<MarkdownBlock> parseMarkdown(const SourceText& source, std::size_t from);

}  // namespace moltact
