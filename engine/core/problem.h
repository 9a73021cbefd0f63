// An error in a user's input (a file, a line, an argument) and its remedy. Any thread except the haptic one.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>

#include "engine/core/printable.h"

namespace moltact {

/// One error in a user's input. `line` and `column` count from 1; 0: not applicable.
struct Problem {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
  std::string message;  ///< the error, in the user's terms
  std::string remedy;   ///< how to correct it; may be empty

  /// Returns "file:line:column: message; remedy" on one line, without unknown parts. Characters that control a terminal
  /// are replaced.
  std::string text() const {
    std::string out = oneLine(file);
    if (line) out += ':' + std::to_string(line);
    if (line && column) out += ':' + std::to_string(column);
    if (!out.empty()) out += ": ";
    out += oneLine(message);
    if (!remedy.empty()) out += "; " + oneLine(remedy);
    return out;
  }
};

/// Either a value or the problem that prevented it.
template <class T>
class Expected {
 public:
  Expected(T value) : held_(std::move(value)) {}
  Expected(Problem problem) : held_(std::move(problem)) {}

  explicit operator bool() const { return held_.index() == 0; }
  T& operator*() & { return std::get<0>(held_); }
  const T& operator*() const& { return std::get<0>(held_); }
  T&& operator*() && { return std::get<0>(std::move(held_)); }
  T* operator->() { return &std::get<0>(held_); }
  const T* operator->() const { return &std::get<0>(held_); }
  const Problem& problem() const { return std::get<1>(held_); }

 private:
  std::variant<T, Problem> held_;
};

}  // namespace moltact
