// A molecule whose atoms a simulation moves (engine/dynamics/live_simulation.h): the hand's contacts push the atoms, and
// the touched surface follows them. The simulation runs on a thread of its own, in a page in a worker; where the window's
// clock is its frames, between frames. It may also run in another program (engine/dynamics/imd), on another computer only after the user has
// agreed to the address. The felt atoms follow it smoothed (engine/dynamics/felt_atoms.h); the drawn ones are where it has
// them. Window's thread. Units: angstrom, kcal/mol, picosecond, piconewton.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/extensions/atom_mover.h"
#include "app/ui/widgets/plot_buffer.h"
#include "engine/dynamics/begin_simulation.h"
#include "engine/dynamics/simulation_engines.h"
#include "engine/platform/background.h"

namespace moltact {

class LiveMolecule : public AtomMover {
 public:
  using AtomMover::AtomMover;
  ~LiveMolecule() override { forgetConnection(); }

  /// The force between atoms that corresponds to one newton in the hand.
  static constexpr double kScale_pN_per_N = 250.0;
  /// The stiffest spring and the largest force with which the hand may push or pull atoms.
  static constexpr double kStiffest_kcal_mol_A2 = 100.0, kStrongest_pN = 2000.0;
  /// Stiffness of the spring that holds the centre of mass in place.
  static constexpr double kHold_kcal_mol_A2 = 5.0;
  static constexpr double kFriction_per_ps = 2.0;
  static constexpr double kUsual_ps_per_s = 1.0, kSlowest_ps_per_s = 0.1, kFastest_ps_per_s = 10.0;
  static constexpr double kUsual_K = 300.0, kHottest_K = 600.0;
  /// Attempts store the positions of molecules up to this size.
  static constexpr std::size_t kMaxRecorded = 300;
  /// Interval and number of the values of a plot.
  static constexpr double kPlotted_s = 0.05, kPlot_s = 20.0;

  void sceneChanged() override;
  void lessonChanged() override { sceneChanged(); }
  void beforeTicks() override;
  void atEnd() override { forget(); }
  bool live() const override { return opening_.busy() || moving(); }

  std::string_view kind() const override { return "simulation"; }
  std::optional<AtomsMoved> position() const override;
  bool moving() const override { return simulation_ != nullptr && (wanted_.running || !waiting_.empty()); }
  void show(const MotionSource& source, const AtomsMoved& position, const MoleculeKey& file) override;

  bool on() const { return on_; }
  void end() override;
  /// Whether a system lies beside the molecule, or the lesson or the command line names one.
  bool offered() const { return on_ || address() || !system().empty(); }
  /// Where another program simulates this molecule; nothing: this program simulates it.
  std::optional<SimulationAddress> address() const;
  /// Whether the user has yet to agree to the address.
  bool asks() const { return on_ && asks_; }
  /// Connects to address(), at the user's request.
  void connect();
  /// Whether speed, temperature, single steps, relaxations and restarts have an effect.
  bool obeysAll() const { return simulation_ && simulation_->obeysAll(); }
  std::string unavailable() const override;
  bool opening() const { return opening_.busy() || (simulation_ && simulation_->opening()); }
  bool ready() const { return simulation_ && !simulation_->opening(); }
  const std::string& problem() const { return problem_; }

  /// What the simulation is asked for; the panel changes it.
  const SimulationCommand& wanted() const { return wanted_; }
  void run(bool running);
  void setSpeed(double ps_per_s) { wanted_.ps_per_s = ps_per_s; }
  void setTemperature(double kelvin) { wanted_.temperature_K = kelvin; }
  void singleStep();
  void relax() { ++wanted_.relaxations; }
  void restart() { ++wanted_.restarts; }

