#include "engine/render/colour_legend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/utf8.h"
#include "engine/fonts/text_face.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/elements.h"
#include "engine/render/label_painter.h"
#include "engine/render/molecule_model.h"
#include "engine/render/picture_painter.h"

namespace moltact {
namespace {

constexpr std::size_t kMostEntries = 9;  // a molecule of more has the first ones
constexpr double kLine_px = 16.0, kGap_px = 5.0, kPadding_px = 10.0, kDot_px = 5.5, kMargin_px = 14.0;

// Chains in their order, then elements from the commonest to the rarest.
std::vector<LegendEntry> entriesOf(const Molecule& molecule, ColourBy by, ElementColours elements) {
  struct Counted {
    LegendEntry entry;
    std::size_t atoms = 0;
  };
  std::vector<LegendEntry> out;
  std::vector<Counted> others;
  std::array<std::size_t, kElementCount + 1> of_element{};
  std::vector<std::size_t> of_chain(molecule.chains.size());
  for (const Atom& a : molecule.atoms) {
    if (const auto chain = by == ColourBy::Chain ? colouredChain(molecule, a) : std::nullopt)
      ++of_chain[*chain];
    else
      ++of_element[std::min<std::size_t>(a.atomic_number, kElementCount)];
  }
  for (std::size_t k = 0; k < of_chain.size(); ++k)
    if (of_chain[k]) out.push_back({chainColour(std::uint32_t(k)), trf("chain {0}", molecule.chains[k].name.string())});
  for (std::size_t k = 0; k < of_element.size(); ++k)
    if (of_element[k])
      others.push_back(
          {{elementColour(std::uint8_t(k), elements), std::string(tr(element(int(k)).name))}, of_element[k]});
  std::stable_sort(others.begin(), others.end(), [](const Counted& a, const Counted& b) { return a.atoms > b.atoms; });
  for (Counted& c : others) out.push_back(std::move(c.entry));
  return out;
}

Colour colourOf(const Rgb8& c) { return Colour(c[0], c[1], c[2]) / 255.0f; }

}  // namespace

std::vector<LegendEntry> legendOf(const Molecule& molecule, ColourBy by, ElementColours elements,
                                  const AtomsLook& look) {
  std::vector<LegendEntry> entries;
  if (look.colouring) {
    for (const auto* list : {&look.colouring->legend.parts, &look.colouring->legend.entries})
      for (const Legend::Entry& e : *list) entries.push_back({colourOf(e.colour), e.name});
  } else {
    entries = entriesOf(molecule, by, elements);
  }
  if (entries.size() > kMostEntries) entries.resize(kMostEntries);
  std::vector<LegendEntry> marks;
  if (look.marks)
    for (const OwnColour& mark : *look.marks)
      if (!mark.name.empty()) marks.push_back({colourOf(mark.colour), mark.name});
  entries.insert(entries.begin(), marks.begin(), marks.end());
  return entries;
}

bool paintLegend(Picture& picture, const std::vector<LegendEntry>& entries, const Theme& theme, double unit_px) {
  const TextFace face(kLine_px * unit_px);
  if (!face.good()) return false;
  if (entries.empty()) return true;
  double wide = 0.0;
  for (const LegendEntry& e : entries) wide = std::max(wide, face.size(charactersOf(e.name)).first);
  const double pad = kPadding_px * unit_px, dot = kDot_px * unit_px, indent = 2 * dot + 8 * unit_px,
               line = (kLine_px + kGap_px) * unit_px;
  const glm::dvec2 low(kMargin_px * unit_px),
      high = low + glm::dvec2(indent + wide + 2 * pad, line * double(entries.size()) - kGap_px * unit_px + 2 * pad);
  const LabelColours colours = labelColours(theme);
  PicturePainter paint(picture);
  paint.box(low, high, 8 * unit_px, colours.ground, 0.86);
  double y = low.y + pad;
  for (const LegendEntry& e : entries) {
    const glm::dvec2 centre{low.x + pad + dot, y + 0.5 * kLine_px * unit_px};
    paint.disc(centre, dot + std::max(1.0, 0.8 * unit_px), colours.text, 0.45);
    paint.disc(centre, dot, e.colour, 1.0);
    face.draw(charactersOf(e.name), low.x + pad + indent, y,
              [&](int x, int y_px, float coverage) { paint.blend(x, y_px, colours.text, double(coverage)); });
    y += line;
  }
  return true;
}

}  // namespace moltact
