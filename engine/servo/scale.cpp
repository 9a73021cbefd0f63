#include "engine/servo/scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace moltact {
namespace {

// Two digits that count, without the exponent that %g would show: 0.25, 4.2, 120.
std::string twoDigits(double value) {
  if (!(value > 0) || !std::isfinite(value)) return "0";
  const int before = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  const double unit = std::pow(10.0, before - 1);
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(1 - before, 0, 12), std::round(value / unit) * unit);
  std::string out = text;
  if (out.find('.') != std::string::npos) {
    while (out.back() == '0') out.pop_back();
    if (out.back() == '.') out.pop_back();
  }
  return out;
}

}  // namespace

Workspace magnified(const Workspace& now, PointA centre, double radius_A, const DeviceSpecs& device) {
  const Vec3 room = finite(device.workspace_mm) ? device.workspace_mm : DeviceSpecs{}.workspace_mm;
  const double half_mm = 0.5 * std::min({room.x, room.y, room.z});
  if (!finite(centre.A) || !std::isfinite(radius_A) || !(half_mm > 0) || !std::isfinite(half_mm)) return now;
  Workspace out = now;
  out.centre_A = centre.A;
  // A part that needs more room than the whole has lies in it as the whole does.
  const double coarsest = std::max(kFinest_A_per_mm, std::min(kCoarsest_A_per_mm, now.A_per_mm));
  out.A_per_mm = std::clamp(radius_A / half_mm, kFinest_A_per_mm, coarsest);
  return out;
}

Workspace rescaled(const Workspace& now, double A_per_mm, PointMm hand, PointA hip) {
  if (!(A_per_mm > 0.0) || !std::isfinite(A_per_mm) || !finite(hand.mm) || !finite(hip.A)) return now;
  Workspace out = now;
  out.A_per_mm = A_per_mm;
  out.centre_A = hip.A - now.rotation * (hand.mm * A_per_mm);
  return out;
}

std::string lengthScale(const Workspace& workspace) {
  return "1 mm here is " + twoDigits(workspace.A_per_mm) + " Å there";
}

std::optional<double> carbonPush_pN(double overlap_A) {
  constexpr double kTouch_A = 3.40, kDepth_kcal_per_mol = 0.107, kPn_A_mol_per_kcal = 69.477;
  if (!(overlap_A >= 0.0 && overlap_A <= kDeepest_A)) return std::nullopt;
  const double near = kTouch_A / (kTouch_A - overlap_A);
  return kPn_A_mol_per_kcal * 12.0 * kDepth_kcal_per_mol / kTouch_A * (std::pow(near, 13) - std::pow(near, 7));
}

std::string scaleSentence(const Workspace& workspace, double stiffness_N_per_mm) {
  const std::string length = lengthScale(workspace);
  if (!(stiffness_N_per_mm > 0.0)) return length + "; nothing pushes back.";
  const std::optional<double> push = carbonPush_pN(workspace.A_per_mm / stiffness_N_per_mm);
  return length + (push ? ", 1 N here would be " + twoDigits(*push) + " pN there."
                        : "; 1 N here presses deeper than atoms can go there.");
}

std::string scaleReason(const Workspace& workspace, double stiffness_N_per_mm) {
  if (!(stiffness_N_per_mm > 0.0)) return "The surface has no spring now.";
  const double depth_A = workspace.A_per_mm / stiffness_N_per_mm;
  const std::string deep = "With 1 N the probe is " + twoDigits(depth_A) + " Å under the surface";
  const std::optional<double> push = carbonPush_pN(depth_A);
  if (!push) return deep + ": so far into each other no two atoms can be pressed.";
  return deep + ". Two carbon atoms pressed that far into each other would push back with " + twoDigits(*push) +
         " pN. The spring in your hand grows evenly with depth; between atoms the force grows ever faster, and a "
         "little farther off they attract.";
}

}  // namespace moltact
