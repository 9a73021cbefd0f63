// The spheres of a scene, and a uniform grid that finds those near a place: all that is prepared before touching.
// Immutable after construction, so every thread may read it. Units: angstrom; indices count from 0 in file order. The
// grid is the paper's "spatial partitioning methods" (section 5). It is hashed by cell, so memory follows the number of
// spheres and not the extent of the scene; a million spheres take about 0.1 s (build/release/tracker_benchmark
// --benchmark_filter=ready).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "engine/core/shared_array.h"
#include "engine/core/sphere.h"

namespace moltact {

class SphereGrid {
 public:
  /// The treatment of spheres with the same centre and radius: keep only the first in the file, or visit each.
  enum class Duplicates : std::uint8_t { KeepFirst, VisitEach };

  /// Centres must be finite and within 1e9 A of the origin, radii finite and not negative (asserted; readers check
  /// files).
  explicit SphereGrid(SharedArray<Sphere> spheres, Duplicates duplicates = Duplicates::KeepFirst);
  /// The same without the spheres of these indices (in any order; beyond the last they are ignored): they keep their
  /// indices and places, but no visit finds them and the box does not count them, so that nothing feels them.
  SphereGrid(SharedArray<Sphere> spheres, std::span<const std::uint32_t> untouchable,
             Duplicates duplicates = Duplicates::KeepFirst);

  /// The spheres at other places, found through the index of `bounds`, which both share: sphere i must lie inside sphere
  /// i of `bounds` (as the spheres of a motion lie inside SphereMotion::sweptSpheres). Untouchable spheres stay so.
  /// A visit finds what it finds in a grid of their own, and some farther spheres; every duplicate is visited that
  /// `bounds` visits. O(n), without sorting: 100 000 spheres take about a millisecond (build/release/motion_benchmark).
  static SphereGrid within(const SphereGrid& bounds, SharedArray<Sphere> spheres);

  const SharedArray<Sphere>& spheres() const { return spheres_; }
  const Sphere& operator[](std::size_t i) const { return spheres_[i]; }
  std::size_t size() const { return spheres_.size(); }
  /// Whether a sphere is there to be felt. `i` in range.
  bool touchable(std::size_t i) const { return untouchable_.empty() || !untouchable_[i]; }
  /// Whether some sphere is there only to be seen.
  bool hasUntouchable() const { return !untouchable_.empty(); }
  /// The indices of those spheres, ascending.
  std::vector<std::uint32_t> untouchable() const;

  /// The box round all centres, widened by the largest radius. Both corners are zero when there are no spheres to feel.
  Vec3 low_A() const { return low_; }
  Vec3 high_A() const { return high_; }
  double largestRadius_A() const { return largest_radius_; }

  /// Bytes beyond the list of spheres.
  std::size_t bytes() const;

  /// Calls visit(index, sphere) for every sphere with |centre - place| <= radius + margin_A, each once, and for some
  /// farther ones: the visitor tests what it needs. A visitor that returns false ends the visit. Of spheres with the same
  /// centre and radius only the first in the file is visited, unless Duplicates::VisitEach was given. No allocation;
  /// the order is fixed for a scene. `cost` counts what is examined besides spheres: cells, and tree nodes of crowded
  /// cells.
  template <class Visit>
  void visitNear(const Vec3& place, double margin_A, Visit&& visit, std::uint64_t* cost = nullptr) const {
    const double reach = margin_A + cell_radius_;
    const auto near = [&](const TreeNode& b) {
      if (cost) ++*cost;
      return glm::distance(place, b.centre) <= b.radius + b.largest + margin_A;
    };
    if (cost) *cost += static_cast<std::uint64_t>(std::min(std::pow(2.0 * reach / cell_, 3.0), double(large_from_)));
    visitBox(place - Vec3(reach), place + Vec3(reach), near, visit);
  }

  /// The same for the spheres whose centres lie within `reach_A` of the place.
  template <class Visit>
  void visitCentresNear(const Vec3& place, double reach_A, Visit&& visit) const {
    const double reach = reach_A + slack_;
    const auto inReach = [&](const TreeNode& b) { return glm::distance(place, b.centre) <= b.radius + reach; };
    visitBox(place - Vec3(reach), place + Vec3(reach), inReach, visit);
  }

  /// The same for the spheres that come within margin_A of any place in the box [low, high]. In a crowded cell only tree
  /// nodes for which `mayMeet(centre, radius)` is true are visited; all spheres of a node lie in that sphere.
  template <class MayMeet, class Visit>
  void visitNearBox(const Vec3& low, const Vec3& high, double margin_A, MayMeet&& mayMeet, Visit&& visit) const {
    const double reach = margin_A + cell_radius_;
    visitBox(
        low - Vec3(reach), high + Vec3(reach),
        [&](const TreeNode& b) { return mayMeet(b.centre, b.radius + b.largest); }, visit);
  }
  template <class Visit>
  void visitNearBox(const Vec3& low, const Vec3& high, double margin_A, Visit&& visit) const {
    visitNearBox(
        low, high, margin_A, [](const Vec3&, double) { return true; }, visit);
  }

  /// The edge of a grid cell (unit: angstrom): a good length of the pieces of a path.
  double cell_A() const { return cell_; }

