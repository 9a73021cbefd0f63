// The functions of OpenHaptics' HD interface that drive Omni and Touch, according to its published documentation
// (version 3, Linux, x86-64). The vendor's library is not part of this program; it is loaded at run time. omni_device.h
// states which function may be called from which thread.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "engine/core/problem.h"
#include "engine/core/units.h"

namespace moltact::hd {

using Handle = std::uint32_t;           // HHD
using SchedulerHandle = unsigned long;  // HDSchedulerHandle
using CallbackCode = std::uint32_t;
using Boolean = unsigned char;  // HDboolean
using Callback = CallbackCode (*)(void*);

struct ErrorInfo {
  std::uint32_t code = 0;
  std::int32_t internal_code = 0;
  Handle device = 0;
};
static_assert(sizeof(ErrorInfo) == 12, "it is returned by value");

inline constexpr Handle kInvalidHandle = 0xFFFFFFFFu;
inline constexpr CallbackCode kDone = 0, kContinue = 1;
inline constexpr std::uint16_t kHighestPriority = 0xFFFF;

enum Name : std::uint32_t {
  // capabilities that can be enabled
  kForceOutput = 0x4000,
  kMaxForceClamping = 0x4001,
  kForceRamping = 0x4002,
  // state
  kButtons = 0x2000,
  kInkwellSwitch = 0x2002,
  kPosition = 0x2050,
  kTransform = 0x2052,
  kCurrentForce = 0x2700,
  // description
  kModel = 0x2501,
  kDriverVersion = 0x2502,
  kVendor = 0x2503,
  kSerial = 0x2504,
  kFirmware = 0x2505,
  kUsableWorkspace = 0x2551,
  kInputDof = 0x2553,
  kOutputDof = 0x2554,
  kCalibrationStyle = 0x2555,
  kMaxStiffness = 0x2602,
  kMaxForce = 0x2603,
  kMaxContinuousForce = 0x2604,
  kMotorTemperature = 0x2605,
  kMaxDamping = 0x2609,
  kVelocityLimit = 0x2606,
  kForceImpulseLimit = 0x2607,
};

enum Calibration : std::uint32_t { kCalibrated = 0x5000, kNeedsUpdate = 0x5001, kNeedsManualInput = 0x5002 };
enum CalibrationStyle : std::uint32_t { kEncoderReset = 1, kAuto = 2, kInkwell = 4 };

enum Error : std::uint32_t {
  kNoError = 0,
  kInvalidEnum = 0x0100,
  kInvalidValue = 0x0101,
  kInvalidOperation = 0x0102,
  kInvalidInputType = 0x0103,
  kBadHandle = 0x0104,
  kWarmMotors = 0x0200,
  kExceededMaxForce = 0x0201,
  kExceededImpulse = 0x0202,
  kExceededVelocity = 0x0203,
  kForceError = 0x0204,
  kDeviceFault = 0x0300,
  kAlreadyInitiated = 0x0301,
  kCommError = 0x0302,
  kCommConfig = 0x0303,
  kTimerError = 0x0304,
  kIllegalBegin = 0x0400,
  kIllegalEnd = 0x0401,
  kFrameError = 0x0402,
  kInvalidPriority = 0x0500,
  kSchedulerFull = 0x0501,
  kInvalidLicense = 0x0600,
};

/// An error described for the user, with a remedy.
struct ErrorWords {
  std::string message, remedy;
  bool begins_with_name = false;  ///< the message starts with a name and keeps its capital letter within a sentence
};
ErrorWords errorWords(std::uint32_t code);
/// A Problem in one sentence, stating that the error prevented `what`.
Problem problemOf(const std::string& what, const ErrorWords& words);

/// The severity of an error, for selecting the one to show: 0 none, 1 wrong calls, 2 licence, 3 force, 4 errors that
/// end the connection.
int errorWeight(std::uint32_t code) noexcept;
/// True if the device or its clock is lost.
inline bool endsConnection(std::uint32_t code) noexcept { return errorWeight(code) == 4; }
/// True if the device has cut a force.
inline bool cutsForce(std::uint32_t code) noexcept { return code > kWarmMotors && code <= kForceError; }

/// True if an error during a frame's begin, write or end means that the frame's force may not have reached the device.
/// Only warnings about warm motors or a force cut by the driver leave the frame valid.
inline bool failsFrame(std::uint32_t code) noexcept {
  return code != kNoError && !(code >= kWarmMotors && code <= kExceededVelocity);
}

struct Library {
  Handle (*initDevice)(const char*);
  void (*disableDevice)(Handle);
  void (*makeCurrentDevice)(Handle);
  void (*beginFrame)(Handle);
  void (*endFrame)(Handle);
  ErrorInfo (*getError)();
  void (*enable)(std::uint32_t);
  void (*disable)(std::uint32_t);  ///< may be null; then only writing zero force ends the force
  void (*getBooleanv)(std::uint32_t, Boolean*);
  void (*getIntegerv)(std::uint32_t, int*);
  void (*getDoublev)(std::uint32_t, double*);
  void (*setDoublev)(std::uint32_t, const double*);
  const char* (*getString)(std::uint32_t);
  std::uint32_t (*checkCalibration)();
  void (*updateCalibration)(std::uint32_t);
  void (*startScheduler)();
  void (*stopScheduler)();
  void (*setSchedulerRate)(unsigned long);
  SchedulerHandle (*scheduleAsynchronous)(Callback, void*, std::uint16_t);
  void (*unschedule)(SchedulerHandle);

  /// The library, loaded at the first call and never unloaded; $MOLTACT_LIBHD names another file. A Problem states how
  /// to obtain the library, or which function is missing.
  static Expected<const Library*> get();
};

/// The stylus's orientation from the 16 numbers of kTransform (column-major, including the gimbal); `otherwise` if they
/// are not a rotation. Haptic thread.
inline Quat orientationOf(const double (&t)[16], const Quat& otherwise) noexcept {
  const glm::dmat3 axes(Vec3(t[0], t[1], t[2]), Vec3(t[4], t[5], t[6]), Vec3(t[8], t[9], t[10]));
  if (!(std::abs(glm::determinant(axes) - 1.0) < 1e-2)) return otherwise;
  const Quat q = glm::normalize(glm::quat_cast(axes));
  return rotates(q) ? q : otherwise;
}

/// Switches the motors on or off, independent of the force written last. Any thread, inside or outside a frame.
inline void switchForce(const Library& hd, bool on) noexcept {
  if (on)
    hd.enable(kForceOutput);
  else if (hd.disable)
    hd.disable(kForceOutput);
}

}  // namespace moltact::hd
