// The balls near a place, inflated, kept while the place moves little: what a method that looks at every
// neighbour in every tick need not look up anew. Haptic thread; no allocation after construction. Units:
// angstrom. Places are relative to origin(): near a scene that lies far off no digits are lost.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>

#include "engine/haptics/ball_scene.h"

namespace moltact {

struct NearBall {
  Vec3 centre;
  double radius;  ///< inflated by the probe
  std::int32_t index;
};

class NearbyBalls {
 public:
  static constexpr std::size_t kMost = 256;  ///< a longer list is not kept but visited in the scene each time

  /// A list serves until the place has moved by `margin_A`.
  explicit NearbyBalls(std::shared_ptr<const BallScene> scene, double margin_A = 0.5)
      : scene_(std::move(scene)),
        margin_(margin_A),
        origin_(1024.0 * glm::round((scene_->low_A() + scene_->high_A()) / 2048.0)) {}

  const BallScene& scene() const noexcept { return *scene_; }
  /// The scene's middle in whole steps of 1024 A, so that differences to it are exact; zero for a scene near
  /// the origin.
  const Vec3& origin() const noexcept { return origin_; }
  double probe_A() const noexcept { return probe_; }
  std::size_t held() const noexcept { return count_; }  ///< balls in the list
  void setProbe(double probe_A) noexcept {
    probe_ = probe_A;
    reach_ = -1.0;
  }

  NearBall ball(std::int32_t i) const noexcept { return inflated(i, (*scene_)[std::size_t(i)]); }

  /// Calls visit(NearBall) once for each ball that comes within `within_A` of the place, and for some farther
  /// ones; returns how near to the place all balls have been visited (at least within_A). The order follows
  /// from the places asked for.
  template <class Visit>
  double each(const Vec3& place, double within_A, Visit&& visit) noexcept {
    if (!(glm::distance(place, around_) + within_A <= reach_)) gather(place, within_A);
    if (fits_) {
      for (std::size_t k = 0; k < count_; ++k) visit(list_[k]);
      return reach_ - glm::distance(place, around_);
    }
    scene_->visitNear(origin_ + place, probe_ + within_A,
                      [&](std::uint32_t i, const Ball& b) { visit(inflated(std::int32_t(i), b)); });
    return within_A;
  }

 private:
  NearBall inflated(std::int32_t i, const Ball& b) const noexcept { return {b.centre_A - origin_, b.radius_A + probe_, i}; }

  void gather(const Vec3& place, double within_A) noexcept {
    around_ = place;
    reach_ = within_A + margin_;
    count_ = 0;
    fits_ = true;
    const Vec3 at = origin_ + place;
    const double farther = probe_ + reach_;
    scene_->visitNear(at, farther, [&](std::uint32_t i, const Ball& b) {
      const Vec3 m = at - b.centre_A;
      const double far = b.radius_A + farther;
      if (glm::dot(m, m) > far * far) return;
      if (count_ == kMost)
        fits_ = false;
      else
        list_[count_++] = inflated(std::int32_t(i), b);
    });
  }

  std::shared_ptr<const BallScene> scene_;
  double margin_;
  Vec3 origin_;
  double probe_ = 0.0;
  Vec3 around_{0.0};
  double reach_ = -1.0;
  bool fits_ = false;
  std::size_t count_ = 0;
  std::array<NearBall, kMost> list_;
};

}  // namespace moltact
