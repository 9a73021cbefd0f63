#include "app/ui/widgets/controls.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

ImVec2 operator+(ImVec2 a, ImVec2 b) { return {a.x + b.x, a.y + b.y}; }
void drawText(ImVec2 at, ImU32 colour, const char* text) { ImGui::GetWindowDrawList()->AddText(at, colour, text); }

float buttonHeight() { return look().tx(34); }

}  // namespace

FieldAsHighAsButton::FieldAsHighAsButton() {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      {look().px(10), std::floor(0.5f * (buttonHeight() - ImGui::GetFontSize()))});
}

FieldAsHighAsButton::~FieldAsHighAsButton() { ImGui::PopStyleVar(); }

bool button(const char* name, const char* label, ButtonLook kind, float width, bool enabled) {
  const Palette& p = look().palette;
  ImU32 ground = p.raised, hovered = p.hovered, pressed = p.pressed, text = p.text;
  if (kind == ButtonLook::Primary) {
    ground = p.accent;
    hovered = faded(p.accent, 0.88f);
    pressed = faded(p.accent, 0.75f);
    text = p.accent_text;
  }
  ImGui::PushStyleColor(ImGuiCol_Button, ground);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, hovered);
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, pressed);
  ImGui::PushStyleColor(ImGuiCol_Text, text);
  ImGui::BeginDisabled(!enabled);
  ImGui::PushID(name);
  const float high = buttonHeight();
  if (kind == ButtonLook::Primary) ImGui::PushFont(look().font(Font::Strong));
  // A label that fills its button is centred and has less padding on both sides; ImGui would cut its end.
  const ImVec2 air = ImGui::GetStyle().FramePadding;
  const float text_w = ImGui::CalcTextSize(label, nullptr, true).x,
              given = width < 0.0f ? ImGui::GetContentRegionAvail().x + width : width;
  const bool tight = width != 0.0f && text_w + 2.0f * air.x > given;
  if (tight) ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {std::max(0.0f, 0.5f * (given - text_w)), air.y});
  const bool clicked = ImGui::Button(label, {width, high});
  if (tight) ImGui::PopStyleVar();
  if (text_w > ImGui::GetItemRectSize().x) widgets().noteCut(label);
  if (kind == ButtonLook::Primary) ImGui::PopFont();
  ImGui::PopID();
  ImGui::EndDisabled();
  ImGui::PopStyleColor(4);
  recordItem(name, label);
  return clicked;
}

bool iconButton(const char* name, Icon icon, const char* text, bool on, bool enabled) {
  const Palette& p = look().palette;
  const float size = look().px(30);
  ImGui::PushID(name);
  ImGui::BeginDisabled(!enabled);
  const bool clicked = ImGui::InvisibleButton("icon", {size, size});
  ImGui::EndDisabled();
  ImGui::PopID();
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  if (hovered || held || on)
    draw->AddRectFilled(low, high, held ? p.pressed : hovered ? p.hovered : p.accent_soft, look().px(6));
  drawIcon(draw, icon, {0.5f * (low.x + high.x), 0.5f * (low.y + high.y)}, look().px(16),
           !enabled  ? faded(p.faint, 0.5f)
           : on      ? p.accent
           : hovered ? p.text
                     : p.quiet);
  recordItem(name, text ? text : "");
  tip(text);
  return clicked;
}

bool toggle(const char* name, const char* label, bool& on, const char* text) {
  const Palette& p = look().palette;
  const float width = std::max(ImGui::GetContentRegionAvail().x, look().px(60)), high = look().tx(28);
  ImGui::PushID(name);
  const bool clicked = ImGui::InvisibleButton("toggle", {width, high});
  ImGui::PopID();
  if (clicked) on = !on;
  const bool hovered = ImGui::IsItemHovered();
  const ImVec2 low = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float track_w = look().px(34), track_h = look().px(19), middle = 0.5f * (low.y + end.y);
  const ImVec2 a{end.x - track_w, middle - 0.5f * track_h}, b{end.x, middle + 0.5f * track_h};
  draw->AddRectFilled(a, b, on ? p.accent : hovered ? p.faint : p.pressed, 0.5f * track_h);
  const float r = 0.5f * track_h - look().px(2.5f);
  draw->AddCircleFilled({on ? b.x - 0.5f * track_h : a.x + 0.5f * track_h, middle}, r, on ? p.accent_text : p.panel,
                        24);
  const std::string shown = elided(label, width - track_w - look().px(8));
  drawText({low.x, middle - 0.5f * ImGui::GetFontSize()}, p.text, shown.c_str());
  recordItem(name, on ? "on" : "off");
  tip(text);
  return clicked;
}

