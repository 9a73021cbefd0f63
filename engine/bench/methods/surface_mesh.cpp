#include "engine/bench/methods/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "engine/bench/methods/union_surface.h"
#include "engine/haptics/mesh/path_in_box.h"

namespace moltact {
namespace {

constexpr double kAside_A = 1e-9;  // tolerance beside a triangle, so that there is no gap between two triangles

constexpr double kAlong = 1e-10;  // sine below which a path is along a border

// Spreads the bits of a 21-bit number to every third position.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffull;
  x = (x | x << 16) & 0x1f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  return (x | x << 2) & 0x1249249249249249ull;
}

}  // namespace

std::shared_ptr<const SurfaceMesh> SurfaceMesh::of(const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                                                   double spacing_A, const Vec3& origin) {
  struct Kept {
    std::weak_ptr<const SphereGrid> scene;
    double probe_A = -1;
    Vec3 origin{0.0};
    std::shared_ptr<const SurfaceMesh> mesh;
  };
  static std::mutex mutex;
  static std::map<double, Kept> kept;
  const std::lock_guard lock(mutex);
  Kept& one = kept[spacing_A];
  if (!one.mesh || one.scene.lock() != scene || one.probe_A != probe_A || one.origin != origin) {
    one.mesh.reset();  // releases the memory before the next mesh is made
    one = {scene, probe_A, origin, std::make_shared<const SurfaceMesh>(*scene, probe_A, spacing_A, origin)};
  }
  return one.mesh;
}

SurfaceMesh::SurfaceMesh(const SphereGrid& scene, double probe_A, double spacing_A, const Vec3& origin) {
  UnionSurface surface = unionSurface(scene, probe_A, spacing_A, origin);
  vertices_ = std::move(surface.vertices);
  std::vector<bool> felt(scene.size());
  triangles_.reserve(surface.triangles.size());
  for (const UnionSurface::Triangle& t : surface.triangles) {
    triangles_.push_back({t.corners, {-1, -1, -1}, t.sphere});
    if (!felt[std::size_t(t.sphere)]) felt[std::size_t(t.sphere)] = true, ++spheres_;
  }
  surface = {};
  sortByPlace();
  findNeighbours();
  makeTree();
}

// Orders triangles along a space-filling curve, so that neighbours in space are near in memory.
void SurfaceMesh::sortByPlace() {
  if (triangles_.empty()) return;
  Vec3 low(1e300), high(-1e300);
  for (const Vec3& v : vertices_) low = glm::min(low, v), high = glm::max(high, v);
  const Vec3 size = high - low;
  const double per = double((1 << 21) - 1) / std::max({size.x, size.y, size.z, 1e-9});
  const auto code = [&](const Vec3& x) {
    const Vec3 u = (x - low) * per;
    return spread(std::uint64_t(u.x)) | spread(std::uint64_t(u.y)) << 1 | spread(std::uint64_t(u.z)) << 2;
  };
  std::vector<std::pair<std::uint64_t, std::int32_t>> order(triangles_.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto& c = triangles_[k].corners;
    order[k] = {
        code((vertices_[std::size_t(c[0])] + vertices_[std::size_t(c[1])] + vertices_[std::size_t(c[2])]) / 3.0),
        std::int32_t(k)};
  }
  std::sort(order.begin(), order.end());
  std::vector<Triangle> sorted;
  sorted.reserve(order.size());
  std::vector<std::int32_t> number(vertices_.size(), -1);
  std::vector<Vec3> vertices;
  vertices.reserve(vertices_.size());
  for (const auto& [at, k] : order) {
    Triangle t = triangles_[std::size_t(k)];
    for (std::int32_t& v : t.corners) {
      std::int32_t& n = number[std::size_t(v)];
      if (n < 0) {
        n = std::int32_t(vertices.size());
        vertices.push_back(vertices_[std::size_t(v)]);
      }
      v = n;
    }
    sorted.push_back(t);
  }
  triangles_ = std::move(sorted);
  vertices_ = std::move(vertices);
}

void SurfaceMesh::findNeighbours() {
  struct Side {
    std::uint64_t corners;  // the lower index first
    std::int32_t triangle, edge;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles_.size());
  for (std::size_t k = 0; k < triangles_.size(); ++k)
    for (int e = 0; e < 3; ++e) {
      const auto a = std::uint64_t(triangles_[k].corners[std::size_t(e)]),
                 b = std::uint64_t(triangles_[k].corners[std::size_t((e + 1) % 3)]);
      sides.push_back({std::min(a, b) << 32 | std::max(a, b), std::int32_t(k), e});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.corners < b.corners; });
  for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
    const Side &a = sides[k], &b = sides[k + 1];
    triangles_[std::size_t(a.triangle)].across[std::size_t(a.edge)] = b.triangle;
    triangles_[std::size_t(b.triangle)].across[std::size_t(b.edge)] = a.triangle;
  }
}

