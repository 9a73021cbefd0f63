// A student's answer to a task, given otherwise than by touch. Plain data.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace moltact {

struct TaskAnswer {
  std::string word = {};              ///< of one of the task's buttons
  std::vector<double> curve = {};     ///< of a task that lets draw one (unit: newton)
  std::optional<double> number = {};  ///< of a task with a slider (in its unit)
};

}  // namespace moltact
