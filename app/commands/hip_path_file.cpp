#include "app/commands/hip_path_file.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

#include "engine/core/text.h"
#include "engine/haptics/contact.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/platform/read_file.h"

namespace moltact {
namespace {

constexpr std::string_view kHeader = "x,y,z";

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // some spreadsheets begin a CSV file with it
constexpr std::size_t kMaxBytes = std::size_t{1} << 30;
constexpr std::size_t kMaxPlaces = 25'000'000;  // seven hours of ticks

bool isBlank(char c) { return c == ' ' || c == '\t'; }

std::string withoutBlanks(std::string_view text) {
  std::string out(text);
  std::erase_if(out, isBlank);
  return out;
}

}  // namespace

Expected<std::vector<PointA>> readHipPath(const std::filesystem::path& file) {
  const std::string name = file.string();
  const auto bytes = readFile(file, kMaxBytes, "split it into shorter paths");
  if (!bytes) return bytes.problem();
  std::string_view text = *bytes;
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());

  std::vector<PointA> path;
  std::size_t line_number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view raw(text.data() + at, end - at), line = trimmed(raw);
    at = end + 1;
    ++line_number;
    if (line_number == 1) {
      if (withoutBlanks(line) != kHeader)
        return Problem{name, 1, 1, tr("the first line is not the header x,y,z"),
                       tr("write x,y,z in the first line, then one row per tick")};
      continue;
    }
    if (line.empty()) continue;
    PointA place;
    const char* next = line.data();
    const char* const stop = line.data() + line.size();
    const auto column = [&](const char* where) { return static_cast<std::size_t>(where - raw.data()) + 1; };
    for (int k = 0; k < 3; ++k) {
      while (next != stop && isBlank(*next)) ++next;
      // std::from_chars rejects a plus sign.
      if (stop - next > 1 && *next == '+' && next[1] != '-') ++next;
      const auto [after, fault] = std::from_chars(next, stop, place.A[k]);
      if (fault == std::errc::result_out_of_range)
        return Problem{name, line_number, column(next), tr("this number is too large or too small for a coordinate"),
                       trf("keep coordinates within {0}", quantityText(kFarthest_A, Dimension::Length, plain()))};
      if (fault != std::errc{})
        return Problem{name, line_number, column(next), tr("a number was expected here"),
                       tr("a row is three numbers with commas between: x,y,z in angstroms")};
      next = after;
      while (next != stop && isBlank(*next)) ++next;
      if (k < 2 && (next == stop || *next != ','))
        return Problem{name, line_number, column(next), tr("a comma was expected here"),
                       tr("a row is three numbers with commas between: x,y,z in angstroms")};
      if (k < 2) ++next;
    }
    if (next != stop)
      return Problem{name, line_number, column(next), tr("there is more than x,y,z in this row"),
                     tr("remove what follows the third number")};
    if (path.size() == kMaxPlaces)
      return Problem{name, line_number, 1, tr("more than 25 million rows"), tr("split it into shorter paths")};
    path.push_back(place);
  }
  if (path.empty())
    return Problem{name, 0, 0, tr("there is no row in this file"),
                   tr("write the header x,y,z and then one row per tick")};
  return path;
}

}  // namespace moltact
