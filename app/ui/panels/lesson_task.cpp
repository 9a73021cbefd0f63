// A touch task in the lesson: a card with a mark, what to do next, and how far the student has come.
#include <algorithm>
#include <string>

#include "app/ui/application.h"
#include "app/ui/controls.h"
#include "app/ui/panels/lesson_blocks.h"
#include "app/ui/theme.h"
#include "app/ui/widget_map.h"

namespace moltact {

void drawLessonTask(Application& app, std::size_t index) {
  const Look& l = look();
  const Palette& p = l.palette;
  LessonSession& session = *app.lesson.session();
  if (index >= session.step().tasks.size()) return;
  const TaskStatus status = session.task(index);
  const std::string name = "task/" + std::to_string(index);
  const std::string sentence = !status.sentence.empty() ? status.sentence : status.done ? "Done." : "This comes after the task before it.";

  const float width = ImGui::GetContentRegionAvail().x, pad = l.px(12), mark = l.px(11);
  const float text_x = pad + 2 * mark + l.px(10), text_w = std::max(l.px(60), width - text_x - pad);
  const ImVec2 size = ImGui::CalcTextSize(sentence.c_str(), nullptr, false, text_w);
  const bool bar = status.current && !status.done;
  const float height = std::max(size.y, 2 * mark) + 2 * pad + (bar ? l.px(13) : 0.0f);
  const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + width, low.y + height};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, status.done ? p.good_soft : status.current ? p.accent_soft : p.raised, l.px(8));

  const ImVec2 centre{low.x + pad + mark, low.y + pad + mark};
  if (status.done) {
    draw->AddCircleFilled(centre, mark, p.good, 32);
    drawIcon(draw, Icon::Check, centre, l.px(15), p.panel);
  } else {
    draw->AddCircle(centre, mark - l.px(1), status.current ? p.accent : p.faint, 32, l.px(2));
    const float part = float(std::clamp(status.progress, 0.0, 1.0));
    if (status.current && part > 0) {
      draw->PathArcTo(centre, mark - l.px(1), -1.5708f, -1.5708f + 6.2832f * part, 32);
      draw->PathStroke(p.good, 0, l.px(3));
    }
  }
  draw->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + text_x, low.y + pad + std::max(0.0f, mark - 0.5f * ImGui::GetFontSize() - l.px(1))},
                status.current || status.done ? p.text : p.quiet, sentence.c_str(), nullptr, text_w);
  if (bar) {
    ImGui::SetCursorScreenPos({low.x + text_x, high.y - pad - l.px(3)});
    ImGui::BeginGroup();
    ImGui::PushItemWidth(text_w);
    const ImVec2 a{low.x + text_x, high.y - pad - l.px(4)}, b{high.x - pad, high.y - pad + l.px(1)};
    draw->AddRectFilled(a, b, p.pressed, l.px(2));
    const float part = float(std::clamp(status.progress, 0.0, 1.0));
    if (part > 0) draw->AddRectFilled(a, {a.x + std::max(b.y - a.y, (b.x - a.x) * part), b.y}, p.accent, l.px(2));
    ImGui::PopItemWidth();
    ImGui::EndGroup();
  }
  ImGui::SetCursorScreenPos(low);
  ImGui::Dummy({width, height});
  recordItem(name, (status.done ? "done: " : status.current ? "current: " : "waiting: ") + sentence);
}

}  // namespace moltact
