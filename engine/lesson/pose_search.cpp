#include "engine/lesson/pose_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/core/even_directions.h"
#include "engine/core/random.h"
#include "engine/core/saturated.h"
#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

constexpr double kVoxel_A = 0.5;  // the smallest; larger where a scene would have more than kMaxVoxels
constexpr double kMaxVoxels = 4e6;
constexpr double kBranch_A = 1.0;   // longest branch of the tree
constexpr double kMinStep_A = 0.1;  // shorter ones are not added
constexpr double kCell_A = 0.5;     // edge of the cells by which sparse regions are recognised
constexpr std::size_t kMaxNodes = 30'000;
constexpr int kShortcuts = 150;

double bell(std::uint64_t& random) {
  const double u = std::max(nextFraction(random), 1e-12), v = nextFraction(random);
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
}

PoseA between(const PoseA& from, const PoseA& to, double part) {
  return {{from.place.A + (to.place.A - from.place.A) * part}, glm::slerp(from.orientation, to.orientation, part)};
}

Quat turned(const Vec3& by, const Quat& q) {
  const double angle = glm::length(by);
  return angle > 0.0 ? glm::normalize(glm::angleAxis(angle, by / angle) * q) : q;
}

class Tree {
 public:
  Tree(const PoseSpace& space, const PoseA& start, const PoseSearch& search)
      : space_(space), search_(search), random_(search.seed), limit_(space.tests() + search.max_tests) {
    add(start, 0);
  }

  std::vector<PoseA> grow() {
    PoseA end;
    if (isEnd(0, end)) return pathTo(0, end);
    while (space_.tests() < limit_ && nodes_.size() < kMaxNodes) {
      const std::size_t before = nodes_.size();
      if (nextFraction(random_) < 0.5)
        towardSomewhere();
      else
        fromSparseRegion();
      for (std::size_t k = before; k < nodes_.size(); ++k)
        if (isEnd(k, end)) return pathTo(k, end);
    }
    return {};
  }

 private:
  struct Node {
    PoseA pose;
    std::size_t parent = 0;
  };
  using Cell = std::array<long, 6>;

  bool allowed(const PoseA& pose) const { return !search_.allowed || search_.allowed(pose); }

  bool isFreeBetween(const PoseA& from, const PoseA& to) const {
    if (search_.allowed) {
      const int pieces = saturateToInteger<int>(space_.motion_A(from, to) / 0.2) + 1;
      for (int k = 1; k <= pieces; ++k)
        if (!allowed(between(from, to, double(k) / pieces))) return false;
    }
    return space_.isFreeBetween(from, to);
  }

  bool isEnd(std::size_t node, PoseA& end) const {
    end = nodes_[node].pose;
    if (search_.reached) return search_.reached(end);
    return space_.leadsOutside(nodes_[node].pose, end);
  }

  Cell cellOf(const PoseA& pose) const {
    const Vec3 d = (pose.place.A - nodes_.front().pose.place.A) / kCell_A;
    const Vec3 a = rotationBetween(nodes_.front().pose.orientation, pose.orientation) * (space_.gyration_A() / kCell_A);
    return {std::lround(d.x), std::lround(d.y), std::lround(d.z), std::lround(a.x), std::lround(a.y), std::lround(a.z)};
  }

  void add(const PoseA& pose, std::size_t parent) {
    nodes_.push_back({pose, parent});
    ++crowd_[cellOf(pose)];
  }

