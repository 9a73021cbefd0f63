// Begins the simulation of a system from a file, in this program: on a thread of its own or between the window's frames,
// in a page in a worker. Not for the haptic thread; may take a second.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "engine/core/problem.h"
#include "engine/dynamics/live_simulation.h"
#include "engine/molecule/molecule.h"

namespace moltact {

enum class SimulationPace : std::uint8_t {
  OwnClock,  ///< beside the window, in real time
  Frames,    ///< between the window's frames, by their time
};

/// The largest molecule that beginSimulation() takes in a page; elsewhere kMaxSimulated (simulation_engines.h). Of 490 atoms, OpenMM's platform Reference in a worker makes 170 steps per second (docs/simulation.md).
inline constexpr std::size_t kMaxSimulatedInPage = 500;

/// A simulation of the system in `system`, whose atoms are those of the molecule in their order and begin where they are;
/// `start` has the rest. A Problem names the file. In a page the worker finds out later whether it can read the system:
/// the frame is then lost, and its fault is the Problem's text.
Expected<std::unique_ptr<LiveSimulation>> beginSimulation(const std::filesystem::path& system,
                                                          std::shared_ptr<const Molecule> molecule, MdStart start,
                                                          SimulationPace pace);

}  // namespace moltact
