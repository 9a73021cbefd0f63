#include "engine/dynamics/begin_simulation.h"

#include <utility>

#include "engine/dynamics/simulation_engines.h"
#include "engine/dynamics/simulation_thread.h"

namespace moltact {

Expected<std::unique_ptr<LiveSimulation>> beginSimulation(const std::filesystem::path& system,
                                                          std::shared_ptr<const Molecule> molecule, MdStart start,
                                                          SimulationPace pace) {
  auto engine = simulationOf(system, *molecule, std::move(start));
  if (!engine) return engine.problem();
  if (pace == SimulationPace::Frames)
    return std::unique_ptr<LiveSimulation>(std::make_unique<SteppedSimulation>(*std::move(engine)));
  return std::unique_ptr<LiveSimulation>(std::make_unique<SimulationThread>(*std::move(engine)));
}

}  // namespace moltact
