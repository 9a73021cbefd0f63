// The step at which a live class waits (docs/live-class.md): the page of a student in a class sets it, and nobody else. One
// for the whole program, because a page has one student. Window's thread.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace moltact {

/// For each lesson, by its file's name without ending and language: the number of the last step, from 0, that may be
/// entered. Lessons that are not held are missing.
inline std::map<std::string, std::size_t, std::less<>>& classHolds() {
  static std::map<std::string, std::size_t, std::less<>> holds;
  return holds;
}

/// Whether a student may not yet go from this step of a lesson to the next ones.
inline bool classHolds(std::string_view lesson, std::size_t step) {
  const auto held = classHolds().find(lesson);
  return held != classHolds().end() && step >= held->second;
}

}  // namespace moltact
