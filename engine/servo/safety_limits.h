// The limits of the safety stage: their values, and the flags that report which of them changed the force.
// docs/safety.md explains the reason and source of each value. Plain data, every thread.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace moltact {

inline constexpr double kTick_s = 0.001;  ///< the length of a tick: 1 kHz

namespace safety {

inline constexpr double kSoftStart_s = 0.5;      ///< duration of a soft start, from zero to full force
inline constexpr double kSlew_N_per_s = 1000.0;  ///< slew rate required by a wall of 1 N/mm at 1 m/s
inline constexpr double kStale_s = 0.020;        ///< without a fresh position for this time the force starts to fade
inline constexpr double kFaded_s = 0.040;        ///< after this time it is zero
inline constexpr double kContactLost_s = 0.100;  ///< after this time the contact is discarded
inline constexpr double kJump_m_per_s = 5.0;     ///< a position that changes faster was misread
inline constexpr double kJump_rad_per_s = 60.0;  ///< the same for rotation
inline constexpr double kMaxSpeed_rad_per_s = 15.0;  ///< from this angular speed no torque drives the hand's rotation
inline constexpr double kMaxSpeed_m_per_s = 1.0;     ///< from this speed no force drives the hand's motion
inline constexpr double kSpeedFadeStart = 0.75;    ///< fraction of that speed at which the driving force starts to fade
inline constexpr double kVendorLimitMargin = 0.9;  ///< usable fraction of a limit of the device's driver
inline constexpr double kHeat_s = 30.0;            ///< thermal time constant of the motors' windings
inline constexpr double kWarm = 0.8;  ///< fraction of the permitted heat at which the peak force starts to fall
inline constexpr double kLightHand_N_s_per_m = 2.0;  ///< damping of the lightest grip
inline constexpr double kUnknownFriction_N = 0.01;   ///< friction assumed for a device that reports none
inline constexpr double kStiffnessMargin =
    0.5;  ///< usable fraction of the stiffness at which the loop becomes unstable
inline constexpr double kStiffening_N_per_mm_s = 1.0;  ///< largest rate of change of the stiffness during contact
/// Below this speed there is no damping, because the measured speed is mostly quantization noise.
inline constexpr double kStillHand_m_per_s = 0.005;
inline constexpr double kStillHand_rad_per_s = 0.1;  ///< the same for rotation
/// Generated energy that was not dissipated, above which the force is cut: half of the energy of a 0.5 N/mm spring at
/// 3.3 N.
inline constexpr double kEnergyCut_J = 0.005;
inline constexpr double kFieldShare = 0.5;             ///< fraction of the stiffness bound that a field may use
inline constexpr double kMaxStiffness_N_per_mm = 5.0;  ///< largest stiffness of a spring, whatever is requested

}  // namespace safety

/// A limit. A sample's `limits` contains the bits of those that changed its force.
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

/// The text of a limit.
struct LimitWords {
  Limit limit;
  std::string_view name;      ///< "Heat"
  std::string_view sentence;  ///< shown while the limit acts; untranslated (N_)
};

/// All limits in the order of their bits.
std::span<const LimitWords> limitWords();

}  // namespace moltact