  double distance(const PoseA& a, const PoseA& b) const {
    const double turn =
        space_.gyration_A() * 2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a.orientation, b.orientation))));
    const Vec3 d = a.place.A - b.place.A;
    return glm::dot(d, d) + turn * turn;
  }

  // A step from a node toward a pose, as far as it is free.
  bool step(std::size_t from, const PoseA& toward) {
    const PoseA& start = nodes_[from].pose;
    const double whole = space_.motion_A(start, toward);
    if (!(whole > 0.0)) return false;
    for (double part = std::min(1.0, kBranch_A / whole); part * whole >= std::min(kMinStep_A, whole); part *= 0.5) {
      const PoseA to = between(start, toward, part);
      if (!isFreeBetween(start, to)) continue;
      int& crowd = crowd_[cellOf(to)];
      if (crowd >= 3) return false;
      add(to, from);
      return true;
    }
    return false;
  }

  void towardSomewhere() {
    const PoseA& origin = nodes_.front().pose;
    PoseA target;
    do target.place.A = Vec3(nextFraction(random_), nextFraction(random_), nextFraction(random_)) * 2.0 - 1.0;
    while (glm::length(target.place.A) > 1.0);
    target.place.A = origin.place.A + target.place.A * search_.reach_A;
    target.orientation = randomOrientation(random_);
    const bool keeps = nextFraction(random_) < 0.6;
    std::size_t nearest = 0;
    double least = 1e300;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const Vec3 d = nodes_[k].pose.place.A - target.place.A;
      const double off = keeps ? glm::dot(d, d) : distance(nodes_[k].pose, target);
      if (off < least) least = off, nearest = k;
    }
    if (keeps) target.orientation = nodes_[nearest].pose.orientation;
    while (space_.tests() < limit_ && step(nearest, target)) nearest = nodes_.size() - 1;
  }

  // Of three nodes the one with the fewest neighbours, moved at random.
  void fromSparseRegion() {
    std::size_t from = 0;
    int least = 1 << 30;
    for (int k = 0; k < 3; ++k) {
      const std::size_t node = nextRandom(random_) % nodes_.size();
      const int crowd = crowd_[cellOf(nodes_[node].pose)];
      if (crowd < least) least = crowd, from = node;
    }
    const double size_A = nextFraction(random_) < 0.5 ? 0.15 : 0.6;
    PoseA to = nodes_[from].pose;
    to.place.A += Vec3(bell(random_), bell(random_), bell(random_)) * size_A;
    to.orientation =
        turned(Vec3(bell(random_), bell(random_), bell(random_)) * (size_A / space_.gyration_A()), to.orientation);
    step(from, to);
  }

  std::vector<PoseA> pathTo(std::size_t node, const PoseA& end) {
    std::vector<PoseA> path;
    const bool beyond = distance(nodes_[node].pose, end) > 0.0;
    if (beyond) path.push_back(end);
    for (std::size_t k = node;; k = nodes_[k].parent) {
      path.push_back(nodes_[k].pose);
      if (k == 0) break;
    }
    std::reverse(path.begin(), path.end());
    for (int k = 0; k < kShortcuts && path.size() > 2; ++k) {
      std::size_t a = nextRandom(random_) % path.size(), b = nextRandom(random_) % path.size();
      if (a > b) std::swap(a, b);
      if (b - a < 2 || !isFreeBetween(path[a], path[b])) continue;
      path.erase(path.begin() + std::ptrdiff_t(a + 1), path.begin() + std::ptrdiff_t(b));
    }
    return path;
  }

  const PoseSpace& space_;
  const PoseSearch& search_;
  std::uint64_t random_;
  std::uint64_t limit_;
  std::vector<Node> nodes_;
  std::map<Cell, int> crowd_;
};

}  // namespace

Quat randomOrientation(std::uint64_t& random) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double u = nextFraction(random), a = kTurn * nextFraction(random), b = kTurn * nextFraction(random);
  return {std::sqrt(u) * std::cos(b), std::sqrt(1.0 - u) * std::sin(a), std::sqrt(1.0 - u) * std::cos(a),
          std::sqrt(u) * std::sin(b)};
}

PoseSpace::PoseSpace(const SphereGrid& scene, const HeldBody& body) : scene_(scene), body_(body) {
  double squares = 0.0, largest = 0.0;
  for (const Sphere& s : body.spheres) {
    lever_ = std::max(lever_, glm::length(s.centre_A));
    squares += glm::dot(s.centre_A, s.centre_A) / double(body.spheres.size());
    largest = std::max(largest, s.radius_A);
  }
  gyration_ = std::max(1.0, std::sqrt(squares));
  cap_ = kFar_A + largest;
  if (scene.size() == 0) return;
  low_ = scene.low_A() - Vec3(cap_);
  const Vec3 size = scene.high_A() + Vec3(cap_) - low_;
  voxel_ = std::max(kVoxel_A, std::cbrt(size.x * size.y * size.z / kMaxVoxels));
  nx_ = saturateToInteger<std::size_t>(size.x / voxel_) + 1;
  ny_ = saturateToInteger<std::size_t>(size.y / voxel_) + 1;
  nz_ = saturateToInteger<std::size_t>(size.z / voxel_) + 1;
  field_.assign(nx_ * ny_ * nz_, float(cap_));
  const double half_diagonal = 0.5 * voxel_ * std::sqrt(3.0);
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (!scene.touchable(i)) continue;
    const Sphere& s = scene[i];
    const double reach = s.radius_A + cap_ + half_diagonal;
    const Vec3 from = glm::max((s.centre_A - reach - low_) / voxel_, Vec3(0.0)),
               to = (s.centre_A + reach - low_) / voxel_;
    const auto end = [](double v, std::size_t n) { return std::min(n, saturateToInteger<std::size_t>(v) + 1); };
    for (std::size_t z = std::size_t(from.z); z < end(to.z, nz_); ++z)
      for (std::size_t y = std::size_t(from.y); y < end(to.y, ny_); ++y)
        for (std::size_t x = std::size_t(from.x); x < end(to.x, nx_); ++x) {
          const Vec3 at = low_ + (Vec3(double(x), double(y), double(z)) + 0.5) * voxel_;
          float& bound = field_[(z * ny_ + y) * nx_ + x];
          bound = std::min(bound, float(glm::distance(at, s.centre_A) - s.radius_A - half_diagonal));
        }
  }
}

