// The renderer's data of a molecule between pictures: the spheres that it draws, colours, ambient occlusion, and blocks to
// find neighbours. A sphere is an atom, or beyond so many atoms a residue (engine/render/residue_spheres.h).
// Made once for a molecule; its colours, its light and its coordinates change. Units: angstrom.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/core/shared_array.h"
#include "engine/molecule/molecule.h"
#include "engine/render/ambient_occlusion.h"
#include "engine/render/atom_style.h"
#include "engine/render/residue_spheres.h"
#include "engine/render/sphere_blocks.h"
#include "engine/structure/colouring.h"
#include "engine/structure/found_structure.h"

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

/// The light among spheres.
struct MoleculeLight {
  OcclusionField field;
  std::vector<glm::vec4> wide;  ///< OcclusionField::wideRound of each sphere; empty where the field has none
};

/// The light among those spheres for which `shown` says so (empty: all). Pure function; any thread but the haptic one.
MoleculeLight lightAmong(const SharedArray<Sphere>& spheres, const std::vector<std::uint8_t>& shown);

struct MoleculeModel {
  /// A molecule of more than `most_single` atoms is drawn by its residues.
  explicit MoleculeModel(std::shared_ptr<const Molecule> molecule, std::size_t most_single = kMaxSingleAtoms);
  /// Takes other coordinates of the same molecule, in a time that follows the number of atoms: colours, blocks, bonds and
  /// secondary structure stay, and so does the light until lightBy(). False, and unchanged, where the molecule
  /// is another one or is drawn by its residues.
  bool moveTo(const std::shared_ptr<const Molecule>& moved);
  /// Takes the light among its spheres, as lightAmong(spheres, shownWithout(hidden)) finds it.
  void lightBy(MoleculeLight found_light);
  /// Of each sphere whether some of its atoms is not among those hidden (ascending; null: none is); empty: all are shown.
  std::vector<std::uint8_t> shownWithout(const AtomList& hidden_atoms) const;
  /// Colours the atoms.
  void paint(AtomPaint with);

  /// Whether a sphere stands for a residue.
  bool byResidue() const { return !first_atom.empty(); }
  std::size_t atoms() const { return molecule->atoms.size(); }
  /// An atom's own sphere. `atom` in range.
  Sphere atomSphere(std::uint32_t atom) const { return molecule->spheres[atom]; }
  /// The sphere that stands for an atom. `atom` in range.
  std::uint32_t sphereOf(std::uint32_t atom) const;
  /// The spheres of which some atom is among these, ascending as they are.
  std::vector<std::uint32_t> spheresOf(std::vector<std::uint32_t> atoms) const;
  /// Of each sphere whether some of its atoms is shown, from the same of each atom.
  std::vector<std::uint8_t> shownSpheres(std::vector<std::uint8_t> atoms) const;
  /// Calls visit(atom, sphere) for every atom that comes within margin_A of the place, and for some others.
  template <class Visit>
  void visitAtomsNear(const Vec3& place_A, double margin_A, Visit&& visit) const {
    if (!byResidue()) return blocks.visitNear(spheres, place_A, margin_A, visit);
    blocks.visitNear(spheres, place_A, margin_A + beyond_A, [&](std::uint32_t sphere, const Sphere&) {
      for (std::uint32_t a = first_atom[sphere]; a < first_atom[sphere + 1]; ++a) visit(a, atomSphere(a));
    });
  }

  std::shared_ptr<const Molecule> molecule;
  AtomList hidden;  ///< as it is lit: those of the light
  AtomPaint paint_used;
  unsigned painted = 0;  ///< grows with every painting
  unsigned lit = 0;      ///< grows with every light
  std::size_t most_single;
  std::vector<std::uint32_t> first_atom;  ///< ResidueSpheres::first_atom; empty where each atom is a sphere
  double beyond_A = 0.0;                  ///< no atom reaches farther out of its sphere
  SharedArray<Sphere> spheres;            ///< the molecule's own, or one for each residue
  SphereBlocks blocks;                    ///< of the spheres
  std::vector<std::uint32_t> colour;      ///< of each sphere: bytes red, green, blue, 255 from the lowest
  MoleculeLight light;
  std::shared_ptr<FoundStructure> found;  ///< of the molecule, for its styles; never null
  Vec3 middle_A{0.0};
  double reach_A = 0.0;  ///< all spheres and atoms lie within this of the middle

 private:
  void measure();
};

/// Up to `most` atoms whose inflated spheres come nearest to a place, nearest first, none farther than `gap_A` from it.
std::vector<std::uint32_t> nearestAtoms(const MoleculeModel& model, PointA place, double probe_A, double gap_A,
                                        std::size_t most);

/// A packed colour with the light paint of what was touched.
std::uint32_t paintedColour(std::uint32_t packed, const Colour& paint);

/// A colour as bytes red, green, blue, alpha from the lowest.
std::uint32_t packColour(const glm::vec3& colour, float alpha = 1.0f);

}  // namespace moltact
