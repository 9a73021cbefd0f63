// The engines that can simulate a molecule. One that runs in this program steps a system from a file (MdEngine); one that
// runs in another program is reached at an address (LiveSimulation). Scenes, window, commands and lesson check find an
// engine by this table. Not for the haptic thread; opening may take seconds.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/dynamics/live_simulation.h"
#include "engine/dynamics/md_engine.h"
#include "engine/molecule/molecule.h"
#include "engine/platform/tcp.h"

namespace moltact {

/// One engine: a row with either `ending` and `make`, or `scheme` and `connect`.
struct SimulationEngine {
  std::string_view name;  ///< "OpenMM"
  /// Of the files with systems that it reads: ".xml".
  std::string_view ending{};
  /// An engine for `start`, whose `system` is the content of the file named `file`. A Problem names that file.
  Expected<std::unique_ptr<MdEngine>> (*make)(const MdStart& start, const std::string& file) = nullptr;
  /// Of its addresses: "imd" in imd://127.0.0.1:8888; also the command that opens the window with one (`moltact imd`).
  std::string_view scheme{};
  /// Which programs it reaches, and how, for the command's help: "GROMACS, LAMMPS, NAMD, by the protocol IMD".
  std::string_view programs{};
  /// What to know of the order of their atoms, for the same: "GROMACS: of the IMD-group"; may be empty.
  std::string_view atom_order{};
  /// Connects and waits for the first positions, at most some seconds or until `cancelled` is true. `start_A`: the places
  /// of the molecule's atoms. A Problem names the address.
  Expected<std::unique_ptr<LiveSimulation>> (*connect)(const TcpAddress& address, std::vector<Vec3> start_A,
                                                       std::shared_ptr<const std::atomic<bool>> cancelled) = nullptr;
};

/// All engines. The first that reads files is the one whose systems `moltact simulate prepare` makes.
std::span<const SimulationEngine> simulationEngines();

/// SCHEME://HOST:PORT, as a scene and the command line name a simulation in another program.
struct SimulationAddress {
  const SimulationEngine* engine = nullptr;  ///< has a scheme
  TcpAddress at;

  std::string text() const { return std::string(engine->scheme) + "://" + at.text(); }
};

/// Nothing for the name of a file. A Problem without a place if the text contains "://" and is no address of an engine.
std::optional<Expected<SimulationAddress>> simulationAddress(std::string_view text);

/// `start` with the content of the file `system` and the atoms' places. A Problem names the file: no engine reads its
/// ending, it cannot be read, or the molecule is too large.
Expected<MdStart> readStart(const std::filesystem::path& system, const Molecule& molecule, MdStart start);

/// An engine for the system in `system`, by its ending. Its atoms are those of the molecule in their order and begin where
/// they are; `start` has the rest. A Problem names the file.
Expected<std::unique_ptr<MdEngine>> simulationOf(const std::filesystem::path& system, const Molecule& molecule,
                                                 MdStart start);
/// Larger molecules are not simulated: even the fastest engine would lag far behind the hand.
inline constexpr std::size_t kMaxSimulated = 5000;
/// Up to so many atoms two cores make 1000 steps per second in a vacuum, and the molecule moves as fast as the window asks
/// (docs/simulation.md: 758 atoms 1100, 1231 atoms 570 steps per second).
inline constexpr std::size_t kMaxFluent = 800;

/// The system beside a molecule's file, with the same name and the ending of an engine. If there is none, the name that
/// the first engine's would have.
std::filesystem::path systemBeside(const std::filesystem::path& molecule_file);

/// The masses of the molecule's atoms by their elements; 1 u where the element is unknown (unit: dalton).
std::vector<double> massesOf(const Molecule& molecule);

/// Why these masses are not those of the molecule's atoms in their order, as a Problem without a file; an empty message
/// if they are. Hydrogens may be heavier by mass that their neighbours gave them.
Problem massFault(const Molecule& molecule, std::span<const double> masses_u);

}  // namespace moltact
