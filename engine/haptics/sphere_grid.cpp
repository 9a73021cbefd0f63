#include "engine/haptics/sphere_grid.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <tuple>

#include "engine/haptics/tracker.h"

namespace moltact {

SphereGrid::SphereGrid(SharedArray<Sphere> spheres, Duplicates duplicates)
    : SphereGrid(std::move(spheres), std::span<const std::uint32_t>{}, duplicates) {}

SphereGrid::SphereGrid(SharedArray<Sphere> spheres, std::span<const std::uint32_t> untouchable, Duplicates duplicates)
    : spheres_(std::move(spheres)) {
  std::size_t felt = spheres_.size();
  std::vector<std::uint8_t> marked;
  for (const std::uint32_t i : untouchable) {
    if (i >= spheres_.size()) continue;
    if (marked.empty()) marked.resize(spheres_.size());
    felt -= marked[i] ? 0 : 1;
    marked[i] = 1;
  }
  untouchable_ = std::move(marked);
  if (felt == 0) {
    cells_ = std::vector<Cell>(16);
    mask_ = 15;
    shift_ = 62;
    return;
  }
  assert(spheres_.size() < std::numeric_limits<std::uint32_t>::max());

  // A sphere more than twice as large as 99 % of the others would widen every query; such spheres are kept separately.
  std::vector<double> radii;
  radii.reserve(felt);
  for (std::size_t i = 0; i < spheres_.size(); ++i)
    if (touchable(i)) radii.push_back(spheres_[i].radius_A);
  const auto at99 = radii.begin() + std::ptrdiff_t(0.99 * double(radii.size() - 1));
  std::nth_element(radii.begin(), at99, radii.end());
  const double large_from = 2.0 * *at99;

  bool first = true, first_felt = true;
  std::size_t small_count = 0;
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    const Sphere& b = spheres_[i];
    assert(std::isfinite(b.radius_A) && b.radius_A >= 0);
    assert(std::isfinite(b.centre_A.x) && std::isfinite(b.centre_A.y) && std::isfinite(b.centre_A.z));
    if (!touchable(i)) continue;
    low_ = first_felt ? b.centre_A : glm::min(low_, b.centre_A);
    high_ = first_felt ? b.centre_A : glm::max(high_, b.centre_A);
    first_felt = false;
    largest_radius_ = std::max(largest_radius_, b.radius_A);
    if (b.radius_A > large_from) continue;
    ++small_count;
    cell_radius_ = std::max(cell_radius_, b.radius_A);
    grid_low_ = first ? b.centre_A : glm::min(grid_low_, b.centre_A);
    grid_high_ = first ? b.centre_A : glm::max(grid_high_, b.centre_A);
    first = false;
  }
  low_ -= Vec3(largest_radius_);
  high_ += Vec3(largest_radius_);
  cell_ = 1.4 * (cell_radius_ + kWaterProbe_A);

  // Counting sort by hashed cell: count, accumulate, place.
  std::vector<std::uint32_t> slot_of(spheres_.size());
  std::vector<Cell> cells;
  cells.assign(std::bit_ceil(std::max<std::size_t>(16, small_count / 4)), Cell{});
  std::size_t used = 0;
  const auto resetTable = [&] {
    mask_ = cells.size() - 1;
    shift_ = 66 - std::countr_zero(cells.size());
    used = 0;
  };
  const auto keyOf = [&](const Sphere& b) {
    return key(cellOf(b.centre_A.x, grid_low_.x), cellOf(b.centre_A.y, grid_low_.y), cellOf(b.centre_A.z, grid_low_.z));
  };
  resetTable();
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    if (!touchable(i) || spheres_[i].radius_A > large_from) continue;
    if (2 * (used + 1) > cells.size()) {  // too full: quadruple the table and count again
      cells.assign(cells.size() * 4, Cell{});
      resetTable();
      i = std::size_t(-1);
      continue;
    }
    const std::uint64_t k = keyOf(spheres_[i]);
    std::size_t s = slot(k);
    while (cells[s].key != k && cells[s].key != kEmpty) s = (s + 1) & mask_;
    if (cells[s].key == kEmpty) {
      cells[s].key = k;
      ++used;
    }
    ++cells[s].end;
    slot_of[i] = static_cast<std::uint32_t>(s);
  }
  std::vector<Cell*> in_order;
  in_order.reserve(used);
  for (Cell& c : cells)
    if (c.key != kEmpty) in_order.push_back(&c);
  std::sort(in_order.begin(), in_order.end(), [](const Cell* a, const Cell* b) { return a->key < b->key; });
  std::uint32_t sum = 0;
  for (Cell* c : in_order) {
    c->begin = sum;
    sum += c->end;
    c->end = c->begin;
  }
  sorted_.resize(small_count);
  std::vector<Sorted> large;
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    if (!touchable(i)) continue;
    const Sorted entry{spheres_[i], static_cast<std::uint32_t>(i)};
    if (spheres_[i].radius_A > large_from)
      large.push_back(entry);
    else
      sorted_[cells[slot_of[i]].end++] = entry;
  }

  // Of equal spheres (for example alternate locations written twice) only the first is kept in a cell.
  const auto same = [](const Sorted& a, const Sorted& b) {
    return a.sphere.centre_A == b.sphere.centre_A && a.sphere.radius_A == b.sphere.radius_A;
  };
  auto kept = sorted_.begin();  // the cells are compacted
  for (Cell* cell : in_order) {
    if (duplicates == Duplicates::VisitEach) break;
    Cell& c = *cell;
    const auto begin = sorted_.begin() + c.begin;
    auto end = sorted_.begin() + c.end;
    if (c.end - c.begin >
        64)  // a cell this full is sorted first, so that equal spheres are adjacent, the first in file order first
      std::sort(begin, end, [](const Sorted& a, const Sorted& b) {
        const auto key = [](const Sorted& s) {
          return std::tuple(s.sphere.centre_A.x, s.sphere.centre_A.y, s.sphere.centre_A.z, s.sphere.radius_A, s.index);
        };
        return key(a) < key(b);
      });
    const auto first_kept = kept;
    for (auto next = begin; next != end; ++next) {
      const auto look_from = kept - first_kept > 64 ? kept - 1 : first_kept;
      if (std::none_of(look_from, kept, [&](const Sorted& k) { return same(k, *next); })) *kept++ = *next;
    }
    c.begin = static_cast<std::uint32_t>(first_kept - sorted_.begin());
    c.end = static_cast<std::uint32_t>(kept - sorted_.begin());
  }
  if (duplicates == Duplicates::KeepFirst) sorted_.erase(kept, sorted_.end());
  large_from_ = static_cast<std::uint32_t>(sorted_.size());
  sorted_.insert(sorted_.end(), large.begin(), large.end());

  std::vector<TreeNode> nodes;
  std::vector<CellTree> trees;
  for (const Cell* cell : in_order) makeTree(cell->begin, cell->end, nodes, trees);
  makeTree(large_from_, static_cast<std::uint32_t>(sorted_.size()), nodes, trees);
  cells_ = std::move(cells);
  tree_nodes_ = std::move(nodes);
  cell_trees_ = std::move(trees);
}

