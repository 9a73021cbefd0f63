// Reads a CSV file of numbers: a header, then rows with one number per column. Blanks around a field, a plus sign and a
// UTF-8 byte order mark are accepted. "nan" and "inf" are read as such.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact {

/// A row of the file, for the caller's checks.
struct NumberRow {
  std::size_t header = 0;                ///< index of the file's header among the accepted ones
  std::span<const double> numbers;       ///< one per column
  std::span<const std::size_t> columns;  ///< column of each number in the line, counted from 1
  std::size_t line = 0;
};

/// Calls `take` for each row in order. Returns a Problem with line, column and remedy in three cases. The file is not a
/// regular file, exceeds 1 GiB or is malformed; it has another header or no row; `take` returns a Problem. Headers have
/// the form "x,y,z" and at most 8 columns. `if_larger` is the remedy for a file over 1 GiB.
std::optional<Problem> readNumberRows(const std::filesystem::path& file, std::span<const std::string_view> headers,
                                      const std::string& if_larger,
                                      const std::function<std::optional<Problem>(const NumberRow&)>& take);

}  // namespace moltact
