#include "app/ui/widgets/rich_text.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

ImFont* fontOf(const TextRun& run) {
  return look().font(run.bold || run.code ? Font::Strong : run.italic ? Font::Italic : Font::Body);
}

// The pen of one paragraph: where the next word goes.
struct Pen {
  ImVec2 start;
  float width, line_height;
  float x = 0.0f;
  int line = 0;

  void newLine() {
    x = 0.0f;
    ++line;
  }
  ImVec2 at() const { return {start.x + x, start.y + float(line) * line_height}; }
};

}  // namespace

std::string wrapped(const std::string& text, float width) {
  const std::string kept = withUnitsKept(text);
  std::string out;
  std::size_t line = 0;  // where the last line of `out` begins
  for (std::size_t at = 0; at < kept.size();) {
    const std::size_t end = std::min(kept.find_first_of(" \n", at + 1), kept.size());
    const std::string word = kept.substr(at, end - at);  // with what is before it
    if (word.front() == '\n') line = out.size() + 1;
    const bool first = out.size() <= line;
    if (!first && word.front() == ' ' && ImGui::CalcTextSize((out.substr(line) + word).c_str()).x > width) {
      out += '\n' + word.substr(1);
      line = out.size() - word.size() + 1;
    } else {
      out += word;
    }
    at = end;
  }
  return out;
}

std::string drawRichText(const char* name, const RichText& text, ImU32 colour, float width) {
  const Look& l = look();
  const float size = l.font(Font::Body)->FontSize;
  const ImVec2 start = ImGui::GetCursorScreenPos();
  Pen pen{start, width > 0 ? width : ImGui::GetContentRegionAvail().x, std::round(size * 1.28f)};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  std::string clicked;
  const bool usable = ImGui::IsWindowHovered();

  for (const TextRun& run : text) {
    ImFont* font = fontOf(run);
    const ImU32 ink = run.link.empty() ? colour : l.palette.accent;
    const std::string shown = run.code ? run.text : withUnitsKept(run.text);
    std::string_view rest = shown;
    ImVec2 link_low{1e9f, 1e9f}, link_high{-1e9f, -1e9f};
    bool link_hovered = false;
    while (!rest.empty()) {
      if (rest.front() == '\n') {
        pen.newLine();
        rest.remove_prefix(1);
        continue;
      }
      // A word with the spaces before it: the spaces vanish where the line breaks.
      const std::size_t spaces = std::min(rest.find_first_not_of(' '), rest.size());
      const std::size_t end = std::min(rest.find_first_of(" \n", spaces), rest.size());
      std::string_view word = rest.substr(spaces, end - spaces);
      const float space_w = float(spaces) * font->CalcTextSizeA(size, 1e9f, 0, " ").x;
      float word_w = font->CalcTextSizeA(size, 1e9f, 0, word.data(), word.data() + word.size()).x;
      if (pen.x > 0 && pen.x + space_w + word_w > pen.width)
        pen.newLine();
      else
        pen.x += pen.x > 0 ? space_w : 0.0f;
      rest.remove_prefix(end);
      // A word wider than the panel is broken within.
      while (word_w > pen.width && word.size() > 1) {
        const char* cut = nullptr;
        font->CalcTextSizeA(size, std::max(pen.width - pen.x, size), 0, word.data(), word.data() + word.size(), &cut);
        const std::size_t n = std::max<std::size_t>(1, std::size_t(cut - word.data()));
        if (n >= word.size()) break;
        draw->AddText(font, size, pen.at(), ink, word.data(), word.data() + n);
        word.remove_prefix(n);
        pen.newLine();
        word_w = font->CalcTextSizeA(size, 1e9f, 0, word.data(), word.data() + word.size()).x;
      }
      if (word.empty()) continue;
      const ImVec2 a = pen.at(), b{a.x + word_w, a.y + size};
      if (run.code)
        draw->AddRectFilled({a.x - l.px(2), a.y}, {b.x + l.px(2), b.y + l.px(1)}, l.palette.raised, l.px(3));
      draw->AddText(font, size, a, ink, word.data(), word.data() + word.size());
      if (!run.link.empty()) {
        draw->AddLine({a.x, b.y}, {b.x, b.y}, faded(ink, 0.6f), 1.0f);
        link_hovered = link_hovered || (usable && ImGui::IsMouseHoveringRect(a, b));
        if (link_low.x > 1e8f) {
          link_low = a;
          link_high = b;
        }
      }
      pen.x += word_w;
    }
    if (link_high.x > 0) {
      // An item only for the keys: the mouse may point at any of its words.
      const ImGuiID id = ImGui::GetID((std::string(name) + "/" + run.text).c_str());
      ImGui::ItemAdd({link_low, link_high}, id);
      recordControl(std::string(name) + "/" + run.text, {link_low.x, link_low.y}, {link_high.x, link_high.y}, run.link);
      if (GImGui->NavActivatePressedId == id) clicked = run.link;
    }
    if (link_hovered) {
      ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
      if (ImGui::IsMouseClicked(0)) clicked = run.link;
    }
  }
  const float height = float(pen.line) * pen.line_height + (pen.x > 0 || pen.line == 0 ? pen.line_height : 0.0f);
  ImGui::Dummy({pen.width, height});
  recordItem(name, plainText(text));
  return clicked;
}

}  // namespace moltact
