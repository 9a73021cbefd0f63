#include "app/ui/widgets/theme.h"

#include <imgui_freetype.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "engine/core/utf8.h"
#include "engine/fonts/font_files.h"
#include "engine/fonts/glyph_coverage.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

Look g_look;

constexpr ImU32 rgb(std::uint32_t hex) { return IM_COL32(hex >> 16 & 255u, hex >> 8 & 255u, hex & 255u, 255); }

Palette darkPalette() {
  return {.ground = rgb(0x12161C),
          .panel = rgb(0x181D25),
          .raised = rgb(0x232A35),
          .hovered = rgb(0x2D3643),
          .pressed = rgb(0x374252),
          .line = rgb(0x2B333F),
          .text = rgb(0xE8ECF2),
          .quiet = rgb(0xA3AEBD),
          .faint = rgb(0x76818F),
          .accent = rgb(0x3FB8AF),
          .accent_text = rgb(0x06201E),
          .accent_soft = rgb(0x1C3A3C),
          .good = rgb(0x58C48A),
          .good_soft = rgb(0x1B3429),
          .warn = rgb(0xE7B354),
          .warn_soft = rgb(0x3A3020),
          .bad = rgb(0xEF7B73),
          .bad_soft = rgb(0x41252A)};
}

Palette lightPalette() {
  return {.ground = rgb(0xEDF0F4),
          .panel = rgb(0xFBFCFD),
          .raised = rgb(0xEEF1F5),
          .hovered = rgb(0xE3E8EE),
          .pressed = rgb(0xD6DDE6),
          .line = rgb(0xDCE2E9),
          .text = rgb(0x1B2430),
          .quiet = rgb(0x55616F),
          .faint = rgb(0x7C8794),
          .accent = rgb(0x0E7F78),
          .accent_text = rgb(0xFFFFFF),
          .accent_soft = rgb(0xD9EFED),
          .good = rgb(0x1D8A55),
          .good_soft = rgb(0xDDF2E6),
          .warn = rgb(0x9A6700),
          .warn_soft = rgb(0xFBF0D4),
          .bad = rgb(0xC23B33),
          .bad_soft = rgb(0xFBE3E1)};
}

// Black and white, with borders around every control, and yellow for active ones.
Palette highContrastPalette() {
  return {.ground = rgb(0x000000),
          .panel = rgb(0x000000),
          .raised = rgb(0x1C1C1C),
          .hovered = rgb(0x3D3D3D),
          .pressed = rgb(0x5A5A5A),
          .line = rgb(0xFFFFFF),
          .text = rgb(0xFFFFFF),
          .quiet = rgb(0xF0F0F0),
          .faint = rgb(0xD0D0D0),
          .accent = rgb(0xFFE14D),
          .accent_text = rgb(0x000000),
          .accent_soft = rgb(0x3B3300),
          .good = rgb(0x5CFF9D),
          .good_soft = rgb(0x003D1C),
          .warn = rgb(0xFFC14D),
          .warn_soft = rgb(0x3D2900),
          .bad = rgb(0xFF9A94),
          .bad_soft = rgb(0x4D0800)};
}

Palette paletteOf(ThemeChoice theme) {
  return theme == ThemeChoice::Light  ? lightPalette()
         : theme == ThemeChoice::Dark ? darkPalette()
                                      : highContrastPalette();
}

ImVec4 v(ImU32 c) { return ImGui::ColorConvertU32ToFloat4(c); }