double PoseSpace::fieldAt(const Vec3& place) const {
  const Vec3 v = (place - low_) / voxel_;
  if (field_.empty() || !(v.x >= 0.0 && v.y >= 0.0 && v.z >= 0.0) || v.x >= double(nx_) || v.y >= double(ny_) ||
      v.z >= double(nz_))
    return std::max(cap_, distanceToBox(scene_, 0.0, place));
  return double(field_[(std::size_t(v.z) * ny_ + std::size_t(v.y)) * nx_ + std::size_t(v.x)]);
}

double PoseSpace::gap_A(const PoseA& pose) const {
  ++tests_;
  const glm::dmat3 axes = glm::mat3_cast(pose.orientation);
  const double slack = voxel_ * std::sqrt(3.0);  // between the bound of a voxel and the distance at a point of it
  double beyond = 1e300, gap = kFar_A;
  bool near = false;
  for (const Sphere& s : body_.spheres) {
    const Vec3 centre = pose.place.A + axes * s.centre_A;
    const double bound = fieldAt(centre) - s.radius_A;
    if (bound + slack < kClear_A) return bound + slack - kClear_A - 1e-9;
    if (bound >= gap) {
      beyond = std::min(beyond, bound);
      continue;
    }
    near = true;
    scene_.visitNear(centre, s.radius_A + gap, [&](std::uint32_t, const Sphere& other) {
      gap = std::min(gap, glm::distance(centre, other.centre_A) - other.radius_A - s.radius_A);
      return gap >= kClear_A;
    });
    if (gap < kClear_A) return std::min(gap, -1e-9);
  }
  return near ? gap : std::max(gap, beyond);
}

double PoseSpace::motion_A(const PoseA& from, const PoseA& to) const {
  return glm::distance(from.place.A, to.place.A) +
         glm::length(rotationBetween(from.orientation, to.orientation)) * lever_;
}

bool PoseSpace::isFreeBetween(const PoseA& from, const PoseA& to) const {
  const double whole = motion_A(from, to);
  if (!isFree(to)) return false;
  for (double at = 0.0; at < whole;) {
    const double gap = gap_A(between(from, to, at / whole));
    if (gap < kClear_A) return false;
    at += std::max(gap, kFinest_A);
  }
  return true;
}

bool PoseSpace::leadsOutside(const PoseA& from, PoseA& outside) const {
  constexpr int kDirections = 14;
  const Vec3 middle = 0.5 * (scene_.low_A() + scene_.high_A());
  const double far = glm::distance(scene_.low_A(), scene_.high_A()) + 2.0 * body_.reach_A + 2.0;
  for (int k = 0; k < kDirections; ++k) {
    const Vec3 out = evenDirection(k, kDirections);
    if (glm::dot(out, from.place.A - middle) < 0.0) continue;
    outside = {{from.place.A + out * far}, from.orientation};
    if (sweep(scene_, HandShape(body_, from.orientation), from.place.A, outside.place.A).sphere < 0 && isFree(from))
      return true;
  }
  return false;
}

std::vector<PoseA> freePath(const PoseSpace& space, const PoseA& start, const PoseSearch& search) {
  if (!space.isFree(start)) return {};
  return Tree(space, start, search).grow();
}

}  // namespace moltact
