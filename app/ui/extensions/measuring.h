// Measures lengths and angles between atoms that the user clicks or touches: two atoms give a length, three an angle,
// four a torsion. Window's thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/application/extension.h"
#include "engine/render/annotations.h"

namespace moltact {

/// The atom drawn at the point `px` of the view, or nothing. `view_px` is its size (unit: pixel; origin: upper left).
std::optional<std::uint32_t> atomAt(const HapticSession& scene, glm::dvec2 px, glm::dvec2 view_px);

class Measuring final : public Extension {
 public:
  explicit Measuring(const HapticSession& scene) : scene_(scene) {}

  /// While on, clicks in the view select atoms and do not push.
  bool on() const { return on_; }
  void switchOn(bool on);

  /// Adds an atom. If the same atom is added twice in a row, the measurement ends. A fifth atom begins another one.
  void take(const Molecule& molecule, std::uint32_t atom);
  /// Ends the measurement; the next atom begins another.
  void finish() { atoms_.clear(); }
  void clear();
  bool any() const { return drawn_ != nullptr; }

  /// The measurements as annotations; null if there are none.
  const std::shared_ptr<const Annotations>& drawn() const { return drawn_; }
  /// The last measurement in words; empty if there is none.
  const std::string& text() const { return text_; }

  /// Removes all measurements, because they belong to a molecule.
  void sceneChanged() override;

 private:
  const HapticSession& scene_;
  void write(const Molecule& molecule);

  bool on_ = false;
  std::vector<std::vector<std::uint32_t>> measures_;  // two to four atoms each; atoms_ may extend the last
  std::vector<std::uint32_t> atoms_;                  // of the current measurement
  std::shared_ptr<const Annotations> drawn_;
  std::shared_ptr<const Molecule> molecule_;
  std::string text_;
};

}  // namespace moltact
