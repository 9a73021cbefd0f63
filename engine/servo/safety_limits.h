// The limits between a method's force and the hand: their figures, and the flags by which each reports that it has
// acted. docs/safety.md says why each exists and where its figure comes from. Plain data, every thread.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace moltact {

inline constexpr double kTick_s = 0.001;  ///< the length of a tick: 1 kHz

namespace safety {

inline constexpr double kSoftStart_s = 0.5;          ///< from nothing to full force
inline constexpr double kSlew_N_per_s = 1000.0;      ///< the slew that a wall of 1 N/mm needs at 1 m/s
inline constexpr double kStale_s = 0.020;            ///< without a fresh position for so long the force begins to fall
inline constexpr double kFaded_s = 0.040;            ///< and after so long it is zero
inline constexpr double kContactLost_s = 0.100;      ///< and after so long the contact is forgotten
inline constexpr double kJump_m_per_s = 5.0;         ///< faster than any hand: the position was misread
inline constexpr double kJump_rad_per_s = 60.0;      ///< the same for its rotation
inline constexpr double kFastest_rad_per_s = 15.0;   ///< from this speed on no torque drives the hand's rotation
inline constexpr double kFastest_m_per_s = 1.0;      ///< from this speed on the force no longer drives the hand
inline constexpr double kSpeedFadeStart = 0.75;      ///< fraction of that speed from which the driving force fades
inline constexpr double kVendorLimitMargin = 0.9;    ///< fraction used of a limit of the device's own driver
inline constexpr double kHeat_s = 30.0;              ///< time constant of the motors' windings
inline constexpr double kWarm = 0.8;                 ///< fraction of the permanent heat from which the peak force falls
inline constexpr double kLightHand_N_s_per_m = 2.0;  ///< the damping of a hand that barely holds the stylus
inline constexpr double kUnknownFriction_N = 0.01;   ///< of a device that reports none
inline constexpr double kStiffnessMargin = 0.5;  ///< fraction of the stiffness at which the loop would become unstable
inline constexpr double kStiffening_N_per_mm_s = 1.0;  ///< how fast the stiffness may change under a finger
/// A slower hand gets no damping: its measured speed is mostly rounding.
inline constexpr double kStillHand_m_per_s = 0.005;
inline constexpr double kStillHand_rad_per_s = 0.1;  ///< the same for its rotation
/// Energy made and not absorbed: half of the energy that 3.3 N store at 0.5 N/mm.
inline constexpr double kEnergyCut_J = 0.005;
inline constexpr double kFieldShare = 0.5;  ///< fraction of the stiffness bound that a field may take from the contact
inline constexpr double kHardest_N_per_mm = 5.0;  ///< the stiffest spring, whatever is asked

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
  std::string_view sentence;  ///< shown to the person while the limit acts
};

/// Every limit in the order of its bit.
std::span<const LimitWords> limitWords();

}  // namespace moltact
