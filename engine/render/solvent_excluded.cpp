#include "engine/render/solvent_excluded.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/core/sphere_intersections.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact {
namespace {

constexpr double kFinest_A = 0.5, kMaxNodes = 200;
constexpr double kLargeProbe_A = 3.0;  // above it thousands of spheres are near each other, and most are buried
constexpr double kBlend_A = 0.15;      // range over which colours blend
constexpr std::uint32_t kNone = 0xFFFFFFFFu;
constexpr double kPi = std::numbers::pi;

// Normalizes an angle to 0 to 2 pi.
double angle(double t) { return t - 2.0 * kPi * std::floor(t / (2.0 * kPi)); }

struct Cancelled {};

class Grid {
 public:
  Grid(const SphereGrid& scene, double probe_A, double max_nodes_in_spheres, SurfaceProgress* progress)
      : scene_(scene), spheres_(scene.spheres()), probe_(probe_A), progress_(progress) {
    const std::span<const Sphere> spheres = spheres_;
    Vec3 low = spheres[0].centre_A, high = low;
    for (const Sphere& b : spheres) {
      low = glm::min(low, b.centre_A - b.radius_A);
      high = glm::max(high, b.centre_A + b.radius_A);
    }
    const Vec3 extent = high - low + 2.0 * probe_A;
    double in_spheres_A3 = 0.0;
    for (const Sphere& b : spheres) in_spheres_A3 += std::pow(2.0 * (b.radius_A + probe_A), 3.0);
    step_ = std::max({kFinest_A, std::max({extent.x, extent.y, extent.z}) / (kMaxNodes - 6),
                      std::cbrt(in_spheres_A3 / max_nodes_in_spheres)});
    low_ = low - probe_A - 2.0 * step_;
    size_ = glm::ivec3(glm::ceil((extent + 4.0 * step_) / step_)) + 1;
    level_.assign(std::size_t(size_.x) * size_.y * size_.z, std::numeric_limits<float>::max());
    findGrown();
    findDistances();
  }

  SolventExcluded triangles() {
    SolventExcluded made;
    made.step_A = step_;
    made.piece.origin_A = low_ + 0.5 * step_ * Vec3(size_);
    cell_vertex_.assign(level_.size(), kNone);
    for (int z = 0; z + 1 < size_.z; ++z) {
      report(0.85, 0.95, z, size_.z);
      for (int y = 0; y + 1 < size_.y; ++y)
        for (int x = 0; x + 1 < size_.x; ++x) addVertex({x, y, z}, made.piece);
    }
    for (int z = 1; z + 1 < size_.z; ++z)
      for (int y = 1; y + 1 < size_.y; ++y)
        for (int x = 1; x + 1 < size_.x; ++x) addFaces({x, y, z}, made.piece);
    made.owner.reserve(made.piece.vertices.size());
    for (const MeshPiece::Vertex& v : made.piece.vertices) {
      report(0.95, 1.0, made.owner.size(), made.piece.vertices.size());
      const Vec3 p = made.piece.origin_A + Vec3(v.place);
      double smallest = std::numeric_limits<double>::max(), next = smallest;
      std::uint32_t owner = 0, second = 0;
      scene_.visitNear(p, probe_ + step_, [&](std::uint32_t i, const Sphere& b) {
        const double gap = glm::length(p - b.centre_A) - b.radius_A;
        if (gap < smallest) {
          next = smallest;
          second = owner;
          smallest = gap;
          owner = i;
        } else if (gap < next) {
          next = gap;
          second = i;
        }
      });
      made.owner.push_back(owner);
      made.second.push_back(second);
      made.share.push_back(float(0.5 * std::exp(-(next - smallest) / kBlend_A)));
    }
    return made;
  }

 private:
  std::size_t at(const glm::ivec3& i) const { return (std::size_t(i.z) * size_.y + i.y) * size_.x + i.x; }
  Vec3 place(const glm::ivec3& i) const { return low_ + step_ * Vec3(i); }

  // Reports that `done` of `all` parts of the work between two fractions are complete.
  void report(double from, double to, std::size_t done, std::size_t all) const {
    if (!progress_) return;
    if (progress_->cancelled.load(std::memory_order_relaxed)) throw Cancelled{};
    progress_->share.store(float(from + (to - from) * double(done) / double(std::max<std::size_t>(1, all))),
                           std::memory_order_relaxed);
  }

