#include "app/ui/widgets/rich_text.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/glossary.h"

namespace moltact {
namespace {

ImFont* fontOf(const TextRun& run) {
  return look().font(run.bold || run.code ? Font::Strong : run.italic ? Font::Italic : Font::Body);
}

constexpr float kLineHeight = 1.28f;                // relative to the font size
constexpr float kScriptSize = 0.72f;                // font size of sub- and superscripts, relative to the text
constexpr float kLowered = 0.17f, kRaised = 0.36f;  // offsets of their baselines, relative to the font size

/// A word or a part of one, in a single style, at the place where it is drawn.
struct TextPiece {
  std::size_t run = 0;
  std::string text;
  ImFont* font = nullptr;
  float size = 0.0f;
  ImVec2 low{}, high{};  ///< relative to the text's upper left corner
  float down = 0.0f;     ///< offset of its letters below `low`
};

/// The text between two possible line breaks. It may contain parts of several runs without a space between them.
struct TextWord {
  float space = 0.0f;  ///< before the word, unless it begins a line
  float width = 0.0f;
  bool new_line = false;  ///< the author has put a line break before it
  std::vector<TextPiece> pieces;
};

struct LaidText {
  std::vector<TextPiece> pieces;
  float height = 0.0f;
};

float bodySize() { return look().font(Font::Body)->FontSize; }
float lineHeight() { return std::round(bodySize() * kLineHeight); }

float widthOf(const TextPiece& p) {
  return p.font->CalcTextSizeA(p.size, 1e9f, 0, p.text.data(), p.text.data() + p.text.size()).x;
}

std::vector<TextWord> wordsOf(const RichText& text) {
  std::vector<TextWord> out;
  bool apart = true, new_line = false;  // the next text begins a word
  float space = 0.0f;
  for (std::size_t r = 0; r < text.size(); ++r) {
    const TextRun& run = text[r];
    ImFont* font = fontOf(run);
    const float size = bodySize();
    const std::string shown = run.code || run.script != Script::None ? run.text : withUnitsKept(run.text);
    for (std::size_t at = 0; at < shown.size();) {
      if (shown[at] == '\n' || shown[at] == ' ') {
        if (shown[at] == '\n') {
          if (new_line) out.push_back({.new_line = true, .pieces = {}});  // an empty line
          new_line = true;
        }
        space += shown[at] == ' ' ? font->CalcTextSizeA(size, 1e9f, 0, " ").x : 0.0f;
        apart = true;
        ++at;
        continue;
      }
      const std::size_t end = std::min(shown.find_first_of(" \n", at), shown.size());
      if (apart) out.push_back({.space = space, .new_line = new_line, .pieces = {}});
      TextPiece piece{.run = r, .text = shown.substr(at, end - at), .font = font, .size = size};
      if (run.script != Script::None) {
        piece.size = std::round(kScriptSize * size);
        const float ascent = font->Ascent / font->FontSize;
        piece.down = (size - piece.size) * ascent + (run.script == Script::Sub ? kLowered : -kRaised) * size;
      }
      const float width = widthOf(piece);
      piece.low.x = out.back().width;
      piece.high.x = piece.low.x + width;
      out.back().width += width;
      out.back().pieces.push_back(std::move(piece));
      apart = new_line = false;
      space = 0.0f;
      at = end;
    }
  }
  return out;
}

// The place of the next word.
struct TextPen {
  float width;
  float x = 0.0f;
  int line = 0;

