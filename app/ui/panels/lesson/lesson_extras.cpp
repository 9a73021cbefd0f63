#include "app/ui/panels/lesson/lesson_extras.h"

#include <vector>

#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/session.h"

namespace moltact {
namespace {

std::string drawOffers(const LessonSession& session, const std::string& name, const char* heading,
                       const std::vector<std::size_t>& steps) {
  if (steps.empty()) return {};
  const Look& l = look();
  ImGui::Dummy({0, l.px(6)});
  drawRichText(name.c_str(), {TextRun{.text = heading, .bold = true}}, l.palette.quiet);
  std::string clicked;
  for (const std::size_t s : steps) {
    const Step& step = session.lesson().steps[s];
    const bool done = session.stepSeen(s) && session.stepDone(s);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float size = ImGui::GetFontSize();
    if (done)
      drawIcon(ImGui::GetWindowDrawList(), Icon::Check, {at.x + l.px(8), at.y + 0.55f * size}, 0.8f * size,
               l.palette.good);
    else
      ImGui::GetWindowDrawList()->AddCircleFilled({at.x + l.px(8), at.y + 0.52f * size}, l.px(2.5f), l.palette.quiet,
                                                  16);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + l.px(22));
    const std::string link = drawRichText((name + "/" + step.id).c_str(),
                                          {TextRun{.text = step.title, .link = "#" + step.id}}, l.palette.text);
    if (!link.empty()) clicked = link;
  }
  return clicked;
}

}  // namespace

std::string drawExtrasOffered(const LessonSession& session) {
  if (session.step().aside) return {};
  return drawOffers(session, "lesson/extras", tr("More on this:"), session.lesson().extrasOf(session.stepIndex()));
}

std::string drawExtrasLeft(const LessonSession& session) {
  const std::vector<Step>& steps = session.lesson().steps;
  std::vector<std::size_t> left;
  for (std::size_t s = 0; s < steps.size(); ++s)
    if (steps[s].extra && !session.stepSeen(s)) left.push_back(s);
  return drawOffers(session, "lesson/extras left", tr("Steps that you have not seen yet:"), left);
}

}  // namespace moltact
