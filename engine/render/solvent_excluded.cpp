#include "engine/render/solvent_excluded.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/core/sphere_intersections.h"
#include "engine/haptics/ball_scene.h"

namespace moltact {
namespace {

constexpr double kFinest_A = 0.5, kMostNodes = 200;
constexpr double kBlend_A = 0.15;  // over which colours pass into each other
constexpr std::uint32_t kNone = 0xFFFFFFFFu;
constexpr double kPi = std::numbers::pi;

// From 0 to 2 pi.
double angle(double t) { return t - 2.0 * kPi * std::floor(t / (2.0 * kPi)); }

class Grid {
 public:
  Grid(const BallScene& scene, double probe_A) : scene_(scene), balls_(scene.balls()), probe_(probe_A) {
    const std::span<const Ball> balls = balls_;
    Vec3 low = balls[0].centre_A, high = low;
    for (const Ball& b : balls) {
      low = glm::min(low, b.centre_A - b.radius_A);
      high = glm::max(high, b.centre_A + b.radius_A);
    }
    const Vec3 extent = high - low + 2.0 * probe_A;
    step_ = std::max(kFinest_A, std::max({extent.x, extent.y, extent.z}) / (kMostNodes - 6));
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
    for (int z = 0; z + 1 < size_.z; ++z)
      for (int y = 0; y + 1 < size_.y; ++y)
        for (int x = 0; x + 1 < size_.x; ++x) addVertex({x, y, z}, made.piece);
    for (int z = 1; z + 1 < size_.z; ++z)
      for (int y = 1; y + 1 < size_.y; ++y)
        for (int x = 1; x + 1 < size_.x; ++x) addFaces({x, y, z}, made.piece);
    made.owner.reserve(made.piece.vertices.size());
    for (const MeshPiece::Vertex& v : made.piece.vertices) {
      const Vec3 p = made.piece.origin_A + Vec3(v.place);
      double least = std::numeric_limits<double>::max(), next = least;
      std::uint32_t owner = 0, second = 0;
      scene_.visitNear(p, probe_ + step_, [&](std::uint32_t i, const Ball& b) {
        const double gap = glm::length(p - b.centre_A) - b.radius_A;
        if (gap < least) {
          next = least;
          second = owner;
          least = gap;
          owner = i;
        } else if (gap < next) {
          next = gap;
          second = i;
        }
      });
      made.owner.push_back(owner);
      made.second.push_back(second);
      made.share.push_back(float(0.5 * std::exp(-(next - least) / kBlend_A)));
    }
    return made;
  }

 private:
  std::size_t at(const glm::ivec3& i) const { return (std::size_t(i.z) * size_.y + i.y) * size_.x + i.x; }
  Vec3 place(const glm::ivec3& i) const { return low_ + step_ * Vec3(i); }

  template <class Visit>
  void nodesWithin(const Vec3& centre, double reach, Visit&& visit) {
    const glm::ivec3 from = glm::max(glm::ivec3(glm::ceil((centre - reach - low_) / step_)), glm::ivec3(0));
    const glm::ivec3 to = glm::min(glm::ivec3(glm::floor((centre + reach - low_) / step_)), size_ - 1);
    for (int z = from.z; z <= to.z; ++z)
      for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) visit(glm::ivec3(x, y, z));
  }

  // Which ball grown by the probe holds a node deepest.
  void findGrown() {
    grown_.assign(level_.size(), kNone);
    for (std::uint32_t b = 0; b < balls_.size(); ++b) {
      const double reach = balls_[b].radius_A + probe_;
      nodesWithin(balls_[b].centre_A, reach + step_, [&](const glm::ivec3& i) {
        const auto out = float(glm::length(place(i) - balls_[b].centre_A) - reach);
        float& least = level_[at(i)];
        if (out < least) {
          least = out;
          grown_[at(i)] = b;
        }
      });
    }
  }

