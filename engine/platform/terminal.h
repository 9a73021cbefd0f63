// The only code that writes to standard output and standard error, whatever they are connected to. The text may contain
// untrusted names and file contents. Nothing in it can control the terminal (engine/core/printable.h), and a value
// cannot start a new line. Any one thread except the haptic one.
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

#include "engine/core/printable.h"

namespace moltact {

/// Text of several lines, or with significant tabs: its line ends are kept.
struct Lines {
  std::string_view text;
};

/// Writes to standard output or error. String literals of the program keep their line ends; every other text is written
/// on one line.
class TerminalText {
 public:
  explicit TerminalText(std::ostream& to) : to_(to) {}

  template <std::size_t N>
  TerminalText& operator<<(const char (&literal)[N]) {
    to_ << literal;
    return *this;
  }
  template <std::size_t N>
  TerminalText& operator<<(char (&made)[N]) {
    return *this << std::string_view(made);
  }
  TerminalText& operator<<(std::string_view value) {
    to_ << oneLine(value);
    return *this;
  }
  TerminalText& operator<<(const std::string& value) { return *this << std::string_view(value); }
  // Only for true pointers: a template on arrays would capture literals.
  template <class Pointer>
  requires std::is_same_v<Pointer, const char*> TerminalText& operator<<(const Pointer& value) {
    return *this << std::string_view(value);
  }
  TerminalText& operator<<(Lines value) {
    to_ << value.text;
    return *this;
  }
  template <class Number>
  requires std::is_arithmetic_v<Number> TerminalText& operator<<(Number value) {
    to_ << value;
    return *this;
  }
  /// Writes the buffered text now.
  void flush() { to_.flush(); }

 private:
  std::ostream& to_;
};

/// Standard output, buffered until flush(), a full buffer or output to standard error.
TerminalText out();
/// Standard error, unbuffered.
TerminalText err();

/// The same as streams, for libraries that write to a stream. Text is cleaned except for line ends.
std::ostream& cleanOut();
std::ostream& cleanErr();

/// Flushes standard output. Returns false if some of it could not be written (for example to a full disk).
bool terminalWritten();

/// Replaces the status line on standard error, if that is a terminal; an empty text removes it.
void showStatus(std::string_view line);

/// True if standard error is a terminal and not a file or a pipe.
bool standardErrorIsTerminal();

/// Hides the console window if the system opened it for this program alone, as Windows does for a program started from
/// the desktop.
void hideOwnTerminal();

enum class Typed {
  Nothing,  ///< no complete line yet
  Line,
  End,  ///< end of input
};
/// Waits up to `wait_ms` for a line on standard input; a signal ends the wait. Bypasses the C and C++ streams.
Typed typedLine(std::string& line, int wait_ms);

}  // namespace moltact
