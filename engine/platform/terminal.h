// The only code that writes to standard output and error, whatever they are connected to. The text may hold names and
// texts from files that others made; nothing in it controls the terminal (engine/core/printable.h), and a value begins
// no line of its own. Any one thread but the haptic one.
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

#include "engine/core/printable.h"

namespace moltact {

/// Text of several lines, or whose tabs matter: its line ends stay.
struct Lines {
  std::string_view text;
};

/// Writes to standard output or error. What is written literally in the program keeps its line ends; every other text
/// comes onto one line.
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
  // Not for arrays: a literal would be taken for a pointer.
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
  /// Now, and not when there is more of it.
  void flush() { to_.flush(); }

 private:
  std::ostream& to_;
};

/// Standard output: kept back until there is some of it, flush() is called, or something goes to standard error.
TerminalText out();
/// Standard error: at once.
TerminalText err();

/// The same as streams, for libraries that write what they were given to one: cleaned too, but for line ends.
std::ostream& cleanOut();
std::ostream& cleanErr();

/// Sends what is kept back; false where something of standard output could not be written (a full disk behind a
/// redirection).
bool terminalWritten();

/// A line on standard error that stands in the place of the last one, while that is a terminal; empty: it goes.
void showStatus(std::string_view line);

/// True when standard error goes to a terminal and not to a file or a pipe.
bool standardErrorIsTerminal();

/// Hides the terminal's window where the system opened one for this program alone, as Windows does for one that is
/// started from the desktop.
void hideOwnTerminal();

enum class Typed {
  Nothing,  ///< yet
  Line,
  End,  ///< nothing more will come
};
/// Waits for a line on standard input, at most so long; a signal ends the wait. Reads it without the C and C++ streams.
Typed typedLine(std::string& line, int wait_ms);

}  // namespace moltact
