#include "engine/device/omni/omni_session.h"

#include <cmath>
#include <utility>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

// Keeps the default for a figure that the driver does not report or reports as 0.
void figure(const hd::Library& hd, std::uint32_t name, double& to, double scale = 1.0) {
  double value = 0;
  hd.getDoublev(name, &value);
  if (std::isfinite(value) && value > 0) to = value * scale;
}

void readFigures(const hd::Library& hd, OmniSession& session) {
  DeviceInfo& info = session.info;
  static_cast<DeviceSpecs&>(info) = phantomOmniFigures();
  info.gives_force = true;
  info.dof_in = 6;
  info.dof_out = 3;
  figure(hd, hd::kMaxForce, info.max_force_N);
  figure(hd, hd::kMaxContinuousForce, info.continuous_force_N);
  figure(hd, hd::kMaxStiffness, info.max_stiffness_N_per_mm);
  figure(hd, hd::kMaxDamping, info.max_damping_N_s_per_m, 1e3);         // the driver reports N s/mm
  figure(hd, hd::kVelocityLimit, info.speed_limit_m_per_s, 1e-3);       // mm/s
  figure(hd, hd::kForceImpulseLimit, info.slew_limit_N_per_s, 1000.0);  // N per tick at 1 kHz
  double box[6] = {};
  hd.getDoublev(hd::kUsableWorkspace, box);
  const Vec3 size(box[3] - box[0], box[4] - box[1], box[5] - box[2]);
  if (finite(size) && size.x > 0 && size.y > 0 && size.z > 0) {
    info.workspace_mm = size;
    session.workspace_middle_mm = Vec3(box[0], box[1], box[2]) + 0.5 * size;
  }
}

std::string text(const hd::Library& hd, std::uint32_t name) {
  const char* found = hd.getString(name);
  return found ? found : "";
}

}  // namespace

Expected<OmniSession> openOmni(const hd::Library& hd) {
  drainErrors(hd);
  OmniSession session;
  session.device = hd.initDevice(nullptr);
  const std::uint32_t error = drainErrors(hd);
  // Warnings such as warm motors do not prevent the use of an open device.
  if (session.device == hd::kInvalidHandle || hd::endsConnection(error) || error == hd::kInvalidLicense) {
    closeOmni(hd, session);
    const hd::ErrorWords words = hd::errorWords(error == hd::kNoError ? std::uint32_t(hd::kCommError) : error);
    return hd::problemOf(tr("no Omni or Touch could be opened"), words);
  }
  hd.makeCurrentDevice(session.device);
  session.model = text(hd, hd::kModel);
  session.serial = text(hd, hd::kSerial);
  readFigures(hd, session);
  session.info.name = session.model.empty() ? "Omni" : session.model;
  int style = 0;
  hd.getIntegerv(hd::kCalibrationStyle, &style);
  session.calibration_style = std::uint32_t(style);
  hd::switchForce(hd, true);
  hd.enable(hd::kMaxForceClamping);
  hd.enable(hd::kForceRamping);
  drainErrors(hd);  // figures that this model lacks are not reported to the user
  return session;
}

void closeOmni(const hd::Library& hd, OmniSession& session) {
  if (session.device != hd::kInvalidHandle) {
    hd::switchForce(hd, false);
    hd.disableDevice(std::exchange(session.device, hd::kInvalidHandle));
  }
  drainErrors(hd);
}

}  // namespace moltact
