// The exact tracker: the god-object method on the union of spheres. Its only error is rounding.
//
// The SCP s moves from its last position down the gradient of |x - h|^2 toward the HIP h and stays outside every
// sphere. Its path consists of pieces in closed form: straight lines, great circles on spheres and arcs of
// intersection circles. The ends of the pieces have closed forms too (docs/exact-tracker.md). The tracker stores
// only a list of the spheres near the SCP (nearby_spheres.h).
//
// The paper's three cases are slideOnSphere (case 1), slideOnCircle (case 2) and holdAtPoint (case 3, a vertex that
// blocks the SCP). Haptic thread; no allocation after construction. Units: angstrom.
#pragma once

#include <array>
#include <memory>

#include "engine/haptics/active_set.h"
#include "engine/haptics/nearby_spheres.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/sweep.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class ExactTracker final : public Tracker {
 public:
  ExactTracker(std::shared_ptr<const SphereGrid> scene, double probe_A);

  Contact step(PointA hip) noexcept override;
  void reset() noexcept override;
  /// A growing probe moves the SCP in small steps within the limit kMaxWork; the remaining growth follows in the next
  /// ticks.
  void setProbe(double probe_A) noexcept override;
  bool setMotion(const SphereMotion* motion) noexcept override;  // moving_spheres.cpp
  void advanceTo(double fraction) noexcept override;
  /// The radius by which the spheres are inflated now. It lags behind setProbe() while a large change is spread over
  /// several ticks.
  double probe_A() const noexcept override { return near_.probe_A(); }
  MemoryUsage memoryUsage() const noexcept override;

  /// Number of ticks that ended early: the motion needed more than kMaxPieces pieces, or the motion or the growth of the
  /// probe examined more than kMaxWork spheres. The SCP then stays outside all spheres (inflated by probe_A()) and
  /// continues in the next tick.
  std::uint64_t cutShort() const noexcept { return cut_short_; }

  /// Cost of the last step() or setProbe() that left the fast path: the number of spheres, cells and groups of spheres
  /// that it examined. The motion and the growth of the probe may each exceed kMaxWork by the cost of one piece or
  /// step.
  std::uint64_t workCount() const noexcept { return near_.workCount(); }

  static constexpr int kMaxPieces = 256;
  static constexpr std::uint64_t kMaxWork = 5'000;

 private:
  static constexpr std::size_t kMaxTouching = 32;

  // An intersection circle and its free arc around the SCP. Angles are measured from axis_1.
  struct Circle {
    std::int32_t i = -1, j = -1;
    Vec3 centre, axis, axis_1, axis_2;  // `axis` points from sphere i to sphere j; an orthonormal basis
    double radius = 0;                  // of the circle
    double to_i = 0, to_j = 0;          // distances of the circle's plane from the two centres
    double between = 0;                 // distance between the two centres
    double low = 0, high = 0;           // ends of the free arc
    double angle = 0;                   // of the SCP; unused in a narrow arc, where along_1 and along_2 replace it
    double along_1 = 1, along_2 = 0;    // cosine and sine of the SCP's angle
    bool narrow = false;  // the free arc is less than half a turn and described by the directions of its ends
    double low_1 = 0, low_2 = 0, high_1 = 0, high_2 = 0;  // cosine and sine of the ends
  };

  // A disc of directions on a sphere, limited by the cosine of the angle to `centre`. Directions with a cosine above
  // `clear` lie in no cap (cap.h). Those above `cosine` can lie in one cap only, the one nearest to the SCP; that cap is
  // then tested.
  struct Patch {
    Vec3 centre{0.0};
    double clear = 2.0, cosine = 2.0;
    Vec3 axis{0.0};    // of the nearest cap; zero: there is none
    double rim = 2.0;  // the nearest cap's cosine
  };

  enum class SlideResult : std::uint8_t { Rests, Continues, Stuck };
  enum class Made : std::uint8_t { Yes, No, FarOff };
  enum class Freed : std::uint8_t { Yes, No, TooMany };

  [[gnu::noinline]] Contact stepFull(double x, double y, double z) noexcept;
  [[gnu::noinline]] Contact stepWhileProbeGrows(const Vec3& hip) noexcept;
  [[gnu::noinline]] Contact stepFast(double x, double y, double z) noexcept;  // ordinary_tick.cpp
  void flow(const Vec3& hip) noexcept;
  SlideResult piece(const Vec3& hip, Admitted admitted) noexcept;
  SlideResult fly(const Vec3& hip) noexcept;
  SlideResult slideOnSphere(const Vec3& hip, std::int32_t sphere, std::int32_t toward = -1) noexcept;
  SlideResult restOnSphere(std::int32_t sphere, const Vec3& direction) noexcept;
  SlideResult slideOnCircle(const Vec3& hip, std::int32_t i, std::int32_t j) noexcept;
  Made makeCircle(std::int32_t i, std::int32_t j) noexcept;
  void holdAtPoint(const std::array<std::int32_t, 3>& spheres) noexcept;
  void findTouching() noexcept;
  int thirdOf(const ActiveSet& set) const noexcept;
  void holdHere() noexcept;
  bool outsideAll() noexcept;
  void resizeProbe() noexcept;                                    // moving_surface.cpp
  Freed depenetrate() noexcept;                                   // moving_surface.cpp
  bool followsQuickly(const Vec3& hip, double moved_A) noexcept;  // moving_spheres.cpp
  void trackSurface(const Vec3& hip) noexcept;
  void forgetSurroundings() noexcept;
  double gapRound(const Vec3& place) noexcept;
  Hit firstHit(const Vec3& to) noexcept;
  SlideResult slideResult(double moved_A) const noexcept;
  double contactAt(const Vec3& place) const noexcept;
  void holdBy(std::int32_t a, std::int32_t b = -1, std::int32_t c = -1) noexcept;
  void cacheActiveSet() noexcept;
  Contact contact(const Vec3& hip) const noexcept;                           // ordinary_tick.cpp
  Contact contactHeldBy(std::size_t count, const Vec3& hip) const noexcept;  // ordinary_tick.cpp

  NearbySpheres near_;
  Vec3 scp_{0.0};           // like every position inside the tracker, relative to near_.origin()
  double contact_A_ = 0.0;  // a sphere within this distance of the SCP counts as touched
  bool armed_ = false;      // the HIP has been outside since the start
  bool behind_ = false;     // the last step ended early
  bool moved_ = false;      // the spheres have moved since `seen_fraction_`, where the SCP was last moved outside
  double seen_fraction_ = 0.0;
  // While spheres move: at clear_fraction_ no sphere except the blocking ones was within clear_gap_ of clear_from_.
  Vec3 clear_from_{0.0};
  double clear_gap_ = 0.0, clear_fraction_ = 0.0;
  bool resizing_ = false;  // the probe grows or shrinks toward goal_A_
  bool resized_ = false;   // the probe's radius has changed since the last tick
  double goal_A_ = 0.0, step_A_ = 0.0;
  bool may_sink_ = false;  // the path has passed touched spheres that do not block it
  Feature feature_ = Feature::Free;
  std::array<std::int32_t, 3> holders_{-1, -1, -1};  // the active set, in the order of Contact::atoms
  struct Held {
    Vec3 centre{0.0};
    double radius = 0.0, inverse_radius = 0.0;
  };
  std::array<Held, 3> held_{};                // geometry of the active set at present; zero where unused
  std::array<Touch, kMaxTouching> touching_;  // surfaces that the SCP touches during the motion
  std::size_t touching_count_ = 0;

  // Data for the fast path of an ordinary tick, one group for each feature.
  Vec3 free_from_{0.0};  // free: every sphere is at least sqrt(free_gap2_) from this point
  double free_gap2_ = 0.0;
  Patch patch_;    // sphere
  Circle circle_;  // circle
  /// Point: rows of the inverse of its normals. The vertex blocks the SCP while all components of the displacement are
  /// >= 0.
  std::array<Vec3, 3> holds_;
  bool holds_known_ = false;

  std::uint64_t cut_short_ = 0;
};

}  // namespace moltact
