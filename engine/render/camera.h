// An orbit camera: it looks at a target from a distance and turns about it. Plain data and arithmetic in double
// precision; usable on every thread. Units: angstrom, radian, pixel (origin at the picture's upper left corner, y
// down). The camera's own axes are x right, y up, z toward the viewer. Coordinates for the graphics card are relative
// to the target, so a molecule a million angstroms from the origin looks as it does at the origin.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <span>

#include "engine/core/units.h"

namespace moltact {

struct Molecule;

/// A half line in the molecule's space; `direction` has length 1.
struct Ray {
  PointA origin;
  Vec3 direction{0.0, 0.0, -1.0};
};

/// The depths between which things are drawn, measured from the eye along the line of sight (unit: angstrom).
struct DepthRange {
  double near_A = 0.1, far_A = 100.0;
};

struct Camera {
  PointA target;                          ///< what it looks at and turns about (default: the origin)
  glm::dquat orientation{1, 0, 0, 0};     ///< the camera's axes in the molecule's space (default: the same axes)
  double distance_A = 40.0;               ///< from the eye to the target (default 40)
  double fov_y_rad = 0.5235987755982988;  ///< the whole vertical angle of view (default 30 degrees)

  Vec3 right() const { return orientation * Vec3(1, 0, 0); }
  Vec3 up() const { return orientation * Vec3(0, 1, 0); }
  Vec3 back() const { return orientation * Vec3(0, 0, 1); }
  PointA eye() const { return {target.A + back() * distance_A}; }

  /// A place in the camera's axes, the eye at the origin, -z ahead (unit: angstrom).
  Vec3 toView(PointA place) const;
  /// The inverse of toView.
  PointA fromView(const Vec3& view) const;

  /// Half the picture's height and width at depth 1.
  double tanHalfY() const;
  double tanHalfX(int width_px, int height_px) const { return tanHalfY() * width_px / height_px; }

  /// The half line from the eye through a place in the picture; (0, 0) is the upper left corner of the first pixel.
  Ray rayThrough(double x_px, double y_px, int width_px, int height_px) const;

  /// Where a place appears in the picture (unit: pixel), and its depth in z (unit: angstrom; not positive: behind the
  /// eye).
  Vec3 project(PointA place, int width_px, int height_px) const;

  /// How large one pixel is at a depth (unit: angstrom).
  double pixel_A(double depth_A, int height_px) const { return 2.0 * tanHalfY() * depth_A / height_px; }

  /// Turns about the target as if the picture were a glass sphere: a drag to the right turns what is seen to the right.
  void orbit(double right_rad, double down_rad);
  /// Turns about the line of sight, counter-clockwise as seen for positive angles.
  void roll(double angle_rad);
  /// Comes closer for factors above 1; the distance stays within 0.5 A and 1e7 A. Other than positive finite factors
  /// are ignored.
  void zoom(double factor);
  /// Moves with the hand: what lies at the target's depth follows a drag of so many pixels.
  void pan(double dx_px, double dy_px, int height_px);
  /// Looks from an azimuth (about +y, 0 = from +z, positive = from +x) and an elevation (positive = from above).
  void lookFrom(double azimuth_rad, double elevation_rad);
  /// Looks at a long molecule from the side: where its longest axis would look at the eye it is turned to lie across
  /// the picture, by the shortest way; else the orientation stays.
  void lookSideOn(const Molecule& molecule);
  /// Turns so that the place lies between the eye and the target; places within 0.1 A of the target can be turned
  /// nowhere.
  void face(PointA place);
  /// Looks along the axis along which these places are least spread, so that the picture shows their longest and their
  /// second longest extent. Of the two ends of that axis the eye is at the one toward which its largest component points
  /// in the positive direction. Fewer than three places leave the orientation as it is.
  void lookAlongThinnest(std::span<const Vec3> places_A);
  /// Moves the target to the middle of the atoms and back until all of them, whole, fit into a picture of this shape;
  /// `margin` is the free share of the picture's half height (default 0.08), and every atom counts as `grown_A` larger
  /// than it is (default 0). The orientation stays.
  /// The atoms of `without` (ascending) do not count, unless these are all.
  void fit(const Molecule& molecule, double aspect, double margin = 0.08, double grown_A = 0.0,
           std::span<const std::uint32_t> without = {});
  /// The same for one sphere.
  void fit(PointA centre, double radius_A, double aspect, double margin = 0.08);

  friend bool operator==(const Camera&, const Camera&) = default;
};

}  // namespace moltact
