// The part of the tab "Motion" about a trajectory. Window's thread.
#pragma once

namespace moltact {

class Application;

/// Draws the section. Returns false, and draws nothing, if no trajectory moves the atoms.
bool drawTrajectorySection(Application& app);

}  // namespace moltact
