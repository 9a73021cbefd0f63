// The renderer's cached data of a molecule: the drawn spheres, colours, ambient occlusion, and blocks for neighbour
// searches. A sphere represents an atom, or in very large molecules a residue (engine/render/residue_spheres.h).
// Created once per molecule; colours, ambient occlusion and coordinates can change. Units: angstrom.
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

/// The chain that determines an atom's colour when colouring by chain; empty for an atom that keeps its element's
/// colour.
std::optional<std::uint32_t> colouredChain(const Molecule& molecule, const Atom& atom);

/// The default colouring of a molecule: by chain if it has several chains of protein or nucleic acid, else by element.
ColourBy usualColourBy(const Molecule& molecule);

/// The colours of a scheme by its name (engine/structure/colouring.h). Null for "element" and "chain", which the
/// renderer implements itself, and for an unknown name.
std::shared_ptr<const Colouring> schemeColouring(const Molecule& molecule, std::string_view name,
                                                 const ColouringInput& input = {});

/// The sources of the atoms' colours; later members override earlier ones.
struct AtomPaint {
  ElementColours elements = ElementColours::Customary;
  ColourBy by = ColourBy::Element;
  std::shared_ptr<const Colouring> colouring;           ///< for this molecule; null: use `by`
  std::shared_ptr<const std::vector<OwnColour>> marks;  ///< parts with colours of their own; null: none
  AtomList touched;                                     ///< atoms mixed with touched_colour; null: none
  Colour touched_colour{0.0f};
  friend bool operator==(const AtomPaint&, const AtomPaint&) = default;
};

/// The colour of each atom (packColour).
std::vector<std::uint32_t> atomColours(const Molecule& molecule, const AtomPaint& paint);

/// The ambient occlusion of a set of spheres.
struct MoleculeLight {
  OcclusionField field;
  std::vector<glm::vec4> wide;  ///< OcclusionField::wideRound per sphere; empty if the field is empty
};

/// Computes the ambient occlusion of the spheres with nonzero `shown` (empty: all). Pure function; any thread except
/// the haptic one.
MoleculeLight lightAmong(const SharedArray<Sphere>& spheres, const std::vector<std::uint8_t>& shown);

struct MoleculeModel {
  /// A molecule of more than `max_single` atoms is drawn by residues.
  explicit MoleculeModel(std::shared_ptr<const Molecule> molecule, std::size_t max_single = kMaxSingleAtoms);
  /// Adopts other coordinates of the same molecule in linear time. Keeps the colours, blocks, bonds and secondary
  /// structure, and the ambient occlusion until lightBy(). Returns false and changes nothing if the molecule is a
  /// different one or is drawn by residues.
  bool moveTo(const std::shared_ptr<const Molecule>& moved);
  /// Adopts the ambient occlusion computed by lightAmong(spheres, shownWithout(hidden)).
  void lightBy(MoleculeLight found_light);
  /// One flag per sphere: nonzero if at least one of its atoms is not in `hidden_atoms` (ascending; null: none). Empty:
  /// all are shown.
  std::vector<std::uint8_t> shownWithout(const AtomList& hidden_atoms) const;
  /// Colours the atoms.
  void paint(AtomPaint with);

  /// True if the spheres represent residues.
  bool byResidue() const { return !first_atom.empty(); }
  std::size_t atoms() const { return molecule->atoms.size(); }
  /// An atom's own sphere. `atom` must be in range.
  Sphere atomSphere(std::uint32_t atom) const { return molecule->spheres[atom]; }
  /// The sphere that represents an atom. `atom` must be in range.
  std::uint32_t sphereOf(std::uint32_t atom) const;
  /// The spheres that represent any of these atoms, ascending.
  std::vector<std::uint32_t> spheresOf(std::vector<std::uint32_t> atoms) const;
  /// Converts flags per atom to flags per sphere: nonzero if any of its atoms is shown.
  std::vector<std::uint8_t> shownSpheres(std::vector<std::uint8_t> atoms) const;
  /// Calls visit(atom, sphere) for every atom within margin_A of the point, and for some others.
  template <class Visit>
  void visitAtomsNear(const Vec3& place_A, double margin_A, Visit&& visit) const {
    if (!byResidue()) return blocks.visitNear(spheres, place_A, margin_A, visit);
    blocks.visitNear(spheres, place_A, margin_A + beyond_A, [&](std::uint32_t sphere, const Sphere&) {
      for (std::uint32_t a = first_atom[sphere]; a < first_atom[sphere + 1]; ++a) visit(a, atomSphere(a));
    });
  }

  std::shared_ptr<const Molecule> molecule;
  AtomList hidden;  ///< the hidden atoms for which `light` was computed
  AtomPaint paint_used;
  unsigned painted = 0;  ///< incremented by every painting
  unsigned lit = 0;      ///< incremented by every lightBy()
  std::size_t max_single;
  std::vector<std::uint32_t> first_atom;  ///< ResidueSpheres::first_atom; empty: each atom is a sphere
  double beyond_A = 0.0;                  ///< upper bound by which an atom extends beyond its sphere
  SharedArray<Sphere> spheres;            ///< the molecule's own, or one per residue
  SphereBlocks blocks;                    ///< of the spheres
  std::vector<std::uint32_t> colour;      ///< per sphere: bytes red, green, blue, 255 from the lowest
  MoleculeLight light;
  std::shared_ptr<FoundStructure> found;  ///< of the molecule, for its styles; never null
  Vec3 middle_A{0.0};                     ///< centre of the bounding box of the spheres' centres
  double reach_A = 0.0;                   ///< radius around middle_A that contains all spheres and atoms

 private:
  void measure();
};

/// The atoms whose inflated spheres are nearest to a point, at most `max_count` and within `gap_A`, nearest first.
std::vector<std::uint32_t> nearestAtoms(const MoleculeModel& model, PointA place, double probe_A, double gap_A,
                                        std::size_t max_count);

/// A packed colour mixed with the paint of touched atoms.
std::uint32_t paintedColour(std::uint32_t packed, const Colour& paint);

/// Packs a colour as bytes red, green, blue, alpha from the lowest.
std::uint32_t packColour(const glm::vec3& colour, float alpha = 1.0f);

}  // namespace moltact
