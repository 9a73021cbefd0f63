#include "app/ui/panels/energy_plot.h"

#include <array>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/pose_list.h"
#include "app/ui/panels/residue_forces.h"
#include "app/ui/panels/while_locked.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/plot.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/field/pair_model.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

// Which of the forces act. None of them would end the layer and with it this control; that choice is among the details.
void drawParts(Application& app) {
  std::vector<OfferedWord> words;
  for (const ForceChoice& f : forceChoices())
    if (f.any()) words.push_back({f.name, f.title, f.sentence});
  TouchSetup touch = app.scene.touch();
  const WhileLocked locked(app, "forces");
  if (wordSegments("forces_felt", words, touch.forces)) app.scene.setTouch(touch);
}

// What of the energy of each held atom is felt.
void drawFeltEnergy(const ForceWatch& forces) {
  if (!forces.on()) return;  // the newest tick is still of forces that have just been switched off
  constexpr double kTo_kcal_mol = 10.0;
  const PairModel& model = forces.field()->model;
  const double from_kcal_mol = model.weak_gain > 1.0 ? -10.0 : -2.0;
  const FeltFunction function(model);
  const auto felt = [&](double energy) { return function.at(energy).value; };
  ImGui::Spacing();
  functionPlot("plot/felt_energy", felt,
               {.title = tr("Felt energy of an atom"),
                .across = tr("kcal/mol energy"),
                .up = tr("kcal/mol felt"),
                .from = from_kcal_mol,
                .to = kTo_kcal_mol,
                .at = forces.highest_kcal_mol()});
  if (!forces.highest_kcal_mol()) return;
  const double highest = *forces.highest_kcal_mol();
  const std::string text = trf("Highest energy of an atom: {0}, felt as {1}", energyBetweenAtoms(highest, decimals(1)),
                               energyBetweenAtoms(felt(highest), decimals(1)));
  const WithFont small(Font::Small);
  drawWrapped("felt_energy", text);
}

}  // namespace

void drawEnergyPlot(Application& app) {
  const TouchLog& log = app.scene.log();
  const auto& energy = log.latest().molecular_energy;
  const std::span<const PlotBuffer> curves = log.energies();
  // What attracts could be the answer to a task that asks what is touched.
  if (!energy || curves.empty() || app.extensions().reveal_policy.all() || app.extensions().task_stager.asksWhat())
    return;
  const Palette& p = look().palette;
  const std::array colours{p.good, p.warn, p.bad};
  std::vector<PlotCurve> shown;
  for (std::size_t k = 0; k < kEnergyParts; ++k)
    shown.push_back({&curves[k], std::string(tr(energyParts()[k].title)),
                     energyBetweenAtoms(energy->parts.values[k], decimals(1)), colours[k % colours.size()]});
  ImGui::Spacing();
  signedPlot("plot/energy", shown, {.title = tr("Energy"), .min_top = 1.0f, .span_s = TouchLog::kPlot_s});
  drawParts(app);
  drawResidueForces(app);
  drawPoses(app);
  drawFeltEnergy(app.scene.forces());
  const double N_per_kcal_mol_A = log.latest().spring_N_per_A / energy->coupling_kcal_mol_A2;
  if (N_per_kcal_mol_A <= 0.0) return;
  const double gain = app.scene.touch().weak_gain;
  const std::string pN = numberText(kForceUnit_pN / N_per_kcal_mol_A, decimals(0)),
                    kcal_mol_A = numberText(1.0 / N_per_kcal_mol_A, decimals(1));
  drawWrapped("force_scale",
              gain > 1.0 ? trf("1 N in the hand is {0} pN or {1} kcal/mol/Å between the atoms, for the weakest "
                               "forces {2} times less.",
                               pN, kcal_mol_A, numberText(gain, decimals(1)))
                         : trf("1 N in the hand is {0} pN or {1} kcal/mol/Å between the atoms.", pN, kcal_mol_A));
  if (const auto between = app.scene.forces().between_kcal_mol_A())
    drawWrapped("force_between",
                trf("Between the atoms now: {0} pN ({1} kcal/mol/Å), felt as {2} pN.",
                    numberText(kForceUnit_pN * *between, decimals(0)), numberText(*between, decimals(1)),
                    numberText(kForceUnit_pN * log.force_N() / N_per_kcal_mol_A, decimals(0))));
}

}  // namespace moltact