bool slider(const char* name, const char* label, double& value, double min, double max, double step,
            const ShownAs& shown_as, const char* text) {
  const Palette& p = look().palette;
  const float width = std::max(ImGui::GetContentRegionAvail().x, look().px(60));
  const float text_h = ImGui::GetFontSize(), track_h = look().px(4), knob = look().px(8), gap = look().px(7);
  const float high = text_h + gap + 2 * knob;
  ImGui::PushID(name);
  ImGui::InvisibleButton("slider", {width, high});
  ImGui::PopID();
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  const ImVec2 low = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
  const float x0 = low.x + knob, x1 = std::max(x0 + 1.0f, end.x - knob), y = end.y - knob;
  const double before = value;
  const auto snapped = [&](double v) { return std::clamp(min + std::round((v - min) / step) * step, min, max); };
  if (held && ImGui::IsMouseDown(0))
    value = snapped(min + (max - min) * double(std::clamp((ImGui::GetIO().MousePos.x - x0) / (x1 - x0), 0.0f, 1.0f)));
  if (const int notches = arrowsAtItem()) value = snapped(value + step * notches);
  if (hovered && !held && ImGui::GetIO().MouseWheel != 0.0f) {
    value = snapped(value + step * double(ImGui::GetIO().MouseWheel));
    ImGui::GetIO().MouseWheel = 0.0f;
  }

  ImDrawList* draw = ImGui::GetWindowDrawList();
  const std::string shown = quantityText(value * shown_as.code_units, shown_as.dimension, shown_as.how);
  const float value_w = ImGui::CalcTextSize(shown.c_str()).x;
  const std::string name_shown = elided(label, width - value_w - look().px(8));
  drawText(low, p.text, name_shown.c_str());
  drawText({end.x - value_w, low.y}, p.quiet, shown.c_str());
  const float at = x0 + (x1 - x0) * float(std::clamp((value - min) / (max - min), 0.0, 1.0));
  draw->AddRectFilled({x0, y - 0.5f * track_h}, {x1, y + 0.5f * track_h}, p.pressed, 0.5f * track_h);
  draw->AddRectFilled({x0, y - 0.5f * track_h}, {at, y + 0.5f * track_h}, p.accent, 0.5f * track_h);
  if (hovered || held) draw->AddCircleFilled({at, y}, knob + look().px(3), faded(p.accent, 0.2f), 32);
  draw->AddCircleFilled({at, y}, knob, p.accent, 32);
  draw->AddCircleFilled({at, y}, knob - look().px(2.5f), p.panel, 32);
  // A script aims at the track, not at the label.
  recordControl(name, {x0, y - knob}, {x1, y + knob}, shown);
  if (!held) tip(text);
  return value != before;
}

