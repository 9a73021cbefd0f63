// Colours, spacing and fonts of the window. Window's thread. Units: pixel at 96 dpi, multiplied by the scale.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

#include "app/ui/widgets/theme_choice.h"
#include "engine/render/view_scene.h"

namespace moltact {

/// The colours that the panels use directly. ImGui's style is made from the same colours.
struct Palette {
  ImU32 ground;  ///< the window's background
  ImU32 panel;   ///< a panel's background
  ImU32 raised;  ///< cards, buttons, fields
  ImU32 hovered, pressed;
  ImU32 line;                ///< borders and separators
  ImU32 text, quiet, faint;  ///< in order of importance
  ImU32 accent, accent_text, accent_soft;
  ImU32 good, good_soft, warn, warn_soft, bad, bad_soft;
};

enum class Font { Body, Strong, Italic, Small, Title, Heading, kCount };

struct Look {
  ThemeChoice theme = ThemeChoice::Light;
  float scale = 1.0f;  ///< the monitor's content scale times the user's setting
  float text = 1.0f;   ///< additional factor for the size of text
  Palette palette{};
  ImFont* fonts[int(Font::kCount)] = {};

  /// Converts to whole pixels at this scale.
  float px(float at_96_dpi) const;
  /// The same for controls that hold text: they grow with the text size too.
  float tx(float at_96_dpi) const;
  ImFont* font(Font f) const { return fonts[int(f)]; }
  /// The colours of the 3-D view.
  Theme viewTheme() const;
};

/// The look of the current frame.
const Look& look();

/// Loads the characters of a text before the next frame if the fonts contain them. Needed for scripts that are not
/// loaded by default; cheap for characters that are.
void requestGlyphs(std::string_view utf8);
/// Whether applyLook() has characters to load.
bool signsWanted();

/// Sets ImGui's style for a theme, a scale and a text size; reloads the fonts if these have changed. Returns a message
/// about fonts that could not be loaded, empty on success; the built-in font replaces them.
std::string applyLook(ThemeChoice theme, float scale, float text);

/// The same colour, more transparent.
ImU32 faded(ImU32 colour, float alpha);

/// Pushes a font until the end of the scope.
class WithFont {
 public:
  explicit WithFont(Font f) { ImGui::PushFont(look().font(f)); }
  ~WithFont() { ImGui::PopFont(); }
  WithFont(const WithFont&) = delete;
  WithFont& operator=(const WithFont&) = delete;
};

/// Pushes a text colour until the end of the scope.
class WithText {
 public:
  explicit WithText(ImU32 colour) { ImGui::PushStyleColor(ImGuiCol_Text, colour); }
  ~WithText() { ImGui::PopStyleColor(); }
  WithText(const WithText&) = delete;
  WithText& operator=(const WithText&) = delete;
};

}  // namespace moltact
