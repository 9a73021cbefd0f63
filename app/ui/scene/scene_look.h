// How the scene is drawn. Panels set the members. Window's thread.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "app/ui/scene/felt_scene.h"
#include "engine/render/view_scene.h"

namespace moltact {

class SceneLook {
 public:
  explicit SceneLook(const FeltScene& felt) : felt_(felt) {}

  ViewPartSet shown;  ///< visible parts
  AtomsLook atoms;
  ColourBy colour_by = ColourBy::Element;
  /// The atoms' fluctuation in a trajectory, which the scheme of that name shows (unit: angstrom); empty: none is known.
  std::vector<float> fluctuation_A;

  /// The colours of a scheme for the molecule on the stage, what the hand holds and the medium of its forces. Null for
  /// "element", "chain" and unknown names. That of the potential is pending: PotentialColours computes it.
  std::shared_ptr<const Colouring> colouring(std::string_view scheme) const;
  /// Whether the contact is with an atom that the scene does not draw; its name would reveal what is to be felt.
  bool touchesUnseen(const Contact& contact) const;
  /// Whether the scene draws no atom of its molecule.
  bool drawsNothing() const;

 private:
  const FeltScene& felt_;
};

}  // namespace moltact
