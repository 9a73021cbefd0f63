// The god-object method on a height field: a point against a scanned surface. The surface consists of two triangles per
// cell of the raster, which meet along the diagonal from the cell's first node to the opposite one. It is continuous
// and passes through every node. The method is exact for it: the only error is rounding.
//
// In flight the SCP moves straight to the HIP, and the cells under its path give the first triangle that it meets. In
// contact the SCP descends |x - h|^2 from triangle to triangle (neighbour tracking, Ho, Basdogan & Srinivasan 1999). It
// moves along an edge or from a corner, always along the steepest path that stays on or above the surface. Neighbours
// follow from the numbers of the cells, so nothing is searched or prepared, and the cost of a tick depends on the
// crossed cells alone.
//
// Beyond its border the surface goes on for kBeyond_A at the heights of its outermost nodes; farther out nothing is felt.
// What lies under the surface is inside: there is no underside. The feature is always Sphere, with the atom that stopped
// the tip at the nearest corner, if any. Haptic thread; no allocation after construction. Units: angstrom; positions
// inside the tracker are in the scan's axes.
#pragma once

#include <array>
#include <memory>

#include "engine/haptics/height_field/height_field.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class HeightFieldTracker final : public Tracker {
 public:
  /// The surface lies `lift_A` above the heights of the field: the radius of the tip, if the hand is to be its centre;
  /// 0: its apex. Null: nothing is felt.
  explicit HeightFieldTracker(std::shared_ptr<const HeightField> field, double lift_A = 0.0);

  Contact step(PointA hip) noexcept override;
  void reset() noexcept override;
  /// A field is scanned for one tip.
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return 0.0; }
  MemoryUsage memoryUsage() const noexcept override;

  /// The owner of the field has changed its heights, or the lift: an SCP in contact is carried up with the surface.
  void surfaceChanged(double lift_A) noexcept;

  /// The height of the surface over a place in the scan's axes, the lift not included; only within kBeyond_A.
  double heightAt(double x_A, double y_A) const noexcept;
  /// Number of ticks in which the SCP did not come to rest; it then lags, outside.
  std::uint64_t cutShort() const noexcept { return cut_short_; }

  static constexpr double kBeyond_A = 1e4;
  static constexpr int kMaxPieces = 2048;  ///< triangles, edges and corners that one tick passes

 private:
  enum class On : std::uint8_t { Nothing, Triangle, Edge, Corner };
  enum class SlideResult : std::uint8_t { Arrived, Meets, Leaves, Rests, Short };
  struct Triangle {  // the cell's column and row from -1, and which half: 0 under the diagonal, 1 over it
    int column = 0, row = 0, half = 0;
    bool operator==(const Triangle&) const = default;
  };
  struct Plane {
    std::array<Vec3, 3> corners;
    Vec3 normal;                  // upward
    double height;                // dot(normal, x) on the plane
    std::array<Vec3, 3> out;      // unit vectors in the plane, out of edge k
    std::array<double, 3> reach;  // dot(out, x) on edge k
  };
  struct Wedge {  // a triangle around a corner, with its right edge as seen from above
    Triangle triangle;
    int edge;
    Vec3 normal, along, in_right, in_left;
  };
  struct Meeting {
    double t = 2.0;
    Triangle triangle;
  };

  double nodeX(int column) const noexcept;
  double nodeY(int row) const noexcept;
  double nodeHeight(int column, int row) const noexcept;
  Vec3 node(int column, int row) const noexcept { return {nodeX(column), nodeY(row), nodeHeight(column, row)}; }
  int columnOf(double x) const noexcept;
  int rowOf(double y) const noexcept;
  Triangle triangleAt(double x, double y) const noexcept;
  static Triangle across(const Triangle& t, int edge) noexcept;
  bool exists(const Triangle& t) const noexcept;
  std::array<int, 2> cornerOf(const Triangle& t, int corner) const noexcept;
  Plane planeOf(const Triangle& t) const noexcept;
  bool reaches(const Vec3& place) const noexcept;
  Meeting cast(const Vec3& from, const Vec3& path) const noexcept;

  SlideResult fly(const Vec3& hip) noexcept;
  SlideResult walk(const Vec3& hip) noexcept;
  SlideResult overTriangle(const Vec3& hip, int& stuck) noexcept;
  SlideResult alongEdge(const Vec3& hip, int& stuck) noexcept;
  SlideResult fromCorner(const Vec3& hip, int& stuck) noexcept;
  void goToTriangle(const Triangle& triangle) noexcept;
  bool goToEdge(const Triangle& triangle, int edge) noexcept;
  bool goToCorner(const Triangle& triangle, int corner) noexcept;
  Vec3 outward() const noexcept;
  std::int32_t nearestAtom() const noexcept;

  std::shared_ptr<const HeightField> field_;
  Vec3 lift_{0.0};  // in the scan's axes
  double top_ = 0.0;
  Vec3 scp_{0.0};
  bool has_been_outside_ = false;
  On on_ = On::Nothing;
  Triangle triangle_, other_;  // other_: on an edge, beyond it
  int edge_ = 0, other_edge_ = 0;
  Plane plane_{}, beyond_{};
  Vec3 edge_from_{0.0}, edge_along_{0.0};
  double edge_length_ = 0.0;
  std::array<Wedge, 8> round_{};
  std::size_t round_count_ = 0;
  Vec3 corner_normal_{0.0};
  std::uint64_t cut_short_ = 0;
};

}  // namespace moltact
