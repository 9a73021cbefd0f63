// The look: colours, spacing and fonts in one place. Window's thread. Units: pixel at 96 dpi, multiplied by the scale.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

#include "app/ui/widgets/theme_choice.h"
#include "engine/render/view_scene.h"

namespace moltact {

/// The colours that the panels draw with themselves; ImGui's own style is made from the same ones.
struct Palette {
  ImU32 ground;  ///< behind everything
  ImU32 panel;   ///< of a panel
  ImU32 raised;  ///< cards, buttons, fields
  ImU32 hovered, pressed;
  ImU32 line;                ///< borders and separators
  ImU32 text, quiet, faint;  ///< from first to last to be read
  ImU32 accent, accent_text, accent_soft;
  ImU32 good, good_soft, warn, warn_soft, bad, bad_soft;
};

enum class Font { Body, Strong, Italic, Small, Title, Heading, kCount };

struct Look {
  ThemeChoice theme = ThemeChoice::Light;
  float scale = 1.0f;  ///< the monitor's content scale times the person's preference
  float text = 1.0f;   ///< how much larger letters are than the scale alone makes them
  Palette palette{};
  ImFont* fonts[int(Font::kCount)] = {};

  /// Pixels at this scale, whole.
  float px(float at_96_dpi) const;
  /// The same for what holds text: it grows with the letters, too.
  float tx(float at_96_dpi) const;
  ImFont* font(Font f) const { return fonts[int(f)]; }
  /// The colours of the 3-D view.
  Theme viewTheme() const;
};

/// The look of the current frame.
const Look& look();

/// Has the signs of a text loaded, where the fonts hold them, before the next frame: of other scripts than those that
/// are always there. Cheap for what is.
void requestGlyphs(std::string_view utf8);
/// Whether there are signs that applyLook() is to load.
bool signsWanted();

/// Sets ImGui's style for a theme, a scale and a size of letters; loads the fonts again when these have changed.
/// Returns what could not be loaded (empty: all well); the built-in font stands in.
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