SphereGrid SphereGrid::within(const SphereGrid& bounds, SharedArray<Sphere> spheres) {
  assert(bounds.size() == spheres.size());
  SphereGrid out(bounds);
  out.spheres_ = std::move(spheres);
  out.largest_radius_ = out.slack_ = 0.0;
  bool first = true;
  for (Sorted& s : out.sorted_) {
    const Sphere& now = out.spheres_[s.index];
    out.slack_ = std::max(out.slack_, s.sphere.radius_A - now.radius_A);
    out.low_ = first ? now.centre_A : glm::min(out.low_, now.centre_A);
    out.high_ = first ? now.centre_A : glm::max(out.high_, now.centre_A);
    out.largest_radius_ = std::max(out.largest_radius_, now.radius_A);
    first = false;
    s.sphere = now;
  }
  out.low_ -= Vec3(out.largest_radius_);
  out.high_ += Vec3(out.largest_radius_);
  out.slack_ += bounds.slack_;
  return out;
}

// Builds a tree over a crowded part of the list by halving the longest of four dimensions, position and radius, down to
// kLeaf spheres. Of a split by radius the larger half comes first, because it is met first.
void SphereGrid::makeTree(std::uint32_t begin, std::uint32_t end, std::vector<TreeNode>& nodes,
                          std::vector<CellTree>& trees) {
  constexpr std::uint32_t kLeaf = 8;
  if (end - begin <= kTreeThreshold) return;
  trees.push_back({begin, static_cast<std::uint32_t>(nodes.size())});
  const auto grow = [&](const auto& self, std::uint32_t from, std::uint32_t to) -> void {
    Vec3 low = sorted_[from].sphere.centre_A, high = low;
    double small = sorted_[from].sphere.radius_A, large = small;
    for (std::uint32_t k = from; k < to; ++k) {
      low = glm::min(low, sorted_[k].sphere.centre_A);
      high = glm::max(high, sorted_[k].sphere.centre_A);
      small = std::min(small, sorted_[k].sphere.radius_A);
      large = std::max(large, sorted_[k].sphere.radius_A);
    }
    const std::size_t node = nodes.size();
    TreeNode bound{.centre = 0.5 * (low + high), .begin = from, .end = to, .leaf = to - from <= kLeaf};
    for (std::uint32_t k = from; k < to; ++k) {
      bound.radius = std::max(bound.radius, glm::distance(bound.centre, sorted_[k].sphere.centre_A));
      bound.largest = std::max(bound.largest, sorted_[k].sphere.radius_A);
    }
    bound.radius += 1e-9 + 1e-12 * (glm::length(bound.centre) + bound.radius);  // margin against rounding
    nodes.push_back(bound);
    if (!bound.leaf) {
      const Vec3 side = high - low;
      const int axis = side.x >= side.y ? (side.x >= side.z ? 0 : 2) : (side.y >= side.z ? 1 : 2);
      const bool by_radius = large - small > side[axis];
      const auto key = [&](const Sorted& s) {
        return std::pair(by_radius ? s.sphere.radius_A : s.sphere.centre_A[axis], s.index);
      };
      const std::uint32_t middle = from + (to - from) / 2;
      std::nth_element(sorted_.begin() + from, sorted_.begin() + middle, sorted_.begin() + to,
                       [&](const Sorted& a, const Sorted& b) { return key(a) < key(b); });
      self(self, middle, to);
      self(self, from, middle);
    }
    nodes[node].next = static_cast<std::uint32_t>(nodes.size());
  };
  grow(grow, begin, end);
}

std::vector<std::uint32_t> SphereGrid::untouchable() const {
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < untouchable_.size(); ++i)
    if (untouchable_[i]) out.push_back(i);
  return out;
}

std::size_t SphereGrid::bytes() const {
  return untouchable_.size() + sorted_.capacity() * sizeof(Sorted) + tree_nodes_.size() * sizeof(TreeNode) +
         cell_trees_.size() * sizeof(CellTree) + cells_.size() * sizeof(Cell);
}

}  // namespace moltact
