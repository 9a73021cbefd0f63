#include "engine/workspace/scale.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/haptics/field/pair_model.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

// A value in the code's unit, shown in the unit `in`: two significant digits without trailing zeros or exponent (0.25,
// 4.2, 120).
std::string twoDigits(double value, Dimension dimension, std::string_view in) {
  const double unit = unitNamed(in, dimension)->in_code_units;
  int count = 0;
  double shown = value / unit;
  if (shown > 0 && std::isfinite(shown)) {
    const int before = static_cast<int>(std::floor(std::log10(shown) + 1e-9));
    const double step = std::pow(10.0, before - 1), rounded = std::round(shown / step);
    shown = rounded * step;
    count = std::clamp(std::fmod(rounded, 10.0) == 0.0 ? -before : 1 - before, 0, 12);
  } else {
    shown = 0.0;
  }
  return quantityText(shown * unit, dimension, {decimals(count), in});
}

std::string lengthInMolecule(double length_A) {
  return twoDigits(length_A, Dimension::Length, unitText(Dimension::Length));
}

std::string forceBetweenAtoms(double force_pN) { return twoDigits(force_pN * 1e-12, Dimension::Force, "pN"); }

std::string one(Dimension dimension) { return quantityText(1.0, dimension, plain()); }

}  // namespace

Workspace magnified(const Workspace& now, PointA centre, double radius_A, const DeviceSpecs& device) {
  const Vec3 room = finite(device.workspace_mm) ? device.workspace_mm : DeviceSpecs{}.workspace_mm;
  const double half_mm = 0.5 * std::min({room.x, room.y, room.z});
  if (!finite(centre.A) || !std::isfinite(radius_A) || !(half_mm > 0) || !std::isfinite(half_mm)) return now;
  Workspace out = now;
  out.centre_A = centre.A;
  // A part that needs a coarser scale than the whole keeps the scale of the whole.
  const double coarsest = std::max(kMinScale_A_per_mm, std::min(kMaxScale_A_per_mm, now.A_per_mm));
  out.A_per_mm = std::clamp(radius_A / half_mm, kMinScale_A_per_mm, coarsest);
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
  return trf("{0} here is {1} there", one(Dimension::HandLength), lengthInMolecule(workspace.A_per_mm));
}

double springEnergy_J(double energy_A2, double stiffness_N_per_mm, double A_per_mm) {
  constexpr double kJ_per_N_mm = 1e-3;
  return kJ_per_N_mm * stiffness_N_per_mm * energy_A2 / (A_per_mm * A_per_mm);
}

std::optional<double> carbonPush_pN(double overlap_A) {
  // Of two carbons of Tripos 5.2 (scale.h). The distance is a parameter of that force field; it does not follow the table
  // of radii of the spheres.
  constexpr double kTouch_A = 3.40, kDepth_kcal_per_mol = 0.107;
  if (!(overlap_A >= 0.0 && overlap_A <= kMaxOverlap_A)) return std::nullopt;
  const double near = kTouch_A / (kTouch_A - overlap_A);
  return kForceUnit_pN * 12.0 * kDepth_kcal_per_mol / kTouch_A * (std::pow(near, 13) - std::pow(near, 7));
}

std::string scaleSentence(const Workspace& workspace, double stiffness_N_per_mm) {
  const std::string hand = one(Dimension::HandLength), there = lengthInMolecule(workspace.A_per_mm);
  if (!(stiffness_N_per_mm > 0.0)) return trf("{0} here is {1} there; nothing pushes back.", hand, there);
  const std::string force = one(Dimension::Force);
  const std::optional<double> push = carbonPush_pN(workspace.A_per_mm / stiffness_N_per_mm);
  return push ? trf("{0} here is {1} there, {2} here would be {3} there.", hand, there, force, forceBetweenAtoms(*push))
              : trf("{0} here is {1} there; {2} here presses deeper than atoms can go there.", hand, there, force);
}

std::string scaleReason(const Workspace& workspace, double stiffness_N_per_mm) {
  if (!(stiffness_N_per_mm > 0.0)) return tr("The surface has no spring now.");
  const double depth_A = workspace.A_per_mm / stiffness_N_per_mm;
  const std::string force = one(Dimension::Force), deep = lengthInMolecule(depth_A);
  const std::optional<double> push = carbonPush_pN(depth_A);
  if (!push)
    return trf("With {0} the probe is {1} under the surface: so far into each other no two atoms can be pressed.",
               force, deep);
  return trf(
      "With {0} the probe is {1} under the surface. Two carbon atoms pressed that far into each other would push back "
      "with {2}. The spring in your hand grows evenly with depth; between atoms the force grows ever faster, and a "
      "little farther off they attract.",
      force, deep, forceBetweenAtoms(*push));
}

}  // namespace moltact