void applyColours(ImGuiStyle& style, const Palette& p) {
  ImVec4* c = style.Colors;
  const ImVec4 none(0, 0, 0, 0);
  c[ImGuiCol_Text] = v(p.text);
  c[ImGuiCol_TextDisabled] = v(p.faint);
  c[ImGuiCol_WindowBg] = v(p.panel);
  c[ImGuiCol_ChildBg] = none;
  c[ImGuiCol_PopupBg] = v(p.panel);
  c[ImGuiCol_Border] = v(p.line);
  c[ImGuiCol_BorderShadow] = none;
  c[ImGuiCol_FrameBg] = v(p.raised);
  c[ImGuiCol_FrameBgHovered] = v(p.hovered);
  c[ImGuiCol_FrameBgActive] = v(p.pressed);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = v(p.panel);
  c[ImGuiCol_MenuBarBg] = v(p.panel);
  c[ImGuiCol_ScrollbarBg] = none;
  c[ImGuiCol_ScrollbarGrab] = v(p.pressed);
  c[ImGuiCol_ScrollbarGrabHovered] = v(p.faint);
  c[ImGuiCol_ScrollbarGrabActive] = v(p.quiet);
  c[ImGuiCol_CheckMark] = v(p.accent);
  c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] = v(p.accent);
  c[ImGuiCol_Button] = v(p.raised);
  c[ImGuiCol_ButtonHovered] = v(p.hovered);
  c[ImGuiCol_ButtonActive] = v(p.pressed);
  c[ImGuiCol_Header] = v(p.accent_soft);
  c[ImGuiCol_HeaderHovered] = v(p.hovered);
  c[ImGuiCol_HeaderActive] = v(p.pressed);
  c[ImGuiCol_Separator] = v(p.line);
  c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = v(p.accent);
  c[ImGuiCol_TableBorderLight] = c[ImGuiCol_TableBorderStrong] = v(p.line);
  c[ImGuiCol_TextSelectedBg] = v(faded(p.accent, 0.35f));
  c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0.45f);
  c[ImGuiCol_NavHighlight] = none;  // keyStop() draws the ring
}

void applySpacing(ImGuiStyle& style, const Look& l) {
  style = ImGuiStyle();
  style.WindowPadding = {l.px(16), l.px(14)};
  style.FramePadding = {l.px(10), l.px(6)};
  style.ItemSpacing = {l.px(8), l.px(8)};
  style.ItemInnerSpacing = {l.px(8), l.px(6)};
  style.CellPadding = {l.px(6), l.px(4)};
  style.IndentSpacing = l.px(18);
  style.ScrollbarSize = l.px(11);
  style.GrabMinSize = l.px(12);
  style.WindowBorderSize = 0.0f;
  style.ChildBorderSize = style.PopupBorderSize = std::max(1.0f, std::round(l.scale));
  style.FrameBorderSize = l.theme == ThemeChoice::HighContrast ? style.ChildBorderSize : 0.0f;
  style.WindowRounding = 0.0f;
  style.ChildRounding = style.PopupRounding = l.px(8);
  style.FrameRounding = style.GrabRounding = l.px(6);
  style.ScrollbarRounding = l.px(6);
  style.WindowTitleAlign = {0.0f, 0.5f};
  style.WindowMinSize = {1.0f, 1.0f};
  style.MouseCursorScale = 1.0f;
}

// The characters of English, other Latin languages, Greek, primes, sub- and superscripts, arrows and simple
// mathematics.
constexpr ImWchar kText[] = {0x20, 0xFF, 0x100, 0x17F, 0x2010, 0x2044, 0};
constexpr ImWchar kSigns[] = {0x370,  0x3FF,  0x2070, 0x209C, 0x2190, 0x21FF, 0x2200,
                              0x2265, 0x25A0, 0x25FF, 0x2713, 0x2717, 0};

// The subset that titles need: H₂O.
constexpr ImWchar kScripts[] = {0x2070, 0x209C, 0};

// Other characters are loaded in pages of 128 when the first of a page is needed.
constexpr unsigned kPage = 128;
std::array<bool, 0x10000 / kPage> g_pages{};
bool g_pages_changed = false;

// ImGui's ranges: those that are always loaded, then the requested pages, terminated by 0.
std::vector<ImWchar> withPages(const ImWchar* always) {
  std::vector<ImWchar> out;
  for (; *always; ++always) out.push_back(*always);
  for (unsigned page = 0; page < g_pages.size(); ++page)
    if (g_pages[page]) {
      out.push_back(ImWchar(std::max(1u, page * kPage)));
      out.push_back(ImWchar(page * kPage + kPage - 1));
    }
  out.push_back(0);
  return out;
}

bool always(char32_t c) {
  for (const ImWchar* ranges : {kText, kSigns})
    for (; *ranges; ranges += 2)
      if (c >= ranges[0] && c <= ranges[1]) return true;
  return false;
}

