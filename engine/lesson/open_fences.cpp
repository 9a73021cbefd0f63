// Finds fenced blocks without an end. In CommonMark such a block extends to the end of the file, and the rest of the
// lesson would be lost silently.
#include <algorithm>
#include <array>
#include <optional>

#include "engine/lesson/reading.h"

namespace moltact::reading {
namespace {

struct Fence {
  char sign = '`';
  std::size_t count = 0;  // number of fence characters
  std::string_view info;
  Place place;
};

/// The opening or closing fence in a line.
std::optional<Fence> fenceOf(std::string_view line, std::size_t number) {
  const std::size_t indent = line.find_first_not_of(' ');
  if (indent == std::string_view::npos || indent > 3) return {};
  Fence f;
  f.sign = line[indent];
  if (f.sign != '`' && f.sign != '~') return {};
  const std::string_view signs = line.substr(indent);
  f.count = std::min(signs.find_first_not_of(f.sign), signs.size());
  f.info = stripped(signs.substr(f.count));
  f.place = {number, indent + 1};
  // With backticks after the fence, it is inline code.
  if (f.count < 3 || (f.sign == '`' && f.info.find('`') != std::string_view::npos)) return {};
  return f;
}

bool ofLesson(const Fence& f) {
  constexpr std::array<std::string_view, 5> kFences{"step", "scene", "touch", "answer", "facts"};
  return std::find(kFences.begin(), kFences.end(), f.info) != kFences.end();
}

}  // namespace

std::vector<Place> findOpenFences(const SourceText& source, std::size_t from) {
  std::vector<Place> out;
  std::optional<Fence> open;
  for (std::size_t n = source.at(from).line; n <= source.lineCount(); ++n) {
    const std::optional<Fence> f = fenceOf(source.line(n), n);
    if (!f) continue;
    if (!open) {
      open = f;
    } else if (f->sign == open->sign && f->count >= open->count && f->info.empty()) {
      open.reset();
    } else if (ofLesson(*open) && ofLesson(*f)) {
      out.push_back(open->place);
      open = f;
    }
  }
  if (open) out.push_back(open->place);
  return out;
}

}  // namespace moltact::reading
