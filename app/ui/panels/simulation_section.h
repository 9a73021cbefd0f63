// The part of the panel Motion about a simulation: its switch, its clock, its heat bath, its plots. Window's thread.
#pragma once

namespace moltact {

class Application;

/// Draws it where the molecule can be simulated. Returns true if a simulation moves the atoms, so that nothing else
/// can.
bool drawSimulationSection(Application& app);

}  // namespace moltact
