// The drawing styles for atoms, with their names in lessons, menus and on the command line. Plain data; any thread
// except the haptic one.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace moltact {

/// A new style needs an enumerator here, a row of the table in draw_style.cpp and its shapes in shapesOf
/// (engine/render/style_shapes.cpp), which pictures and exported models share.
enum class DrawStyle : std::uint8_t { Spheres, Cartoon, BallAndStick, Sticks, Lines, Surface };

struct DrawStyleInfo {
  DrawStyle style;
  std::string_view name;      ///< as in `style: cartoon` of a scene and `--style cartoon`
  const char* label;          ///< in menus: "Cartoon"; untranslated (N_)
  const char* sentence;       ///< description for a tool tip and `--help`; untranslated (N_)
  bool uses_probe = false;    ///< the shapes depend on the scene's probe; surfaceOf computes them
  bool hides_places = false;  ///< opaque where the molecule is felt: hides the labels of points behind it

  /// The translated label.
  const char* shownLabel() const;
};

/// All styles, in menu order.
std::span<const DrawStyleInfo> drawStyles();

/// The row of a style.
const DrawStyleInfo& infoOf(DrawStyle style);
inline std::string_view nameOf(DrawStyle style) { return infoOf(style).name; }
/// Finds a style by name; nullptr if there is none.
const DrawStyleInfo* findDrawStyle(std::string_view name);

}  // namespace moltact
