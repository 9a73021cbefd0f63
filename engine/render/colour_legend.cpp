#include "engine/render/colour_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/core/utf8.h"
#include "engine/fonts/text_face.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/elements.h"
#include "engine/render/cartoon.h"
#include "engine/render/label_painter.h"
#include "engine/render/molecule_model.h"
#include "engine/render/picture_painter.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxEntries = 9;  // longer legends are truncated
constexpr double kLegendLine_px = 16.0, kGap_px = 5.0, kPadding_px = 10.0, kDot_px = 5.5, kMargin_px = 14.0;

// How an atom appears in the picture.
enum Seen : std::uint8_t { kNot, kInRibbon, kItself };

std::vector<std::uint8_t> seenAtoms(const Molecule& molecule, const AtomsLook& look) {
  std::vector<std::uint8_t> out(molecule.atoms.size(), look.styles.empty() ? kItself : kNot);
  std::vector<std::uint8_t> ribbon(molecule.atoms.size(), 0);
  for (const Residue& r : molecule.residues)
    if (inCartoon(r)) std::fill_n(ribbon.begin() + r.first_atom, r.atom_count, std::uint8_t{1});
  for (const StyledAtoms& style : look.styles) {
    const bool alone = style.style == DrawStyle::Cartoon && !(look.spheres_near_A > 0.0);
    const auto see = [&](std::uint32_t a) {
      out[a] = std::max<std::uint8_t>(out[a], alone && ribbon[a] ? kInRibbon : kItself);
    };
    if (!style.atoms)
      for (std::uint32_t a = 0; a < out.size(); ++a) see(a);
    else
      for (const std::uint32_t a : *style.atoms)
        if (a < out.size()) see(a);
  }
  if (look.hidden)
    for (const std::uint32_t a : *look.hidden)
      if (a < out.size()) out[a] = kNot;
  return out;
}

// Chains in order, then elements by decreasing frequency. If there are more chains than colours or than lines of a
// legend, only the elements are listed.
std::vector<LegendEntry> entriesOf(const Molecule& molecule, ColourBy by, ElementColours elements,
                                   const std::vector<std::uint8_t>& seen) {
  struct Counted {
    LegendEntry entry;
    std::size_t atoms = 0;
  };
  std::vector<LegendEntry> out;
  std::vector<Counted> others;
  std::array<std::size_t, kElementCount + 1> of_element{};
  std::vector<std::size_t> of_chain(molecule.chains.size());
  for (std::size_t k = 0; k < molecule.atoms.size(); ++k) {
    const Atom& a = molecule.atoms[k];
    if (seen[k] == kNot) continue;
    if (const auto chain = by == ColourBy::Chain ? colouredChain(molecule, a) : std::nullopt)
      ++of_chain[*chain];
    else if (seen[k] == kItself)
      ++of_element[std::min<std::size_t>(a.atomic_number, kElementCount)];
  }
  const auto chains = std::size_t(std::count_if(of_chain.begin(), of_chain.end(), [](std::size_t n) { return n > 0; }));
  for (std::size_t k = 0; k < of_chain.size() && chains <= std::min(kMaxEntries, kChainColours); ++k)
    if (of_chain[k]) out.push_back({chainColour(std::uint32_t(k)), trf("chain {0}", molecule.chains[k].name.string())});
  for (std::size_t k = 0; k < of_element.size(); ++k)
    if (of_element[k])
      others.push_back(
          {{elementColour(std::uint8_t(k), elements), std::string(tr(element(int(k)).name))}, of_element[k]});
  std::stable_sort(others.begin(), others.end(), [](const Counted& a, const Counted& b) { return a.atoms > b.atoms; });
  for (Counted& c : others) out.push_back(std::move(c.entry));
  return out;
}

// Entries of equal colour share a line, because a repeated colour would be ambiguous.
std::vector<LegendEntry> eachColourOnce(const std::vector<LegendEntry>& entries) {
  constexpr float kSame = 0.5f / 255.0f;
  std::vector<LegendEntry> out;
  for (const LegendEntry& e : entries) {
    const auto same = std::find_if(out.begin(), out.end(), [&](const LegendEntry& o) {
      return glm::all(glm::lessThan(glm::abs(o.colour - e.colour), glm::vec3(kSame)));
    });
    if (same == out.end())
      out.push_back(e);
    else if (same->name != e.name)
      same->name += (same->name.empty() || e.name.empty() ? "" : ", ") + e.name;
  }
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
    entries = entriesOf(molecule, by, shownColours(elements, molecule.atoms.size()), seenAtoms(molecule, look));
  }
  if (entries.size() > kMaxEntries) entries.resize(kMaxEntries);
  std::vector<LegendEntry> marks;
  if (look.marks)
    for (const OwnColour& mark : *look.marks)
      if (!mark.name.empty()) marks.push_back({colourOf(mark.colour), mark.name});
  entries.insert(entries.begin(), marks.begin(), marks.end());
  return eachColourOnce(entries);
}

const std::vector<LegendEntry>& LegendMemory::of(std::shared_ptr<const Molecule> molecule, ColourBy by,
                                                 ElementColours elements, const AtomsLook& look) {
  AtomsLook drawn = look;
  drawn.cut.reset();  // changes often and does not affect colours
  if (molecule != molecule_ || by != by_ || elements != elements_ || !(drawn == look_) || language() != language_) {
    molecule_ = std::move(molecule);
    by_ = by;
    elements_ = elements;
    look_ = std::move(drawn);
    language_ = language();
    entries_ = molecule_ ? legendOf(*molecule_, by, elements, look_) : std::vector<LegendEntry>();
  }
  return entries_;
}

bool paintLegend(Picture& picture, const std::vector<LegendEntry>& entries, const Theme& theme, double unit_px) {
  const TextFace face(kLegendLine_px * unit_px);
  if (!face.good()) return false;
  if (entries.empty()) return true;
  double wide = 0.0;
  for (const LegendEntry& e : entries) wide = std::max(wide, face.size(charactersOf(e.name)).first);
  const double pad = kPadding_px * unit_px, dot = kDot_px * unit_px, indent = 2 * dot + 8 * unit_px,
               line = (kLegendLine_px + kGap_px) * unit_px;
  const glm::dvec2 low(kMargin_px * unit_px),
      high = low + glm::dvec2(indent + wide + 2 * pad, line * double(entries.size()) - kGap_px * unit_px + 2 * pad);
  const LabelColours colours = labelColours(theme);
  PicturePainter paint(picture);
  paint.box(low, high, 8 * unit_px, colours.ground, 0.86);
  double y = low.y + pad;
  for (const LegendEntry& e : entries) {
    const glm::dvec2 centre{low.x + pad + dot, y + 0.5 * kLegendLine_px * unit_px};
    paint.disc(centre, dot + std::max(1.0, 0.8 * unit_px), colours.text, 0.45);
    paint.disc(centre, dot, e.colour, 1.0);
    face.draw(charactersOf(e.name), low.x + pad + indent, y,
              [&](int x, int y_px, float coverage) { paint.blend(x, y_px, colours.text, double(coverage)); });
    y += line;
  }
  return true;
}

}  // namespace moltact
