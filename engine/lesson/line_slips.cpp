// Finds lines that were meant as a heading or a choice but are plain text in Markdown, because a blank is missing.
#include <algorithm>

#include "engine/language/catalogue.h"
#include "engine/lesson/reading.h"

namespace moltact::reading {
namespace {

// "##Three"
bool headingWithoutBlank(std::string_view line) {
  const std::size_t signs = std::min(line.find_first_not_of('#'), line.size());
  return signs >= 2 && signs <= 6 && signs < line.size() && line[signs] != ' ' && line[signs] != '\t';
}

// "-[x] a", "- [x]a", "- [] a"
bool choiceWithoutBlank(std::string_view line) {
  if (line.empty() || (line[0] != '-' && line[0] != '*')) return false;
  const std::string_view box = stripped(line.substr(1));
  if (box.starts_with("[]")) return true;
  const bool ticks =
      box.size() > 3 && box[0] == '[' && box[2] == ']' && (box[1] == ' ' || box[1] == 'x' || box[1] == 'X');
  // Excludes links, whose text may be a single letter.
  return ticks && box[3] != '(' && (line[1] == '[' || box[3] != ' ');
}

}  // namespace

void findLineSlips(Reading& reading, std::size_t from) {
  const SourceText& source = reading.source;
  std::string_view fence;  // of the block that contains the line
  for (std::size_t n = source.at(from).line; n <= source.lineCount(); ++n) {
    const std::string_view line = stripped(source.line(n));
    const std::string_view sign = line.starts_with("```") ? "```" : line.starts_with("~~~") ? "~~~" : "";
    if (!sign.empty() && (fence.empty() || fence == sign)) {
      fence = fence.empty() ? sign : std::string_view();
      continue;
    }
    if (!fence.empty()) continue;
    if (headingWithoutBlank(line))
      reading.error({n, 1}, tr("this is no heading: a blank is missing after its signs"),
                    tr("write it as in '## Its name'"));
    else if (choiceWithoutBlank(line))
      reading.error({n, 1}, tr("this is no choice: a blank is missing"),
                    tr("write it as in '- [x] right' and '- [ ] wrong'"));
  }
}

}  // namespace moltact::reading
