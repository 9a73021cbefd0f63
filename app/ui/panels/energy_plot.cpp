#include "app/ui/panels/energy_plot.h"

#include <array>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/plot.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/haptics/field/pair_model.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

// Forces between atoms are given in the unit of their literature, whatever unit the user chose for the energy of springs.
std::string kcal(double value) { return trf("{0} kcal/mol", numberText(value, decimals(1))); }

}  // namespace

void drawEnergyPlot(Application& app) {
  const TouchLog& log = app.scene.log();
  const auto& energy = log.latest().molecular_energy;
  const TouchLog::Energies* curves = log.energies();
  if (!energy || !curves || app.extensions().reveal_policy.all()) return;
  const Palette& p = look().palette;
  const std::array shown{
      PlotCurve{&curves->van_der_waals, tr("Van der Waals"), kcal(energy->van_der_waals_kcal_mol), p.good},
      PlotCurve{&curves->electrostatic, tr("Charges"), kcal(energy->electrostatic_kcal_mol), p.warn}};
  ImGui::Spacing();
  signedPlot("plot/energy", shown, {.title = tr("Energy"), .min_top = 1.0f, .span_s = TouchLog::kPlot_s});
  const double N_per_kcal_mol_A = log.latest().spring_N_per_A / energy->coupling_kcal_mol_A2;
  if (N_per_kcal_mol_A <= 0.0) return;
  const std::string scale =
      trf("1 N in the hand is {0} pN between the atoms.", numberText(kForceUnit_pN / N_per_kcal_mol_A, decimals(0)));
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(scale.c_str());
  ImGui::PopTextWrapPos();
  recordItem("force_scale", scale);
}

}  // namespace moltact
