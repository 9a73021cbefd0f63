// How a person wants the atoms of a molecule of their own drawn, in the words of a scene: what `style: …`, `hide: …` and
// others say there. Window's thread.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>

#include "app/ui/application/extension.h"
#include "engine/core/problem.h"
#include "engine/lesson/lesson.h"
#include "engine/render/annotations.h"

namespace moltact {

/// A key of a scene that the page offers.
struct OwnLookKey {
  std::string_view key;  ///< as a scene writes it
  const char* label;     ///< what it does, in English
  const char* example;   ///< a value of it
};

class OwnLook final : public Extension {
 public:
  explicit OwnLook(const TouchScene& scene) : scene_(scene) {}

  static std::span<const OwnLookKey> keys();
  static constexpr std::size_t kKeys = 6;

  /// As they stand on the page; those that are empty change nothing.
  std::array<std::string, kKeys> values;

  /// What is wrong with a value for this molecule; nothing where it can be shown.
  std::optional<Problem> fault(std::size_t key, const Molecule& molecule) const;
  /// Shows all that is written; nothing where a value has a fault.
  void show(TouchScene& scene);

  /// Names and hydrogen bonds; null where none are wanted.
  const std::shared_ptr<const Annotations>& drawn() const { return drawn_; }
  /// What is written belongs to a molecule.
  void sceneChanged() override;

 private:
  const TouchScene& scene_;
  std::shared_ptr<const Annotations> drawn_;
  std::shared_ptr<const Molecule> molecule_;
};

}  // namespace moltact
