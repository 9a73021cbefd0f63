#include "app/commands/number_rows.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "engine/core/text.h"
#include "engine/haptics/contact.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/platform/read_file.h"

namespace moltact {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // some spreadsheets begin a CSV file with it
constexpr std::size_t kMaxBytes = std::size_t{1} << 30;
constexpr std::size_t kMaxColumns = 8;

bool isBlank(char c) { return c == ' ' || c == '\t'; }

std::string withoutBlanks(std::string_view text) {
  std::string out(text);
  std::erase_if(out, isBlank);
  return out;
}

// "x,y,z or x,y,z,qw,qx,qy,qz"
std::string listed(std::span<const std::string_view> headers) {
  std::string out;
  for (const std::string_view header : headers)
    out = out.empty() ? std::string(header) : trf("{0} or {1}", out, header);
  return out;
}

}  // namespace

std::optional<Problem> readNumberRows(const std::filesystem::path& file, std::span<const std::string_view> headers,
                                      const std::string& if_larger,
                                      const std::function<std::optional<Problem>(const NumberRow&)>& take) {
  const std::string name = file.string();
  const auto bytes = readFile(file, kMaxBytes, if_larger);
  if (!bytes) return bytes.problem();
  std::string_view text = *bytes;
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());

  NumberRow row;
  std::string_view header;
  std::size_t count = 0, rows = 0;
  std::array<double, kMaxColumns> numbers{};
  std::array<std::size_t, kMaxColumns> columns{};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view raw(text.data() + at, end - at), line = trimmed(raw);
    at = end + 1;
    ++row.line;
    if (row.line == 1) {
      const auto known = std::find(headers.begin(), headers.end(), withoutBlanks(line));
      if (known == headers.end())
        return Problem{name, 1, 1, trf("the first line is not the header {0}", listed(headers)),
                       trf("write {0} in the first line, then the rows", listed(headers))};
      header = *known;
      row.header = std::size_t(known - headers.begin());
      count = std::size_t(std::count(header.begin(), header.end(), ',')) + 1;
      row.numbers = std::span<const double>(numbers).first(count);
      row.columns = std::span<const std::size_t>(columns).first(count);
      continue;
    }
    if (line.empty()) continue;
    const char* next = line.data();
    const char* const stop = line.data() + line.size();
    const auto column = [&](const char* where) { return static_cast<std::size_t>(where - raw.data()) + 1; };
    const auto expected = [&](const char* what) {
      return Problem{name, row.line, column(next), what,
                     trf("a row is {0} numbers with commas between: {1}", count, header)};
    };
    for (std::size_t k = 0; k < count; ++k) {
      while (next != stop && isBlank(*next)) ++next;
      // std::from_chars rejects a plus sign.
      if (stop - next > 1 && *next == '+' && next[1] != '-') ++next;
      columns[k] = column(next);
      const auto [after, fault] = std::from_chars(next, stop, numbers[k]);
      if (fault == std::errc::result_out_of_range)
        return Problem{name, row.line, column(next), tr("this number is too large or too small for a coordinate"),
                       trf("keep coordinates within {0}", quantityText(kMaxPosition_A, Dimension::Length, plain()))};
      if (fault != std::errc{}) return expected(tr("a number was expected here"));
      next = after;
      while (next != stop && isBlank(*next)) ++next;
      if (k + 1 == count) break;
      if (next == stop || *next != ',') return expected(tr("a comma was expected here"));
      ++next;
    }
    if (next != stop)
      return Problem{name, row.line, column(next), trf("there is more than {0} in this row", header),
                     tr("remove what follows the last number")};
    ++rows;
    if (std::optional<Problem> problem = take(row)) return problem;
  }
  if (rows == 0)
    return Problem{name, 0, 0, tr("there is no row in this file"),
                   trf("write {0} in the first line, then the rows", listed(headers))};
  return std::nullopt;
}

}  // namespace moltact
