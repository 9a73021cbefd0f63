// A tab beside the view, on request: whether the molecule gives way to the hand as an elastic network, and the network's
// modes, each shown as a movement or felt alone.
#include <imgui.h>

#include <algorithm>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/elastic_molecule.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/while_locked.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/haptics/field/pair_model.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

constexpr std::size_t kListed = 6;

void line(const char* name, const std::string& text) {
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  recordItem(name, text);
}

// The stiffness of a mode if the whole molecule moves along it, per angstrom of its root mean square displacement over
// the nodes times the root of their number: the mode has unit length.
double stiffness_pN_per_A(const ElasticModel& model, std::size_t mode) {
  return model.modes->eigenvalues[mode] * model.spring_kcal_mol_A2 * kForceUnit_pN;
}

void drawModes(ElasticMolecule& elastic) {
  const ElasticModel& model = *elastic.model();
  ImGui::Spacing();
  sectionTitle(tr("Its softest motions"));
  const float gap = look().px(4), wide = 0.5f * (ImGui::GetContentRegionAvail().x - gap);
  for (std::size_t k = 0; k < std::min(kListed, model.modes->count()); ++k) {
    const std::string name = "mode/" + std::to_string(k + 1);
    line(name.c_str(), trf("{0}: {1} pN/Å", k + 1, numberText(stiffness_pN_per_A(model, k), significant(2))));
    const bool shown = elastic.shownMode() == k, only = elastic.onlyMode() == k;
    if (button((name + "/show").c_str(), shown ? tr("Stop") : tr("Show"),
               shown ? ButtonLook::Primary : ButtonLook::Plain, wide))
      elastic.showMode(shown ? std::nullopt : std::optional(k));
    tip(tr("Moves the molecule to and fro along this motion."));
    ImGui::SameLine(0.0f, gap);
    if (button((name + "/only").c_str(), only ? tr("Feel all") : tr("Feel alone"),
               only ? ButtonLook::Primary : ButtonLook::Plain, wide))
      elastic.giveWayIn(only ? std::nullopt : std::optional(k));
    tip(tr("The molecule gives way along this motion only."));
  }
}

}  // namespace

void drawMotionTab(Application& app) {
  ElasticMolecule& elastic = app.extensions().movers.get<ElasticMolecule>();
  {
    const WhileLocked locked(app, "elastic");
    bool on = elastic.on();
    if (toggle("elastic", tr("Elastic molecule"), on,
               tr("The molecule gives way where it is pushed, and springs back. Springs join residues that are nearer "
                  "than 15 Å.")))
      elastic.turn(on);
  }
  if (!elastic.on()) return;
  if (elastic.computing()) return line("elastic/computing", tr("The springs are being computed."));
  if (!elastic.model()) return line("elastic/problem", elastic.problem());
  line("elastic/displacement",
       trf("Greatest displacement: {0}", quantityText(elastic.maxDisplacement_A(), Dimension::Length, decimals(1))));
  line("elastic/energy",
       trf("Energy of the springs: {0} kcal/mol", numberText(elastic.energy_kcal_mol(), decimals(1))));
  line("elastic/scale",
       trf("1 N in the hand is {0} pN between the atoms.", numberText(ElasticMolecule::kScale_pN_per_N, decimals(0))));
  const std::string spring = numberText(elastic.model()->spring_kcal_mol_A2, significant(2));
  line("elastic/springs",
       elastic.model()->spring_assumed
           ? trf("Each spring: {0} kcal/mol/Å², assumed, because the file has no displacement factors.", spring)
           : trf("Each spring: {0} kcal/mol/Å², which gives the mean displacement factor of the file.", spring));
  drawModes(elastic);
}

}  // namespace moltact
