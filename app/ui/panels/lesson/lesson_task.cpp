// A touch task in the lesson: a card with its state, the instruction, the next action and the progress.
#include <algorithm>
#include <cmath>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/files/library.h"
#include "app/ui/panels/lesson/lesson_blocks.h"
#include "app/ui/panels/lesson/lesson_keys.h"
#include "app/ui/panels/lesson/lesson_task_parts.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/figure_title.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

// Figures are shown in lessons above beginners' level, or if the details of the touch panel are open.
bool showsFigures(const Application& app) {
  const std::string& level = app.lesson.session()->lesson().level;
  return (!level.empty() && levelRank(level) > 0) || app.panels.touch_details;
}

// The measurements of this kind of task in one line. Time and force are left to the teacher's report.
void drawFigures(const std::string& name, const Task& task) {
  std::string line;
  for (const TaskFigure& f : task.ownFigures()) {
    if (f.value == 0.0 && f.unit.empty()) continue;  // no errors were counted
    line += (line.empty() ? "" : "  ·  ") + figureTitle(std::string(f.name)) + " " +
            quantityIn(f.value, f.unit, decimals(f.value == std::round(f.value) ? 0 : 2));
  }
  if (line.empty()) return;
  WithFont small(Font::Small);
  WithText quiet(look().palette.quiet);
  const float room = ImGui::GetContentRegionAvail().x;
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(wrapped(line, room).c_str());
  ImGui::PopTextWrapPos();
  recordItem(name + "/figures", line);
}

// One mark per trial: right, wrong or open.
void drawTrials(const std::string& name, const TaskTrials& trials) {
  if (trials.of == 0 || trials.right.empty()) return;
  const Look& l = look();
  const float room = ImGui::GetContentRegionAvail().x, each = std::min(l.px(22), room / float(trials.of)),
              half = 0.4f * each;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  std::string marks;
  for (std::size_t k = 0; k < trials.of; ++k) {
    const ImVec2 centre{low.x + each * (float(k) + 0.5f), low.y + 0.5f * each};
    if (k >= trials.right.size()) {
      draw->AddCircle(centre, half, l.palette.faint, 24, l.px(1.5f));
      continue;
    }
    const bool right = trials.right[k];
    draw->AddCircleFilled(centre, half, right ? l.palette.good : l.palette.bad, 24);
    drawIcon(draw, right ? Icon::Check : Icon::Close, centre, 1.3f * half, l.palette.panel);
    marks += right ? "+" : "-";
  }
  ImGui::Dummy({room, each});
  recordRectangle(name + "/trials", {low.x, low.y}, {low.x + each * float(trials.of), low.y + each}, marks);
}

}  // namespace

void drawLessonTask(Application& app, std::size_t index) {
  const Look& l = look();
  const Palette& p = l.palette;
  LessonSession& session = *app.lesson.session();
  if (index >= session.step().tasks.size()) return;
  const TaskStatus status = session.task(index);
  const std::string name = "task/" + std::to_string(index);
  const bool away = status.current && !app.lesson.onStage();
  const std::string& molecule = session.scene().molecule.name;
  const std::string next = !away           ? status.sentence
                           : app.loading() ? trf("Opening {0} …", molecule)
                                           : trf("This step uses {0}.", molecule);

  const float width = ImGui::GetContentRegionAvail().x, pad = l.px(12), mark = l.px(11);
  const float text_x = pad + 2 * mark + l.px(10), text_w = std::max(l.px(60), width - text_x - pad);
  const std::string say_lines = wrapped(status.say, text_w), next_lines = wrapped(next, text_w);
  const float say_h = ImGui::CalcTextSize(say_lines.c_str(), nullptr, false, text_w + 1).y,
              gap = next.empty() ? 0.0f : l.px(4);
  const float next_h = next.empty() ? 0.0f : ImGui::CalcTextSize(next_lines.c_str(), nullptr, false, text_w + 1).y;
  const bool bar = status.current && !away;
  const float say_y = std::max(0.0f, mark - 0.5f * ImGui::GetFontSize() - l.px(1));
  float height = std::max(say_y + say_h + gap + next_h, 2 * mark) + 2 * pad + (bar ? l.px(13) : 0.0f);
  if (status.current) {
    // The card keeps its height, so that content below does not move when the text changes.
    PanelState& panels = app.panels;
    const bool same = panels.lesson_memory.task == index && panels.lesson_memory.task_width == width;
    if (same) height = std::max(height, panels.lesson_memory.task_height);
    panels.lesson_memory.task_height = height;
    panels.lesson_memory.task_width = width;
  }
  const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + width, low.y + height};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, status.solved ? p.good_soft : status.current ? p.accent_soft : p.raised, l.px(8));

  const ImVec2 centre{low.x + pad + mark, low.y + pad + mark};
  if (status.done) {
    // If the tries are used up, the task is closed but not solved.
    draw->AddCircleFilled(centre, mark, status.solved ? p.good : p.faint, 32);
    drawIcon(draw, status.solved ? Icon::Check : Icon::Close, centre, l.px(15), p.panel);
  } else {
    draw->AddCircle(centre, mark - l.px(1), status.current ? p.accent : p.faint, 32, l.px(2));
    const float part = float(std::clamp(status.progress, 0.0, 1.0));
    if (status.current && part > 0) {
      draw->PathArcTo(centre, mark - l.px(1), -1.5708f, -1.5708f + 6.2832f * part, 32);
      draw->PathStroke(p.good, 0, l.px(3));
    }
  }
  const ImVec2 at{low.x + text_x, low.y + pad + say_y};
  const auto write = [&](const std::string& text, float y, ImU32 colour) {
    draw->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x, y}, colour, text.c_str(), nullptr, text_w + 1);
  };
  write(say_lines, at.y, status.current ? p.text : p.quiet);
  write(next_lines, at.y + say_h + gap, status.done ? p.text : p.quiet);
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
  if (status.current) app.panels.lesson_memory.task_y = at.y + say_h;
  ImGui::SetCursorScreenPos(low);
  ImGui::Dummy({width, height});
  if (const auto& wanted = app.panels.lesson_memory.wanted; wanted && wanted->task && wanted->index == index) {
    ImGui::SetScrollHereY(0.3f);
    app.panels.lesson_memory.wanted.reset();
  }
  // A task that becomes current is scrolled into view, except at the start of a step.
  if (status.current && app.panels.lesson_memory.task != index) {
    if (index > app.panels.lesson_memory.task && !ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.3f);
    app.panels.lesson_memory.task = index;
  }
  recordItem(name, (status.solved    ? "done: "
                    : status.done    ? "not solved: "
                    : status.current ? "current: "
                                     : "waiting: ") +
                       status.say + (next.empty() ? "" : "\n" + next));
  if (const Task* task = session.taskAt(index); task && !away) {
    if (status.current || status.done) drawTrials(name, task->trials());
    if (const auto asked = task->slider(); asked && status.current) drawTaskSlider(app, index, *asked);
    if (status.current) drawTaskButtons(app, index, *task);
    if (task->curves() && (status.current || status.done)) drawTaskCurve(app, index, *task->curves(), status.current);
    if (status.done && showsFigures(app)) drawFigures(name, *task);
  }
  if (away && !app.loading() &&
      (button((name + "/bring back").c_str(), withKey(trf("Bring {0} back", molecule), "Enter").c_str(),
              ButtonLook::Primary, width) ||
       lessonKeyOnItem(app, '\n', name + "/bring back")))
    app.lesson.askForScene();
}

}  // namespace moltact
