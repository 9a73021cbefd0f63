#include "engine/molecule/view_part.h"

#include <array>
#include <string>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::array kParts{
    ViewPartInfo{ViewPart::Atoms, "atoms", NC_("part of the picture", "Atoms"),
                 N_("the atoms as spheres of their van der Waals radii"), false},
    ViewPartInfo{ViewPart::Spheres, "spheres", NC_("part of the picture", "Faces"),
                 N_("the atoms' spheres inflated by the probe, which the hand feels"), true},
    ViewPartInfo{ViewPart::Circles, "circles", NC_("part of the picture", "Creases"),
                 N_("circles where two inflated spheres meet"), true},
    ViewPartInfo{ViewPart::Points, "points", NC_("part of the picture", "Pits"),
                 N_("points where three inflated spheres meet"), true},
    ViewPartInfo{ViewPart::Cones, "cones", NC_("part of the picture", "Cones"),
                 N_("the two cones that share the circle in use, with the atoms' centres as apexes"), true, true},
    ViewPartInfo{ViewPart::Facets, "facets", NC_("part of the picture", "Facets"),
                 N_("the triangles around the contact, for methods that use triangles"), true, true},
    ViewPartInfo{ViewPart::Hip, "hip", NC_("part of the picture", "Hand"),
                 N_("the position of the hand (haptic interface point, HIP)"), true},
    ViewPartInfo{ViewPart::Scp, "scp", NC_("part of the picture", "Contact point"),
                 N_("the position of the probe on the surface (surface contact point, SCP)"), true},
    ViewPartInfo{ViewPart::Force, "force", NC_("part of the picture", "Force"),
                 N_("an arrow for the force on the hand"), false},
    ViewPartInfo{ViewPart::Probe, "probe", NC_("part of the picture", "Probe"),
                 N_("the probe: a water molecule in its sphere"), false},
    ViewPartInfo{ViewPart::Target, "target", NC_("part of the picture", "Target"),
                 N_("the targets of a task: places to reach and marked atoms"), false},
};

}  // namespace

const char* ViewPartInfo::shownLabel() const { return trc("part of the picture", label); }

std::span<const ViewPartInfo> viewParts() { return kParts; }

ViewPartSet defaultViewParts() { return {ViewPart::Atoms, ViewPart::Force, ViewPart::Probe, ViewPart::Target}; }

Expected<ViewPartSet> parseViewParts(std::string_view names) {
  ViewPartSet set;
  while (!names.empty()) {
    const std::size_t comma = names.find(',');
    const std::string_view name = names.substr(0, comma);
    names = comma == std::string_view::npos ? std::string_view{} : names.substr(comma + 1);
    bool known = name == "none" || name.empty();
    for (const ViewPartInfo& p : kParts)
      if (name == p.name || name == "all" || (name == "haptic" && p.haptic)) {
        set.set(p.part);
        known = true;
      }
    if (known) continue;
    std::string list;
    for (const ViewPartInfo& p : kParts) list += (list.empty() ? "" : ", ") + std::string(p.name);
    return Problem{.file = {},
                   .message = trf("there is no shape named '{0}'", name),
                   .remedy = trf("the names are {0}, and the groups haptic, all and none", list)};
  }
  return set;
}

}  // namespace moltact
