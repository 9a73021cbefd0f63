// The two structures of a lesson's scene (its key `then`): reads the second one and moves the atoms between the two as
// the student's slider requests, also during contact. Window's thread. Units: angstrom, second.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/ui/extensions/atom_mover.h"
#include "engine/lesson/second_state.h"
#include "engine/platform/background.h"

namespace moltact {

class MovingStates : public AtomMover {
 public:
  using AtomMover::AtomMover;

  /// The maximum speed of any touchable atom, and the minimum duration of the whole motion.
  static constexpr double kMaxSpeed_A_per_s = 8.0, kMin_s = 1.5;

  void sceneChanged() override;
  void lessonChanged() override { sceneChanged(); }
  void beforeTicks() override;
  bool live() const override { return reading_.busy() || moving(); }

  std::string_view kind() const override { return kMovedByStates; }
  std::optional<AtomsMoved> position() const override;
  bool moving() const override { return states_ && share_ != wanted_; }
  void show(const MotionSource& source, const AtomsMoved& position, const MoleculeKey& file) override;

  /// Whether the scene has two structures and both have been read.
  bool ready() const { return states_ != nullptr; }
  /// The present position of the atoms (0: first structure, 1: second), and the requested one.
  double share() const { return share_; }
  double wanted() const { return wanted_; }
  void goTo(double share);
  /// The names of the two structures.
  const std::string& name(int state) const { return names_[std::size_t(state)]; }

 private:
  void forget();
  void take(Expected<TwoStates> states);
  void begin();
  bool place(const MotionSource& source);

  std::filesystem::path file_;                // of the second structure
  SecondState then_;                          // from which states_ was computed
  std::shared_ptr<const Molecule> molecule_;  // the first structure
  NewestWork<Expected<TwoStates>> reading_;
  std::shared_ptr<const TwoStates> states_;
  std::shared_ptr<const Molecule> begins_;  // its atoms where a scene starts at another share than 0
  double begins_share_ = 0.0;
  std::array<std::string, 2> names_;
  double share_ = 0.0, wanted_ = 0.0, per_s_ = 0.0;
};

}  // namespace moltact
