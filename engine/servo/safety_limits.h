// The limits between what a method computes and what a hand is given: their figures, and the bits by which each says
// that it has acted. Why each is there and where its figure comes from: docs/safety.md. Plain data, every thread.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace moltact {

inline constexpr double kTick_s = 0.001;  ///< the length of a tick: 1 kHz

namespace safety {

inline constexpr double kSoftStart_s = 0.5;            ///< from nothing to full force
inline constexpr double kSlew_N_per_s = 1000.0;        ///< what a wall of 1 N/mm needs at 1 m/s
inline constexpr double kStale_s = 0.020;              ///< without a fresh place for so long the force begins to fall
inline constexpr double kFaded_s = 0.040;              ///< and is nothing here
inline constexpr double kContactLost_s = 0.100;        ///< and here the contact is forgotten
inline constexpr double kJump_m_per_s = 5.0;           ///< faster than any hand: the place was misread
inline constexpr double kJump_rad_per_s = 60.0;        ///< the same of its turning
inline constexpr double kFastest_rad_per_s = 15.0;     ///< from here on no torque drives the hand's turning
inline constexpr double kFastest_m_per_s = 1.0;        ///< from here on the force no longer drives the hand at all
inline constexpr double kSpeedFadeStart = 0.75;        ///< of that speed: from here on no longer fully
inline constexpr double kVendorLimitMargin = 0.9;      ///< so near to a limit of the device's own driver
inline constexpr double kHeat_s = 30.0;                ///< how fast the motors' windings warm and cool
inline constexpr double kWarm = 0.8;                   ///< of the heat borne for good: from here on the peak falls
inline constexpr double kLightHand_N_s_per_m = 2.0;    ///< the damping of a hand that barely holds the stylus
inline constexpr double kUnknownFriction_N = 0.01;     ///< of a device that tells none
inline constexpr double kStiffnessMargin = 0.5;        ///< of the stiffness at which the loop would become unstable
inline constexpr double kStiffening_N_per_mm_s = 1.0;  ///< how fast the stiffness may change under a finger
inline constexpr double kStillHand_m_per_s =
    0.005;  ///< slower than this no damping is given: the speed is mostly rounding
inline constexpr double kStillHand_rad_per_s = 0.1;  ///< the same of its turning
inline constexpr double kEnergyCut_J = 0.005;     ///< made and not absorbed again: half of what 3.3 N store at 0.5 N/mm
inline constexpr double kHardest_N_per_mm = 5.0;  ///< no spring is stiffer, whatever is asked

}  // namespace safety

/// One limit; a sample's `limits` holds the bits of those that changed its force.
enum class Limit : std::uint32_t {
  NotFinite = 1u << 0,
  Clamp = 1u << 1,
  Heat = 1u << 2,
  Slew = 1u << 3,
  SoftStart = 1u << 4,
  StalePlace = 1u << 5,
  LateLoop = 1u << 6,
  Jump = 1u << 7,
  Speed = 1u << 8,
  Damping = 1u << 9,
  EnergyCut = 1u << 10,
  Stiffness = 1u << 11,
  Unplugged = 1u << 12,
  Panic = 1u << 13,
  DeviceFault = 1u << 14,
};

/// The limits that acted in a tick.
class LimitFlags {
 public:
  void add(Limit limit) { bits_ |= static_cast<std::uint32_t>(limit); }
  void add(LimitFlags others) { bits_ |= others.bits_; }
  bool has(Limit limit) const { return bits_ & static_cast<std::uint32_t>(limit); }
  bool any() const { return bits_ != 0; }
  friend bool operator==(LimitFlags, LimitFlags) = default;

 private:
  std::uint32_t bits_ = 0;
};

struct LimitWords {
  Limit limit;
  std::string_view name;      ///< "Heat"
  std::string_view sentence;  ///< what the person is told while it acts
};

/// Every limit in the order of its bit.
std::span<const LimitWords> limitWords();

}  // namespace moltact
