// The largest stiffness of the spring between HIP and SCP at which a pressed device comes to rest. It is measured at
// surfaces of several kinds, along several directions of the device, with and without friction and hand. The reference
// is a plain wall pressed along the same directions. On a virtual clock. Units: angstrom, newton, millimetre.
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

/// A point of a surface that is pressed perpendicularly.
struct StiffnessPlace {
  std::string name;
  scenes::Scene scene;
  Vec3 surface{0.0}, out{0.0, 0.0, 1.0};  ///< first point of contact, and the outward unit vector
  bool holds = true;                      ///< a pressed probe stays by itself; false: on a ridge only a hand holds it
};

/// One sphere, a crease, a pit, the pit of four spheres, a hole too narrow for the probe, a flat face of
/// eight atoms.
std::vector<StiffnessPlace> stiffnessPlaces();

/// A device and the push on it.
struct StiffnessSetup {
  std::string name;
  DeviceParameters device;
  HandParameters hand;
  double push_N = 0;          ///< without a hand: a constant push, under which the device starts at rest in the surface
  double strike_N_s = 0;      ///< impulse into the surface; without a hand small enough to keep contact
  int ticks = 0;              ///< time after which it must be at rest
  double begin_N_per_mm = 0;  ///< start of the search, the same for all
};

/// With friction and a light hand, with either alone, and with neither.
std::vector<StiffnessSetup> stiffnessSetups();

/// The largest stiffness (unit: N/mm) at which the device comes to rest in contact less than 0.75 A deep. The search
/// goes upward from the setup's start in steps of 15 % to the first unstable value, then refines to 3 %; it goes
/// downward if the start is unstable. Returns 0 if none down to 0.02 is stable, 20 if all are. `turn`: the device's
/// axes in the scene. The pressed device receives an impulse.
double stiffestStable(const std::function<std::unique_ptr<Tracker>()>& make, const Vec3& surface, const Vec3& out,
                      const glm::dmat3& turn, const StiffnessSetup& setup);

struct Stiffness {
  std::string setup, place;
  const Method* method = nullptr;      ///< nullptr: the plain wall
  std::vector<double> limit_N_per_mm;  ///< for each direction
  std::vector<double> of_wall;         ///< the same divided by the plain wall's along that direction
};

struct StiffnessOptions {
  std::vector<const Method*> methods;
  std::size_t directions = 12;
  std::uint64_t seed = 1;
};

std::vector<Stiffness> measureStiffness(const StiffnessOptions& options, const Progress& progress);

/// One row per setup and place, one column per method: median and minimum over directions.
ReportTable stiffnessTable(const std::vector<Stiffness>& rows);
/// The setups.
ReportTable stiffnessSetupsTable();
/// One row per setup, place, method and direction.
ReportTable stiffnessFigures(const std::vector<Stiffness>& rows);
/// Sentences that state which limits exceed the plain wall's, and why.
std::string stiffnessSentences(const std::vector<Stiffness>& rows);

}  // namespace moltact::bench
