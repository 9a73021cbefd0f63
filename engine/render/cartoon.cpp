#include "engine/render/cartoon.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/sphere_intersections.h"
#include "engine/core/units.h"
#include "engine/render/sticks.h"
#include "engine/structure/backbone.h"
#include "engine/structure/secondary_structure.h"

namespace moltact {
namespace {

constexpr int kPieces = 8;    // subdivisions between two residues
constexpr int kCorners = 14;  // vertices of a cross section

// A residue on the ribbon's path.
struct Knot {
  Vec3 place, side;  // `side` along the ribbon's width
  double width = kTube_A, thickness = kTube_A;
  bool arrow = false;  // the strand ends here
  std::uint32_t colour = 0;
};

Vec3 unit(const Vec3& v, const Vec3& otherwise) {
  const double n = glm::length(v);
  return n > 1e-6 ? v / n : otherwise;
}

Vec3 across(const Vec3& v, const Vec3& along) { return v - along * glm::dot(v, along); }

class Ribbon {
 public:
  Ribbon(std::vector<Knot> knots, MeshPiece& piece) : knots_(std::move(knots)), piece_(piece) {
    // The sides of neighbours point the same way, so that the ribbon does not flip.
    for (std::size_t i = 1; i < knots_.size(); ++i)
      if (glm::dot(knots_[i].side, knots_[i - 1].side) < 0) knots_[i].side = -knots_[i].side;
  }

  void build() {
    if (knots_.size() < 2) return;
    Vec3 tangent = unit(knots_[1].place - knots_[0].place, {1, 0, 0});
    for (std::size_t i = 0; i + 1 < knots_.size(); ++i)
      for (int k = 0; k < kPieces; ++k) {
        const double t = double(k) / kPieces;
        // The colour, and at a strand's end the arrow, change midway between residues.
        const bool second = 2 * k >= kPieces;
        if (2 * k == kPieces) ring(i, t - 1e-9, i, tangent);
        ring(i, t, second ? i + 1 : i, tangent);
      }
    ring(knots_.size() - 2, 1.0, knots_.size() - 1, tangent);
    close(first_ring_, true);
    close(last_ring_, false);
  }

 private:
  Vec3 placeAt(std::ptrdiff_t i) const {
    const auto n = std::ptrdiff_t(knots_.size());
    if (i < 0) return 2.0 * knots_[0].place - knots_[1].place;
    if (i >= n) return 2.0 * knots_[std::size_t(n - 1)].place - knots_[std::size_t(n - 2)].place;
    return knots_[std::size_t(i)].place;
  }

  // Half the width; in an arrow it decreases from the barbs to the tip.
  double widthAt(std::size_t i, double t) const {
    const Knot &a = knots_[i], &b = knots_[i + 1];
    if (a.arrow) return t < 0.5 ? glm::mix(0.5 * kArrowWidth_A, kTube_A, 2.0 * t) : b.width;
    if (b.arrow) return t < 0.5 ? a.width : glm::mix(kArrowWidth_A, 0.5 * kArrowWidth_A, 2.0 * t - 1.0);
    const double s = t * t * (3.0 - 2.0 * t);
    return glm::mix(a.width, b.width, s);
  }

  void ring(std::size_t i, double t, std::size_t coloured, Vec3& tangent) {
    const Vec3 p0 = placeAt(std::ptrdiff_t(i) - 1), p1 = placeAt(std::ptrdiff_t(i)),
               p2 = placeAt(std::ptrdiff_t(i) + 1), p3 = placeAt(std::ptrdiff_t(i) + 2);
    const double t2 = t * t, t3 = t2 * t;  // Catmull and Rom 1974
    const Vec3 place = 0.5 * (2.0 * p1 + (p2 - p0) * t + (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) * t2 +
                              (3.0 * p1 - p0 - 3.0 * p2 + p3) * t3);
    tangent = unit(0.5 * ((p2 - p0) + 2.0 * t * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) +
                          3.0 * t2 * (3.0 * p1 - p0 - 3.0 * p2 + p3)),
                   tangent);
    const Vec3 side = unit(across(glm::mix(knots_[i].side, knots_[i + 1].side, t), tangent), anyNormal(tangent));
    const Vec3 up = glm::cross(tangent, side);
    const double width = widthAt(i, t), thick = glm::mix(knots_[i].thickness, knots_[i + 1].thickness, t);
    const auto first = std::uint32_t(piece_.vertices.size());
    for (int c = 0; c < kCorners; ++c) {
      const double angle = kTwoPi * c / kCorners, x = std::cos(angle), y = std::sin(angle);
      const Vec3 out = unit(side * (x / width) + up * (y / thick), up);
      piece_.vertices.push_back({glm::vec3(place + side * (x * width) + up * (y * thick) - piece_.origin_A),
                                 glm::vec3(out), knots_[coloured].colour});
    }
    if (any_)
      for (std::uint32_t c = 0; c < kCorners; ++c) {
        const std::uint32_t d = (c + 1) % kCorners;
        piece_.triangle(last_ring_ + c, last_ring_ + d, first + c);
        piece_.triangle(first + c, last_ring_ + d, first + d);
      }
    if (!any_) first_ring_ = first;
    any_ = true;
    last_ring_ = first;
    last_tangent_ = tangent;
    if (first == first_ring_) first_tangent_ = tangent;
  }

