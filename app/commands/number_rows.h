// A CSV file of numbers as commands read it: a header, then rows of as many numbers. Blanks around the fields, a plus
// sign and a UTF-8 byte order mark are accepted; "nan" and "inf" are read as such.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact {

/// A row that has been read, for whoever judges its numbers.
struct NumberRow {
  std::size_t header = 0;                ///< which of the headers the file has
  std::span<const double> numbers;       ///< as many as the header has columns
  std::span<const std::size_t> columns;  ///< of each number in the line, counted from 1
  std::size_t line = 0;
};

/// Hands over each row in order. A Problem with line, column and remedy where the file is no ordinary one, larger than
/// 1 GiB or broken, has another header or no row, or where `take` returns one. Headers are as "x,y,z", of 8 columns at
/// most; `if_larger` is the remedy for a file over 1 GiB.
std::optional<Problem> readNumberRows(const std::filesystem::path& file, std::span<const std::string_view> headers,
                                      const std::string& if_larger,
                                      const std::function<std::optional<Problem>(const NumberRow&)>& take);

}  // namespace moltact