bool segments(const char* name, std::span<const std::string> labels, std::size_t& chosen) {
  const Palette& p = look().palette;
  const float width = ImGui::GetContentRegionAvail().x, high = look().tx(32), inset = look().px(3);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, low + ImVec2(width, high), p.raised, look().px(7));
  // Each choice has the width of its label and an equal share of the rest. If little room is left, labels are in small
  // type. If the labels do not fit, all widths are equal.
  const auto wordsWide = [&] {
    float words = 0.0f;
    for (const std::string& label : labels) words += ImGui::CalcTextSize(tr(label.c_str())).x;
    return words;
  };
  const float count = float(std::max<std::size_t>(1, labels.size()));
  const bool small = width - wordsWide() < count * look().px(14);
  if (small) ImGui::PushFont(look().font(Font::Small));
  const float rest = width - wordsWide();
  const bool fits = rest >= count * 2 * inset;
  float next = low.x;
  bool changed = false;
  ImGui::PushID(name);
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const float each = fits ? ImGui::CalcTextSize(tr(labels[k].c_str())).x + rest / count : width / count;
    ImGui::SetCursorScreenPos({next, low.y});
    next += each;
    ImGui::PushID(int(k));
    if (ImGui::InvisibleButton("segment", {each, high}) && chosen != k) {
      chosen = k;
      changed = true;
    }
    ImGui::PopID();
    const bool on = chosen == k;
    const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
    if (on || ImGui::IsItemHovered())
      draw->AddRectFilled(a + ImVec2(inset, inset), b + ImVec2(-inset, -inset), on ? p.accent : p.hovered,
                          look().px(5));
    const std::string shown = elided(tr(labels[k].c_str()), each - (fits ? 0.0f : 2 * inset));
    const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
    drawText({0.5f * (a.x + b.x - size.x), 0.5f * (a.y + b.y - size.y)}, on ? p.accent_text : p.quiet, shown.c_str());
    recordItem(std::string(name) + "/" + labels[k], on ? "on" : "off");
  }
  if (small) ImGui::PopFont();
  ImGui::PopID();
  return changed;
}

bool wordSegments(const char* name, std::span<const OfferedWord> words, std::string& word) {
  std::vector<std::string> titles;
  for (const OfferedWord& w : words) titles.emplace_back(w.title);
  auto chosen = std::size_t(
      std::find_if(words.begin(), words.end(), [&](const OfferedWord& w) { return w.name == word; }) - words.begin());
  const bool other = segments(name, titles, chosen);
  if (other) word = words[chosen].name;
  return other;
}

bool disclosure(const char* name, const char* label, bool& open) {
  const Palette& p = look().palette;
  const float width = ImGui::GetContentRegionAvail().x, high = look().tx(30);
  ImGui::PushID(name);
  const bool clicked = ImGui::InvisibleButton("disclosure", {width, high});
  ImGui::PopID();
  if (clicked) open = !open;
  const ImVec2 low = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
  const float middle = 0.5f * (low.y + end.y);
  const ImU32 colour = ImGui::IsItemHovered() ? p.text : p.quiet;
  drawIcon(ImGui::GetWindowDrawList(), open ? Icon::ChevronDown : Icon::ChevronRight, {low.x + look().px(6), middle},
           look().px(12), colour);
  const std::string shown = elided(label, width - look().px(20));
  drawText({low.x + look().px(20), middle - 0.5f * ImGui::GetFontSize()}, colour, shown.c_str());
  recordItem(name, open ? "open" : "closed");
  return clicked;
}

void progressBar(const char* name, float part, bool done) {
  const Palette& p = look().palette;
  const float high = look().px(5);
  ImGui::Dummy({ImGui::GetContentRegionAvail().x, high});
  const ImVec2 low = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, end, p.pressed, 0.5f * high);
  part = std::clamp(part, 0.0f, 1.0f);
  if (part > 0.0f)
    draw->AddRectFilled(low, {low.x + std::max(high, (end.x - low.x) * part), end.y}, done ? p.good : p.accent,
                        0.5f * high);
  recordItem(name, quantityText(double(part), Dimension::Share));
}

void sectionTitle(const char* label) {
  WithFont strong(Font::Strong);
  ImGui::TextUnformatted(label);
}

