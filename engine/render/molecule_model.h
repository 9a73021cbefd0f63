// The renderer's data of a molecule between pictures: balls, colours, ambient occlusion, and a grid to find neighbours.
// Made once for a molecule; only its colours change. Units: angstrom.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/haptics/ball_scene.h"
#include "engine/molecule/molecule.h"
#include "engine/render/ambient_occlusion.h"
#include "engine/render/atom_style.h"
#include "engine/render/ball_blocks.h"
#include "engine/structure/colouring.h"

namespace moltact {

/// The chain whose colour an atom has in pictures coloured by chain; none for an atom that keeps its element's.
std::optional<std::uint32_t> colouredChain(const Molecule& molecule, const Atom& atom);

/// How a molecule is coloured where nobody said it: by chain where several chains of protein or nucleic acid are there.
ColourBy usualColourBy(const Molecule& molecule);

/// The colours of a scheme by its name (engine/structure/colouring.h); null for "element" and "chain", which the picture
/// makes itself, and for a name that is not known.
std::shared_ptr<const Colouring> schemeColouring(const Molecule& molecule, std::string_view name);

/// What the atoms' colours come from, the later over the earlier.
struct AtomPaint {
  ElementColours elements = ElementColours::Customary;
  ColourBy by = ColourBy::Element;
  std::shared_ptr<const Colouring> colouring;           ///< of this molecule; null: as `by` says
  std::shared_ptr<const std::vector<OwnColour>> marks;  ///< parts in colours of their own; null: none
  AtomList touched;                                     ///< lightly painted; null: none
  Colour touched_colour{0.0f};
  friend bool operator==(const AtomPaint&, const AtomPaint&) = default;
};

/// The colour of each atom (packColour).
std::vector<std::uint32_t> atomColours(const Molecule& molecule, const AtomPaint& paint);

struct MoleculeModel {
  explicit MoleculeModel(std::shared_ptr<const Molecule> molecule);
  /// The light among the atoms without those hidden (ascending; null: none is).
  void shade(std::shared_ptr<const std::vector<std::uint32_t>> hidden_atoms);
  /// Colours the atoms.
  void paint(AtomPaint with);

  std::shared_ptr<const Molecule> molecule;
  std::shared_ptr<const std::vector<std::uint32_t>> hidden;  ///< as it is shaded
  AtomPaint paint_used;
  unsigned painted = 0;  ///< grows with every painting
  BallScene scene;
  BallBlocks blocks;                  ///< of the scene's balls
  std::vector<std::uint32_t> colour;  ///< bytes red, green, blue, 255 from the lowest
  OcclusionField occlusion;
  std::vector<glm::vec4> wide;  ///< OcclusionField::wideRound of each ball; empty where the field has none
  Vec3 middle_A{0.0};
  double reach_A = 0.0;  ///< all balls lie within this of the middle
};

/// Up to `most` atoms whose inflated spheres come nearest to a place, nearest first, none farther than `gap_A` from it.
std::vector<std::uint32_t> nearestAtoms(const BallScene& scene, PointA place, double probe_A, double gap_A,
                                        std::size_t most);

/// A packed colour with the light paint of what was touched.
std::uint32_t paintedColour(std::uint32_t packed, const Colour& paint);

/// A colour as bytes red, green, blue, alpha from the lowest.
std::uint32_t packColour(const glm::vec3& colour, float alpha = 1.0f);

}  // namespace moltact
