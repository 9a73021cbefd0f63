// Whether a learning platform knows who works, so that no lesson asks for a name. Set once by a page in a platform, before
// it opens its lesson. Window's thread.
#pragma once

namespace moltact {

inline bool& learnerKnownFlag() {
  static bool known = false;
  return known;
}
inline bool learnerKnown() { return learnerKnownFlag(); }

}  // namespace moltact
