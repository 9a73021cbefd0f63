// The part of the tab Motion about a simulation: its switch, its clock, its heat bath, its plots.
#include <imgui.h>

#include <array>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/live_molecule.h"
#include "app/ui/panels/motion_sections.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/panels/while_locked.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/plot.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

void simulationLine(const char* name, const std::string& text, Font font = Font::Body) {
  const WithFont with(font);
  drawWrapped(name, text);
}

void drawClock(LiveMolecule& live) {
  const float gap = ImGui::GetStyle().ItemSpacing.x, half = 0.5f * (ImGui::GetContentRegionAvail().x - gap);
  const bool running = live.wanted().running;
  if (button("simulation/play", running ? tr("Pause") : tr("Play"), ButtonLook::Primary, half)) live.run(!running);
  if (!live.obeysAll()) return;
  ImGui::SameLine();
  if (button("simulation/step", tr("One step"), ButtonLook::Plain, half, !running)) live.singleStep();
  tip(trf("{0} ps at a time, while it stands still", numberText(LiveSimulation::kSingle_ps, significant(1))).c_str());
  if (button("simulation/relax", tr("Let it relax"), ButtonLook::Plain, half)) live.relax();
  tip(tr("Moves the atoms to the nearest minimum of the energy."));
  ImGui::SameLine();
  if (button("simulation/restart", tr("Start again"), ButtonLook::Plain, half)) live.restart();
  double speed = live.wanted().ps_per_s;
  if (slider("simulation/speed", tr("Speed (ps per second)"), speed, LiveMolecule::kSlowest_ps_per_s,
             LiveMolecule::kFastest_ps_per_s, 0.1, {Dimension::None, {decimals(1), {}}},
             tr("How many picoseconds are simulated in a second of yours.")))
    live.setSpeed(speed);
}

// A simulation in another program: the user agrees to its address, or connects again. False: there is nothing to say.
bool drawConnection(LiveMolecule& live) {
  const auto address = live.address();
  if (!address || live.opening() || live.ready()) return false;
  if (live.asks())
    simulationLine("simulation/asks", trf("Another program simulates this molecule, at {0}. Positions and forces cross "
                                          "the network unencrypted. Connect only to a computer that you trust.",
                                          address->at.text()));
  else
    simulationLine("simulation/problem", live.problem());
  if (button("simulation/connect", trf("Connect to {0}", address->at.text()).c_str(), ButtonLook::Primary))
    live.connect();
  return true;
}

void drawHold(Application& app, LiveMolecule& live) {
  using Hold = LiveMolecule::Hold;
  sectionTitle(tr("The hand"));
  const std::array<std::string, 2> words{N_("Pushes"), N_("Pulls")};
  std::size_t chosen = live.hold() == Hold::Push ? 0 : 1;
  if (segments("simulation/hold", words, chosen))
    live.setHold(chosen == 0 ? Hold::Push : live.namesHeld() ? Hold::Selection : Hold::Atom);
  if (live.hold() == Hold::Push) return;
  bool residue = live.hold() == Hold::Residue;
  if (!live.namesHeld() &&
      toggle("simulation/residue", tr("Hold the whole residue"), residue,
             tr("A press holds what it touches first, an atom or its whole residue, until it ends. With a device, hold "
                "the space bar while you touch.")))
    live.setHold(residue ? Hold::Residue : Hold::Atom);
  const std::string held = mayNameAtoms(app) ? live.heldText() : std::string();
  simulationLine("simulation/held",
                 held.empty() ? live.namesHeld() ? tr("Press on one of the atoms that the lesson names and drag it.")
                                                 : tr("Press on an atom and drag it.")
                              : trf("Held: {0}, moved by {1} Å", held, numberText(live.pulledBy_A(), decimals(1))));
  simulationLine(
      "simulation/spring",
      trf("Spring of the hand: {0} kcal/mol/Å²", numberText(live.springOfHand_kcal_mol_A2(), significant(2))),
      Font::Small);
}

