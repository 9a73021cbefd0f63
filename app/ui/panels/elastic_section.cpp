// The part of the tab Motion about an elastic molecule: the switch whether it yields to the hand as an elastic network,
// and the network's modes, each shown as a movement, or some of them felt alone.
#include <imgui.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/elastic_molecule.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/motion_sections.h"
#include "app/ui/panels/while_locked.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

// The number of the softest modes that are listed.
constexpr std::size_t kListed = 6;

void drawModes(Application& app, ElasticMolecule& elastic) {
  const ElasticModel& model = *elastic.model();
  ImGui::Spacing();
  sectionTitle(tr("Its softest motions"));
  drawWrapped("mode/energy", trf("Beside each: the energy that moves the residues along it by 1 Å (root mean square). "
                                 "Heat gives a motion {0}.",
                                 energyBetweenAtoms(0.5 * kThermalEnergy_kcal_mol, decimals(1))));
  const std::vector<std::size_t>& felt = elastic.feltModes();
  const std::size_t listed = std::min(std::max(kListed, felt.empty() ? 0 : felt.back() + 1), model.modes->count());
  std::vector<std::string> numbers;
  std::optional<WhileLocked> locked(std::in_place, app, "elastic");
  for (std::size_t k = 0; k < listed; ++k) {
    numbers.push_back(std::to_string(k + 1));
    // A mode has unit length over all nodes.
    const double energy = 0.5 * model.modes->eigenvalues[k] * model.spring_kcal_mol_A2 * double(model.modes->nodes);
    bool on = elastic.feels(k);
    if (toggle(("mode/" + numbers[k]).c_str(),
               trf("Motion {0}: {1}", numbers[k], energyBetweenAtoms(energy, significant(2))).c_str(), on,
               tr("The molecule gives way along the motions that are switched on; with none, in every way.")))
      elastic.feelMode(k, on);
  }
  locked.reset();
  drawWrapped("mode/felt", elastic.feltModes().empty()
                               ? tr("The molecule gives way in every way.")
                               : tr("The molecule gives way along the motions that are switched on, and no other."));
  bool shown = elastic.modeShown();
  if (toggle("mode/shown", tr("Show a motion"), shown, tr("Moves the molecule to and fro along this motion.")))
    elastic.showMode(shown);
  std::size_t mode = elastic.mode();
  if (segments("modes", std::span(numbers).first(std::min(kListed, listed)), mode)) elastic.chooseMode(mode);
}

}  // namespace

bool drawElasticMoleculeSection(Application& app) {
  ElasticMolecule& elastic = app.extensions().movers.get<ElasticMolecule>();
  if (const std::string why = elastic.unavailable(); !why.empty() && !elastic.on()) {
    drawWrapped("elastic/unavailable", why);
    return false;
  }
  {
    const WhileLocked locked(app, "elastic");
    bool on = elastic.on();
    if (toggle("elastic", tr("Elastic molecule"), on,
               tr("The molecule gives way where it is pushed, and springs back. Springs join residues that are nearer "
                  "than 15 Å."))) {
      if (on)
        elastic.start();
      else
        elastic.end();
    }
  }
  if (!elastic.on()) return false;
  if (!elastic.model()) {
    drawWrapped("elastic/problem", elastic.computing() ? trf("The springs are being computed: {0}",
                                                             quantityText(elastic.progress(), Dimension::Share))
                                                       : elastic.problem());
    if (elastic.computing()) progressBar("elastic/progress", float(elastic.progress()), false);
    return true;
  }
  drawWrapped("elastic/displacement", trf("Greatest displacement: {0}",
                                          quantityText(elastic.maxDisplacement_A(), Dimension::Length, decimals(1))));
  drawWrapped("elastic/energy",
              trf("Energy of the springs: {0}", energyBetweenAtoms(elastic.energy_kcal_mol(), decimals(2))));
  drawWrapped("elastic/scale", trf("1 N in the hand is {0} pN between the atoms.",
                                   numberText(ElasticMolecule::kScale_pN_per_N, decimals(0))));
  const std::string spring = numberText(elastic.model()->spring_kcal_mol_A2, significant(2));
  drawWrapped("elastic/springs",
              elastic.model()->spring_assumed
                  ? trf("Each spring: {0} kcal/mol/Å², assumed, because the file has no B factors.", spring)
                  : trf("Each spring: {0} kcal/mol/Å², which gives the mean B factor of the file.", spring));
  drawModes(app, elastic);
  return true;
}

}  // namespace moltact
