// The spheres of a scene in a uniform grid that finds the spheres near a point: the data prepared before touching.
// Immutable after construction, so every thread may read it. Units: angstrom; indices count from 0 in file order.
//
// The grid is the paper's "spatial partitioning methods" (section 5). It is hashed by cell, so its memory is
// proportional to the number of spheres, independent of the extent of the scene. Construction takes about 0.1 s for a
// million spheres (build/release/tracker_benchmark --benchmark_filter=ready). A visit costs time proportional to the
// cells in its range and the spheres found.
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
  /// The treatment of spheres with equal centre and radius: visit only the first in the file, or each.
  enum class Duplicates : std::uint8_t { KeepFirst, VisitEach };

  /// Centres must be finite and within 1e9 A of the origin, radii finite and not negative (asserted; readers check
  /// files).
  explicit SphereGrid(SharedArray<Sphere> spheres, Duplicates duplicates = Duplicates::KeepFirst);
  /// The same with untouchable spheres, given by index in any order; indices out of range are ignored. They keep their
  /// indices and positions, but no visit finds them and the bounding box excludes them, so they exert no force.
  SphereGrid(SharedArray<Sphere> spheres, std::span<const std::uint32_t> untouchable,
             Duplicates duplicates = Duplicates::KeepFirst);

  /// Creates a grid for spheres at other positions that shares the index of `bounds`. Sphere i must lie inside sphere i
  /// of `bounds`, as the spheres of a motion lie inside SphereMotion::sweptSpheres(). Untouchable spheres stay so. A
  /// visit finds the same spheres as in a grid of their own and some farther ones; duplicates are visited as in
  /// `bounds`. O(n), without sorting: 100 000 spheres take about a millisecond (build/release/motion_benchmark).
  static SphereGrid within(const SphereGrid& bounds, SharedArray<Sphere> spheres);

  const SharedArray<Sphere>& spheres() const { return spheres_; }
  const Sphere& operator[](std::size_t i) const { return spheres_[i]; }
  std::size_t size() const { return spheres_.size(); }
  /// True if sphere `i` can be felt. `i` must be in range.
  bool touchable(std::size_t i) const { return untouchable_.empty() || !untouchable_[i]; }
  /// True if at least one sphere is untouchable: drawn but not felt.
  bool hasUntouchable() const { return !untouchable_.empty(); }
  /// The indices of the untouchable spheres, ascending.
  std::vector<std::uint32_t> untouchable() const;

  /// The bounding box of all centres, widened by the largest radius. Both corners are zero without touchable spheres.
  Vec3 low_A() const { return low_; }
  Vec3 high_A() const { return high_; }
  double largestRadius_A() const { return largest_radius_; }

  /// Memory besides the list of spheres (unit: byte).
  std::size_t bytes() const;

  /// Calls visit(index, sphere) once for every sphere with |centre - place| <= radius + margin_A, and for some farther
  /// ones; the visitor applies the exact test. A visitor that returns false ends the visit. Of spheres with equal
  /// centre and radius only the first in the file is visited, unless Duplicates::VisitEach was given. No allocation;
  /// the order is fixed for a scene. `cost` is increased by the number of examined cells and tree nodes of crowded
  /// cells, without spheres.
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

  /// The same for the spheres whose centres lie within `reach_A` of the point.
  template <class Visit>
  void visitCentresNear(const Vec3& place, double reach_A, Visit&& visit) const {
    const double reach = reach_A + slack_;
    const auto inReach = [&](const TreeNode& b) { return glm::distance(place, b.centre) <= b.radius + reach; };
    visitBox(place - Vec3(reach), place + Vec3(reach), inReach, visit);
  }

  /// The same for the spheres within margin_A of any point of the box [low, high]. In a crowded cell only tree nodes
  /// with `mayMeet(centre, radius)` are visited; the sphere (centre, radius) contains all spheres of the node.
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

  /// The edge length of a grid cell (unit: angstrom), suitable as the length of the pieces of a path.
  double cell_A() const { return cell_; }

 private:
  struct Cell {
    std::uint64_t key = kEmpty;
    std::uint32_t begin = 0, end = 0;  // range in sorted_
  };
  struct Sorted {
    Sphere sphere;
    std::uint32_t index;
  };
  // A cell with more spheres than this has a tree, so that the cost of a visit is proportional to the number of spheres
  // found. An example is a hundred thousand spheres within 0.1 A.
  static constexpr std::uint32_t kTreeThreshold = 64;
  struct TreeNode {
    Vec3 centre{0.0};
    double radius = 0.0, largest = 0.0;  // bounds of the distance of a centre from `centre`, and of the radii
    std::uint32_t begin = 0, end = 0;    // range in sorted_
    std::uint32_t next = 0;              // index of the next tree node outside this subtree
    bool leaf = false;
  };
  struct CellTree {
    std::uint32_t begin = 0, root = 0;  // start of the cell in sorted_, root of its tree in tree_nodes_
  };
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};
  // Cells per axis on either side of the origin; spheres farther away share the last cell.
  static constexpr double kHalfCells = 1 << 20;

  std::int64_t cellOf(double x, double low) const {
    const double c = std::floor((x - low) / cell_);
    return static_cast<std::int64_t>(!(c > 0) ? 0 : (c > 2 * kHalfCells - 1 ? 2 * kHalfCells - 1 : c));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    return static_cast<std::uint64_t>(x) | static_cast<std::uint64_t>(y) << 21 | static_cast<std::uint64_t>(z) << 42;
  }
  // Four cells adjacent along x share a cache line.
  std::size_t slot(std::uint64_t k) const {
    return static_cast<std::size_t>(((k >> 2) * 0x9E3779B97F4A7C15ull) >> shift_) << 2 | (k & 3);
  }
  const Cell* find(std::uint64_t k) const {
    for (std::size_t s = slot(k);; s = (s + 1) & mask_) {
      if (cells_[s].key == k) return &cells_[s];
      if (cells_[s].key == kEmpty) return nullptr;
    }
  }

  // A visitor without a return value never ends a visit.
  template <class Visit>
  static bool continueVisit(Visit&& visit, const Sorted& s) {
    if constexpr (std::is_same_v<decltype(visit(s.index, s.sphere)), bool>)
      return visit(s.index, s.sphere);
    else
      return visit(s.index, s.sphere), true;
  }

  template <class Accept, class Visit>
  bool visitRange(std::uint32_t begin, std::uint32_t end, Accept&& accept, Visit&& visit) const {
    if (end - begin > kTreeThreshold) return visitTree(begin, accept, visit);
    for (std::uint32_t k = begin; k < end; ++k)
      if (!continueVisit(visit, sorted_[k])) return false;
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
          if (!continueVisit(visit, sorted_[k])) return false;
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
    const double cell_count = double(x1 - x0 + 1) * double(y1 - y0 + 1) * double(z1 - z0 + 1);
    if (cell_count > double(large_from_)) {  // a box over most of a sparse scene: scanning the list is faster
      for (std::uint32_t k = 0; k < large_from_; ++k)
        if (!continueVisit(visit, sorted_[k])) return;
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
  SharedArray<std::uint8_t> untouchable_;  // one flag per sphere; empty: none is untouchable
  std::vector<Sorted> sorted_;             // by cell, the cells along x, then y, then z: neighbours are near in memory
  std::uint32_t large_from_ = 0;      // start of the few spheres much larger than the rest, which every visit tests
  SharedArray<TreeNode> tree_nodes_;  // trees in preorder
  SharedArray<CellTree> cell_trees_;  // by begin
  SharedArray<Cell> cells_;           // open addressing, at most half full
  std::size_t mask_ = 0;
  int shift_ = 62;  // 64 minus the bits of a quarter of the table
  Vec3 low_{0.0}, high_{0.0}, grid_low_{0.0}, grid_high_{0.0};
  double cell_ = 1.0, cell_radius_ = 0.0, largest_radius_ = 0.0;
  double slack_ = 0.0;  // upper bound of the distance from a centre to the one that selected its cell
};

}  // namespace moltact
