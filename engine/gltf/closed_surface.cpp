#include "engine/gltf/closed_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace moltact {
namespace {

constexpr std::uint32_t kNobody = 0xFFFFFFFFu;

struct Box {
  Vec3 low{0.0}, high{0.0};
};

Box boxOf(std::span<const Sphere> spheres) {
  Box box{Vec3(std::numeric_limits<double>::max()), Vec3(std::numeric_limits<double>::lowest())};
  for (const Sphere& b : spheres)
    if (b.radius_A > 0) {
      box.low = glm::min(box.low, b.centre_A - b.radius_A);
      box.high = glm::max(box.high, b.centre_A + b.radius_A);
    }
  if (box.low.x > box.high.x) return {};
  return box;
}

class Cutter {
 public:
  Cutter(std::span<const Sphere> spheres, double step_A) : spheres_(spheres), step_(step_A) {
    const Box box = boxOf(spheres);
    out_.middle_A = 0.5 * (box.low + box.high);
    // A margin of two cells, so that the surface closes within the grid.
    const Vec3 cells = glm::ceil((box.high - box.low) / step_) + 4.0;
    size_ = glm::ivec3(cells) + 1;
    low_ = out_.middle_A - 0.5 * cells * step_;
  }

  ClosedSurface cut() {
    measure();
    // The six paths from a corner of a cube to the opposite one along its edges: six tetrahedra, the same in every
    // cube.
    static constexpr std::array<std::array<int, 3>, 6> kOrders{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    glm::ivec3 c;
    for (c.z = 0; c.z + 1 < size_.z; ++c.z)
      for (c.y = 0; c.y + 1 < size_.y; ++c.y)
        for (c.x = 0; c.x + 1 < size_.x; ++c.x) {
          if (!crossed(c)) continue;
          for (const auto& order : kOrders) {
            std::array<glm::ivec3, 4> corners{c, c, c, c};
            for (int k = 1; k < 4; ++k) {
              corners[std::size_t(k)] = corners[std::size_t(k - 1)];
              ++corners[std::size_t(k)][order[std::size_t(k - 1)]];
            }
            const bool even = (order[1] - order[0] + 3) % 3 == 1;
            tetrahedron(corners, even);
          }
        }
    return std::move(out_);
  }

 private:
  std::size_t index(const glm::ivec3& p) const { return (std::size_t(p.z) * size_.y + p.y) * size_.x + p.x; }
  Vec3 place(const glm::ivec3& p) const { return low_ + step_ * Vec3(p); }

  // Computes the signed distance to the nearest sphere's surface at each grid point near one.
  void measure() {
    const std::size_t n = std::size_t(size_.x) * size_.y * size_.z;
    distance_.assign(n, std::numeric_limits<float>::max());
    owner_.assign(n, kNobody);
    for (std::uint32_t b = 0; b < spheres_.size(); ++b) {
      const Sphere& sphere = spheres_[b];
      if (!(sphere.radius_A > 0)) continue;
      const double reach = sphere.radius_A + 2 * step_;
      const auto from = glm::max(glm::ivec3(glm::ceil((sphere.centre_A - reach - low_) / step_)), glm::ivec3(0));
      const auto to = glm::min(glm::ivec3(glm::floor((sphere.centre_A + reach - low_) / step_)), size_ - 1);
      glm::ivec3 p;
      for (p.z = from.z; p.z <= to.z; ++p.z)
        for (p.y = from.y; p.y <= to.y; ++p.y)
          for (p.x = from.x; p.x <= to.x; ++p.x) {
            const auto d = float(glm::distance(place(p), sphere.centre_A) - sphere.radius_A);
            if (const std::size_t i = index(p); d < distance_[i]) {
              distance_[i] = d;
              owner_[i] = b;
            }
          }
    }
  }

  bool inside(const glm::ivec3& p) const { return distance_[index(p)] < 0.0f; }

  bool crossed(const glm::ivec3& c) const {
    const bool first = inside(c);
    for (int k = 1; k < 8; ++k)
      if (inside(c + glm::ivec3(k & 1, k >> 1 & 1, k >> 2)) != first) return true;
    return false;
  }

  // The vertex of the surface on the edge between two adjacent points; created once.
  std::uint32_t corner(const glm::ivec3& a, const glm::ivec3& b) {
    const std::size_t ia = std::min(index(a), index(b)), ib = std::max(index(a), index(b));
    const glm::ivec3 step = glm::abs(b - a);
    const auto [it, made] =
        corners_.try_emplace(ia * 8 + std::size_t(step.x + 2 * step.y + 4 * step.z), std::uint32_t(out_.places.size()));
    if (!made) return it->second;
    const Vec3 pa = place(index(a) == ia ? a : b), pb = place(index(a) == ia ? b : a);
    const double da = double(distance_[ia]), db = double(distance_[ib]);
    // Never on a grid point, where the vertices of several edges would coincide.
    const double t = std::clamp(da / (da - db), 0.01, 0.99);
    const Vec3 p = glm::mix(pa, pb, t);
    const auto off = [&](std::uint32_t sphere) {
      return std::abs(glm::distance(p, spheres_[sphere].centre_A) - spheres_[sphere].radius_A);
    };
    const std::uint32_t one = owner_[ia], other = owner_[ib];
    const std::uint32_t on = other == kNobody || (one != kNobody && off(one) <= off(other)) ? one : other;
    out_.places.push_back(glm::vec3(p - out_.middle_A));
    out_.normals.push_back(glm::vec3(glm::normalize(p - spheres_[on].centre_A)));
    corner_owner_.push_back(on);
    return it->second;
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool swap) {
    if (swap) std::swap(b, c);
    out_.triangles.insert(out_.triangles.end(), {a, b, c});
    const Vec3 middle = out_.middle_A + Vec3(out_.places[a] + out_.places[b] + out_.places[c]) / 3.0;
    const auto depth = [&](std::uint32_t corner) {
      const Sphere& sphere = spheres_[corner_owner_[corner]];
      return glm::distance(middle, sphere.centre_A) - sphere.radius_A;
    };
    std::uint32_t best = a;
    for (const std::uint32_t k : {b, c})
      if (depth(k) < depth(best)) best = k;
    out_.owners.push_back(corner_owner_[best]);
  }

  // `even`: the corners 1, 2, 3 are counter-clockwise as seen from the side away from corner 0.
  void tetrahedron(const std::array<glm::ivec3, 4>& p, bool even) {
    std::array<std::size_t, 4> in{}, ex{};
    std::size_t n_in = 0, n_ex = 0;
    for (std::size_t k = 0; k < 4; ++k) (inside(p[k]) ? in[n_in++] : ex[n_ex++]) = k;
    if (n_in == 0 || n_ex == 0) return;
    // The corners ordered inner before outer; an odd permutation reverses the triangles.
    std::array<std::size_t, 4> order{};
    std::copy_n(in.begin(), n_in, order.begin());
    std::copy_n(ex.begin(), n_ex, order.begin() + std::ptrdiff_t(n_in));
    bool odd = !even;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) odd ^= order[i] > order[j];
    const auto at = [&](std::size_t i, std::size_t j) { return corner(p[order[i]], p[order[j]]); };
    if (n_in == 1) {
      triangle(at(0, 1), at(0, 2), at(0, 3), odd);
    } else if (n_in == 3) {
      triangle(at(3, 0), at(3, 1), at(3, 2), odd);
    } else {
      const std::uint32_t a = at(0, 2), b = at(0, 3), c = at(1, 3), d = at(1, 2);
      triangle(a, b, c, odd);
      triangle(a, c, d, odd);
    }
  }

  std::span<const Sphere> spheres_;
  double step_;
  Vec3 low_{0.0};
  glm::ivec3 size_{0};
  std::vector<float> distance_;
  std::vector<std::uint32_t> owner_, corner_owner_;
  std::unordered_map<std::size_t, std::uint32_t> corners_;
  ClosedSurface out_;
};

}  // namespace

double usualStep_A(std::span<const Sphere> spheres) {
  const Box box = boxOf(spheres);
  const Vec3 size = box.high - box.low;
  return std::max(0.15, std::max({size.x, size.y, size.z}) / 100.0);
}

double cellCount(std::span<const Sphere> spheres, double step_A) {
  const Box box = boxOf(spheres);
  const Vec3 cells = glm::ceil((box.high - box.low) / step_A) + 4.0;
  return cells.x * cells.y * cells.z;
}

ClosedSurface closedSurface(std::span<const Sphere> spheres, double step_A) { return Cutter(spheres, step_A).cut(); }

}  // namespace moltact
