// Helpers of the picture tests: one off-screen context for the program, small molecules, comparison of pictures.
#pragma once

#include <doctest/doctest.h>

#include <memory>
#include <vector>

#include "engine/render/renderer.h"

namespace moltact::test {

/// The renderer of this program. Without EGL, the calling test fails with the reason.
Renderer& renderer();

std::shared_ptr<const Molecule> molecule(const std::vector<PlacedAtom>& atoms);
PlacedAtom atom(Vec3 place_A, double radius_A, int atomic_number);

/// A camera at (0, 0, distance) that looks at the origin.
Camera frontCamera(double distance_A);

/// Draws and reads back the picture; a problem fails the test.
Picture drawn(const ViewScene& scene, int width_px, int height_px, const RenderOptions& options = {});

/// The largest difference of any byte, and the number of pixels with a difference of more than `level`.
struct Difference {
  int largest = 0;
  std::size_t pixels = 0;
  double mean = 0;
};
Difference compare(const Picture& a, const Picture& b, int level);

/// A rod of three atoms in the hand, the hand below it and turned by 0.5 rad about the line of sight.
ViewScene rodInHand();

}  // namespace moltact::test
