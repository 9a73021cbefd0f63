// A tip that scans a molecule line by line, as that of an atomic force microscope does. The picture of a rigid tip in
// contact is the dilation of the spheres by the tip (Keller, Surf. Sci. 253, 353, 1991): at each node the tip rests on
// the atom that stops it highest. A spherical tip of radius R stands above an atom of radius r at the height
// z - R + sqrt((R + r)^2 - d^2) of its apex, with d the horizontal distance. The flank of a cone has a straight line as
// its profile. Both are exact.
//
// At constant force the tip sinks into the atoms until their forces add up to the set force. The model is an elastic
// foundation: each atom pushes straight up, in proportion to the depth of the tip under the height at which this atom
// alone would stop it. The force is then a piecewise linear function of the height, whose solution is exact. The
// substrate is rigid.
//
// Any thread except the haptic one. Units: angstrom, piconewton, newton per metre.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/sphere.h"
#include "engine/haptics/height_field/height_field.h"

namespace moltact {

struct ScanSetup {
  double tip_A = 10.0;     ///< radius of the tip's apex, 0 to kMaxTip_A
  double cone_deg = 0.0;   ///< half the opening angle of the cone above the apex, 0 to kMaxCone_deg; 0: a ball alone
  double spacing_A = 0.5;  ///< between lines, and between the nodes of a line: kMinScanSpacing_A to kMaxScanSpacing_A
  double margin_A = 5.0;   ///< from the outermost spheres to the border of the scan, 0 to kMaxScanMargin_A
  double below_A = 0.0;    ///< from the lowest point of the spheres down to the substrate, 0 to kMaxBelow_A
  double force_pN = 0.0;   ///< 0: contact without force; to kMaxScanForce_pN
  double contact_N_per_m = 1.0;    ///< stiffness of an atom's contact, kMinContact_N_per_m to kMaxContact_N_per_m
  Quat orientation = kNoRotation;  ///< rotates the scan's axes into the molecule's; the tip comes from its +z
  friend bool operator==(const ScanSetup&, const ScanSetup&) = default;

  /// The depth to which a single atom yields (unit: angstrom).
  double sink_A() const { return 0.01 * force_pN / contact_N_per_m; }
};

inline constexpr double kMaxTip_A = 100.0, kMaxCone_deg = 60.0, kMaxScanMargin_A = 200.0, kMaxBelow_A = 10'000.0;
inline constexpr double kMinScanSpacing_A = 0.02, kMaxScanSpacing_A = 20.0;
inline constexpr double kMaxScanForce_pN = 10'000.0, kMinContact_N_per_m = 0.01, kMaxContact_N_per_m = 1000.0;
inline constexpr std::size_t kMaxScanNodes = 4'000'000;

class ScanningTip {
 public:
  /// The scan covers all spheres but those of `without` (ascending indices) with the margin. The substrate lies
  /// `below_A` under their lowest point. A Problem if no sphere is left, if a value of the setup is out of its range, and if the scan would have more
  /// than kMaxScanNodes nodes.
  static Expected<ScanningTip> over(std::span<const Sphere> spheres, const ScanSetup& setup,
                                    std::span<const std::uint32_t> without = {});

  /// The scan so far: the heights of the lines that are still to come are 0.
  const HeightField& field() const { return field_; }
  /// Takes the field of a finished scan.
  HeightField take() && { return std::move(field_); }
  const ScanSetup& setup() const { return setup_; }
  int linesDone() const { return line_; }
  bool done() const { return line_ >= field_.rows; }
  /// Starts again with another radius of the tip (0 to kMaxTip_A, clamped) on the same nodes; allocates nothing.
  void restart(double tip_A) noexcept;
  /// Scans the next line, if there is one.
  void scanLine();
  void scanAll() {
    while (!done()) scanLine();
  }

 private:
  struct Atom {  // in the scan's axes
    Vec3 centre;
    double radius, reach;  // of the atom; of atom and tip
    double far;            // horizontal distance at which the tip passes down to the substrate
    std::int32_t index;
  };
  struct Stop {
    double height;
    std::int32_t atom;
  };

  ScanningTip() = default;
  void setReach() noexcept;
  double apexOver(const Atom& atom, double d2) const;
  template <class Visit>
  void eachStop(double y, Visit&& visit) const;
  void sinkLine(double y, double* heights, std::int32_t* stopped_by);

  ScanSetup setup_;
  HeightField field_;
  double sine_ = 0.0, cosine_ = 1.0;      // of the cone's angle
  double farthest_ = 0.0;                 // the greatest Atom::far
  std::vector<Atom> atoms_;               // ascending in y
  std::vector<std::vector<Stop>> stops_;  // at constant force: those of a line, by node
  int line_ = 0;
};

}  // namespace moltact
