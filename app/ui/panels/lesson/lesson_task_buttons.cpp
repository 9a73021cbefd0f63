#include <imgui.h>

#include <algorithm>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/panels/lesson/lesson_keys.h"
#include "app/ui/panels/lesson/lesson_task_parts.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/theme.h"
#include "engine/language/catalogue.h"

namespace moltact {

bool drawTaskButtons(Application& app, std::size_t index, const Task& task) {
  const std::vector<TaskButton> offered = task.buttons();
  if (offered.empty()) return false;
  const Look& l = look();
  const float gap = ImGui::GetStyle().ItemSpacing.x, room = ImGui::GetContentRegionAvail().x;
  std::string chosen;
  std::vector<std::string> labels;
  float widest = 0.0f;
  for (const TaskButton& b : offered) {
    labels.push_back(withKey(tr(b.label), b.key == '\n' ? "Enter" : std::string_view(&b.key, 1)));
    widest = std::max(widest, ImGui::CalcTextSize(labels.back().c_str()).x + l.px(28));
  }
  // Side by side if they fit, otherwise one below the other.
  const float count = float(offered.size()), each = (room - gap * (count - 1)) / count;
  const bool beside = widest <= each;
  for (std::size_t k = 0; k < offered.size(); ++k) {
    if (beside && k > 0) ImGui::SameLine();
    const bool first = k == 0 && offered[k].key == '\n';
    const std::string name = "task/" + std::to_string(index) + "/" + std::string(offered[k].word);
    if (button(name.c_str(), labels[k].c_str(), first ? ButtonLook::Primary : ButtonLook::Plain,
               beside ? each : room) ||
        lessonKeyOnItem(app, offered[k].key, name))
      chosen = offered[k].word;
  }
  if (chosen.empty()) return false;
  app.lesson.session()->answerTask({chosen});
  return true;
}

}  // namespace moltact
