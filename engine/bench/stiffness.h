// The greatest stiffness of the spring between HIP and SCP at which a pressed device comes to rest: at places of
// several kinds, pressed along several directions of the device, with and without its friction and the hand. Each is
// compared with a plain wall pressed along the same directions. On a virtual clock. Units: angstrom, newton,
// millimetre.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/bench/closed_loop.h"
#include "engine/bench/report_table.h"
#include "engine/bench/scenes.h"
#include "engine/bench/timing.h"
#include "engine/haptics/methods.h"

namespace moltact::bench {

/// A place that is pressed straight in.
struct StiffnessPlace {
  std::string name;
  scenes::Scene scene;
  Vec3 surface{0.0}, out{0.0, 0.0, 1.0};  ///< the point of first contact, and the unit vector out of it
  bool holds = true;  ///< a probe that is pushed in stays there by itself; on a ridge only a hand holds it
};

/// One sphere, a crease, a pit, the pit of four spheres, a hole too narrow for the probe, a flat face of
/// eight atoms.
std::vector<StiffnessPlace> stiffnessPlaces();

/// A device and the push on it.
struct StiffnessSetup {
  std::string name;
  DeviceParameters device;
  HandParameters hand;
  double push_N = 0;          ///< with no hand: a constant push, under which the device begins at rest in the surface
  double strike_N_s = 0;      ///< straight in; without a hand so little that the device stays in contact
  int ticks = 0;              ///< until it must be at rest
  double begin_N_per_mm = 0;  ///< where the search begins, the same for all
};

/// With friction and a light hand, with each alone, with neither.
std::vector<StiffnessSetup> stiffnessSetups();

/// The greatest stiffness (unit: N/mm) at which the device comes to rest in contact less than 0.75 A deep,
/// searched upward from the set-up's beginning in steps of 15 % to the first that does not, and then to 3 %;
/// downward where the first does not. 0 where none down to 0.02 does, 20 where all do. `turn`: the device's
/// axes in the scene. The device is struck while it is pressed.
double stiffestStable(const std::function<std::unique_ptr<Tracker>()>& make, const Vec3& surface, const Vec3& out,
                      const glm::dmat3& turn, const StiffnessSetup& setup);

struct Stiffness {
  std::string setup, place;
  const Method* method = nullptr;      ///< nullptr: the plain wall
  std::vector<double> limit_N_per_mm;  ///< for each direction
  std::vector<double> of_wall;         ///< the same over the plain wall's along that direction
};

struct StiffnessOptions {
  std::vector<const Method*> methods;
  std::size_t directions = 12;
  std::uint64_t seed = 1;
};

std::vector<Stiffness> measureStiffness(const StiffnessOptions& options, const Progress& progress);

/// Set-ups and places down, methods across: the median over directions, and the least.
ReportTable stiffnessTable(const std::vector<Stiffness>& rows);
/// The set-ups themselves.
ReportTable stiffnessSetupsTable();
/// A row a set-up, place, method and direction.
ReportTable stiffnessFigures(const std::vector<Stiffness>& rows);
/// Sentences that say which limits lie above the plain wall's, and why.
std::string stiffnessSentences(const std::vector<Stiffness>& rows);

}  // namespace moltact::bench
