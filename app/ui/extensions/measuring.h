// Lengths and angles that a person measures: places are atoms that were clicked or are touched, two for a length, three
// for an angle, four for a torsion. Window's thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/application/extension.h"
#include "engine/render/annotations.h"

namespace moltact {

/// The atom that is seen at a place of the view (unit: pixel from its upper left corner); none: beside the molecule.
std::optional<std::uint32_t> atomAt(const HapticSession& scene, glm::dvec2 px, glm::dvec2 view_px);

class Measuring final : public Extension {
 public:
  explicit Measuring(const HapticSession& scene) : scene_(scene) {}

  /// While it is on, clicks in the view are places and do not push.
  bool on() const { return on_; }
  void switchOn(bool on);

  /// The next place. The last one once more, or a fifth, ends the measure; what comes then begins another.
  void take(const Molecule& molecule, std::uint32_t atom);
  /// What comes next begins another measure.
  void finish() { atoms_.clear(); }
  void clear();
  bool any() const { return drawn_ != nullptr; }

  /// What is drawn; null where nothing has been measured.
  const std::shared_ptr<const Annotations>& drawn() const { return drawn_; }
  /// What was measured last, in words; empty where nothing was.
  const std::string& text() const { return text_; }

  /// Measures belong to a molecule.
  void sceneChanged() override;

 private:
  const HapticSession& scene_;
  void write(const Molecule& molecule);

  bool on_ = false;
  std::vector<std::vector<std::uint32_t>> measures_;  // all that have a value, the last perhaps unfinished
  std::vector<std::uint32_t> atoms_;                  // of the one that has begun
  std::shared_ptr<const Annotations> drawn_;
  std::shared_ptr<const Molecule> molecule_;
  std::string text_;
};

}  // namespace moltact
