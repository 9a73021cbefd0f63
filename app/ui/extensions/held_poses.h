// The poses of a held body while forces between atoms act: those of lowest energy that the hand has reached, and an
// energy minimum below one of them. A pose can be saved, marked in the picture and, if the hand had reached it, taken
// again. Energies are those of the pose, van der Waals and electrostatic, without the bound of the walls. While a task or
// a question of the step is open, no pose is marked, computed or taken. Window's thread. Units: angstrom, kcal/mol,
// second.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/application/extension.h"
#include "engine/haptics/field/minimise_pose.h"
#include "engine/haptics/field/pair_field.h"

namespace moltact {

class LessonGuide;
class Opener;

struct HeldPose {
  PoseA pose;
  MolecularEnergy energy;
  double time_s = 0.0;     ///< since the body was taken in hand
  bool minimised = false;  ///< computed, not reached by the hand
};

/// The root mean square distance of a body's atoms between two of its poses.
double rmsdBetween_A(const HeldBody& body, const PoseA& one, const PoseA& other);

class HeldPoses final : public Extension {
 public:
  /// From the first press on, a pose is recorded after the body has been at rest for kQuiet_ticks. Its energy must be
  /// negative and at least kGain below that of every recorded one. One within kSame_A of the last recorded pose
  /// replaces it. Of more than kMaxPoses poses of the hand the oldest is dropped.
  static constexpr double kGain_kcal_mol = 0.1, kSame_A = 0.5, kMoved_A = 0.05;
  static constexpr int kQuiet_ticks = 100;
  static constexpr std::size_t kMaxPoses = 12;
  /// Of a minimisation.
  static constexpr int kMaxSteps = 400;

  /// The energy minimum below a pose.
  struct Minimum {
    HeldPose from, to;
    int steps = 0;
    bool done = false;       ///< else it is being computed
    bool converged = false;  ///< else kMaxSteps were taken
    bool listed = false;
  };

  HeldPoses(Opener& opener, HapticSession& scene, LessonGuide& lesson, const FrameTime& time)
      : opener_(opener), scene_(scene), lesson_(lesson), time_(time) {}

  /// Of the forces that act now, in the order in which they were found. Empty without a body or forces.
  const std::vector<HeldPose>& list() const;
  /// Whether a body is held and forces between atoms act on it.
  bool on() const;
  /// Index in list().
  std::optional<std::size_t> selected() const { return selected_; }
  void select(std::optional<std::size_t> pose) { selected_ = pose; }
  const std::optional<Minimum>& minimum() const { return minimum_; }
  /// How far the atoms are moved from the hand's pose to the minimum (root mean square); 0 without one.
  double movedByMinimum_A() const;
  /// The pose to be marked: the selected one, or else the minimum.
  std::optional<PoseA> marked() const;

  /// The distance of a pose from the one that the step's task names, or else from that of the molecule's file.
  double offKnown_A(const HeldPose& pose) const;
  /// Whether offKnown_A() is the distance from a task's pose.
  bool taskNamesPose() const;

  /// Whether the step has an open task or question, so that no help is given.
  bool taskOpen() const;
  /// Starts a minimisation from the selected pose, or else from the present one, and selects none; a part of it is computed in each frame.
  void minimise();
  /// Adds the computed minimum to the list and selects it.
  void addMinimum();
  /// Whether take() would act: a pose that the hand reached is selected.
  bool canTake() const;
  /// Takes the body back to the selected pose; the force rises softly. If a task opens afterwards, the scene begins
  /// again.
  void take();
  /// The selected pose as a PDB file's text.
  Expected<std::string> pdb() const;

  void beforeTicks() override;
  void ticks(const FeltTicks& felt) override;
  void sceneChanged() override;
  bool live() const override { return minimum_ && !minimum_->done; }

 private:
  struct Computation {
    explicit Computation(const PairField& field, const PairModel& model)
        : sum(field.places, field.atoms, field.held, model), minimiser(sum, radiusOfGyration_A(field.held)) {}
    PairSum sum;
    PoseMinimiser minimiser;
  };
  std::string forces() const;
  void record(const ServoSample& sample);

  Opener& opener_;
  HapticSession& scene_;
  LessonGuide& lesson_;
  const FrameTime& time_;

  std::shared_ptr<const HeldBody> body_;
  std::shared_ptr<const SphereGrid> spheres_;
  double began_s_ = 0.0;
  std::map<std::string, std::vector<HeldPose>> lists_;  // by forces()
  std::string key_;                                     // of the last frame
  std::optional<std::size_t> selected_;
  std::optional<Minimum> minimum_;
  std::unique_ptr<Computation> computing_;
  PoseA quiet_at_;
  int quiet_ticks_ = 0;
  bool taken_ = false;  // and no task has opened since
};

}  // namespace moltact