namespace {

// Places a tool tip where it covers no neighbour of its item: beside the panel, or below or above a bar. Without room
// there, ImGui places it.
void placeBesidePanel(const char* text) {
  const Look& l = look();
  const ImVec2 words = ImGui::CalcTextSize(text, nullptr, false, l.tx(280)), all = ImGui::GetIO().DisplaySize;
  const ImVec2 size{words.x + 2 * l.px(10), words.y + 2 * l.px(7)};
  const ImVec2 low = ImGui::GetWindowPos(), item_low = ImGui::GetItemRectMin(), item_high = ImGui::GetItemRectMax();
  const ImVec2 high{low.x + ImGui::GetWindowWidth(), low.y + ImGui::GetWindowHeight()};
  const float gap = l.px(8);
  const bool bar = high.y - low.y < 3 * (item_high.y - item_low.y);
  const float x = std::clamp(item_low.x, 0.0f, std::max(0.0f, all.x - size.x));
  const float y = std::clamp(item_low.y, 0.0f, std::max(0.0f, all.y - size.y));
  if (bar && all.y - high.y >= size.y + gap)
    ImGui::SetNextWindowPos({x, high.y + gap});
  else if (bar && low.y >= size.y + gap)
    ImGui::SetNextWindowPos({x, low.y - gap - size.y});
  else if (!bar && all.x - high.x >= size.x + gap)
    ImGui::SetNextWindowPos({high.x + gap, y});
  else if (!bar && low.x >= size.x + gap)
    ImGui::SetNextWindowPos({low.x - gap - size.x, y});
}

}  // namespace

void tip(const char* text) {
  if (!text || !*text || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  if (ImGui::GetCurrentContext() && ImGui::IsAnyMouseDown()) return;
  placeBesidePanel(text);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {look().px(10), look().px(7)});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(look().tx(280));
  ImGui::TextUnformatted(text);
  recordRectangle(
      "tip", glm::vec2(ImGui::GetWindowPos().x, ImGui::GetWindowPos().y),
      glm::vec2(ImGui::GetWindowPos().x + ImGui::GetWindowWidth(), ImGui::GetWindowPos().y + ImGui::GetWindowHeight()),
      text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

std::string elided(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  widgets().noteCut(text);
  std::string cut = text;
  while (!cut.empty()) {
    do cut.pop_back();
    while (!cut.empty() && (cut.back() & 0xC0) == 0x80);  // whole characters of UTF-8
    if (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0xC0) cut.pop_back();
    if (const std::string with = cut + "…"; ImGui::CalcTextSize(with.c_str()).x <= width) return with;
  }
  return {};
}

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoNavFocus;

void beginFixed(const char* name, const Rectangle& where, ImGuiWindowFlags flags) {
  ImGui::SetNextWindowPos({where.low.x, where.low.y});
  ImGui::SetNextWindowSize({where.size().x, where.size().y});
  ImGui::Begin(name, nullptr, kFixed | flags);
}

}  // namespace

bool beginPanel(const char* name, const Rectangle& where, ImGuiWindowFlags flags) {
  if (where.empty()) return false;
  beginFixed(name, where, ImGuiWindowFlags_NoBringToFrontOnFocus | flags);
  return true;
}

bool beginOverlay(const char* name, const Rectangle& where) {
  if (where.empty()) return false;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  beginFixed(name, where,
             ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  return true;
}

void endPanel() { ImGui::End(); }

bool beginPage(const char* name, const char* title, bool& open, float width, float height) {
  if (open && !ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float margin = look().px(16);
  ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(
      {std::min(look().tx(width), window.x - 2 * margin), std::min(look().tx(height), window.y - 2 * margin)});
  const float edge = look().theme == ThemeChoice::HighContrast ? ImGui::GetStyle().PopupBorderSize : 0.0f;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, look().px(10));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, edge);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {look().px(22), look().px(18)});
  const bool shown = ImGui::BeginPopupModal(name, nullptr,
                                            ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                                ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar(3);
  if (!shown) {
    open = false;
    return false;
  }
  {
    WithFont heading(Font::Title);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(title);
  }
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - look().px(38));
  ImGui::PushID(name);
  if (iconButton((std::string(name) + "/close").c_str(), Icon::Close, "Close (Esc)")) open = false;
  ImGui::PopID();
  if (ImGui::IsKeyPressed(ImGuiKey_Escape, false)) open = false;
  ImGui::Spacing();
  if (!open) ImGui::CloseCurrentPopup();
  return true;
}

void endPage() { ImGui::EndPopup(); }

}  // namespace moltact