std::string loadFonts(Look& l) {
  struct Face {
    const char* file;
    float size;
    bool signs;
  };
  static constexpr std::array<Face, int(Font::kCount)> kFaces{{{"Inter-Regular.otf", 16.0f, true},
                                                               {"Inter-SemiBold.otf", 16.0f, true},
                                                               {"Inter-Italic.otf", 16.0f, true},
                                                               {"Inter-Regular.otf", 14.0f, true},
                                                               {"Inter-SemiBold.otf", 19.0f, false},
                                                               {"Inter-SemiBold.otf", 25.0f, false}}};
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  io.Fonts->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  io.Fonts->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  // static, because ImGui reads the ranges later, when the atlas is built.
  static std::vector<ImWchar> text, signs, scripts;
  text = withPages(kText);
  signs = withPages(kSigns);
  scripts = withPages(kScripts);
  std::string missing;
  const std::string deja_vu = dejaVuFile().string();
  for (std::size_t k = 0; k < kFaces.size(); ++k) {
    const std::string file = interFile(kFaces[k].file).string();
    // ImGui's font size is ascent plus descent; Inter's em is 1 / 1.21 of it.
    const float size = std::round(kFaces[k].size * 1.19f * l.scale * l.text);
    ImFont* font = nullptr;
    if (std::filesystem::exists(file)) font = io.Fonts->AddFontFromFileTTF(file.c_str(), size, nullptr, text.data());
    if (!font) {
      if (missing.empty())
        missing = trf("{0} is missing, so the text looks plain; install the package fonts-inter", file);
      font = io.Fonts->AddFontDefault();
    } else if (std::filesystem::exists(deja_vu)) {
      ImFontConfig merge;
      merge.MergeMode = true;
      const std::vector<ImWchar>& more = kFaces[k].signs ? signs : scripts;
      io.Fonts->AddFontFromFileTTF(deja_vu.c_str(), size * 0.95f, &merge, more.data());
    }
    l.fonts[k] = font;
  }
  io.FontDefault = l.fonts[int(Font::Body)];
  return missing;
}

}  // namespace

float Look::px(float at_96_dpi) const { return std::round(at_96_dpi * scale); }

float Look::tx(float at_96_dpi) const { return std::round(at_96_dpi * scale * text); }

const Look& look() { return g_look; }

ImU32 faded(ImU32 colour, float alpha) {
  const ImU32 a = ImU32(float(colour >> IM_COL32_A_SHIFT & 255u) * alpha + 0.5f);
  return (colour & ~IM_COL32_A_MASK) | a << IM_COL32_A_SHIFT;
}

Theme Look::viewTheme() const {
  if (theme == ThemeChoice::Light) return lightTheme();
  Theme t = darkTheme();
  if (theme == ThemeChoice::HighContrast) {
    t.background_top = t.background_bottom = Colour(0.0f);
    t.scp = Colour(1.0f);
    t.fade = 0.3f;
    t.wire_strength = 1.4f;
  }
  return t;
}

void requestGlyphs(std::string_view utf8) {
  // Characters below U+0200 are always loaded.
  if (std::none_of(utf8.begin(), utf8.end(), [](char c) { return static_cast<unsigned char>(c) >= 0xC8; })) return;
  for (const char32_t c : charactersOf(utf8)) {
    if (c < 0x180 || c > 0xFFFF || g_pages[c / kPage] || always(c)) continue;
    if (GlyphCoverage::ofWindow().writable(c) != Writable::Yes) continue;
    g_pages[c / kPage] = g_pages_changed = true;
  }
}

bool signsWanted() { return g_pages_changed; }

std::string applyLook(ThemeChoice theme, float scale, float text) {
  std::string missing;
  const bool reload = std::exchange(g_pages_changed, false) || g_look.scale * g_look.text != scale * text ||
                      !ImGui::GetIO().Fonts->IsBuilt() || !g_look.fonts[0];
  g_look.theme = theme;
  g_look.scale = scale;
  g_look.text = text;
  g_look.palette = paletteOf(theme);
  applySpacing(ImGui::GetStyle(), g_look);
  applyColours(ImGui::GetStyle(), g_look.palette);
  if (reload) missing = loadFonts(g_look);
  return missing;
}

}  // namespace moltact
