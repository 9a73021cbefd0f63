// Left: the lesson's step, its text, tasks and questions; Back and Next below.
#include <algorithm>
#include <string>

#include "app/ui/application.h"
#include "app/ui/controls.h"
#include "app/ui/panels/lesson_blocks.h"
#include "app/ui/theme.h"
#include "app/ui/widget_map.h"

namespace moltact {
namespace {

void drawHead(Application& app, const LessonSession& session) {
  const Look& l = look();
  const std::size_t count = session.lesson().steps.size(), at = session.stepIndex();
  {
    WithFont small(Font::Small);
    WithText quiet(l.palette.quiet);
    const std::string place = "Step " + std::to_string(at + 1) + " of " + std::to_string(count);
    const float place_w = ImGui::CalcTextSize(place.c_str()).x, width = ImGui::GetContentRegionAvail().x;
    ImGui::TextUnformatted(elided(session.lesson().title, width - place_w - l.px(12)).c_str());
    recordItem("lesson/title", session.lesson().title);
    ImGui::SameLine(ImGui::GetWindowContentRegionMin().x + width - place_w);
    ImGui::TextUnformatted(place.c_str());
    recordItem("lesson/place", place);
  }
  // A bar of steps: done, here, to come.
  const float width = ImGui::GetContentRegionAvail().x, gap = l.px(3), high = l.px(4);
  const float each = (width - gap * float(count - 1)) / float(count);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  for (std::size_t k = 0; k < count; ++k) {
    const float x = low.x + (each + gap) * float(k);
    const ImU32 colour = k == at ? l.palette.accent : session.stepDone(k) && k < at ? faded(l.palette.accent, 0.45f) : l.palette.pressed;
    ImGui::GetWindowDrawList()->AddRectFilled({x, low.y}, {x + std::max(1.0f, each), low.y + high}, colour, 0.5f * high);
  }
  ImGui::Dummy({width, high + l.px(6)});
  WithFont heading(Font::Heading);
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(session.step().title.c_str());
  ImGui::PopTextWrapPos();
  recordItem("lesson/step", session.step().title);
  (void)app;
}

void drawFoot(Application& app, const LessonSession& session) {
  const Look& l = look();
  const float width = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
  const float back_w = std::min(l.px(96), 0.4f * width);
  if (button("lesson/back", "Back", ButtonLook::Plain, back_w, session.hasBack())) app.lesson.back();
  ImGui::SameLine();
  const bool last = !session.hasNext();
  const char* label = last ? (session.finished() ? "Lesson done" : "Last step") : "Next";
  const ButtonLook kind = session.stepDone() ? ButtonLook::Primary : ButtonLook::Plain;
  if (button("lesson/next", label, last ? ButtonLook::Plain : kind, width - back_w - gap, !last)) app.lesson.next();
}

}  // namespace

void drawLessonPanel(Application& app) {
  LessonSession* session = app.lesson.session();
  if (!session || !beginPanel("lesson", app.layout.lesson, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) return;
  const Look& l = look();
  const float foot = l.px(34) + l.px(12);
  const std::size_t before = session->stepIndex();
  // A new step begins at its top.
  static std::size_t shown_step = ~std::size_t{0};
  ImGui::BeginChild("text", {0, -foot});
  if (shown_step != before) ImGui::SetScrollY(0.0f);
  shown_step = before;
  drawHead(app, *session);
  ImGui::Spacing();
  std::string link;
  if (before == 0) link = drawLessonBlocks(app, session->lesson().introduction, "lesson/intro");
  if (const std::string other = drawLessonBlocks(app, session->step().blocks, "lesson"); !other.empty()) link = other;
  ImGui::Dummy({0, l.px(10)});
  ImGui::EndChild();
  const float edge = ImGui::GetCursorScreenPos().y - l.px(3);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRectFullScreen();
  draw->AddLine({app.layout.lesson.low.x, edge}, {app.layout.lesson.high.x, edge}, l.palette.line, std::max(1.0f, l.scale));
  draw->PopClipRect();
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + l.px(4));
  drawFoot(app, *session);
  if (!link.empty() && !app.lesson.follow(link)) app.messages.notice("This link leads out of the lesson: " + link);
  endPanel();
}

}  // namespace moltact
