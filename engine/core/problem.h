// A fault in something that a person gave us (a file, a line, an argument), and its remedy. Used outside the haptic
// thread only.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>

#include "engine/core/printable.h"

namespace moltact {

/// One fault in a user's input. `line` and `column` count from 1; 0 means that there is no such place.
struct Problem {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
  std::string message;  ///< what is wrong, in the person's own terms
  std::string remedy;   ///< what would correct it; may be empty

  /// "file:line:column: message; remedy" on one line, leaving out what is not known. Names and what a message quotes
  /// may hold anything; what would steer a terminal is replaced.
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

/// Either a value, or the problem that prevented it.
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
