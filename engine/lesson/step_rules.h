// Rules by which answers to a question change the order of steps: "after 2 wrong: go to #aside-x", "if right: skip
// #the-long-way". A rule that leads back or to an aside applies once; one that leads forward or skips stays in force.
// Therefore no rules can trap a student (tests/lesson/step_rules_test.cpp). Plain data; any thread but the haptic one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/lesson/source_text.h"

namespace moltact {

struct StepRule {
  enum class When : std::uint8_t { Right, RightAtFirst, Wrong };
  enum class Then : std::uint8_t { GoTo, Skip };
  When when = When::Right;
  int wrong = 0;  ///< for Wrong: the number of wrong answers
  Then then = Then::GoTo;
  std::vector<std::string> steps;  ///< ids after reading, before that as written; one for GoTo
  std::vector<Place> step_places;  ///< place of each step
  Place place;                     ///< place of the value

  /// Whether it applies after `attempts` answers, of which the last may have been right.
  bool holds(int attempts, bool answered_right) const {
    const int wrong_ones = attempts - (answered_right ? 1 : 0);
    switch (when) {
      case When::Right:
        return answered_right;
      case When::RightAtFirst:
        return answered_right && attempts == 1;
      case When::Wrong:
        break;
    }
    return wrong_ones >= wrong;
  }
  /// The key as written by an author: "after 2 wrong".
  std::string key() const;
  friend bool operator==(const StepRule& a, const StepRule& b) {
    return a.when == b.when && a.wrong == b.wrong && a.then == b.then && a.steps == b.steps;
  }
};

/// "go to" and "skip".
std::string_view wordOf(StepRule::Then then);

}  // namespace moltact
