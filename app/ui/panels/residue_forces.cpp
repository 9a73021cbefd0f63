#include "app/ui/panels/residue_forces.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

bool mayShow(const Application& app) { return app.scene.forces().on() && mayNameAtoms(app); }

std::span<const EnergyShare> listed(const Application& app) {
  const std::vector<EnergyShare>& all = app.scene.forces().residues();
  return std::span(all).first(std::min(all.size(), kListedResidues));
}

std::string nameOf(const Molecule& molecule, std::uint32_t residue) {
  const AtomWords words = molecule.words(molecule.residues[residue].first_atom);
  const std::string& name = words.residue.empty() ? words.atom : words.residue;
  return words.chain.empty() || molecule.chains.size() < 2 ? name : name + " " + words.chain;
}

ImU32 packed(const Colour& c) { return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1.0f}); }

// The name at the left, the energy at the right, and between them a bar from the middle: to the left if the residue
// attracts.
void row(const std::string& name, double energy, double greatest, float name_width, float value_width) {
  const Look& l = look();
  const std::string value = numberText(energy, decimals(1));
  const float width = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeight(), gap = l.px(8);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const Theme theme = l.viewTheme();
  const ImU32 colour = packed(energy < 0.0 ? theme.attracts : theme.repels);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddText(low, l.palette.text, elided(name, name_width).c_str());
  draw->AddText({low.x + width - ImGui::CalcTextSize(value.c_str()).x, low.y}, l.palette.text, value.c_str());
  const float from = low.x + name_width + gap, to = low.x + width - value_width - gap, middle = 0.5f * (from + to),
              y = low.y + 0.5f * line, thick = l.px(6);
  if (to - from > l.px(16)) {
    const float end = middle + float(energy / greatest) * 0.5f * (to - from);
    draw->AddRectFilled({std::min(middle, end), y - 0.5f * thick}, {std::max(middle, end), y + 0.5f * thick}, colour,
                        l.px(2));
    draw->AddLine({middle, low.y}, {middle, low.y + line}, l.palette.quiet, 1.0f);
  }
  ImGui::Dummy({width, line});
}

}  // namespace

void drawResidueForces(Application& app) {
  if (!mayShow(app)) return;
  const std::span<const EnergyShare> rows = listed(app);
  ImGui::Spacing();
  sectionTitle(tr("Strongest residues"));
  const WithFont small(Font::Small);
  const Look& l = look();
  if (rows.empty()) {
    const WithText quiet(l.palette.quiet);
    ImGui::TextUnformatted(tr("None within reach"));
    recordItem("residue_forces", "");
    return;
  }
  const Molecule& molecule = *app.scene.stage().molecule;
  std::vector<std::string> names;
  double greatest = 0.0;
  float name_width = 0.0f, value_width = 0.0f;
  for (const EnergyShare& one : rows) {
    names.push_back(nameOf(molecule, one.index));
    greatest = std::max(greatest, std::abs(one.total_kcal_mol()));
    name_width = std::max(name_width, ImGui::CalcTextSize(names.back().c_str()).x);
    value_width = std::max(value_width, ImGui::CalcTextSize(numberText(one.total_kcal_mol(), decimals(1)).c_str()).x);
  }
  const float width = ImGui::GetContentRegionAvail().x;
  name_width = std::min(std::max(name_width, l.tx(110)), 0.5f * width);
  value_width = std::max(value_width, l.tx(36));
  // The heads of the columns.
  const char *attracts = tr("attract"), *repels = tr("repel");
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float gap = l.px(8), middle = low.x + 0.5f * (name_width + width - value_width);
  const Theme theme = l.viewTheme();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddText(low, l.palette.quiet, tr("kcal/mol"));
  draw->AddText({middle - gap - ImGui::CalcTextSize(attracts).x, low.y}, packed(theme.attracts), attracts);
  draw->AddText({middle + gap, low.y}, packed(theme.repels), repels);
  ImGui::Dummy({width, ImGui::GetTextLineHeight()});
  std::string all;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    row(names[k], rows[k].total_kcal_mol(), greatest, name_width, value_width);
    all += (all.empty() ? "" : "; ") + names[k] + " " + numberText(rows[k].total_kcal_mol(), decimals(1));
  }
  recordItem("residue_forces", all);
}

void showForces(const Application& app, ViewScene& scene) {
  if (!mayShow(app)) return;
  const Molecule& molecule = *app.scene.stage().molecule;
  for (const EnergyShare& one : listed(app)) {
    const Residue& residue = molecule.residues[one.index];
    const double energy = one.total_kcal_mol();
    auto& glowing = energy < 0.0 ? scene.attracting : scene.repelling;
    for (std::uint32_t a = residue.first_atom; a < residue.first_atom + residue.atom_count; ++a)
      glowing.push_back({a, std::abs(energy)});
  }
  scene.held_lines = app.scene.forces().drawnLines();
}

}  // namespace moltact
