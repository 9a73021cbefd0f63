// A student's answer to a task other than by touch. Plain data.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace moltact {

struct TaskAnswer {
  std::string word = {};              ///< the word of one of the task's buttons
  std::vector<double> curve = {};     ///< for a task in which a curve is drawn (unit: newton)
  std::optional<double> number = {};  ///< for a task with a slider (in the slider's unit)
};

}  // namespace moltact