  template <class Visit>
  void nodesWithin(const Vec3& centre, double reach, Visit&& visit) {
    const glm::ivec3 from = glm::max(glm::ivec3(glm::ceil((centre - reach - low_) / step_)), glm::ivec3(0));
    const glm::ivec3 to = glm::min(glm::ivec3(glm::floor((centre + reach - low_) / step_)), size_ - 1);
    for (int z = from.z; z <= to.z; ++z)
      for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) visit(glm::ivec3(x, y, z));
  }

  // Visits the nodes within `around` of a cone with its tip at a point, of length `reach`, and some others, possibly
  // repeatedly. `bend`: half of its opening angle.
  template <class Visit>
  void nodesInCone(const Vec3& tip, const Vec3& axis, double bend, double around, double reach, Visit&& visit) {
    constexpr double kWidest = 1.0;
    if (!(bend < kWidest)) return nodesWithin(tip, reach + around, visit);
    const auto width = [&](double t) { return std::min(t * std::tan(bend), reach * std::sin(bend)) + around; };
    for (double t = 0.0; t <= reach;) {
      const double on = step_ + 0.5 * (width(t) - around);
      nodesWithin(tip + t * axis, std::hypot(width(t + on), on), visit);
      t += on;
    }
  }

  // For each node, the inflated sphere in which it lies deepest.
  void findGrown() {
    grown_.assign(level_.size(), kNone);
    for (std::uint32_t b = 0; b < spheres_.size(); ++b) {
      report(0.0, 0.3, b, spheres_.size());
      const double reach = spheres_[b].radius_A + probe_;
      nodesWithin(spheres_[b].centre_A, reach + step_, [&](const glm::ivec3& i) {
        const auto out = float(glm::length(place(i) - spheres_[b].centre_A) - reach);
        float& smallest = level_[at(i)];
        if (out < smallest) {
          smallest = out;
          grown_[at(i)] = b;
        }
      });
    }
  }

