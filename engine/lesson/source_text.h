// The bytes of a lesson's file and their places. Immutable after construction; any thread. Lines and columns count from
// 1; a column is one character (a UTF-8 code point), as in editors.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/utf8.h"

namespace moltact {

/// A place in a text file; 0 means none.
struct Place {
  std::size_t line = 0, column = 0;
};

/// A Problem at a place; the caller adds the file's name.
inline Problem problemAt(const Place& place, std::string message, std::string remedy) {
  return {{}, place.line, place.column, std::move(message), std::move(remedy)};
}

class SourceText {
 public:
  /// Accepts any bytes. A byte order mark at the start is removed.
  SourceText(std::string name, std::string bytes);

  const std::string& name() const { return name_; }
  std::string_view bytes() const { return bytes_; }

  /// The place of a byte; an offset beyond the end gives the place after the last byte.
  Place at(std::size_t offset) const;

  std::size_t lineCount() const { return starts_.size(); }
  /// The bytes of a line without its line end; empty if the line does not exist.
  std::string_view line(std::size_t number) const;
  /// The offset of the start of a line (unit: byte).
  std::size_t lineStart(std::size_t number) const { return starts_[number - 1]; }

 private:
  std::string name_, bytes_;
  std::vector<std::size_t> starts_;
};

/// The offset of the first byte that is not valid UTF-8 (or is a zero byte), or npos.
std::size_t firstBadByte(std::string_view text);

/// The text without spaces, tabs and carriage returns at both ends. The result is always a view into `text`, even if it
/// is empty.
std::string_view stripped(std::string_view text);

}  // namespace moltact