void drawPlots(const LiveMolecule& live) {
  const MdEnergies& e = live.frame().energies;
  const PlotLook of{.span_s = LiveMolecule::kPlot_s, .shown_as = {Dimension::None, {decimals(0), {}}}};
  PlotLook temperature = of, push = of;
  temperature.title = tr("Temperature (K)");
  temperature.min_top = 490.0f;
  push.title = tr("Force of the hand (pN)");
  push.min_top = 100.0f;
  if (live.frame().has_temperature) plot("plot/temperature", live.plots().temperature_K, e.temperature_K, temperature);
  const std::array energy{PlotCurve{&live.plots().energy_kcal_mol, tr("Potential energy"),
                                    energyBetweenAtoms(e.potential_kcal_mol, decimals(1)), look().palette.good}};
  if (live.frame().has_energy)
    signedPlot("plot/potential_energy", energy,
               {.title = tr("Energy"), .min_top = 10.0f, .span_s = LiveMolecule::kPlot_s});
  plot("plot/push", live.plots().push_pN, live.push_pN(), push);
  if (live.hold() == LiveMolecule::Hold::Push) return;
  const PlotLook pulled{.title = tr("Pulled by (Å)"),
                        .min_top = 1.0f,
                        .span_s = LiveMolecule::kPlot_s,
                        .shown_as = {Dimension::None, {decimals(1), {}}}};
  plot("plot/pulled", live.plots().pulled_A, live.pulledBy_A(), pulled);
}

}  // namespace

bool drawLiveMoleculeSection(Application& app) {
  LiveMolecule& live = app.extensions().movers.get<LiveMolecule>();
  if (!live.offered()) return false;
  if (const std::string why = live.unavailable(); !why.empty() && !live.on()) {
    simulationLine("simulation/unavailable", why);
    return false;
  }
  // A lesson that locks the panel still needs the user's consent.
  if (live.on() && drawConnection(live)) return true;
  const WhileLocked locked(app, "simulation");
  {
    bool on = live.on();
    if (toggle("simulation", tr("Simulation"), on,
               tr("The atoms move according to the forces between them and a heat bath, and the hand pushes them."))) {
      if (on)
        live.start();
      else
        live.end();
    }
  }
  if (!live.on()) return false;
  if (live.opening()) {
    const auto address = live.address();
    simulationLine("simulation/opening", address ? trf("Waiting for the simulation at {0}.", address->at.text())
                                                 : tr("The simulation is being loaded."));
    return true;
  }
  if (!live.ready()) {
    simulationLine("simulation/problem", live.problem());
    return true;
  }
  drawClock(live);
  ImGui::Spacing();
  drawHold(app, live);
  ImGui::Spacing();
  double kelvin = live.wanted().temperature_K;
  if (live.obeysAll() && slider("simulation/bath", tr("Heat bath (K)"), kelvin, 1.0, LiveMolecule::kHottest_K, 1.0,
                                {Dimension::None, {decimals(0), {}}},
                                tr("The temperature to which friction and random forces bring the atoms.")))
    live.setTemperature(kelvin);
  if (live.frame().has_time)
    simulationLine("simulation/time", trf("Simulated: {0} ps", numberText(live.frame().time_ps, decimals(1))));
  if (live.frame().silent) simulationLine("simulation/silent", tr("The server sends nothing. The forces have ended."));
  drawPlots(live);
  ImGui::Spacing();
  simulationLine(
      "simulation/scale",
      trf("1 N in the hand is {0} pN between the atoms.", numberText(LiveMolecule::kScale_pN_per_N, decimals(0))),
      Font::Small);
  if (const auto address = live.address()) {
    simulationLine("simulation/engine",
                   trf("The simulation at {0} sends {1} frames in a second.", address->at.text(),
                       numberText(live.frame().frames_per_s, significant(2))),
                   Font::Small);
    return true;
  }
  const EngineFacts engine = live.engine();
  simulationLine(
      "simulation/engine",
      trf("{0} computes on {1}: {2} steps of {3} fs in a second at most.", engine.name, engine.platform,
          numberText(engine.measured_steps_per_s, significant(2)), numberText(1000.0 * engine.step_ps, decimals(1))),
      Font::Small);
  return true;
}

}  // namespace moltact
