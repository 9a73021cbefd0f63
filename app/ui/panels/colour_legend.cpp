// In the view's upper left corner where the colours of the atoms are not the customary ones: what each of them is.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/elements.h"
#include "engine/render/molecule_model.h"

namespace moltact {
namespace {

struct LegendEntry {
  Colour colour;
  std::string name;
  std::size_t atoms = 0;
};

constexpr std::size_t kMostEntries = 9;  // entries; a molecule of more has the commonest

// Chains in their order, then elements from the commonest to the rarest.
std::vector<LegendEntry> entriesOf(const Molecule& molecule, ColourBy by, ElementColours elements) {
  std::vector<LegendEntry> chains, others;
  std::array<std::size_t, kElementCount + 1> of_element{};
  std::vector<std::size_t> of_chain(molecule.chains.size());
  for (const Atom& a : molecule.atoms) {
    if (const auto chain = by == ColourBy::Chain ? colouredChain(molecule, a) : std::nullopt)
      ++of_chain[*chain];
    else
      ++of_element[std::min<std::size_t>(a.atomic_number, kElementCount)];
  }
  for (std::size_t k = 0; k < of_chain.size(); ++k)
    if (of_chain[k])
      chains.push_back(
          {chainColour(std::uint32_t(k)), trf("chain {0}", molecule.chains[k].name.string()), of_chain[k]});
  for (std::size_t k = 0; k < of_element.size(); ++k)
    if (of_element[k])
      others.push_back(
          {elementColour(std::uint8_t(k), elements), std::string(tr(element(int(k)).name)), of_element[k]});
  std::stable_sort(others.begin(), others.end(),
                   [](const LegendEntry& a, const LegendEntry& b) { return a.atoms > b.atoms; });
  chains.insert(chains.end(), others.begin(), others.end());
  return chains;
}

std::vector<LegendEntry> entriesOf(const Legend& legend) {
  std::vector<LegendEntry> entries;
  for (const auto* list : {&legend.parts, &legend.entries})
    for (const Legend::Entry& e : *list)
      entries.push_back({Colour(e.colour[0], e.colour[1], e.colour[2]) / 255.0f, e.name});
  return entries;
}

// What a scene marks with a name, and what was touched where that stays painted.
std::vector<LegendEntry> namedMarks(const Application& app) {
  std::vector<LegendEntry> entries;
  if (const auto& marks = app.scene.look.marks)
    for (const OwnColour& mark : *marks)
      if (!mark.name.empty())
        entries.push_back({Colour(mark.colour[0], mark.colour[1], mark.colour[2]) / 255.0f, mark.name});
  if (app.extensions().touch_traces.painted()) entries.push_back({look().viewTheme().touched, tr("touched")});
  return entries;
}

}  // namespace

void drawColourLegend(Application& app, const Rectangle& view) {
  const bool by_chain = app.scene.colour_by == ColourBy::Chain;
  const Colouring* const scheme = app.scene.look.colouring.get();
  const std::vector<LegendEntry> marked = namedMarks(app);
  if (!app.settings.legend || !(app.settings.colour_blind_safe || by_chain || scheme || !marked.empty()) ||
      !app.scene.shown.has(ViewPart::Atoms))
    return;
  const Look& l = look();
  std::vector<LegendEntry> entries =
      scheme ? entriesOf(scheme->legend)
             : entriesOf(*app.scene.stage().molecule, app.scene.colour_by, elementColoursOf(app.settings));
  if (entries.size() > kMostEntries) entries.resize(kMostEntries);
  entries.insert(entries.begin(), marked.begin(), marked.end());
  ViewScene marks;
  app.lesson.decorate(marks);
  if (!marks.highlighted.empty() && app.scene.shown.has(ViewPart::Target))
    entries.push_back({l.viewTheme().target, tr("marked"), marks.highlighted.size()});
  WithFont small(Font::Small);
  const float line = ImGui::GetFontSize() + l.px(5), pad = l.px(10), dot = 0.36f * ImGui::GetFontSize(),
              indent = 2 * dot + l.px(8);
  float wide = 0.0f;
  for (const LegendEntry& e : entries) wide = std::max(wide, ImGui::CalcTextSize(e.name.c_str()).x);
  const ImVec2 low{view.low.x + l.px(14), view.low.y + l.px(14)};
  const ImVec2 high{low.x + indent + wide + 2 * pad, low.y + line * float(entries.size()) - l.px(5) + 2 * pad};
  if (high.x > view.high.x - l.px(60) || high.y > view.high.y - l.px(80)) return;  // no room for it
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, faded(l.palette.panel, 0.88f), l.px(8));
  std::string text;
  float y = low.y + pad;
  for (const LegendEntry& e : entries) {
    const ImVec2 centre{low.x + pad + dot, y + 0.5f * ImGui::GetFontSize()};
    draw->AddCircleFilled(centre, dot, ImGui::ColorConvertFloat4ToU32({e.colour.x, e.colour.y, e.colour.z, 1.0f}), 24);
    draw->AddCircle(centre, dot, l.palette.quiet, 24, 1.0f);
    draw->AddText({low.x + pad + indent, y}, l.palette.text, e.name.c_str());
    text += (text.empty() ? "" : ", ") + e.name;
    y += line;
  }
  recordRectangle("view/legend", {low.x, low.y}, {high.x, high.y}, text);
}

}  // namespace moltact