  // Where the way from a node inside the grown ball to one outside leaves it, as a share of the way.
  double leaves(const Vec3& inside, const Vec3& outside, std::uint32_t ball) const {
    const Vec3 way = outside - inside, from = inside - balls_[ball].centre_A;
    const double reach = balls_[ball].radius_A + probe_;
    const double a = glm::dot(way, way), b = glm::dot(way, from), c = glm::dot(from, from) - reach * reach;
    return (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
  }

  // The way to the circle in which two grown spheres meet: to those arcs of it that no third one holds, and so to the
  // places where three meet, in which the probe rests in pits and in crevices narrower than the grid.
  void spreadCircle(std::uint32_t first, std::uint32_t second, double reach) {
    const auto circle = circleOf(inflated(balls_[first], probe_), inflated(balls_[second], probe_));
    if (!circle) return;
    const Vec3 u = anyNormal(circle->axis), v = glm::cross(circle->axis, u);
    const double radius = circle->radius_A;
    held_.clear();
    bool all_held = false;
    scene_.visitNear(circle->centre_A, radius + probe_, [&](std::uint32_t k, const Ball& third) {
      if (k == first || k == second) return true;
      // How far the circle's place at the angle t lies outside, squared: z + x cos t + y sin t.
      const Vec3 to = circle->centre_A - third.centre_A;
      const double x = 2.0 * radius * glm::dot(to, u), y = 2.0 * radius * glm::dot(to, v), h = std::hypot(x, y),
                   z = glm::dot(to, to) + radius * radius - std::pow(third.radius_A + probe_, 2.0);
      all_held = z < -h - 1e-9;
      if (!all_held && std::abs(z) < h) {
        const double half = std::acos(z / h), begin = angle(std::atan2(y, x) + kPi - half);
        held_.push_back({begin, begin + 2.0 * half});
      }
      return !all_held;
    });
    if (all_held) return;
    std::sort(held_.begin(), held_.end());
    // What is held goes round at most once and may reach over the circle's begin.
    double end = 0.0;
    for (const auto& [from, to] : held_) end = std::max(end, to - 2.0 * kPi);
    for (const auto& [from, to] : held_) {
      if (from > end) spreadArc(*circle, u, v, end, from, reach);
      end = std::max(end, to);
    }
    if (end < 2.0 * kPi) spreadArc(*circle, u, v, end, 2.0 * kPi, reach);
  }

  void spreadArc(const SphereCircle& circle, const Vec3& u, const Vec3& v, double begin, double end, double reach) {
    constexpr double kPiece_A = 1.0;
    const auto way_at = [&](double t) { return std::cos(t) * u + std::sin(t) * v; };
    const int pieces = std::max(1, int(std::ceil((end - begin) * circle.radius_A / kPiece_A)));
    const double half = 0.5 * (end - begin) / pieces, least_along = std::cos(std::min(half, kPi));
    for (int k = 0; k < pieces; ++k) {
      const double at_middle = begin + (2 * k + 1) * half;
      const Vec3 middle = way_at(at_middle), across = glm::cross(circle.axis, middle), low = way_at(at_middle - half),
                 high = way_at(at_middle + half);
      nodesWithin(circle.centre_A + circle.radius_A * middle, reach + half * circle.radius_A, [&](const glm::ivec3& i) {
        const Vec3 from = place(i) - circle.centre_A, flat = from - circle.axis * glm::dot(from, circle.axis);
        const double n = glm::length(flat);
        const bool beside = n > 1e-9 && glm::dot(flat, middle) >= n * least_along;
        const Vec3 nearest = beside ? flat / n : glm::dot(flat, across) > 0.0 ? high : low;
        const Vec3 d = from - circle.radius_A * nearest;
        float& least = level_[at(i)];
        least = std::min(least, float(glm::dot(d, d)));
      });
    }
  }

  void findDistances() {
    const std::vector<float> out = std::move(level_);
    level_.assign(out.size(), std::numeric_limits<float>::max());
    // Inside: how far the nearest crossing lies. Only nodes a little deeper than the probe's radius need it.
    const double reach = probe_ + 1.8 * step_;
    // Of a crossing on a grown sphere the sphere itself is the nearest where its nearest place is close to the crossing.
    const auto spread = [&](const Vec3& s, std::uint32_t ball) {
      const Vec3 centre = balls_[ball].centre_A;
      const double radius = balls_[ball].radius_A + probe_;
      nodesWithin(s, reach, [&](const glm::ivec3& i) {
        const Vec3 p = place(i), d = p - s, outward = p - centre;
        double way2 = glm::dot(d, d);
        if (const double n = glm::length(outward); n > 1e-6) {
          const double along = radius - n;
          if (along * along < way2 && glm::length(centre + outward * (radius / n) - s) < 0.6 * step_)
            way2 = along * along;
        }
        float& least = level_[at(i)];
        least = std::min(least, float(way2));
      });
    };
    for (int z = 1; z + 1 < size_.z; ++z)
      for (int y = 1; y + 1 < size_.y; ++y)
        for (int x = 1; x + 1 < size_.x; ++x) {
          const glm::ivec3 i(x, y, z);
          if (out[at(i)] > 0) continue;
          for (int k = 0; k < 6; ++k) {
            glm::ivec3 j = i;
            j[k >> 1] += k & 1 ? 1 : -1;
            if (out[at(j)] <= 0) continue;
            // The ball that holds this node deepest need not be the last one that the way leaves.
            Vec3 p = place(i);
            std::uint32_t ball = grown_[at(i)];
            double t = leaves(p, place(j), ball);
            if (const std::uint32_t other = grown_[at(j)]; other != kNone && other != ball) {
              const double later = leaves(p, place(j), other);
              if (later > t && later <= 1.0) {
                t = later;
                ball = other;
              }
            }
            const Vec3 s = p + std::clamp(t, 0.0, 1.0) * (place(j) - p);
            spread(s, ball);
          }
        }
    for (std::uint32_t a = 0; a < balls_.size(); ++a)
      scene_.visitNear(balls_[a].centre_A, balls_[a].radius_A + 2.0 * probe_, [&](std::uint32_t b, const Ball&) {
        if (b > a) spreadCircle(a, b, reach);
      });
    // Positive where a probe can be: from the distance to its middle's nearest place.
    for (std::size_t k = 0; k < level_.size(); ++k) {
      const bool far = level_[k] == std::numeric_limits<float>::max();
      const float way = far ? float(probe_ + 1.8 * step_) : std::sqrt(level_[k]);
      level_[k] = out[k] > 0 ? float(probe_) + (far ? float(step_) : way) : float(probe_) - way;
    }
    grown_.clear();
    grown_.shrink_to_fit();
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

  // The mean of the crossings on a cell's edges, drawn onto the surface.
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

  // Round each edge that crosses the surface, the four cells' vertices.
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

  const BallScene& scene_;
  std::span<const Ball> balls_;
  double probe_, step_ = kFinest_A;
  Vec3 low_{0.0};
  glm::ivec3 size_{1};
  std::vector<float> level_;  // distance out of the grown balls; then of the surface, positive outside
  std::vector<std::uint32_t> grown_, cell_vertex_;
  std::vector<std::pair<double, double>> held_;  // angles of a circle, from and to
};

}  // namespace

SolventExcluded solventExcluded(std::span<const Ball> balls, double probe_A) {
  if (balls.empty() || !(probe_A > 0)) return {};
  const BallScene scene(std::vector<Ball>(balls.begin(), balls.end()));
  return Grid(scene, probe_A).triangles();
}

}  // namespace moltact
