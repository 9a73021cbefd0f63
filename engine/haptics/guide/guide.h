// Guidance of the hand along a way (guidance virtual fixture: Rosenberg 1993; Bowyer, Davies & Rodriguez y Baena 2014).
// The force is the negative gradient of a potential of the distance d between the hand and the nearest point of the way:
//
//   s = d for a spring, max(0, d - r) for a tube of radius r
//   U = k s^2 / 2             for s <= F / k
//   U = F s - F^2 / (2 k)     beyond, where the force has its greatest size F
//
// It depends on the position alone. Work on a closed path is therefore zero, and no force acts along the way: the guide
// never draws the hand forward. Where two parts of the way are equally near, the direction of the force changes at once;
// the energy is continuous there, and the safety stage limits the rate of the force.
//
// Construction allocates and belongs to the window's thread. The functions are pure, for every thread including the
// haptic one: no lock, allocation, exception or log. Units: angstrom, newton of the hand.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/units.h"
#include "engine/haptics/felt_force.h"

namespace moltact {

/// A way of straight pieces. It may have gaps, where the hand is lifted.
class GuidePath {
 public:
  /// Limit on the points of all parts; a tick examines at most this many pieces.
  static constexpr std::size_t kMaxPoints = 4096;

  /// One vector of points for each part without gaps. Points that are not finite and points equal to their predecessor
  /// are left out, as are those after kMaxPoints.
  explicit GuidePath(const std::vector<std::vector<Vec3>>& parts_A);

  bool empty() const noexcept { return pieces_.empty(); }
  double length_A() const noexcept { return length_A_; }  ///< without gaps

  struct Nearest {
    Vec3 place_A{0.0};
    double distance_A = 0.0;
    double along_A = 0.0;  ///< from the beginning of the way, gaps not counted
  };
  /// The nearest point of the way; the earliest of several. The way must not be empty.
  Nearest nearest(const Vec3& hand_A) const noexcept;
  /// The point at this length from the beginning; clamped to the way, which must not be empty.
  Vec3 at(double along_A) const noexcept;

 private:
  struct Piece {
    Vec3 from{0.0}, to{0.0};
    double along_A = 0.0;  // of `from`
  };
  // A sphere around some consecutive pieces, which are passed over if it is farther away than what was found.
  struct Group {
    Vec3 centre{0.0};
    double radius_A = 0.0;
    std::size_t begin = 0, end = 0;
  };
  std::vector<Piece> pieces_;
  std::vector<Group> groups_;
  double length_A_ = 0.0;
};

enum class GuideKind : std::uint8_t { Spring, Tube };

/// Stiffness and greatest force of a guide at full strength, at the hand: soft enough to be overcome with two fingers.
inline constexpr double kGuideStiffness_N_per_mm = 0.1, kGuideMax_N = 0.8;

/// A guide as felt: its potential.
struct Guide {
  std::shared_ptr<const GuidePath> path;  ///< null or empty: no guide
  GuideKind kind = GuideKind::Tube;
  double radius_A = 1.0;            ///< r of a tube
  double stiffness_N_per_A = 0.02;  ///< k
  double max_N = kGuideMax_N;       ///< F
};

/// The part of the distance that stretches the spring: s.
double guideStretch_A(GuideKind kind, double radius_A, double distance_A) noexcept;

/// Force, energy and stiffness of the guide for this hand. Zero without a way and for a position that is not finite. The
/// stiffness is k where the spring is stretched up to F, also for directions across the way; zero inside a tube.
FeltForce guideForce(const Guide& guide, const Vec3& hand_A) noexcept;

}  // namespace moltact
