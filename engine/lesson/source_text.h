// The bytes of a lesson file and where each of them stands. Immutable after construction; any thread.
// Lines and columns count from 1; a column is a character (a UTF-8 code point), as editors count.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/utf8.h"

namespace moltact {

/// A place in a text file. 0 means that there is no such place.
struct Place {
  std::size_t line = 0, column = 0;
};

/// What is wrong at a place of the file that is read; whoever knows the file's name adds it.
inline Problem problemAt(const Place& place, std::string message, std::string remedy) {
  return {{}, place.line, place.column, std::move(message), std::move(remedy)};
}

class SourceText {
 public:
  /// Takes any bytes. A byte order mark at the start is left out.
  SourceText(std::string name, std::string bytes);

  const std::string& name() const { return name_; }
  std::string_view bytes() const { return bytes_; }

  /// The place of a byte; an offset beyond the end gives the place just after the last byte.
  Place at(std::size_t offset) const;

  std::size_t lineCount() const { return starts_.size(); }
  /// The bytes of a line without its line end; empty for a line that does not exist.
  std::string_view line(std::size_t number) const;
  /// Where a line starts (unit: byte).
  std::size_t lineStart(std::size_t number) const { return starts_[number - 1]; }

 private:
  std::string name_, bytes_;
  std::vector<std::size_t> starts_;
};

/// The offset of the first byte that is not valid UTF-8 (or is a zero byte), or npos.
std::size_t firstBadByte(std::string_view text);

/// Without spaces, tabs and carriage returns at either end. The result is always a view into `text`, an empty one too.
std::string_view stripped(std::string_view text);

}  // namespace moltact
