#include "app/commands/hip_path_file.h"

#include <charconv>
#include <fstream>
#include <iterator>
#include <string_view>

namespace moltact {
namespace {

constexpr std::string_view kHeader = "x,y,z";

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.back() == '\r' || text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  return text;
}

}  // namespace

Expected<std::vector<PointA>> readHipPath(const std::filesystem::path& file) {
  std::error_code error;
  const std::string name = file.string();
  if (std::filesystem::is_directory(file, error)) return Problem{name, 0, 0, "this is a folder", "name a file with the header x,y,z"};
  std::ifstream in(file, std::ios::binary);
  if (!in) return Problem{name, 0, 0, "the file cannot be opened", "check its name and that you may read it"};
  const std::string text{std::istreambuf_iterator<char>(in), {}};

  std::vector<PointA> path;
  std::size_t line_number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view raw(text.data() + at, end - at), line = trimmed(raw);
    at = end + 1;
    ++line_number;
    if (line_number == 1) {
      if (line != kHeader)
        return Problem{name, 1, 1, "the first line is not the header x,y,z", "write x,y,z in the first line, then a row a tick"};
      continue;
    }
    if (line.empty()) continue;
    PointA place;
    const char* next = line.data();
    const char* const stop = line.data() + line.size();
    const auto column = [&](const char* where) { return static_cast<std::size_t>(where - raw.data()) + 1; };
    for (int k = 0; k < 3; ++k) {
      while (next != stop && *next == ' ') ++next;
      const auto [after, fault] = std::from_chars(next, stop, place.A[k]);
      if (fault == std::errc::result_out_of_range)
        return Problem{name, line_number, column(next), "this number is too large or too small for a coordinate", "keep coordinates within 1e9 A"};
      if (fault != std::errc{})
        return Problem{name, line_number, column(next), "a number was expected here", "a row is three numbers with commas between: x,y,z in angstroms"};
      next = after;
      while (next != stop && *next == ' ') ++next;
      if (k < 2 && (next == stop || *next != ','))
        return Problem{name, line_number, column(next), "a comma was expected here", "a row is three numbers with commas between: x,y,z in angstroms"};
      if (k < 2) ++next;
    }
    if (next != stop) return Problem{name, line_number, column(next), "there is more than x,y,z in this row", "remove what follows the third number"};
    path.push_back(place);
  }
  if (path.empty()) return Problem{name, 0, 0, "there is no row in this file", "write the header x,y,z and then a row a tick"};
  return path;
}

}  // namespace moltact