  void close(std::uint32_t ring, bool at_start) {
    const Vec3 out = at_start ? -first_tangent_ : last_tangent_;
    const auto first = std::uint32_t(piece_.vertices.size());
    for (std::uint32_t c = 0; c < kCorners; ++c) {
      MeshPiece::Vertex v = piece_.vertices[ring + c];
      v.normal = glm::vec3(out);
      piece_.vertices.push_back(v);
    }
    for (std::uint32_t c = 1; c + 1 < kCorners; ++c)
      at_start ? piece_.triangle(first, first + c + 1, first + c) : piece_.triangle(first, first + c, first + c + 1);
  }

  std::vector<Knot> knots_;
  MeshPiece& piece_;
  std::uint32_t first_ring_ = 0, last_ring_ = 0;
  Vec3 first_tangent_{1, 0, 0}, last_tangent_{1, 0, 0};
  bool any_ = false;
};

class Cartoon {
 public:
  Cartoon(const Molecule& molecule, std::span<const std::uint8_t> drawn, std::span<const std::uint32_t> colours)
      : molecule_(molecule), drawn_(drawn), colours_(colours) {
    for (const Sphere& a : molecule.spheres) piece_.origin_A += a.centre_A / double(molecule.atoms.size());
  }

  MeshPiece build(const MoleculeStructure& structure) {
    std::vector<std::uint8_t> ends(molecule_.residues.size(), 0);
    for (const StructureElement& e : structure.elements)
      if (e.kind == SecondaryStructure::Strand) ends[e.last_residue] = 1;
    for (const ProteinStretch& stretch : proteinBackbone(molecule_)) protein(stretch, structure, ends);
    for (const NucleicStretch& stretch : nucleicBackbone(molecule_)) nucleic(stretch);
    return std::move(piece_);
  }

 private:
  Vec3 at(std::uint32_t atom) const { return molecule_.spheres[atom].centre_A; }

  void protein(const ProteinStretch& stretch, const MoleculeStructure& structure,
               const std::vector<std::uint8_t>& ends) {
    std::vector<Knot> run;
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      const AminoAcidAtoms& r = stretch[i];
      if (!drawn_[r.ca]) {
        Ribbon(std::move(run), piece_).build();
        run.clear();
        continue;
      }
      const SecondaryStructure kind = structure.of_residue[r.residue];
      Knot knot;
      knot.place = at(r.ca);
      knot.colour = colours_[r.ca];
      const std::size_t before = i > 0 ? i - 1 : i, after = i + 1 < stretch.size() ? i + 1 : i;
      const Vec3 along = unit(at(stretch[after].ca) - at(stretch[before].ca), {1, 0, 0});
      // Strands are pleated; the ribbon follows the middle of the pleats.
      if (kind == SecondaryStructure::Strand && before != i && after != i)
        knot.place = 0.5 * knot.place + 0.25 * (at(stretch[before].ca) + at(stretch[after].ca));
      const Vec3 carbonyl = r.c != kNoAtom && r.o != kNoAtom ? at(r.o) - at(r.c) : anyNormal(along);
      const Vec3 flat = unit(across(carbonyl, along), anyNormal(along));
      // In a helix the carbonyl, and the ribbon's width, point along the axis; in a strand they lie in the sheet.
      knot.side = flat;
      if (kind != SecondaryStructure::Coil) {
        knot.width = kind == SecondaryStructure::Helix ? kHelixWidth_A : kStrandWidth_A;
        knot.thickness = kFlat_A;
        knot.arrow = ends[r.residue] != 0;
      }
      run.push_back(knot);
    }
    Ribbon(std::move(run), piece_).build();
  }

  void nucleic(const NucleicStretch& stretch) {
    constexpr double kBand_A = 1.1, kRung_A = 0.34;
    std::vector<Knot> run;
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      const NucleotideAtoms& r = stretch[i];
      if (!drawn_[r.guide()]) {
        Ribbon(std::move(run), piece_).build();
        run.clear();
        continue;
      }
      const Vec3 along = unit(
          at(stretch[std::min(i + 1, stretch.size() - 1)].guide()) - at(stretch[i > 0 ? i - 1 : 0].guide()), {1, 0, 0});
      const Vec3 inward = r.c1 != kNoAtom ? at(r.c1) - at(r.guide()) : anyNormal(along);
      Knot knot;
      knot.place = at(r.guide());
      knot.colour = colours_[r.guide()];
      knot.side = unit(glm::cross(along, inward), anyNormal(along));  // the band winds around the helix
      knot.width = kBand_A;
      knot.thickness = kFlat_A;
      run.push_back(knot);
      if (r.base == kNoAtom) continue;
      // The rung starts on the band, midway between this phosphate and the next.
      const Vec3 from = i + 1 < stretch.size() ? 0.5 * (at(r.guide()) + at(stretch[i + 1].guide())) : at(r.guide());
      addStick(piece_, from, at(r.base), kRung_A, colours_[r.base], true);
    }
    Ribbon(std::move(run), piece_).build();
  }

  const Molecule& molecule_;
  std::span<const std::uint8_t> drawn_;
  std::span<const std::uint32_t> colours_;
  MeshPiece piece_;
};

}  // namespace

MeshPiece cartoon(const Molecule& molecule, std::span<const std::uint8_t> drawn, std::span<const std::uint32_t> colours,
                  const MoleculeStructure& structure) {
  return Cartoon(molecule, drawn, colours).build(structure);
}

bool inCartoon(const Residue& residue) {
  return residue.kind == ResidueKind::AminoAcid || residue.kind == ResidueKind::Nucleotide;
}

}  // namespace moltact
