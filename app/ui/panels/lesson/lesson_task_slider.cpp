// The number that a task lets the student set.
#include <algorithm>
#include <cmath>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/panels/lesson/lesson_task_parts.h"
#include "app/ui/widgets/controls.h"
#include "engine/language/catalogue.h"

namespace moltact {

void drawTaskSlider(Application& app, std::size_t index, const TaskSlider& asked) {
  const std::string name = "task/" + std::to_string(index) + "/slider";
  double value = asked.value;
  if (!slider(name.c_str(), tr(std::string(asked.name).c_str()), value, asked.min, asked.max, asked.step,
              {asked.dimension, {decimals(1), {}}}))
    return;
  // Steps are multiples from zero, so that the displayed number is exactly the stored one.
  value = std::clamp(std::round(value / asked.step) * asked.step, asked.min, asked.max);
  app.lesson.session()->answerTask({.number = value});
}

}  // namespace moltact
