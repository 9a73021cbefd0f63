#include "app/ui/panels/lesson/lesson_ends.h"

#include <string>

#include "app/ui/application/application.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

void drawGoals(const LessonSession& session) {
  const Look& l = look();
  for (std::size_t k = 0; k < session.lesson().goals.size(); ++k) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + l.px(8), at.y + 0.52f * ImGui::GetFontSize()}, l.px(2.5f),
                                                l.palette.accent, 16);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + l.px(22));
    drawRichText(("lesson/goal/" + std::to_string(k)).c_str(), {TextRun{.text = session.lesson().goals[k]}},
                 l.palette.text);
  }
}

}  // namespace

void drawLessonGoals(Application& app, const LessonSession& session) {
  if (session.lesson().goals.empty() || session.lesson().test) return;
  bool open = app.panels.lesson_memory.goals.value_or(false);
  if (disclosure("lesson/goals", tr("What you can do afterwards"), open)) app.panels.lesson_memory.goals = open;
  if (open) drawGoals(session);
  ImGui::Spacing();
}

void settleLessonGoals(Application& app, const LessonSession& session, float width, float text_height) {
  PanelState& panels = app.panels;
  if (panels.lesson_memory.goals) return;
  const bool begins = session.stepIndex() == 0 && session.visitedSteps().size() == 1 && session.parts().done == 0;
  float height = 0.0f;
  for (const std::string& goal : session.lesson().goals)
    height += richTextHeight({TextRun{.text = goal}}, width - look().px(22)) + ImGui::GetStyle().ItemSpacing.y;
  const float work = panels.lesson_memory.task_y > 0.0f ? panels.lesson_memory.task_y : panels.lesson_memory.question_y;
  const bool seen = work > 0.0f && work <= panels.lesson_memory.text_end;
  panels.lesson_memory.goals =
      begins && height <= 0.5f * text_height && (!seen || work + height <= panels.lesson_memory.text_end);
}

}  // namespace moltact