  void newLine() {
    x = 0.0f;
    ++line;
  }
  void put(TextPiece piece, LaidText& out) {
    const float wide = piece.high.x - piece.low.x;
    piece.low = {x, float(line) * lineHeight()};
    piece.high = {x + wide, piece.low.y + bodySize()};
    x += wide;
    out.pieces.push_back(std::move(piece));
  }
};

LaidText layOut(const RichText& text, float width) {
  LaidText out;
  TextPen pen{width};
  for (TextWord& word : wordsOf(text)) {
    if (word.new_line || (pen.x > 0 && pen.x + word.space + word.width > width))
      pen.newLine();
    else
      pen.x += pen.x > 0 ? word.space : 0.0f;
    const bool breaks = word.width > width;
    for (TextPiece& piece : word.pieces) {
      // A word wider than the panel is broken inside.
      while (breaks && pen.x + (piece.high.x - piece.low.x) > width && piece.text.size() > 1) {
        const char *begin = piece.text.data(), *end = begin + piece.text.size(), *cut = nullptr;
        piece.font->CalcTextSizeA(piece.size, std::max(width - pen.x, piece.size), 0, begin, end, &cut);
        // Do not break inside a UTF-8 character.
        std::size_t n = std::max<std::size_t>(1, std::size_t(cut - begin));
        while (n < piece.text.size() && (static_cast<unsigned char>(piece.text[n]) & 0xC0) == 0x80) ++n;
        if (n >= piece.text.size()) break;
        TextPiece part = piece;
        part.text.resize(n);
        part.low.x = 0.0f;
        part.high.x = widthOf(part);
        pen.put(std::move(part), out);
        pen.newLine();
        piece.text.erase(0, n);
        piece.low.x = 0.0f;
        piece.high.x = widthOf(piece);
      }
      pen.put(std::move(piece), out);
    }
  }
  out.height = float(pen.line) * lineHeight() + (pen.x > 0 || pen.line == 0 ? lineHeight() : 0.0f);
  return out;
}

void paintPiece(ImDrawList* draw, ImVec2 start, const TextPiece& p, const TextRun& run, ImU32 ink) {
  const Look& l = look();
  const ImVec2 a{start.x + p.low.x, start.y + p.low.y}, b{start.x + p.high.x, start.y + p.high.y};
  if (run.code) draw->AddRectFilled({a.x - l.px(2), a.y}, {b.x + l.px(2), b.y + l.px(1)}, l.palette.raised, l.px(3));
  draw->AddText(p.font, p.size, {a.x, a.y + p.down}, ink, p.text.data(), p.text.data() + p.text.size());
}

void underline(ImDrawList* draw, ImVec2 a, ImVec2 b, ImU32 ink, bool dotted) {
  const Look& l = look();
  if (!dotted) return draw->AddLine({a.x, b.y}, {b.x, b.y}, faded(ink, 0.6f), 1.0f);
  const float dot = std::max(1.0f, l.px(1.5f)), y = b.y + l.px(1);
  for (float x = a.x; x < b.x; x += 2.0f * dot) draw->AddRectFilled({x, y}, {std::min(x + dot, b.x), y + dot}, ink);
}

}  // namespace

std::string wrapped(const std::string& text, float width) {
  const std::string kept = withUnitsKept(text);
  std::string out;
  std::size_t line = 0;  // start of the last line of `out`
  for (std::size_t at = 0; at < kept.size();) {
    const std::size_t end = std::min(kept.find_first_of(" \n", at + 1), kept.size());
    const std::string word = kept.substr(at, end - at);  // including the blank before it
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

void drawWrapped(const char* name, const std::string& text) {
  ImGui::TextUnformatted(wrapped(text, ImGui::GetContentRegionAvail().x).c_str());
  recordItem(name, text);
}

std::string drawRichText(const char* name, const RichText& text, ImU32 colour, float width) {
  const Look& l = look();
  const ImVec2 start = ImGui::GetCursorScreenPos();
  if (width <= 0) width = ImGui::GetContentRegionAvail().x;
  const LaidText laid = layOut(text, width);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  std::string clicked;
  const bool usable = ImGui::IsWindowHovered();
  std::size_t k = 0;
  for (std::size_t r = 0; r < text.size(); ++r) {
    const TextRun& run = text[r];
    const bool word = wordLink(run.link).has_value();
    const ImU32 ink = run.link.empty() || word ? colour : l.palette.accent;
    const TextPiece* first = nullptr;
    bool link_hovered = false;
    for (; k < laid.pieces.size() && laid.pieces[k].run == r; ++k) {
      const TextPiece& p = laid.pieces[k];
      paintPiece(draw, start, p, run, ink);
      if (run.link.empty()) continue;
      const ImVec2 a{start.x + p.low.x, start.y + p.low.y}, b{start.x + p.high.x, start.y + p.high.y};
      underline(draw, a, b, word ? l.palette.accent : ink, word);
      link_hovered = link_hovered || (usable && ImGui::IsMouseHoveringRect(a, b));
      if (!first) first = &p;
    }
    if (first) {
      // An item for the keyboard only; the mouse can point at each of its words.
      const ImVec2 a{start.x + first->low.x, start.y + first->low.y},
          b{start.x + first->high.x, start.y + first->high.y};
      const ImGuiID id = ImGui::GetID((std::string(name) + "/" + run.text).c_str());
      ImGui::ItemAdd({a, b}, id);
      recordControl(std::string(name) + "/" + run.text, {a.x, a.y}, {b.x, b.y}, word ? run.text : run.link);
      if (GImGui->NavActivatePressedId == id) clicked = run.link;
    }
    if (link_hovered) {
      ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
      if (ImGui::IsMouseClicked(0)) clicked = run.link;
    }
  }
  ImGui::Dummy({width, laid.height});
  recordItem(name, plainText(text));
  return clicked;
}

void paintRichText(ImDrawList* draw, ImVec2 at, const RichText& text, ImU32 colour, float width) {
  for (const TextPiece& p : layOut(text, width).pieces) paintPiece(draw, at, p, text[p.run], colour);
}

float richTextHeight(const RichText& text, float width) {
  return layOut(text, width).height - (lineHeight() - bodySize());
}

RichTextWidths richTextWidths(const RichText& text) {
  RichTextWidths out;
  float line = 0.0f;
  for (const TextWord& word : wordsOf(text)) {
    line = word.new_line ? word.width : line + (line > 0 ? word.space : 0.0f) + word.width;
    out.min = std::max(out.min, word.width);
    out.whole = std::max(out.whole, line);
  }
  return out;
}

std::string drawRichTable(const char* name, const Table& table, ImU32 colour, float width) {
  const Look& l = look();
  const std::size_t columns = table.sides.size();
  if (columns == 0) return {};
  if (width <= 0) width = ImGui::GetContentRegionAvail().x;
  const float pad_x = l.px(8), pad_y = l.px(5), rule = std::max(1.0f, std::round(l.scale));
  const float room = std::max(1.0f, width - 2 * pad_x * float(columns));
  std::vector<RichTextWidths> wanted(columns);
  std::vector<std::vector<RichText>> rows = table.rows;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      if (r == 0)
        for (TextRun& run : rows[r][c]) run.bold = true;
      const RichTextWidths w = richTextWidths(rows[r][c]);
      wanted[c] = {std::max(wanted[c].min, w.min), std::max(wanted[c].whole, w.whole)};
    }
  float min = 0.0f, whole = 0.0f;
  for (const RichTextWidths& w : wanted) min += w.min, whole += w.whole;
  std::vector<float> wide(columns);
  for (std::size_t c = 0; c < columns; ++c) {
    const RichTextWidths& w = wanted[c];
    // If all texts fit on one line, each column has its full width. Otherwise the room beyond the widest words is
    // divided by the lengths of the texts. If even the widest words do not fit, words are broken.
    wide[c] = whole <= room ? w.whole
              : min <= room ? w.min + (room - min) * (w.whole - w.min) / std::max(1.0f, whole - min)
                            : room * w.min / min;
    wide[c] = std::max(1.0f, std::ceil(wide[c]));
  }
  std::string clicked;
  const ImVec2 start = ImGui::GetCursorScreenPos();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  float y = start.y, all_wide = 0.0f;
  for (const float w : wide) all_wide += w + 2 * pad_x;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    float high = bodySize();
    for (std::size_t c = 0; c < columns; ++c) high = std::max(high, richTextHeight(rows[r][c], wide[c] + 0.5f));
    if (r == 0)
      draw->AddRectFilled({start.x, y}, {start.x + all_wide, y + high + 2 * pad_y}, l.palette.raised, l.px(4),
                          ImDrawFlags_RoundCornersTop);
    float x = start.x;
    for (std::size_t c = 0; c < columns; ++c) {
      const float free = std::max(0.0f, wide[c] - richTextWidths(rows[r][c]).whole);
      const float shift = table.sides[c] == Table::Side::Right    ? free
                          : table.sides[c] == Table::Side::Middle ? std::floor(0.5f * free)
                                                                  : 0.0f;
      ImGui::SetCursorScreenPos({x + pad_x + shift, y + pad_y});
      const std::string cell = std::string(name) + "/" + std::to_string(r) + "/" + std::to_string(c);
      ImGui::PushID(int(r * columns + c));
      if (std::string link = drawRichText(cell.c_str(), rows[r][c], colour, wide[c] - shift + 0.5f); !link.empty())
        clicked = std::move(link);
      ImGui::PopID();
      x += wide[c] + 2 * pad_x;
    }
    y += high + 2 * pad_y;
    draw->AddRectFilled({start.x, y}, {start.x + all_wide, y + rule}, r == 0 ? l.palette.faint : l.palette.line);
    y += rule;
  }
  ImGui::SetCursorScreenPos(start);
  ImGui::Dummy({all_wide, y - start.y});
  return clicked;
}

}  // namespace moltact
