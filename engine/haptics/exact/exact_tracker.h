// The exact tracker: the god-object on the union of spheres, with no error but rounding.
//
// The SCP s flows down |x - h|^2 toward the HIP h from its last place and stays outside every sphere. Its path is made of
// pieces that are known in closed form: straight flight, great circles on spheres, arcs of intersection circles; so are
// the places where one piece ends and the next begins (docs/exact-tracker.md). Nothing is kept but a list of the spheres
// near the SCP (nearby_spheres.h).
//
// Where the paper's three cases are: slideOnSphere (case 1), slideOnCircle (case 2), a vertex that holds (case 3).
// Haptic thread; no allocation after construction. Units: angstrom.
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
  /// A growing surface carries the SCP in steps, as many as kMaxLooked allows; the rest follows in the next ticks.
  void setProbe(double probe_A) noexcept override;
  bool setMotion(const SphereMotion* motion) noexcept override;  // moving_spheres.cpp
  void advanceTo(double fraction) noexcept override;
  /// What the spheres are inflated by now: where a large change is carried on over several ticks it lags behind
  /// setProbe().
  double probe_A() const noexcept override { return near_.probe_A(); }
  MemoryUsage memoryUsage() const noexcept override;

  /// Ticks that were cut short because a flow had taken kMaxPieces pieces or looked at kMaxLooked spheres, or a surface
  /// that swells had. The SCP then lags, outside all spheres (inflated by probe_A()), and goes on in the next tick.
  std::uint64_t cutShort() const noexcept { return cut_short_; }

  /// Spheres, cells and groups of spheres that the last step() or setProbe() that had to look round looked at: what it
  /// cost. At most kMaxLooked for a flow, as many for a surface that swells, and what one piece or step of either
  /// adds.
  std::uint64_t looked() const noexcept { return near_.looked(); }

  static constexpr int kMaxPieces = 256;
  static constexpr std::uint64_t kMaxLooked = 5'000;

 private:
  static constexpr std::size_t kMaxTouching = 32;

  // An intersection circle and the free arc of it round the SCP. Angles count from axis_1.
  struct Circle {
    std::int32_t i = -1, j = -1;
    Vec3 centre, axis, axis_1, axis_2;  // `axis` from sphere i to sphere j; all unit and at right angles
    double radius = 0, to_i = 0, to_j = 0,
           between = 0;               // of the circle; its plane's distance from either centre; theirs
    double low = 0, high = 0;         // the free arc
    double angle = 0;                 // where the SCP is; in a narrow arc `along_1` and `along_2` tell it alone
    double along_1 = 1, along_2 = 0;  // its direction: cosine and sine of the angle
    bool narrow = false;              // the free arc is less than half a turn: its ends' directions say all
    double low_1 = 0, low_2 = 0, high_1 = 0, high_2 = 0;
  };

  // Directions on a sphere round `centre`, by the cosine to it: where no cap is, and where none is but the one nearest
  // to the SCP, which is then asked itself.
  struct Patch {
    Vec3 centre{0.0};
    double clear = 2.0, cosine = 2.0;
    Vec3 axis{0.0};    // of the nearest cap; zero where there is none
    double rim = 2.0;  // its cosine
  };

  enum class SlideResult : std::uint8_t { Rests, GoesOn, Stuck };
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
  void swell() noexcept;                                          // moving_surface.cpp
  Freed depenetrate() noexcept;                                   // moving_surface.cpp
  bool followsQuickly(const Vec3& hip, double moved_A) noexcept;  // moving_spheres.cpp
  void trackSurface(const Vec3& hip) noexcept;
  void forgetSurroundings() noexcept;
  double gapRound(const Vec3& place) noexcept;
  Hit firstMet(const Vec3& to) noexcept;
  SlideResult slideResult(double moved_A) const noexcept;
  double contactAt(const Vec3& place) const noexcept;
  void holdBy(std::int32_t a, std::int32_t b = -1, std::int32_t c = -1) noexcept;
  void lookAtHolders() noexcept;
  Contact contact(const Vec3& hip) const noexcept;                           // ordinary_tick.cpp
  Contact contactHeldBy(std::size_t count, const Vec3& hip) const noexcept;  // ordinary_tick.cpp

  NearbySpheres near_;
  Vec3 scp_{0.0};           // this and every place inside the tracker is relative to near_.origin()
  double contact_A_ = 0.0;  // a sphere whose surface is no farther than this from the SCP is touched
  bool armed_ = false;      // has the HIP been outside since the start?
  bool behind_ = false;     // the last flow was cut short
  bool moved_ =
      false;  // the spheres have moved on from `seen_fraction_` of the motion, where the SCP was last brought out
  double seen_fraction_ = 0.0;
  // While spheres move: when the fraction was clear_fraction_, no sphere but the holders was nearer to this place than
  // clear_gap_.
  Vec3 clear_from_{0.0};
  double clear_gap_ = 0.0, clear_fraction_ = 0.0;
  bool swells_ = false;   // the surface is growing or shrinking to probe goal_A_
  bool swelled_ = false;  // and has gone on since the last tick
  double goal_A_ = 0.0, step_A_ = 0.0;
  bool may_sink_ = false;  // it has passed spheres that are touched and do not hold
  Feature feature_ = Feature::Free;
  std::array<std::int32_t, 3> holders_{-1, -1, -1};  // as Contact::atoms has them
  struct Held {
    Vec3 centre{0.0};
    double radius = 0.0, inverse_radius = 0.0;
  };
  std::array<Held, 3> held_{};                // the same spheres, as they are now; nothing where there is none
  std::array<Touch, kMaxTouching> touching_;  // what the SCP touches, while it flows
  std::size_t touching_count_ = 0;

  // What lets an ordinary tick end at once, for the feature the SCP is on.
  Vec3 free_from_{0.0};  // free: no sphere is nearer to this place than the root of free_gap2_
  double free_gap2_ = 0.0;
  Patch patch_;    // sphere
  Circle circle_;  // circle
  std::array<Vec3, 3>
      holds_;  // point: rows of the inverse of its normals; all shares of the displacement >= 0 means it holds
  bool holds_known_ = false;

  std::uint64_t cut_short_ = 0;
};

}  // namespace moltact
