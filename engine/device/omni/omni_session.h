// Opens an Omni or Touch and reads its description. Blocks, because the driver may search a network. Any thread except
// the haptic one, one at a time.
#pragma once

#include "engine/device/device.h"
#include "engine/device/omni/hd_library.h"

namespace moltact {

struct OmniSession {
  hd::Handle device = hd::kInvalidHandle;
  DeviceInfo info;
  std::string model, serial;
  std::uint32_t calibration_style = 0;
  Vec3 workspace_middle_mm{0.0};  ///< middle of the usable workspace, relative to the driver's origin
};

/// Initialises the vendor's default device. Returns a Problem if there is none or it is in use; then nothing stays
/// open.
Expected<OmniSession> openOmni(const hd::Library& hd);
void closeOmni(const hd::Library& hd, OmniSession& session);

/// Empties the driver's error stack, newest first, and calls `each` for each error. Returns the most severe, the newest
/// of equally severe ones. Any thread, including the haptic one.
template <class Each>
std::uint32_t drainErrors(const hd::Library& hd, Each&& each) noexcept {
  constexpr int kMaxErrors = 64;  // per call; the stack is short
  std::uint32_t worst = hd::kNoError;
  for (int k = 0; k < kMaxErrors; ++k) {
    const std::uint32_t code = hd.getError().code;
    if (code == hd::kNoError) break;
    each(code);
    if (hd::errorWeight(code) > hd::errorWeight(worst)) worst = code;
  }
  return worst;
}
inline std::uint32_t drainErrors(const hd::Library& hd) noexcept {
  return drainErrors(hd, [](std::uint32_t) {});
}

}  // namespace moltact