  // Where the edge from a node inside the inflated sphere to one outside leaves it, as a fraction of the edge.
  double leaves(const Vec3& inside, const Vec3& outside, std::uint32_t sphere) const {
    const Vec3 offset = outside - inside, from = inside - spheres_[sphere].centre_A;
    const double reach = spheres_[sphere].radius_A + probe_;
    const double a = glm::dot(offset, offset), b = glm::dot(offset, from), c = glm::dot(from, from) - reach * reach;
    return (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
  }

  // Spreads the distance to the circle of two inflated spheres, on its arcs that no third sphere covers. This includes
  // the points where three meet, at which the probe rests in pits and in crevices narrower than the grid.
  void spreadCircle(std::uint32_t first, std::uint32_t second, double reach) {
    const auto circle = circleOf(inflated(spheres_[first], probe_), inflated(spheres_[second], probe_));
    if (!circle) return;
    const Vec3 u = anyNormal(circle->axis), v = glm::cross(circle->axis, u);
    const double radius = circle->radius_A;
    held_.clear();
    bool all_held = false;
    scene_.visitNear(circle->centre_A, radius + probe_, [&](std::uint32_t k, const Sphere& third) {
      if (k == first || k == second) return true;
      // The squared distance outside the sphere of the circle's point at angle t is z + x cos t + y sin t.
      const Vec3 to = circle->centre_A - third.centre_A;
      const double x = 2.0 * radius * glm::dot(to, u), y = 2.0 * radius * glm::dot(to, v), h = std::hypot(x, y),
                   z = glm::dot(to, to) + radius * radius - std::pow(third.radius_A + probe_, 2.0);
      all_held = z < -h - 1e-9;
      if (!all_held && std::abs(z) < h) {
        const double half = std::acos(z / h), begin = angle(std::atan2(y, x) + kPi - half);
        held_.push_back({begin, begin + 2.0 * half, k});
      }
      return !all_held;
    });
    if (all_held) return;
    std::sort(held_.begin(), held_.end());
    // Covered arcs start within the circle and may extend past its start.
    const Arcs arcs{*circle, u, v, first, second};
    double end = 0.0;
    std::uint32_t last = kNone;  // the sphere that covers the circle up to there
    for (const Held& h : held_)
      if (h.to - 2.0 * kPi > end) {
        end = h.to - 2.0 * kPi;
        last = h.by;
      }
    for (const Held& h : held_) {
      if (h.from > end) {
        spreadArc(arcs, end, h.from, reach);
        if (last != kNone) spreadCorner(arcs, end, last, reach);
        spreadCorner(arcs, h.from, h.by, reach);
      }
      if (h.to > end) {
        end = h.to;
        last = h.by;
      }
    }
    if (end < 2.0 * kPi) {
      spreadArc(arcs, end, 2.0 * kPi, reach);
      if (last != kNone) spreadCorner(arcs, end, last, reach);
    }
  }

  // The circle of two inflated spheres; `u` is the direction of angle 0.
  struct Arcs {
    const SphereCircle& circle;
    Vec3 u, v;
    std::uint32_t first, second;
    Vec3 direction(double t) const { return std::cos(t) * u + std::sin(t) * v; }
    Vec3 at(double t) const { return circle.centre_A + circle.radius_A * direction(t); }
  };
  Vec3 inward(const Vec3& p, std::uint32_t sphere) const { return glm::normalize(spheres_[sphere].centre_A - p); }

  // A corner is the nearest point only for inner nodes between the directions to the spheres' centres.
  void spreadCorner(const Arcs& arcs, double t, std::uint32_t third, double reach) {
    const Vec3 tip = arcs.at(t);
    const Vec3 to[] = {inward(tip, arcs.first), inward(tip, arcs.second), inward(tip, third)};
    const Vec3 sum = to[0] + to[1] + to[2];
    const Vec3 axis = glm::length(sum) > 1e-6 ? glm::normalize(sum) : to[0];
    double smallest = 1.0;
    for (const Vec3& d : to) smallest = std::min(smallest, glm::dot(axis, d));
    nodesInCone(tip, axis, std::acos(std::clamp(smallest, -1.0, 1.0)), step_, reach, [&](const glm::ivec3& i) {
      const Vec3 d = place(i) - tip;
      float& level = level_[at(i)];
      level = std::min(level, float(glm::dot(d, d)));
    });
  }

  void spreadArc(const Arcs& arcs, double begin, double end, double reach) {
    constexpr double kPiece_A = 1.0;
    const SphereCircle& circle = arcs.circle;
    const int pieces = std::max(1, int(std::ceil((end - begin) * circle.radius_A / kPiece_A)));
    const double half = 0.5 * (end - begin) / pieces, min_along = std::cos(std::min(half, kPi));
    for (int k = 0; k < pieces; ++k) {
      const double at_middle = begin + (2 * k + 1) * half;
      const Vec3 middle = arcs.direction(at_middle), across = glm::cross(circle.axis, middle),
                 low = arcs.direction(at_middle - half), high = arcs.direction(at_middle + half);
      const Vec3 tip = arcs.at(at_middle), to_first = inward(tip, arcs.first), to_second = inward(tip, arcs.second);
      const Vec3 sum = to_first + to_second;
      const Vec3 axis = glm::length(sum) > 1e-6 ? glm::normalize(sum) : to_first;
      const double bend = std::acos(std::clamp(glm::dot(axis, to_first), -1.0, 1.0)) + half;
      nodesInCone(tip, axis, bend, half * circle.radius_A + step_, reach, [&](const glm::ivec3& i) {
        const Vec3 from = place(i) - circle.centre_A, flat = from - circle.axis * glm::dot(from, circle.axis);
        const double n = glm::length(flat);
        const bool beside = n > 1e-9 && glm::dot(flat, middle) >= n * min_along;
        const Vec3 nearest = beside ? flat / n : glm::dot(flat, across) > 0.0 ? high : low;
        const Vec3 d = from - circle.radius_A * nearest;
        float& smallest = level_[at(i)];
        smallest = std::min(smallest, float(glm::dot(d, d)));
      });
    }
  }

  void findDistances() {
    const std::vector<float> out = std::move(level_);
    level_.assign(out.size(), std::numeric_limits<float>::max());
    // Inside: the distance to the nearest crossing. Only nodes slightly deeper than the probe's radius need it.
    const double reach = probe_ + 1.8 * step_;
    // For a crossing on an inflated sphere, the sphere itself is nearest if its nearest point is close to the crossing.
    const auto spread = [&](const Vec3& s, std::uint32_t sphere) {
      const Vec3 centre = spheres_[sphere].centre_A;
      const double radius = spheres_[sphere].radius_A + probe_;
      // Only for nodes whose nearest point of the sphere is near the crossing; others have nearer crossings, arcs or
      // corners.
      const Vec3 in = glm::normalize(centre - s);
      const double outside = 1.8 * step_;
      nodesInCone(s - outside * in, in, 0.0, 1.5 * step_, outside + std::min(reach, radius), [&](const glm::ivec3& i) {
        const Vec3 p = place(i), d = p - s, outward = p - centre;
        double way2 = glm::dot(d, d);
        if (const double n = glm::length(outward); n > 1e-6) {
          const double along = radius - n;
          if (along * along < way2 && glm::length(centre + outward * (radius / n) - s) < 0.6 * step_)
            way2 = along * along;
        }
        float& smallest = level_[at(i)];
        smallest = std::min(smallest, float(way2));
      });
    };
    std::vector<std::uint8_t> exposed(spheres_.size(), probe_ <= kLargeProbe_A);
    for (int z = 1; z + 1 < size_.z; ++z) {
      report(0.3, 0.6, std::size_t(z), std::size_t(size_.z));
      for (int y = 1; y + 1 < size_.y; ++y)
        for (int x = 1; x + 1 < size_.x; ++x) {
          const glm::ivec3 i(x, y, z);
          if (out[at(i)] > 0) continue;
          for (int k = 0; k < 6; ++k) {
            glm::ivec3 j = i;
            j[k >> 1] += k & 1 ? 1 : -1;
            if (out[at(j)] <= 0) continue;
            // The sphere in which this node lies deepest is not necessarily the last one that the edge leaves.
            Vec3 p = place(i);
            std::uint32_t sphere = grown_[at(i)];
            double t = leaves(p, place(j), sphere);
            if (const std::uint32_t other = grown_[at(j)]; other != kNone && other != sphere) {
              const double later = leaves(p, place(j), other);
              if (later > t && later <= 1.0) {
                t = later;
                sphere = other;
              }
            }
            const Vec3 s = p + std::clamp(t, 0.0, 1.0) * (place(j) - p);
            spread(s, sphere);
            for (const std::uint32_t b : {sphere, grown_[at(i)], grown_[at(j)]})
              if (b != kNone) exposed[b] = 1;
          }
        }
    }
    for (std::uint32_t a = 0; a < spheres_.size(); ++a) {
      report(0.6, 0.82, a, spheres_.size());
      if (!exposed[a]) continue;
      scene_.visitNear(spheres_[a].centre_A, spheres_[a].radius_A + 2.0 * probe_, [&](std::uint32_t b, const Sphere&) {
        if (b > a && exposed[b]) spreadCircle(a, b, reach);
      });
    }
    fillWays();
    // The level is positive where a probe can be: computed from the distance to the nearest position of its centre.
    for (std::size_t k = 0; k < level_.size(); ++k) {
      const bool far = !(double(level_[k]) < reach);
      const float distance = far ? float(reach) : level_[k];
      level_[k] = out[k] > 0 ? float(probe_) + (far ? float(step_) : distance) : float(probe_) - distance;
    }
    grown_.clear();
    grown_.shrink_to_fit();
  }

  // Converts squares to distances. A node without a distance takes that of a neighbour plus the distance to it, so that
  // there is no hole where the surface is finer than the grid.
  void fillWays() {
    std::vector<std::uint8_t> reached(level_.size());
    for (std::size_t k = 0; k < level_.size(); ++k) {
      reached[k] = level_[k] < std::numeric_limits<float>::max();
      level_[k] = std::sqrt(level_[k]);
    }
    const auto relax = [&](int side) {
      const auto from = [&](int size) { return side > 0 ? 1 : size - 2; };
      for (int z = from(size_.z); z >= 1 && z + 1 < size_.z; z += side) {
        report(0.82, 0.85, std::size_t(z), std::size_t(size_.z));
        for (int y = from(size_.y); y >= 1 && y + 1 < size_.y; y += side)
          for (int x = from(size_.x); x >= 1 && x + 1 < size_.x; x += side) {
            if (reached[at({x, y, z})]) continue;
            float& distance = level_[at({x, y, z})];
            for (int k = 0; k < 13; ++k) {  // the neighbours that precede it
              const glm::ivec3 d(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
              const float by = float(step_ * std::sqrt(double(d.x * d.x + d.y * d.y + d.z * d.z)));
              distance = std::min(distance, level_[at(glm::ivec3(x, y, z) + side * d)] + by);
            }
          }
      }
    };
    relax(1);
    relax(-1);
  }

  double levelAt(const Vec3& p) const {
    const Vec3 g = glm::clamp((p - low_) / step_, Vec3(0.0), Vec3(size_ - 2));
    const glm::ivec3 i = glm::min(glm::ivec3(g), size_ - 2);
    const Vec3 f = g - Vec3(i);
    double sum = 0;
    for (int k = 0; k < 8; ++k) {
      const glm::ivec3 s(k & 1, k >> 1 & 1, k >> 2);
      sum += double(level_[at(i + s)]) * (s.x ? f.x : 1 - f.x) * (s.y ? f.y : 1 - f.y) * (s.z ? f.z : 1 - f.z);
    }
    return sum;
  }

  Vec3 slopeAt(const Vec3& p) const {
    Vec3 slope;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 d(0.0);
      d[axis] = 0.75 * step_;
      slope[axis] = levelAt(p + d) - levelAt(p - d);
    }
    return slope;
  }

  // The mean of the crossings on a cell's edges, projected onto the surface.
  void addVertex(const glm::ivec3& cell, MeshPiece& piece) {
    Vec3 sum(0.0);
    int crossings = 0;
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < 4; ++k) {
        glm::ivec3 a = cell;
        a[(axis + 1) % 3] += k & 1;
        a[(axis + 2) % 3] += k >> 1;
        glm::ivec3 b = a;
        ++b[axis];
        const double la = level_[at(a)], lb = level_[at(b)];
        if ((la > 0) == (lb > 0)) continue;
        sum += glm::mix(place(a), place(b), la / (la - lb));
        ++crossings;
      }
    if (crossings == 0) return;
    Vec3 p = sum / double(crossings), slope = slopeAt(p);
    for (int round = 0; round < 2 && glm::length(slope) > 1e-9; ++round) {
      p -= glm::normalize(slope) * std::clamp(levelAt(p), -0.5 * step_, 0.5 * step_);
      slope = slopeAt(p);
    }
    cell_vertex_[at(cell)] = std::uint32_t(piece.vertices.size());
    const Vec3 normal = glm::length(slope) > 1e-9 ? glm::normalize(slope) : Vec3(0, 0, 1);
    piece.vertices.push_back({glm::vec3(p - piece.origin_A), glm::vec3(normal), 0xFFFFFFFFu});
  }

