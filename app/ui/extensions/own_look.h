// The user's own style for the atoms of a molecule, in the words of a scene: the values of `style`, `hide` and other
// keys. Window's thread.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>

#include "app/ui/application/extension.h"
#include "engine/lesson/lesson.h"

namespace moltact {

/// A key of a scene that the page app/ui/panels/look_page.cpp offers.
struct OwnLookKey {
  std::string_view key;  ///< as in a scene
  const char* label;     ///< what it does, in English
  const char* example;   ///< an example of a value
};

class OwnLook final : public Extension {
 public:
  explicit OwnLook(const HapticSession& scene) : scene_(scene) {}

  static std::span<const OwnLookKey> keys();
  static constexpr std::size_t kKeys = 6;

  /// The values on the page. Without a style or a colour here the scene's stays.
  std::array<std::string, kKeys> values;

  /// What is wrong with each value for this molecule; empty if it is valid.
  const std::array<std::string, kKeys>& faults(const std::shared_ptr<const Molecule>& molecule);
  /// Applies all values; does nothing if any of them is invalid.
  void show(HapticSession& scene);

  /// Clears the values, because they belong to a molecule.
  void sceneChanged() override;

 private:
  const HapticSession& scene_;
  std::shared_ptr<const Molecule> molecule_;
  // The input of faults_: selections are evaluated only when a value changes, not in every frame.
  std::shared_ptr<const Molecule> checked_molecule_;
  std::array<std::string, kKeys> checked_, faults_;
};

}  // namespace moltact
