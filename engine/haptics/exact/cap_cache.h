// What a ball's sphere is covered with: one cap for every neighbour that cuts it. This is all that the exact tracker
// prepares, and only for balls that the SCP has been on: a list is gathered from the scene's grid when it is first
// asked for (about 1 us) and kept in a ring of fixed size; the oldest lists give way. Haptic thread; no allocation
// after construction. Units: angstrom; angles as cosines.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/haptics/ball_scene.h"

namespace moltact {

/// The part of sphere i inside ball j: the directions x from i's centre with dot(axis, x) > cos_rim.
struct Cap {
  Vec3 axis;        ///< unit, toward the neighbour's centre
  double cos_rim;   ///< cosine of the angle from the axis to the rim: (d^2 + Ri^2 - Rj^2) / (2 d Ri), in (-1, 1)
  std::int32_t ball;
};

class CapCache {
 public:
  static constexpr std::uint32_t kCaps = 4096;      ///< in all lists together
  static constexpr std::uint32_t kLongest = 1024;   ///< a longer list is not kept but visited in the grid each time
  static constexpr std::uint32_t kLists = 128;

  explicit CapCache(std::shared_ptr<const BallScene> scene);

  /// Inflates every ball; forgets all lists.
  void setProbe(double probe_A) noexcept;
  double probe_A() const noexcept { return probe_; }
  double radius(std::int32_t ball) const noexcept { return (*scene_)[std::size_t(ball)].radius_A + probe_; }
  /// Relative to origin(): near a scene that lies far off no digits are lost.
  Vec3 centre(std::int32_t ball) const noexcept { return (*scene_)[std::size_t(ball)].centre_A - origin_; }
  /// The scene's middle in whole steps of 1024 A, so that differences to it are exact; zero for a scene near the origin.
  const Vec3& origin() const noexcept { return origin_; }
  const BallScene& scene() const noexcept { return *scene_; }

  /// The ball that holds all of `ball`'s sphere, or -1. Equal balls: the first in the file holds the others.
  /// Only a larger ball whose centre is near can: no list is gathered for the question.
  std::int32_t coveredBy(std::int32_t ball) const noexcept;

  /// The least of cos_rim - dot(axis, x) over the caps: x may turn by at least so many radians in any direction
  /// before a cap is met, because a cosine changes by at most one a radian. 2 when there is no cap.
  double slack(std::int32_t ball, const Vec3& x) noexcept;

  /// Calls visit(Cap) for each cap of the ball's sphere.
  template <class Visit>
  void eachCap(std::int32_t ball, Visit&& visit) noexcept {
    const List& list = find(ball);
    if (list.too_long) {
      eachCapInGrid(ball, visit);
      return;
    }
    for (std::uint32_t k = list.begin; k < list.begin + list.count; ++k)
      visit(Cap{{x_[k], y_[k], z_[k]}, cos_rim_[k], ball_[k]});
  }

  std::uint32_t listsHeld() const noexcept { return held_; }
  std::size_t bytes() const noexcept;

 private:
  struct List {
    std::int32_t ball = -1;
    std::uint32_t begin = 0, count = 0;
    bool too_long = false;
  };

  const List& find(std::int32_t ball) noexcept {
    if (last_->ball == ball) return *last_;
    return lookUp(ball);
  }
  const List& lookUp(std::int32_t ball) noexcept;
  void gather(std::int32_t ball, List& list) noexcept;
  double slackOfList(std::uint32_t begin, std::uint32_t count, const Vec3& x) const noexcept;

  template <class Visit>
  void eachCapInGrid(std::int32_t ball, Visit&& visit) const noexcept {
    const Vec3 c = (*scene_)[std::size_t(ball)].centre_A;
    const double r = radius(ball);
    scene_->visitNear(c, r + probe_, [&](std::uint32_t index, const Ball& other) {
      const auto j = static_cast<std::int32_t>(index);
      if (j == ball) return;
      const Vec3 way = other.centre_A - c;
      const double rj = other.radius_A + probe_, d2 = glm::dot(way, way);
      if (d2 >= (r + rj) * (r + rj)) return;
      const double d = std::sqrt(d2);
      if (!(d > 0.0)) return;
      const double cosine = (d2 + (r - rj) * (r + rj)) / (2.0 * d * r);
      if (std::abs(cosine) >= 1.0) return;  // one of the two lies in the other, or touches it in one point
      visit(Cap{way / d, cosine, j});
    });
  }

  std::shared_ptr<const BallScene> scene_;
  Vec3 origin_;
  double probe_ = 0.0;
  std::uint32_t held_ = 0;  // lists of some ball: asked in every tick
  std::unique_ptr<List[]> lists_;
  List* last_;
  std::uint32_t next_list_ = 0, next_cap_ = 0;
  // The caps, each member by itself, so that slack() runs over whole vectors.
  std::unique_ptr<double[]> x_, y_, z_, cos_rim_;
  std::unique_ptr<std::int32_t[]> ball_;
};

}  // namespace moltact