  // For each edge that crosses the surface, a face of the four adjacent cells' vertices.
  void addFaces(const glm::ivec3& node, MeshPiece& piece) {
    const bool outside = level_[at(node)] > 0;
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 next = node;
      ++next[axis];
      if ((level_[at(next)] > 0) == outside) continue;
      std::uint32_t corner[4];
      for (int k = 0; k < 4; ++k) {
        glm::ivec3 cell = node;
        cell[(axis + 1) % 3] -= k == 1 || k == 2;
        cell[(axis + 2) % 3] -= k >= 2;
        corner[k] = cell_vertex_[at(cell)];
      }
      if (std::find(corner, corner + 4, kNone) != corner + 4) continue;
      if (outside) std::swap(corner[1], corner[3]);
      piece.triangle(corner[0], corner[1], corner[2]);
      piece.triangle(corner[0], corner[2], corner[3]);
    }
  }

  const SphereGrid& scene_;
  std::span<const Sphere> spheres_;
  double probe_, step_ = kFinest_A;
  SurfaceProgress* progress_;
  Vec3 low_{0.0};
  glm::ivec3 size_{1};
  std::vector<float> level_;  // distance outside the inflated spheres; then of the surface, positive outside
  std::vector<std::uint32_t> grown_, cell_vertex_;
  struct Held {
    double from, to;  // angles on a circle
    std::uint32_t by;
    auto operator<=>(const Held&) const = default;
  };
  std::vector<Held> held_;
};

}  // namespace

SolventExcluded solventExcluded(std::span<const Sphere> spheres, double probe_A, SurfaceProgress* progress,
                                double max_nodes_in_spheres) try {
  if (spheres.empty() || !(probe_A > 0)) return {};
  const SphereGrid scene(std::vector<Sphere>(spheres.begin(), spheres.end()));
  return Grid(scene, probe_A, max_nodes_in_spheres, progress).triangles();
} catch (const Cancelled&) {
  return {};
}

}  // namespace moltact
