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

Workspace magnified(const Workspace& now, PointA centre, double radius_A, const DeviceFigures& device) {
  const Vec3 room = finite(device.workspace_mm) ? device.workspace_mm : DeviceFigures{}.workspace_mm;
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
  out.centre_A = hip.A - now.turn * (hand.mm * A_per_mm);
  return out;
}

std::string lengthScale(const Workspace& workspace) { return "1 mm here is " + twoDigits(workspace.A_per_mm) + " Å there"; }

std::string scaleSentence(const Workspace& workspace, std::optional<double> pN_per_N) {
  const std::string length = lengthScale(workspace);
  if (pN_per_N) return length + ", 1 N here would be " + twoDigits(*pN_per_N) + " pN there.";
  return length + "; the force is made for the hand and is none between molecules.";
}

}  // namespace moltact
