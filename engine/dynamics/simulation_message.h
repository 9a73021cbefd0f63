// Commands, frames and starts of a simulation as rows of numbers, for a simulation in a worker of a page, which shares no
// memory with the window (openmm_worker.cpp, begin_simulation_web.cpp). Texts travel beside them. Any thread.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/dynamics/live_simulation.h"

namespace moltact {

/// A command and the window's time for which it is carried out (unit: second).
struct TimedCommand {
  SimulationCommand command;
  double elapsed_s = 0.0;
};

/// What is read from numbers is nothing if their count does not fit.
std::vector<double> numbersOf(const TimedCommand& command);
std::optional<TimedCommand> commandOf(std::span<const double> numbers);

/// Without the fault and what another program's simulation sends (SimulationFrame).
std::vector<double> numbersOf(const SimulationFrame& frame);
std::optional<SimulationFrame> frameOf(std::span<const double> numbers);

/// Without the system and the platform.
std::vector<double> numbersOf(const MdStart& start);
std::optional<MdStart> startOf(std::span<const double> numbers);

}  // namespace moltact
