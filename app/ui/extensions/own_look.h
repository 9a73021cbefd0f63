// How a person wants the atoms of a molecule of their own drawn, in the words of a scene: what `style: …`, `hide: …` and
// others say there. Window's thread.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>

#include "app/ui/application/extension.h"
#include "engine/lesson/lesson.h"

namespace moltact {

/// A key of a scene that the page offers.
struct OwnLookKey {
  std::string_view key;  ///< as a scene writes it
  const char* label;     ///< what it does, in English
  const char* example;   ///< a value of it
};

class OwnLook final : public Extension {
 public:
  explicit OwnLook(const HapticSession& scene) : scene_(scene) {}

  static std::span<const OwnLookKey> keys();
  static constexpr std::size_t kKeys = 6;

  /// As they stand on the page. Without a style or colours the picture keeps those that it has.
  std::array<std::string, kKeys> values;

  /// What is wrong with each value for this molecule; empty where it can be shown.
  const std::array<std::string, kKeys>& faults(const std::shared_ptr<const Molecule>& molecule);
  /// Shows all that is written; nothing where a value has a fault.
  void show(HapticSession& scene);

  /// What is written belongs to a molecule.
  void sceneChanged() override;

 private:
  const HapticSession& scene_;
  std::shared_ptr<const Molecule> molecule_;
  // What the faults are of: selections are worked out when a value is another, not in each frame.
  std::shared_ptr<const Molecule> checked_molecule_;
  std::array<std::string, kKeys> checked_, faults_;
};

}  // namespace moltact
