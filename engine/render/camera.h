// An orbit camera: it looks at a target from a distance and orbits it. Plain data in double precision; usable on every
// thread. Units: angstrom, radian, pixel (origin at the picture's upper left corner, y down). The camera's own axes are
// x right, y up, z toward the viewer. Coordinates for the graphics card are relative to the target, so a molecule a
// million angstroms from the origin is drawn with full precision. Quat is constructed as (w, x, y, z).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <span>

#include "engine/core/units.h"

namespace moltact {

struct Molecule;

/// A ray in the molecule's space; `direction` is a unit vector.
struct Ray {
  PointA origin;
  Vec3 direction{0.0, 0.0, -1.0};
};

/// The range of drawn depths, measured from the eye along the line of sight (unit: angstrom).
struct DepthRange {
  double near_A = 0.1, far_A = 100.0;
};

struct Camera {
  PointA target;                          ///< centre of the view and of the orbit
  glm::dquat orientation{1, 0, 0, 0};     ///< rotates the molecule's axes into the camera's axes
  double distance_A = 40.0;               ///< from the eye to the target
  double fov_y_rad = 0.5235987755982988;  ///< full vertical field of view (default 30 degrees)

  Vec3 right() const { return orientation * Vec3(1, 0, 0); }
  Vec3 up() const { return orientation * Vec3(0, 1, 0); }
  Vec3 back() const { return orientation * Vec3(0, 0, 1); }
  PointA eye() const { return {target.A + back() * distance_A}; }

  /// Transforms a point to the camera's axes; the eye is the origin, -z is forward (unit: angstrom).
  Vec3 toView(PointA place) const;
  /// The inverse of toView.
  PointA fromView(const Vec3& view) const;

  /// Half the picture's height or width at depth 1.
  double tanHalfY() const;
  double tanHalfX(int width_px, int height_px) const { return tanHalfY() * width_px / height_px; }

  /// The ray from the eye through a point of the picture; (0, 0) is the upper left corner of the first pixel.
  Ray rayThrough(double x_px, double y_px, int width_px, int height_px) const;

  /// Projects a point into the picture (unit: pixel), with its depth in z (unit: angstrom; zero or negative: behind the
  /// eye).
  Vec3 project(PointA place, int width_px, int height_px) const;

  /// The size of one pixel at a depth (unit: angstrom).
  double pixel_A(double depth_A, int height_px) const { return 2.0 * tanHalfY() * depth_A / height_px; }

  /// Rotates about the target like a trackball: a drag to the right rotates the molecule to the right.
  void orbit(double right_rad, double down_rad);
  /// Rotates the camera about the line of sight; positive angles are counter-clockwise as seen.
  void roll(double angle_rad);
  /// Multiplies the magnification by `factor`; the distance stays within 0.5 A and 1e7 A. Factors that are not positive
  /// and finite are ignored.
  void zoom(double factor);
  /// Moves the target so that points at its depth follow a drag of the pointer.
  void pan(double dx_px, double dy_px, int height_px);
  /// Sets the viewing direction by azimuth (about +y, 0 = from +z, positive = from +x) and elevation (positive = from
  /// above).
  void lookFrom(double azimuth_rad, double elevation_rad);
  /// Shows a long molecule from the side. If its longest axis points at the eye, the smallest rotation that lays it
  /// across the picture is applied; else the orientation is kept.
  void lookSideOn(const Molecule& molecule);
  /// Rotates so that the point lies between the eye and the target. Points within 0.1 A of the target are ignored.
  void face(PointA place);
  /// Looks along the axis of smallest extent of these points, so that the picture shows the two larger extents. Of the
  /// axis's two directions, the eye is in the one whose largest component is positive. With fewer than three points the
  /// orientation is kept.
  void lookAlongThinnest(std::span<const Vec3> places_A);
  /// Moves the target to the middle of the atoms, and back until all of them fit completely into a picture with this
  /// aspect ratio. `margin` is the free fraction of the picture's half height. Each atom's radius is enlarged by
  /// `grown_A`. The orientation is kept. The atoms of `without` (ascending) are ignored, unless these are all.
  void fit(const Molecule& molecule, double aspect, double margin = 0.08, double grown_A = 0.0,
           std::span<const std::uint32_t> without = {});
  /// The same for one sphere.
  void fit(PointA centre, double radius_A, double aspect, double margin = 0.08);

  friend bool operator==(const Camera&, const Camera&) = default;
};

}  // namespace moltact