void SurfaceMesh::makeTree() {
  if (triangles_.empty()) return;
  nodes_.reserve(triangles_.size());
  makeNode(0, std::int32_t(triangles_.size()));
  nodes_.shrink_to_fit();
}

std::int32_t SurfaceMesh::makeNode(std::int32_t first, std::int32_t count) {
  const auto at = std::int32_t(nodes_.size());
  nodes_.push_back({{}, first, count});
  Box box;
  box.low.fill(INFINITY), box.high.fill(-INFINITY);
  if (count <= kLeaf) {
    for (std::int32_t k = first; k < first + count; ++k)
      for (const std::int32_t v : triangles_[std::size_t(k)].corners)
        for (int axis = 0; axis < 3; ++axis) {
          const double x = vertices_[std::size_t(v)][axis];
          float& low = box.low[std::size_t(axis)];
          float& high = box.high[std::size_t(axis)];
          low = std::min(low, std::nextafter(float(x - 2.0 * kAside_A), -INFINITY));
          high = std::max(high, std::nextafter(float(x + 2.0 * kAside_A), INFINITY));
        }
  } else {
    const std::int32_t half = count / 2;
    const std::int32_t left = makeNode(first, half), right = makeNode(first + half, count - half);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(nodes_[std::size_t(left)].box.low[axis], nodes_[std::size_t(right)].box.low[axis]);
      box.high[axis] = std::max(nodes_[std::size_t(left)].box.high[axis], nodes_[std::size_t(right)].box.high[axis]);
    }
    nodes_[std::size_t(at)].first = right;
    nodes_[std::size_t(at)].count = 0;
  }
  nodes_[std::size_t(at)].box = box;
  return at;
}

std::size_t SurfaceMesh::bytes() const {
  return sizeof(*this) + vertices_.capacity() * sizeof(Vec3) + triangles_.capacity() * sizeof(Triangle) +
         nodes_.capacity() * sizeof(Node);
}

SurfaceMesh::Plane SurfaceMesh::plane(std::int32_t triangle) const noexcept {
  const auto& c = triangles_[std::size_t(triangle)].corners;
  const std::array<Vec3, 3> p{vertices_[std::size_t(c[0])], vertices_[std::size_t(c[1])], vertices_[std::size_t(c[2])]};
  Plane out;
  const Vec3 across = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double twice = glm::length(across);
  out.normal = twice > 0.0 ? across / twice : Vec3(0.0);
  out.height = glm::dot(out.normal, p[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side = glm::cross(p[(k + 1) % 3] - p[k], out.normal);
    const double length = glm::length(side);
    out.out[k] = length > 0.0 ? side / length : Vec3(0.0);
    out.reach[k] = glm::dot(out.out[k], p[k]);
  }
  return out;
}

SurfaceMesh::Hit SurfaceMesh::cast(const Vec3& from, const Vec3& path) const noexcept {
  Hit best;
  if (nodes_.empty()) return best;
  const Vec3 per_path = 1.0 / path;
  const double length = glm::length(path);
  std::int32_t stack[64];
  int waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const std::int32_t at = stack[--waiting];
    const Node& node = nodes_[std::size_t(at)];
    const auto &low = node.box.low, &high = node.box.high;
    if (!pathMeetsBox(from, path, per_path, {low[0], low[1], low[2]}, {high[0], high[1], high[2]}, best.t)) continue;
    if (node.count == 0) {
      stack[waiting++] = node.first;
      stack[waiting++] = at + 1;
      continue;
    }
    for (std::int32_t k = node.first; k < node.first + node.count; ++k) {
      const Plane f = plane(k);
      const double falls = -glm::dot(f.normal, path);
      if (!(falls > 1e-12 * length)) continue;
      const double above = glm::dot(f.normal, from) - f.height;
      if (above < -kSkin_A) continue;
      const double t = above <= kSkin_A ? 0.0 : above / falls;
      if (t > best.t || (t == best.t && best.triangle >= 0)) continue;
      const Vec3 x = from + path * t;
      bool within = true;
      for (std::size_t e = 0; e < 3; ++e) {
        const double beyond = glm::dot(f.out[e], x) - f.reach[e];
        // A start on the triangle's border counts as under it only if the path does not lead out over that border.
        within = within && beyond <= kAside_A &&
                 (above > kSkin_A || beyond < -kAside_A || glm::dot(f.out[e], path) <= kAlong * length);
      }
      if (within) best = {t, k};
    }
  }
  return best;
}

}  // namespace moltact