  /// What a press does: it pushes atoms by contact; or holds the first atom that it touches, or that atom's residue, or the
  /// atoms that the scene names if it touches one of them, until it ends.
  enum class Hold : std::uint8_t { Push, Atom, Residue, Selection };
  /// Whether the scene names atoms for Hold::Selection.
  bool namesHeld() const { return !selected_.empty(); }
  Hold hold() const { return hold_; }
  void setHold(Hold hold);
  /// The stiffness of the hand's spring between the atoms.
  double springOfHand_kcal_mol_A2() const;
  /// What is held, in words; empty if nothing is.
  std::string heldText() const;
  /// How far the centre of the held atoms has moved since they were taken.
  double pulledBy_A() const;

  /// The newest state of the simulation.
  const SimulationFrame& frame() const { return frame_; }
  EngineFacts engine() const { return simulation_ ? simulation_->engine() : EngineFacts(); }
  /// Size of the force with which the hand pushes or pulls the atoms.
  double push_pN() const { return push_pN_; }
  struct Plots {
    PlotBuffer temperature_K, energy_kcal_mol, push_pN, pulled_A;
  };
  const Plots& plots() const { return plots_; }

 private:
  using Opened = std::unique_ptr<LiveSimulation>;
  static Expected<Opened> openFile(const std::filesystem::path& system, const std::shared_ptr<const Molecule>& molecule,
                                   SimulationPace pace);
  static Expected<Opened> openAddress(const SimulationAddress& address, const std::shared_ptr<const Molecule>& molecule,
                                      const std::shared_ptr<const std::atomic<bool>>& cancelled);
  std::filesystem::path system() const;
  void onStart() override;
  void forget();
  void forgetConnection() {
    if (cancelled_) cancelled_->store(true, std::memory_order_relaxed);
    cancelled_.reset();
  }
  void begin();
  void beginElsewhere(const SimulationAddress& address);
  void take(Expected<Opened> opened);
  void fail(std::string why);
  void lose(std::string why);
  void addImpulses();
  void pushAtoms();
  void takeOrLetGo();
  void gripAtoms(double spring_kcal_mol_A2);
  Vec3 heldCentre_A() const;
  void takeSceneKeys();
  double massOf(std::uint32_t atom) const { return atom < masses_u_.size() ? masses_u_[atom] : 1.0; }
  void readFrame(double dt_s);
  void drawNewest();
  void startAgain();
  std::vector<Sphere> placed() const;

  bool on_ = false, by_lesson_ = false, asks_ = false;
  std::filesystem::path named_for_;           // the molecule for which the command line names an address
  std::string agreed_;                        // the address to which the user has agreed
  std::filesystem::path file_;                // of the system
  std::shared_ptr<const Molecule> molecule_;  // which it simulates
  NewestWork<Expected<Opened>> opening_;
  std::shared_ptr<std::atomic<bool>> cancelled_;  // of the connection that is being made
  std::unique_ptr<LiveSimulation> simulation_;
  std::string problem_;
  SimulationCommand wanted_;
  SimulationFrame frame_;
  std::vector<Vec3> smooth_A_;      // the atoms as they are felt
  std::uint64_t drawn_ = 0;         // the frame that is drawn
  std::vector<Vec3> impulses_N_s_;  // of each atom since the last step
  std::uint64_t ticks_ = 0;         // in which they were given
  std::vector<Sphere> waiting_;     // the atoms until the loop takes them
  double push_pN_ = 0.0, unplotted_s_ = 0.0;
  std::vector<Vec3> shown_A_;  // the displacements that a playback shows
  static constexpr std::size_t kPlotLength = std::size_t(kPlot_s / kPlotted_s);
  Plots plots_{PlotBuffer(kPlotLength), PlotBuffer(kPlotLength), PlotBuffer(kPlotLength), PlotBuffer(kPlotLength)};
  Hold hold_ = Hold::Push;
  std::vector<std::uint32_t> selected_;  // the atoms that the scene names for the hand, ascending
  std::vector<double> masses_u_;         // of the molecule's atoms
  std::vector<double> shares_;           // of the held atoms in their mass
  std::vector<Vec3> taken_A_;            // the places of the held atoms when they were taken
  Vec3 hand_took_at_A_{0.0};
  Vec3 taken_at_A_{0.0};  // their centre of mass then
};

}  // namespace moltact
