// View > Come close: the atoms to zoom to, typed as a selection or chosen from a list.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/selection.h"
#include "engine/molecule/elements.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxOffered = 6;

// The molecule's ligands by their names, as selections.
std::vector<std::string> ligandsOf(const Molecule& molecule) {
  std::vector<std::string> out;
  for (const Residue& r : molecule.residues) {
    if (r.kind != ResidueKind::Ligand) continue;
    std::string one = "ligand " + std::string(r.name);
    if (std::find(out.begin(), out.end(), one) == out.end()) out.push_back(std::move(one));
    if (out.size() == kMaxOffered) break;
  }
  return out;
}

// The selection for an element's name in the language in use or in English ("iron", "Eisen"); empty if it is not an
// element.
std::string elementNamed(std::string_view written) {
  const std::string name = lower(std::string(written));
  for (int k = 1; k <= kElementCount; ++k)
    if (const Element& e = element(k); name == lower(std::string(e.name)) || name == lower(std::string(tr(e.name))))
      return "element " + std::string(e.symbol);
  return {};
}

}  // namespace

void drawZoomPage(Application& app) {
  PanelState& panels = app.panels;
  const bool appears = panels.pages.zoom && !ImGui::IsPopupOpen("zoom");
  if (!beginPage("zoom", tr("Come close to atoms"), panels.pages.zoom, 520, 400)) return;
  const TouchableModel& stage = app.scene.stage();
  ImGui::TextWrapped(
      "%s",
      tr("Name an element, as iron, or atoms as a lesson does: residue 35 52, chain A, ligand, within 5\u00a0Å of "
         "(ligand)."));
  ImGui::Spacing();
  ImGui::SetNextItemWidth(-1.0f);
  bool asked = ImGui::InputText("##atoms", &panels.zoom_atoms, ImGuiInputTextFlags_EnterReturnsTrue);
  recordItem("zoom/atoms", panels.zoom_atoms);
  if (appears) writeInLastField("##atoms");
  std::string fault;
  std::vector<std::uint32_t> atoms;
  if (const std::string_view written = trimmed(panels.zoom_atoms); stage && !written.empty()) {
    const std::string by_name = elementNamed(written);
    const Expected<Selection> selection = parseSelection(by_name.empty() ? std::string(written) : by_name);
    if (selection) atoms = selection->select(*stage.molecule);
    if (atoms.empty()) {
      Problem why = selection ? selection->whyEmpty(*stage.molecule) : selection.problem();
      why.line = why.column = 0;
      fault = why.text();
    }
  }
  // Reserves two lines, so that nothing below moves during typing.
  const float y = ImGui::GetCursorPosY();
  {
    const WithText bad(look().palette.bad);
    ImGui::TextWrapped("%s", fault.c_str());
    recordItem("zoom/fault", fault);
  }
  ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), y + 2.2f * ImGui::GetTextLineHeightWithSpacing()));
  asked = button("zoom/go", tr("Come close"), ButtonLook::Primary, -1.0f, !atoms.empty()) || asked;
  std::string chosen;
  if (stage) {
    const std::vector<std::string> offered = ligandsOf(*stage.molecule);
    ImGui::Spacing();
    if (!offered.empty()) sectionTitle(tr("In this molecule"));
    float room = 0.0f;
    for (const std::string& one : offered) {
      const float width = ImGui::CalcTextSize(one.c_str()).x + look().px(36);
      if (room > width) ImGui::SameLine();
      if (button(("zoom/" + one).c_str(), one.c_str(), ButtonLook::Plain, width)) chosen = one;
      room = (room > width ? room : ImGui::GetContentRegionAvail().x) - width - ImGui::GetStyle().ItemSpacing.x;
    }
  }
  if (!chosen.empty()) panels.zoom_atoms = chosen;
  const bool go = asked && !atoms.empty();
  if (go) {
    panels.pages.zoom = false;
    ImGui::CloseCurrentPopup();
  }
  endPage();
  if (go) app.zoomTo(atoms);
}

}  // namespace moltact
