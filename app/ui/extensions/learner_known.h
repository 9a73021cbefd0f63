// The learning platform around the page: whether it knows who works, so that no lesson asks for a name, and the way back to
// it. Set once by a page in a platform, before it opens its lesson. Window's thread.
#pragma once

#include <string>

namespace moltact {

inline bool& learnerKnownFlag() {
  static bool known = false;
  return known;
}
inline bool learnerKnown() { return learnerKnownFlag(); }

/// The code by which a page of a study has assigned the student, which lessons take instead of asking; empty: none.
inline std::string& assignedCode() {
  static std::string code;
  return code;
}

/// Leaves the program for the page of the platform that launched it; null if there is none, or it names no such page.
inline void (*&platformReturn())() {
  static void (*leave)() = nullptr;
  return leave;
}

}  // namespace moltact
