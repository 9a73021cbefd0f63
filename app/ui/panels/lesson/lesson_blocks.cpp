#include "app/ui/panels/lesson/lesson_blocks.h"

#include "app/ui/application/application.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

// Draws one block; each kind has its overload.
struct BlockPainter {
  Application& app;
  std::string name;
  std::size_t& hint;  // the number of the next one
  std::string link;

  void text(const RichText& t, ImU32 colour, float indent = 0.0f) {
    if (indent > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
    if (std::string clicked = drawRichText(name.c_str(), t, colour); !clicked.empty()) link = std::move(clicked);
  }

  void operator()(const Paragraph& p) { text(p.text, look().palette.text); }

  void operator()(const Subheading& s) {
    RichText bold = s.text;
    for (TextRun& run : bold) run.bold = true;
    ImGui::Spacing();
    text(bold, look().palette.text);
  }

  void operator()(const ListBlock& list) {
    const Look& l = look();
    for (const ListBlock::Item& item : list.items) {
      const float indent = l.px(20) * float(item.depth + 1);
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImDrawList* draw = ImGui::GetWindowDrawList();
      const float size = ImGui::GetFontSize();
      if (item.number > 0) {
        const std::string number = std::to_string(item.number) + ".";
        draw->AddText({at.x + indent - l.px(20), at.y}, l.palette.quiet, number.c_str());
      } else {
        draw->AddCircleFilled({at.x + indent - l.px(12), at.y + 0.52f * size}, l.px(2.5f), l.palette.accent, 16);
      }
      text(item.text, l.palette.text, indent);
    }
  }

  void operator()(const Tip& tip) {
    const Look& l = look();
    const std::size_t mine = hint++;
    bool open = mine < app.panels.hints;
    // The key opens the next one; a click this one and those before it.
    const std::string label = mine == app.panels.hints ? withKey(tr("Hint"), "H") : std::string(tr("Hint"));
    if (disclosure((name + "/hint").c_str(), label.c_str(), open)) app.panels.hints = open ? mine + 1 : mine;
    if (!open) return;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, pad = l.px(12);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    // The ground goes under text whose height is known only afterwards.
    draw->ChannelsSplit(2);
    draw->ChannelsSetCurrent(1);
    ImGui::SetCursorScreenPos({low.x + pad, low.y + pad});
    for (const RichText& p : tip.paragraphs) {
      ImGui::SetCursorScreenPos({low.x + pad, ImGui::GetCursorScreenPos().y});
      if (std::string clicked = drawRichText((name + "/hint text").c_str(), p, l.palette.text, width - 2 * pad);
          !clicked.empty())
        link = clicked;
    }
    const float end = ImGui::GetCursorScreenPos().y + pad - ImGui::GetStyle().ItemSpacing.y;
    draw->ChannelsSetCurrent(0);
    draw->AddRectFilled(low, {low.x + width, end}, l.palette.warn_soft, l.px(8));
    draw->ChannelsMerge();
    ImGui::SetCursorScreenPos({low.x, end});
    ImGui::Dummy({width, l.px(2)});
  }

  void operator()(const TeacherNote&) {}

  void operator()(const Quote& quote) {
    const Look& l = look();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    for (const RichText& p : quote.paragraphs) text(p, l.palette.quiet, l.px(16));
    ImGui::GetWindowDrawList()->AddRectFilled(
        low, {low.x + l.px(3), ImGui::GetCursorScreenPos().y - ImGui::GetStyle().ItemSpacing.y}, l.palette.line);
  }

  // Pictures belong to the page on a Git host; here the molecule itself is on the stage.
  void operator()(const Image& image) {
    if (image.description.empty()) return;
    text({TextRun{.text = image.description, .italic = true}}, look().palette.quiet);
  }

  void operator()(const CodeText& code) {
    WithText quiet(look().palette.quiet);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(code.text.c_str());
    ImGui::PopTextWrapPos();
  }

  void operator()(const TaskHere& task) { drawLessonTask(app, task.index); }

  void operator()(const QuestionHere& question) {
    if (std::string clicked = drawLessonQuestion(app, question.index); !clicked.empty()) link = std::move(clicked);
  }
};

}  // namespace

std::string drawLessonBlocks(Application& app, const std::vector<Block>& blocks, const std::string& prefix,
                             std::size_t hints_before) {
  std::string link;
  std::size_t hint = hints_before;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    ImGui::PushID(int(k));
    BlockPainter painter{app, prefix + "/" + std::to_string(k), hint, {}};
    std::visit(painter, blocks[k]);
    ImGui::PopID();
    if (!painter.link.empty()) link = painter.link;
  }
  return link;
}

}  // namespace moltact
