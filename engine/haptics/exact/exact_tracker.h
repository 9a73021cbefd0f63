// The exact tracker: the god-object on the union of balls, with no error but rounding.
//
// The SCP s flows down |x - h|^2 toward the HIP h from its last place and stays outside every ball. Its way is made of
// pieces that are known in closed form: straight flight, great circles on spheres, arcs of intersection circles; so are
// the places where one piece ends and the next begins (docs/exact-tracker.md). Nothing is kept but a list of the balls
// near the SCP (nearby_balls.h).
//
// Where the paper's three cases are: slideOnSphere (case 1), slideOnCircle (case 2), a vertex that holds (case 3).
// Haptic thread; no allocation after construction. Units: angstrom.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "engine/haptics/ball_scene.h"
#include "engine/haptics/nearby_balls.h"
#include "engine/haptics/sweep.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class ExactTracker final : public Tracker {
 public:
  ExactTracker(std::shared_ptr<const BallScene> scene, double probe_A);

  Contact step(PointA hip) noexcept override;
  void reset() noexcept override;
  void setProbe(double probe_A) noexcept override;
  double probe_A() const noexcept override { return near_.probe_A(); }
  Footprint footprint() const noexcept override;

  /// Ticks whose flow was cut short because it took more pieces than kMostPieces; the SCP then lags, outside all balls.
  std::uint64_t cutShort() const noexcept { return cut_short_; }

  static constexpr int kMostPieces = 512;

 private:
  static constexpr int kMostTouching = 12;

  // The balls that the SCP touches, the ones that hold it first.
  struct Touching {
    std::array<std::int32_t, kMostTouching> balls;
    int count = 0;
    bool has(std::int32_t ball) const;
    void add(std::int32_t ball);
    void set(std::int32_t ball) { balls[0] = ball, count = 1; }
  };

  // An intersection circle and the free arc of it round the SCP. Angles count from axis_1.
  struct Circle {
    std::int32_t i = -1, j = -1;
    Vec3 centre, axis, axis_1, axis_2;  // `axis` from ball i to ball j; all unit and at right angles
    double radius = 0, to_i = 0, to_j = 0, between = 0;  // of the circle; its plane's distance from either centre; theirs
    double low = 0, high = 0;                // the free arc
    std::int32_t low_ball = -1, high_ball = -1;  // what ends it
    double angle = 0;                        // where the SCP is; in a narrow arc `along_1` and `along_2` tell it alone
    double along_1 = 1, along_2 = 0;         // its direction: cosine and sine of the angle
    bool narrow = false;                     // the free arc is less than half a turn: its ends' directions say all
    double low_1 = 0, low_2 = 0, high_1 = 0, high_2 = 0;
  };

  // Directions on a sphere round `centre`, by the cosine to it: where no cap is, and where none is but the one nearest to
  // the SCP, which is then asked itself.
  struct Patch {
    Vec3 centre{0.0};
    double clear = 2.0, cosine = 2.0;
    Vec3 axis{0.0};            // of the nearest cap; zero where there is none
    double rim = 2.0;          // its cosine
  };

  enum class Went : std::uint8_t { Rests, GoesOn, Stuck };

  [[gnu::noinline]] Contact lookRound(double x, double y, double z) noexcept;
  bool holdsQuickly(const Vec3& hip) noexcept;
  void flow(const Vec3& hip) noexcept;
  Went fly(const Vec3& hip) noexcept;
  Went slideOnSphere(const Vec3& hip, std::int32_t ball) noexcept;
  Went slideOnCircle(const Vec3& hip, std::int32_t i, std::int32_t j) noexcept;
  bool makeCircle(std::int32_t i, std::int32_t j) noexcept;
  void moveAlongCircle(double turned, std::int32_t meets) noexcept;
  void holdAtPoint(const std::array<std::int32_t, 3>& balls) noexcept;
  bool carry() noexcept;            // carry_surface.cpp
  std::int32_t outermost(std::int32_t ball) const noexcept;
  double gapRound(const Vec3& place) noexcept;
  Hit firstMet(const Vec3& to, std::span<const std::int32_t> leaving) noexcept;
  Vec3 normalOf(std::int32_t ball) const noexcept {
    const NearBall b = near_.ball(ball);
    return (scp_ - b.centre) / b.radius;
  }
  Contact contact(const Vec3& hip) const noexcept;
  void rememberHolders() noexcept;

  NearbyBalls near_;
  Vec3 scp_{0.0};            // this and every place inside the tracker is relative to near_.origin()
  bool armed_ = false;       // has the HIP been outside since the start?
  Feature feature_ = Feature::Free;
  std::array<std::int32_t, 3> holders_{-1, -1, -1};  // as Contact::atoms has them
  Touching touching_;

  // What lets an ordinary tick end at once, for the feature the SCP is on.
  Vec3 free_from_{0.0};      // free: no ball is nearer to this place than the root of free_gap2_
  double free_gap2_ = 0.0;
  Patch patch_;              // sphere
  Circle circle_;            // circle
  std::array<Vec3, 3> holds_;// point: rows of the inverse of its normals; all shares of the pull >= 0 means it holds
  bool holds_known_ = false;

  std::int32_t forced_ball_ = -1;  // the next piece slides on this sphere, or on this pair's circle
  std::int32_t forced_pair_ = -1;
  bool forced_flight_ = false;
  std::uint64_t cut_short_ = 0;
};

}  // namespace moltact
