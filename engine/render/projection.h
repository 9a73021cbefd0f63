// The projection of a camera for a picture of one size: in single precision relative to the target, with the range of
// the depth buffer. Plain data. Units: angstrom; NDC from -1 to 1, y up.
#pragma once

#include "engine/render/camera.h"

namespace moltact {

struct Projection {
  int width_px = 1, height_px = 1;
  float tan_x = 1, tan_y = 1;  ///< half the picture's width and height at depth 1
  DepthRange depth;

  Projection(const Camera& camera, int width, int height, DepthRange range)
      : width_px(width),
        height_px(height),
        tan_x(float(camera.tanHalfX(width, height))),
        tan_y(float(camera.tanHalfY())),
        depth(range) {}

  /// Window depth (0 near, 1 far) of a depth d is scale - offset / d.
  float depthScale() const { return float(depth.far_A / (depth.far_A - depth.near_A)); }
  float depthOffset() const { return float(depth.far_A * depth.near_A / (depth.far_A - depth.near_A)); }

  /// NDC x and y, and the window depth, of a point in front of the eye (camera's axes).
  glm::vec3 toNdc(const glm::vec3& view) const {
    const float d = -view.z;
    return {view.x / (d * tan_x), view.y / (d * tan_y), depthScale() - depthOffset() / d};
  }
};

}  // namespace moltact
