#include "engine/trajectory/frame_placer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/molecule/reader.h"
#include "engine/structure/bonds.h"
#include "engine/structure/superposition.h"

namespace moltact {
namespace {

constexpr std::uint32_t kNone = ~0u;

AtomPairs selfPairs(const Molecule& molecule, std::span<const std::uint32_t> atoms) {
  AtomPairs out;
  if (atoms.empty())
    for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i) out.emplace_back(i, i);
  for (const std::uint32_t i : atoms) out.emplace_back(i, i);
  return out;
}

/// The multiple of the cell's vectors nearest to this displacement.
Vec3 nearestLattice(const glm::dmat3& cell, const glm::dmat3& inverse, const Vec3& displacement_A) {
  return cell * glm::round(inverse * displacement_A);
}

}  // namespace

Expected<FramePlacer> FramePlacer::make(std::shared_ptr<const Molecule> molecule, std::size_t atoms,
                                        const std::string& file, const FrameFit& fit) {
  const Molecule& m = *molecule;
  FramePlacer out;
  const std::size_t in_file = m.atoms_in_file ? m.atoms_in_file : m.atoms.size();
  if (m.beside_from > 0)
    return Problem{file, 0, 0, tr("a trajectory moves one molecule, not two side by side"),
                   tr("leave out the second molecule")};
  if (atoms != in_file && atoms != m.atoms.size())
    return Problem{
        file, 0, 0,
        trf("its frames have {0} atoms; the molecule has {1}, and its file {2}", atoms, m.atoms.size(), in_file),
        tr("take the structure from which the trajectory was computed, with the same atoms")};
  out.superposed_ = fit.superposed;
  if (fit.superposed) {
    const AtomPairs pairs = selfPairs(m, fit.on);
    if (const auto possible = superpose(m, m, pairs); !possible) {
      if (!fit.on.empty())
        return Problem{file, 0, 0, tr("its frames cannot be superposed on fewer than three atoms, or atoms on a line"),
                       tr("superpose on more atoms")};
      out.superposed_ = false;
    }
    out.fitted_ = pairs;
  }
  const std::size_t n = m.atoms.size();
  const BondTable bonds(n, findBonds(m));
  out.part_of_.assign(n, kNone);
  std::vector<std::size_t> sizes;
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t root = 0; root < n; ++root) {
    if (out.part_of_[root] != kNone) continue;
    const auto part = static_cast<std::uint32_t>(sizes.size());
    sizes.push_back(0);
    out.part_of_[root] = part;
    waiting.assign(1, root);
    for (std::size_t k = 0; k < waiting.size(); ++k) {
      ++sizes.back();
      for (const std::uint32_t next : bonds.neighbours(waiting[k])) {
        if (out.part_of_[next] != kNone) continue;
        out.part_of_[next] = part;
        out.steps_.push_back({next, waiting[k]});
        waiting.push_back(next);
      }
    }
  }
  out.parts_ = sizes.size();
  out.largest_ = static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  if (out.parts_ > 1) {
    std::vector<std::uint32_t> of_largest;
    for (std::uint32_t i = 0; i < n; ++i)
      if (out.part_of_[i] == out.largest_) of_largest.push_back(i);
    if (of_largest.size() >= 3) out.turns_ = selfPairs(m, of_largest);
  }
  out.molecule_ = std::move(molecule);
  return out;
}

void FramePlacer::makeWhole(std::vector<Vec3>& places, const glm::dmat3& cell) const {
  const glm::dmat3 inverse = glm::inverse(cell);
  for (const Step& step : steps_)
    places[step.atom] -= nearestLattice(cell, inverse, places[step.atom] - places[step.from]);
  // Each covalent molecule comes as near as possible to its place beside the largest one in the structure.
  std::vector<Vec3> here(parts_, Vec3(0.0)), there(parts_, Vec3(0.0));
  std::vector<double> count(parts_, 0.0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::uint32_t part = part_of_[i];
    here[part] += places[i];
    there[part] += molecule_->spheres[i].centre_A;
    ++count[part];
  }
  const auto middle = [&](const std::vector<Vec3>& sums, std::size_t part) { return sums[part] / count[part]; };
  // The largest one shows how the whole has turned.
  glm::dmat3 turned(1.0);
  if (!turns_.empty())
    if (const auto fit = superpose(*molecule_, places, turns_)) turned = glm::transpose(fit->rotation);
  std::vector<Vec3> shift(parts_);
  for (std::size_t part = 0; part < parts_; ++part)
    shift[part] = nearestLattice(
        cell, inverse,
        middle(here, part) - middle(here, largest_) - turned * (middle(there, part) - middle(there, largest_)));
  for (std::size_t i = 0; i < places.size(); ++i) places[i] -= shift[part_of_[i]];
}

std::vector<Vec3> FramePlacer::place(const TrajectoryFrame& frame) const {
  const Molecule& m = *molecule_;
  const std::size_t n = m.atoms.size();
  std::vector<Vec3> out(n);
  const bool of_file = frame.positions_A.size() != n && !m.numbers_in_file.empty();
  for (std::size_t i = 0; i < n; ++i) out[i] = frame.positions_A[of_file ? m.numbers_in_file[i] : i];
  if (frame.cell_A) {
    std::vector<Vec3> whole = out;
    makeWhole(whole, *frame.cell_A);
    // A cell without sense, such as one thinner than rounding, is left out.
    const bool sound = std::all_of(whole.begin(), whole.end(), [](const Vec3& place) {
      return std::abs(place.x) <= kMaxCoordinate_A && std::abs(place.y) <= kMaxCoordinate_A &&
             std::abs(place.z) <= kMaxCoordinate_A;
    });
    if (sound) out = std::move(whole);
  }
  if (!superposed_) return out;
  const auto fit = superpose(m, out, fitted_);
  // Atoms of this frame alone lie on a line: it is left as it is.
  if (!fit) return out;
  for (Vec3& place : out) place = (*fit)(place);
  return out;
}

}  // namespace moltact
