// The two structures of a lesson's scene (its key `then`): reads the second one, and leads the atoms between the two
// where the student's slider wants them, while they are touched. Window's thread. Units: angstrom, second.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/ui/application/extension.h"
#include "engine/lesson/second_state.h"
#include "engine/platform/background.h"

namespace moltact {

struct ApplicationOptions;
class LessonGuide;
class Messages;

class MovingStates : public Extension {
 public:
  MovingStates(HapticSession& scene, LessonGuide& lesson, Messages& messages, const ApplicationOptions& options)
      : scene_(scene), lesson_(lesson), messages_(messages), options_(options) {}

  /// No atom that can be felt moves faster, and the whole way takes at least so long.
  static constexpr double kMaxSpeed_A_per_s = 8.0, kMin_s = 1.5;

  void sceneChanged() override;
  void lessonChanged() override { sceneChanged(); }
  void beforeTicks() override;
  bool live() const override { return reading_.busy() || (states_ && share_ != wanted_); }

  /// Whether the scene has two states, and both have been read.
  bool there() const { return states_ != nullptr; }
  /// Where the atoms are on their way (0 the first state, 1 the second), and where they are to go.
  double share() const { return share_; }
  double wanted() const { return wanted_; }
  void goTo(double share);
  /// What the scene's second structure is and how it lies on the first; without a molecule where there() is false.
  const SecondState& then() const { return then_; }
  /// The file of the second structure.
  const std::filesystem::path& file() const { return file_; }
  /// In a playback: the atoms of the molecule on the stage stand at this share of the way to another structure, once
  /// that has been read.
  void show(const MoleculeKey& other, const SecondState& then);
  /// What the two are called.
  const std::string& name(int state) const { return names_[std::size_t(state)]; }

 private:
  HapticSession& scene_;
  LessonGuide& lesson_;
  Messages& messages_;
  const ApplicationOptions& options_;
  void forget();
  void take(Expected<TwoStates> states);
  void begin();

  std::filesystem::path file_;                // of the second structure
  SecondState then_;                          // what states_ was made of, with
  std::shared_ptr<const Molecule> molecule_;  // the first state's
  NewestWork<Expected<TwoStates>> reading_;
  std::shared_ptr<const TwoStates> states_;
  std::shared_ptr<const Molecule> begins_;  // with its atoms where a scene began that does not begin in the first state
  double begins_share_ = 0.0;
  std::array<std::string, 2> names_;
  double share_ = 0.0, wanted_ = 0.0, per_s_ = 0.0;
};

}  // namespace moltact
