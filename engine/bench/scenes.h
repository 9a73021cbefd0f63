// Scenes in which haptic methods are known to fail, and HIP paths over them, for tests and benchmarks. All are
// deterministic functions of arguments and seed, equal on every machine. Units: angstrom.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/sphere.h"

namespace moltact::scenes {

struct Scene {
  std::string name;
  std::vector<Sphere> spheres;
  double probe_A = 1.4;
};

/// Random numbers that are equal with every standard library (SplitMix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double uniform(double low, double high);
  Vec3 direction();

 private:
  std::uint64_t state_;
};

Scene oneSphere();    ///< carbon, at the origin
Scene bond();         ///< C and O 1.23 apart: a crease
Scene pit();          ///< three carbons 2.5 apart: with the probe a pit on either side
Scene tetrahedron();  ///< methane-like: C and four H at 1.09
Scene cube();         ///< cubane-like: eight C at the corners of a cube of edge 1.57
Scene shell();        ///< fullerene-like: 60 C on a truncated icosahedron of edge 1.43
Scene cluster(int n,
              std::uint64_t seed);  ///< n random atoms of radii 1.1 to 2 in a cube, as dense as an organic crystal

/// n x n x n spheres of one size. In the simple cubic lattice eight inflated surfaces meet in the middle of each cell,
/// in the face-centred lattice six (octahedral hole) and four (tetrahedral hole).
Scene simpleCubic(int n);
Scene faceCentred(int n);

/// n spheres of radius 1.7 on a circle in the plane z = 0; the largest sphere that fits through the hole has radius
/// probe + slack_A.
Scene ring(int n, double slack_A);

/// Two inflated spheres whose surfaces touch in the point (R, 0, 0); that overlap by `overlap_A`; that touch, with a
/// third sphere across the seam.
Scene touching();
Scene barelyOverlapping(double overlap_A = 1e-9);
Scene touchingAcross();

Scene nested();      ///< a sphere inside another, one touching it from inside, and a neighbour
Scene duplicates();  ///< the pit with two copies of each atom and three of one (alternate locations)

Scene shifted(Scene scene, Vec3 by, const std::string& how);

/// All scenes above, random clusters of 5, 20 and 50, and some scenes a million angstroms from the origin.
std::vector<Scene> all(std::uint64_t seed = 1);

using Path = std::vector<Vec3>;

/// A walk of fixed step along the surface. Its depth varies between 0 and depth_A, and occasionally the HIP leaves the
/// surface. Starts outside.
Path walk(const Scene& scene, int ticks, std::uint64_t seed, double step_A = 0.02, double depth_A = 0.8);

/// The same walk, with a jump to a random position (inside or outside) every 37th tick.
Path jumps(const Scene& scene, int ticks, std::uint64_t seed, double step_A = 0.02);

/// Straight passes through the scene, each with a random step of 0.05 to 12 A per tick.
Path passes(const Scene& scene, int ticks, std::uint64_t seed);

}  // namespace moltact::scenes
