// A molecule that yields: an elastic network (engine/dynamics) takes the impulses of the hand's contacts and moves the
// atoms, in steps of kStep_ticks that the servo loop follows. Modes of the network can be shown as movements, and the
// response restricted to some of them. Network and modes are kept in the cache folder. Window's thread; they are computed on
// a background thread.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/extensions/atom_mover.h"
#include "engine/dynamics/elastic_motion.h"
#include "engine/platform/background.h"

namespace moltact {

/// What is computed once for a molecule.
struct ElasticModel {
  std::shared_ptr<const ElasticNetwork> network;
  std::shared_ptr<const NormalModes> modes;
  double spring_kcal_mol_A2 = 0.0;
  bool spring_assumed = false;                  ///< the file has no displacement factors
  std::vector<double> compliances_A2_mol_kcal;  ///< of each node, along its softest direction
};

/// How far the computation is; written by the background thread.
struct ElasticProgress {
  std::atomic<double> share{0.0};
  std::atomic<bool> unwanted{false};  ///< ends the computation
};

class ElasticMolecule : public AtomMover {
 public:
  using AtomMover::AtomMover;

  /// The force between atoms that corresponds to one newton in the hand.
  static constexpr double kScale_pN_per_N = 100.0;
  static constexpr std::size_t kModes = kElasticModes;
  /// A step is queued while the previous one is followed; the relaxation time covers the delay (relaxationFor).
  static constexpr int kStep_ticks = 20;
  static constexpr double kStep_s = kStep_ticks * kTick_s;
  /// Stiffness of the springs where the file has no displacement factors.
  static constexpr double kUsualSpring_kcal_mol_A2 = 0.3;
  /// Amplitude of a shown mode at the node that moves most, and its period.
  static constexpr double kShown_A = 3.0, kShown_s = 4.0;

  void sceneChanged() override;
  void lessonChanged() override { sceneChanged(); }
  void beforeTicks() override;
  bool live() const override { return reading_.busy() || moving(); }

  std::string_view kind() const override { return "elastic"; }
  std::optional<AtomsMoved> position() const override;
  bool moving() const override { return motion_ && !resting_; }
  void show(const MotionSource& source, const AtomsMoved& position, const MoleculeKey& file) override;

  /// Whether the molecule yields.
  bool on() const { return on_; }
  void end() override;
  std::string unavailable() const override;
  bool computing() const { return reading_.busy(); }
  /// The finished fraction of the computation.
  double progress() const { return progress_ ? progress_->share.load() : 0.0; }
  const std::string& problem() const { return problem_; }
  /// Null until it is computed.
  const ElasticModel* model() const { return model_.get(); }

  double energy_kcal_mol() const { return motion_ ? motion_->energy_kcal_mol() : 0.0; }
  double maxDisplacement_A() const { return motion_ ? motion_->maxDisplacement_A() : 0.0; }
  /// The mode that can be shown as a movement, and whether it is.
  std::size_t mode() const { return mode_; }
  bool modeShown() const { return shown_; }
  void chooseMode(std::size_t mode);
  void showMode(bool on);
  /// The modes along which alone the molecule gives way, ascending; empty: it gives way in every way.
  const std::vector<std::size_t>& feltModes() const { return felt_; }
  bool feels(std::size_t mode) const { return std::binary_search(felt_.begin(), felt_.end(), mode); }
  /// Switches a mode on or off. Ignores a mode that the molecule does not have.
  void feelMode(std::size_t mode, bool on);

 private:
  void onStart() override;
  void forget();
  void resetModes();
  void begin();
  void take(Expected<ElasticModel> made);
  void step();
  void addImpulses();
  void restrict();
  std::vector<Sphere> displaced() const;

  bool on_ = false, by_lesson_ = false, resting_ = true;
  std::shared_ptr<const Molecule> molecule_;  // of which model_ is made
  NewestWork<Expected<ElasticModel>> reading_;
  std::shared_ptr<const ElasticModel> model_;
  std::string problem_;
  std::optional<ElasticMotion> motion_;
  std::vector<Vec3> impulses_N_s_;             // of each node since the last step
  std::uint64_t ticks_ = 0;                    // in which they were given
  std::vector<Sphere> waiting_;                // the atoms after the last step, until the loop takes them
  std::shared_ptr<ElasticProgress> progress_;  // of the newest computation
  std::size_t mode_ = 0;
  std::vector<std::size_t> felt_;
  bool shown_ = false;
  double shown_for_s_ = 0.0;
};

}  // namespace moltact
