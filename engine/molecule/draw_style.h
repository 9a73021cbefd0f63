// The ways in which atoms are drawn: their names in lessons, menus and on the command line. Plain data; any thread but the
// haptic one.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace moltact {

/// A new style is a word here, a row of the table in draw_style.cpp and its shapes in shapesOf
/// (engine/render/style_shapes.cpp), which pictures and exported models share.
enum class DrawStyle : std::uint8_t { Spheres, Cartoon, BallAndStick, Sticks, Lines, Surface };

struct DrawStyleInfo {
  DrawStyle style;
  std::string_view name;      ///< as in `style: cartoon` of a scene and `--style cartoon`
  const char* label;          ///< "Cartoon", of menus, in English
  const char* sentence;       ///< what it shows, for a tool tip and for `--help`, in English
  bool uses_probe = false;    ///< its shapes depend on the scene's probe, and are made by surfaceOf
  bool hides_places = false;  ///< as solid as what is felt: a place behind it has no label

  /// The label in the language in use.
  const char* shownLabel() const;
};

/// All styles in the order in which they are offered.
std::span<const DrawStyleInfo> drawStyles();

/// The row of a style.
const DrawStyleInfo& infoOf(DrawStyle style);
inline std::string_view nameOf(DrawStyle style) { return infoOf(style).name; }
/// Null where there is none of that name.
const DrawStyleInfo* findDrawStyle(std::string_view name);

}  // namespace moltact
