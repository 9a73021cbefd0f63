#include "engine/render/view_scene.h"

#include <algorithm>
#include <array>
#include <string>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::array kShapes{
    ShapeName{Shape::Atoms, "atoms", N_("the atoms as balls of their van der Waals radii"), false},
    ShapeName{Shape::Spheres, "spheres", N_("the atoms' spheres inflated by the probe, which the hand feels"), true},
    ShapeName{Shape::Circles, "circles", N_("circles where two inflated spheres meet"), true},
    ShapeName{Shape::Points, "points", N_("points where three inflated spheres meet"), true},
    ShapeName{Shape::Cones, "cones",
              N_("the two cones that share the circle in use, with the atoms' centres as apexes"), true},
    ShapeName{Shape::Facets, "facets",
              N_("the triangles round the contact, while a method that feels triangles is in use"), true},
    ShapeName{Shape::Hip, "hip", N_("the haptic interface point: where the hand is"), true},
    ShapeName{Shape::Scp, "scp", N_("the surface contact point: the hand's proxy on the surface"), true},
    ShapeName{Shape::Force, "force", N_("an arrow for the force on the hand"), false},
    ShapeName{Shape::Probe, "probe", N_("the probe: a water molecule in its sphere"), false},
    ShapeName{Shape::Target, "target", N_("what a task asks for: places to reach and marked atoms"), false},
};

constexpr Colour hex(std::uint32_t rgb) {
  return {float(rgb >> 16 & 255) / 255.0f, float(rgb >> 8 & 255) / 255.0f, float(rgb & 255) / 255.0f};
}

}  // namespace

std::span<const ShapeName> shapeNames() { return kShapes; }

ShapeSet defaultShapes() { return {Shape::Atoms, Shape::Force, Shape::Probe, Shape::Target}; }

Expected<ShapeSet> parseShapes(std::string_view names) {
  ShapeSet set;
  while (!names.empty()) {
    const std::size_t comma = names.find(',');
    const std::string_view name = names.substr(0, comma);
    names = comma == std::string_view::npos ? std::string_view{} : names.substr(comma + 1);
    bool known = name == "none" || name.empty();
    for (const ShapeName& s : kShapes)
      if (name == s.name || name == "all" || (name == "haptic" && s.haptic)) {
        set.set(s.shape);
        known = true;
      }
    if (known) continue;
    std::string list;
    for (const ShapeName& s : kShapes) list += (list.empty() ? "" : ", ") + std::string(s.name);
    return Problem{.file = {},
                   .message = trf("there is no shape named '{0}'", name),
                   .remedy = trf("the names are {0}, and the groups haptic, all and none", list)};
  }
  return set;
}

Theme darkTheme() {
  return {.background_top = hex(0x232B38),
          .background_bottom = hex(0x0D1117),
          .surface = hex(0x7FC4E8),
          .in_use = hex(0xFFD166),
          .hip = hex(0xFF5D8F),
          .scp = hex(0xFFFFFF),
          .force = hex(0x3DDC97),
          .probe = hex(0xA9D6F5),
          .target = hex(0xFFB000),
          .wire_strength = 1.0f,
          .fade = 0.6f};
}

Theme lightTheme() {
  return {.background_top = hex(0xFFFFFF),
          .background_bottom = hex(0xDDE4EC),
          .surface = hex(0x1E5F8C),
          .in_use = hex(0xC2410C),
          .hip = hex(0xD6246E),
          .scp = hex(0x101820),
          .force = hex(0x0B8457),
          .probe = hex(0x2F78B4),
          .target = hex(0xE07A00),
          .wire_strength = 1.25f,
          .fade = 0.42f};
}

}  // namespace moltact
