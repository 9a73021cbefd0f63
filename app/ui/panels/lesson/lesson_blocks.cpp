#include "app/ui/panels/lesson/lesson_blocks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/glossary.h"
#include "engine/lesson/lesson_files.h"

namespace moltact {
namespace {

/// Draws `inner` with a margin on a background whose height is known only afterwards. `inner` receives its width.
template <class Inner>
void onGround(ImU32 ground, const Inner& inner) {
  const Look& l = look();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, pad = l.px(12);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->ChannelsSplit(2);
  draw->ChannelsSetCurrent(1);
  ImGui::SetCursorScreenPos({low.x + pad, low.y + pad});
  inner(low.x + pad, width - 2 * pad);
  const float end = ImGui::GetCursorScreenPos().y + pad - ImGui::GetStyle().ItemSpacing.y;
  draw->ChannelsSetCurrent(0);
  draw->AddRectFilled(low, {low.x + width, end}, ground, l.px(8));
  if (l.theme == ThemeChoice::HighContrast) draw->AddRect(low, {low.x + width, end}, l.palette.line, l.px(8));
  draw->ChannelsMerge();
  ImGui::SetCursorScreenPos({low.x, end});
  ImGui::Dummy({width, l.px(2)});
}

/// Draws the meaning of a glossary word. Returns a link that was clicked in it.
std::string drawWord(Application& app, const std::string& name, const GlossaryWord& word) {
  std::string link;
  bool closed = false;
  onGround(look().palette.accent_soft, [&](float x, float width) {
    const float y = ImGui::GetCursorScreenPos().y, side = look().tx(30);
    drawRichText((name + "/word").c_str(), {TextRun{.text = word.word, .bold = true}}, look().palette.text,
                 width - side);
    const ImVec2 below = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({x + width - look().tx(26), y - look().px(6)});
    closed = iconButton((name + "/close word").c_str(), Icon::Close, tr("Close the meaning"));
    ImGui::SetCursorScreenPos({x, below.y - look().px(4)});
    link = drawRichText((name + "/meaning").c_str(), word.meaning, look().palette.text, width);
  });
  if (closed) app.panels.lesson_memory.word = {};
  return link;
}

// Draws one block; one overload per kind of block.
struct BlockPainter {
  Application& app;
  std::string name;
  std::size_t& hint;  // the index of the next hint
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
    LessonSession& session = *app.lesson.session();
    bool open = mine < session.hintsOpen();
    // The key opens the next hint; a click opens this one and those before it.
    const std::string label = mine == session.hintsOpen() ? withKey(tr("Hint"), "H") : std::string(tr("Hint"));
    if (disclosure((name + "/hint").c_str(), label.c_str(), open)) session.openHints(open ? mine + 1 : mine);
    if (!open) return;
    onGround(l.palette.warn_soft, [&](float x, float width) {
      for (const RichText& p : tip.paragraphs) {
        ImGui::SetCursorScreenPos({x, ImGui::GetCursorScreenPos().y});
        if (std::string clicked = drawRichText((name + "/hint text").c_str(), p, l.palette.text, width);
            !clicked.empty())
          link = std::move(clicked);
      }
    });
  }

  void operator()(const TeacherNote& note) {
    if (!app.panels.lesson_memory.teacher_notes) return;
    const Look& l = look();
    onGround(l.palette.raised, [&](float x, float width) {
      {
        const WithFont small(Font::Small);
        drawRichText((name + "/teacher").c_str(), {TextRun{.text = tr("For the teacher"), .bold = true}},
                     l.palette.quiet, width);
      }
      for (std::size_t k = 0; k < note.paragraphs.size(); ++k) {
        ImGui::SetCursorScreenPos({x, ImGui::GetCursorScreenPos().y});
        const std::string part = name + "/note/" + std::to_string(k);
        if (std::string clicked = drawRichText(part.c_str(), note.paragraphs[k], l.palette.text, width);
            !clicked.empty())
          link = std::move(clicked);
      }
    });
  }

  void operator()(const Quote& quote) {
    const Look& l = look();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    for (const RichText& p : quote.paragraphs) text(p, l.palette.quiet, l.px(16));
    ImGui::GetWindowDrawList()->AddRectFilled(
        low, {low.x + l.px(3), ImGui::GetCursorScreenPos().y - ImGui::GetStyle().ItemSpacing.y}, l.palette.line);
  }

  void operator()(const Image& image) {
    const Look& l = look();
    const std::optional<FileLink> file = fileLink(app.lesson.file(), image.path);
    const LessonPictures::Shown* shown = file ? &app.extensions().lesson_pictures.find(file->file) : nullptr;
    if (!shown || !shown->texture) {
      // The description is shown until the picture is loaded, and if it cannot be loaded.
      text({TextRun{.text = image.description, .italic = true}}, l.palette.quiet);
      if (shown && !shown->fault.empty())
        drawRichText((name + "/fault").c_str(), {TextRun{.text = shown->fault}}, l.palette.bad);
      return;
    }
    const float room = ImGui::GetContentRegionAvail().x;
    const float width = std::min(room, l.px(float(shown->width_px)));
    const ImVec2 size{width, std::round(width * float(shown->height_px) / float(shown->width_px))};
    if (ImGui::InvisibleButton("picture", size)) {
      app.panels.lesson_memory.picture = {image.path, image.description};
      app.panels.pages.picture = true;
    }
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddImageRounded(shown->texture, low, high, {0, 0}, {1, 1}, IM_COL32_WHITE, l.px(6));
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    recordItem(name, trf("Picture: {0}", image.description));
    tip(tr("Show it large"));
    if (!image.caption.empty()) {
      const WithFont small(Font::Small);
      ImGui::PushTextWrapPos(0.0f);
      const WithText quiet(l.palette.quiet);
      ImGui::TextUnformatted(image.caption.c_str());
      ImGui::PopTextWrapPos();
      recordItem(name + "/caption", image.caption);
    }
  }

  void operator()(const Table& table) {
    if (std::string clicked = drawRichTable(name.c_str(), table, look().palette.text); !clicked.empty())
      link = std::move(clicked);
    ImGui::Spacing();
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
    LessonPanelMemory::Word& open = app.panels.lesson_memory.word;
    if (open.below == painter.name)
      if (const GlossaryWord* word = findWord(app.lesson.session()->lesson(), open.id))
        if (std::string clicked = drawWord(app, painter.name, *word); !clicked.empty())
          painter.link = std::move(clicked);
    // A click on a word opens its meaning below the block; a second click closes it.
    if (const auto id = wordLink(painter.link)) {
      open = open == LessonPanelMemory::Word{painter.name, *id} ? LessonPanelMemory::Word{}
                                                                : LessonPanelMemory::Word{painter.name, *id};
      painter.link.clear();
    }
    ImGui::PopID();
    if (!painter.link.empty()) link = painter.link;
  }
  return link;
}

}  // namespace moltact
