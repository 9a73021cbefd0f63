// Over the view's lower edge if the lesson's file has faults: a bar that opens the list of them, with line, problem and
// remedy. For authors; students do not see it in a lesson without errors.
#include <algorithm>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

std::string headline(const Application& app, const LessonWatch& watch) {
  const std::string file = watch.file().filename().string();
  const std::size_t errors = watch.errors(), warnings = watch.faults().size() - errors;
  const std::string problems = trnf("{0} problem", "{0} problems", errors, errors);
  if (!watch.shown(app.lesson)) return trf("{0} cannot be opened: {1}", file, problems);
  if (errors == 0) return trf("{0}: {1}", file, trnf("{0} warning", "{0} warnings", warnings, warnings));
  return watch.stale() ? trf("{0}: {1}. You see the last good version", file, problems)
                       : trf("{0}: {1}", file, problems);
}

std::string placeText(std::size_t line) { return line ? trf("Line {0}", line) : tr("File"); }

void drawFault(const LessonWatch::Fault& fault, std::size_t index, float place_w) {
  const Look& l = look();
  const Problem& p = fault.problem;
  const std::string place = placeText(p.line);
  const float left = ImGui::GetCursorPosX();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + l.px(5), at.y + 0.5f * line}, l.px(4),
                                              fault.error ? l.palette.bad : l.palette.warn, 16);
  ImGui::SetCursorPosX(left + l.px(18));
  {
    WithText quiet(l.palette.quiet);
    ImGui::TextUnformatted(place.c_str());
  }
  ImGui::SameLine(left + l.px(18) + place_w + l.px(12));
  ImGui::BeginGroup();
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(p.message.c_str());
  if (!p.remedy.empty()) {
    WithText quiet(l.palette.quiet);
    ImGui::TextUnformatted(p.remedy.c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::EndGroup();
  recordItem("lesson-problem/" + std::to_string(index), place + ": " + p.message + "; " + p.remedy);
}

}  // namespace

void drawLessonProblems(Application& app) {
  const LessonWatch& watch = app.extensions().lesson_watch;
  if (watch.faults().empty()) return;
  const Look& l = look();
  const Rectangle& seen = app.layout().view;
  const Rectangle view = seen.size().x > l.px(260) ? seen
                                                   : Rectangle{{0, app.layout().menu.high.y},
                                                               {app.layout().menu.high.x, app.layout().status.low.y}};
  const Palette& p = l.palette;
  const float margin = l.px(14), pad = l.px(10), side = l.px(12), button_w = l.tx(76);
  const float width = std::min(view.size().x - 2 * margin, l.tx(640));
  if (width < l.px(160)) return;
  const std::string text = headline(app, watch);
  const float text_w = width - 2 * side - button_w - l.px(12);
  const float text_h = ImGui::CalcTextSize(text.c_str(), nullptr, false, text_w).y, head = std::max(l.tx(34), text_h);
  // Keeps the line free in which the view describes the contact.
  const float bottom = view.high.y - (view.size().x > l.px(400) ? l.tx(62) : l.tx(84));
  const bool open = app.panels.lesson_memory.problems;
  const float most = std::max(l.px(90), 0.5f * view.size().y);
  const float height =
      open ? std::min(most, head + app.panels.lesson_memory.problems_height + 3 * pad) : head + 2 * pad;

  ImGui::SetNextWindowPos({0.5f * (view.low.x + view.high.x - width), bottom - height});
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, p.panel);
  ImGui::PushStyleColor(ImGuiCol_Border, faded(watch.errors() ? p.bad : p.warn, 0.6f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, l.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(1.0f, l.scale));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {side, pad});
  ImGui::Begin("lesson-problems", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNavFocus);
  const float top = ImGui::GetCursorPosY();
  ImGui::SetCursorPosY(top + 0.5f * (head - text_h));
  ImGui::PushTextWrapPos(side + text_w);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  recordItem("lesson-problems", text);
  ImGui::SetCursorPos({width - side - button_w, top + 0.5f * (head - l.tx(34))});
  if (button("lesson-problems/show", open ? tr("Hide") : tr("Show"), ButtonLook::Plain, button_w))
    app.panels.lesson_memory.problems = !open;
  if (open) {
    ImGui::SetCursorPosY(top + head + pad);
    ImGui::BeginChild("list", {0, 0});
    const float before = ImGui::GetCursorPosY();
    std::size_t most_line = 0;
    for (const LessonWatch::Fault& f : watch.faults()) most_line = std::max(most_line, f.problem.line);
    const float place_w = ImGui::CalcTextSize(placeText(most_line).c_str()).x;
    for (std::size_t k = 0; k < watch.faults().size(); ++k) drawFault(watch.faults()[k], k, place_w);
    app.panels.lesson_memory.problems_height = ImGui::GetCursorPosY() - before;
    ImGui::EndChild();
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
  ImGui::PopStyleColor(2);
}

}  // namespace moltact