 private:
  struct Cell {
    std::uint64_t key = kEmpty;
    std::uint32_t begin = 0, end = 0;  // into sorted_
  };
  struct Sorted {
    Sphere sphere;
    std::uint32_t index;
  };
  // A cell with more spheres than this (a hundred thousand within 0.1 A, say) has a tree, so that the cost of a visit
  // follows from the number of spheres found.
  static constexpr std::uint32_t kTreeThreshold = 64;
  struct TreeNode {
    Vec3 centre{0.0};
    double radius = 0.0, largest = 0.0;  // no centre is farther from `centre`, no radius larger
    std::uint32_t begin = 0, end = 0,
                  next = 0;  // into sorted_; the place of the next tree node that is not below this one
    bool leaf = false;
  };
  struct CellTree {
    std::uint32_t begin = 0, root = 0;  // of the cell in sorted_; of its tree in tree_nodes_
  };
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};
  static constexpr double kHalfCells =
      1 << 20;  // cells an axis holds on either side of the origin; farther ones fold into the last

  std::int64_t cellOf(double x, double low) const {
    const double c = std::floor((x - low) / cell_);
    return static_cast<std::int64_t>(!(c > 0) ? 0 : (c > 2 * kHalfCells - 1 ? 2 * kHalfCells - 1 : c));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    return static_cast<std::uint64_t>(x) | static_cast<std::uint64_t>(y) << 21 | static_cast<std::uint64_t>(z) << 42;
  }
  // Four cells side by side along x share a line of the cache.
  std::size_t slot(std::uint64_t k) const {
    return static_cast<std::size_t>(((k >> 2) * 0x9E3779B97F4A7C15ull) >> shift_) << 2 | (k & 3);
  }
  const Cell* find(std::uint64_t k) const {
    for (std::size_t s = slot(k);; s = (s + 1) & mask_) {
      if (cells_[s].key == k) return &cells_[s];
      if (cells_[s].key == kEmpty) return nullptr;
    }
  }

  // Visitors that return nothing never end a visit.
  template <class Visit>
  static bool goesOn(Visit&& visit, const Sorted& s) {
    if constexpr (std::is_same_v<decltype(visit(s.index, s.sphere)), bool>)
      return visit(s.index, s.sphere);
    else
      return visit(s.index, s.sphere), true;
  }

  template <class Accept, class Visit>
  bool visitRange(std::uint32_t begin, std::uint32_t end, Accept&& accept, Visit&& visit) const {
    if (end - begin > kTreeThreshold) return visitTree(begin, accept, visit);
    for (std::uint32_t k = begin; k < end; ++k)
      if (!goesOn(visit, sorted_[k])) return false;
    return true;
  }

  template <class Accept, class Visit>
  [[gnu::noinline]] bool visitTree(std::uint32_t begin, Accept&& accept, Visit&& visit) const {
    const auto cell_tree = std::lower_bound(cell_trees_.begin(), cell_trees_.end(), begin,
                                            [](const CellTree& c, std::uint32_t b) { return c.begin < b; });
    const std::uint32_t end = tree_nodes_[cell_tree->root].next;
    for (std::uint32_t node = cell_tree->root; node < end;) {
      const TreeNode& b = tree_nodes_[node];
      if (!accept(b)) {
        node = b.next;
        continue;
      }
      if (b.leaf)
        for (std::uint32_t k = b.begin; k < b.end; ++k)
          if (!goesOn(visit, sorted_[k])) return false;
      ++node;
    }
    return true;
  }

  template <class Accept, class Visit>
  void visitBox(Vec3 low, Vec3 high, Accept&& accept, Visit&& visit) const {
    const auto spheres = static_cast<std::uint32_t>(sorted_.size());
    if (!visitRange(large_from_, spheres, accept, visit)) return;
    if (large_from_ == 0) return;
    low = glm::max(low, grid_low_);
    high = glm::min(high, grid_high_);
    if (low.x > high.x || low.y > high.y || low.z > high.z) return;
    const std::int64_t x0 = cellOf(low.x, grid_low_.x), x1 = cellOf(high.x, grid_low_.x);
    const std::int64_t y0 = cellOf(low.y, grid_low_.y), y1 = cellOf(high.y, grid_low_.y);
    const std::int64_t z0 = cellOf(low.z, grid_low_.z), z1 = cellOf(high.z, grid_low_.z);
    const double looked_up = double(x1 - x0 + 1) * double(y1 - y0 + 1) * double(z1 - z0 + 1);
    if (looked_up > double(large_from_)) {  // a box over most of a sparse scene: the list is shorter than the cells
      for (std::uint32_t k = 0; k < large_from_; ++k)
        if (!goesOn(visit, sorted_[k])) return;
      return;
    }
    for (std::int64_t z = z0; z <= z1; ++z)
      for (std::int64_t y = y0; y <= y1; ++y)
        for (std::int64_t x = x0; x <= x1; ++x)
          if (const Cell* c = find(key(x, y, z)))
            if (!visitRange(c->begin, c->end, accept, visit)) return;
  }

  void makeTree(std::uint32_t begin, std::uint32_t end, std::vector<TreeNode>& nodes, std::vector<CellTree>& trees);

  SharedArray<Sphere> spheres_;
  SharedArray<std::uint8_t> untouchable_;  // of each sphere; empty: none is
  std::vector<Sorted> sorted_;             // by cell, the cells along x, then y, then z: neighbours lie near in memory;
  std::uint32_t large_from_ = 0;      // from here on the few spheres much larger than the rest, tested at every visit
  SharedArray<TreeNode> tree_nodes_;  // trees, each node before those below it
  SharedArray<CellTree> cell_trees_;  // by begin
  SharedArray<Cell> cells_;           // open addressing, at most half full
  std::size_t mask_ = 0;
  int shift_ = 62;  // 64 less the bits of a quarter of the table
  Vec3 low_{0.0}, high_{0.0}, grid_low_{0.0}, grid_high_{0.0};
  double cell_ = 1.0, cell_radius_ = 0.0, largest_radius_ = 0.0;
  double slack_ = 0.0;  // no centre is farther from the centre that its cell was chosen by
};

}  // namespace moltact
