// The energy of what the hand holds with the molecule, as live curves in the touch tab. Window's thread.
#pragma once

namespace moltact {

class Application;

/// Draws nothing where no forces between atoms act.
void drawEnergyPlot(Application& app);

}  // namespace moltact
