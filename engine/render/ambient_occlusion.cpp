#include "engine/render/ambient_occlusion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace moltact {
namespace {

constexpr int kMostVoxels = 192;

struct Field {
  Vec3 low{0.0};
  double voxel_A = 1.0;
  glm::ivec3 size{1};
  std::vector<float> value;

  std::size_t at(int x, int y, int z) const { return (std::size_t(z) * size.y + y) * size.x + x; }

  float sample(const Vec3& p) const {
    const Vec3 g = (p - low) / voxel_A - 0.5;
    const glm::ivec3 i = glm::clamp(glm::ivec3(glm::floor(g)), glm::ivec3(0), size - 2);
    const glm::vec3 f = glm::clamp(glm::vec3(g - Vec3(i)), 0.0f, 1.0f);
    const auto lerpX = [&](int y, int z) {
      const std::size_t k = at(i.x, y, z);
      return value[k] + (value[k + 1] - value[k]) * f.x;
    };
    const auto lerpY = [&](int z) { return glm::mix(lerpX(i.y, z), lerpX(i.y + 1, z), f.y); };
    return glm::mix(lerpY(i.z), lerpY(i.z + 1), f.z);
  }
};

// Three running means in a row along each axis come close to a Gaussian.
void blur(Field& field, double sigma_A) {
  const int half = std::max(1, int(std::lround(sigma_A / field.voxel_A)));
  std::vector<float> line;
  const auto along = [&](int n, std::size_t stride, std::size_t begin) {
    line.resize(std::size_t(n) + 1);
    for (int i = 0; i < n; ++i) line[i + 1] = line[i] + field.value[begin + i * stride];
    for (int i = 0; i < n; ++i)
      field.value[begin + i * stride] =
          (line[std::min(n, i + half + 1)] - line[std::max(0, i - half)]) / float(2 * half + 1);
  };
  for (int pass = 0; pass < 3; ++pass) {
    line.assign(1, 0.0f);
    for (int z = 0; z < field.size.z; ++z)
      for (int y = 0; y < field.size.y; ++y) along(field.size.x, 1, field.at(0, y, z));
    for (int z = 0; z < field.size.z; ++z)
      for (int x = 0; x < field.size.x; ++x) along(field.size.y, field.size.x, field.at(x, 0, z));
    for (int y = 0; y < field.size.y; ++y)
      for (int x = 0; x < field.size.x; ++x)
        along(field.size.z, std::size_t(field.size.x) * field.size.y, field.at(x, y, 0));
  }
}

}  // namespace

std::vector<AmbientOcclusion> ambientOcclusion(std::span<const Ball> balls) {
  std::vector<AmbientOcclusion> out(balls.size());
  if (balls.size() < 2) return out;
  Vec3 low = balls[0].centre_A, high = low;
  for (const Ball& b : balls) {
    low = glm::min(low, b.centre_A);
    high = glm::max(high, b.centre_A);
  }
  struct Width {
    double sigma_A, share;
  };
  for (const Width width : {Width{2.0, 0.50}, Width{6.0, 0.62}}) {
    Field field;
    const double margin = 2.0 * width.sigma_A + 2.0;
    field.low = low - Vec3(margin);
    const Vec3 extent = high - low + Vec3(2 * margin);
    const double longest = std::max({extent.x, extent.y, extent.z});
    field.voxel_A = std::max(0.5 * width.sigma_A, longest / kMostVoxels);
    if (field.voxel_A > 1.5 * width.sigma_A) continue;  // too wide a scene for this width: left unshaded
    field.size = glm::max(glm::ivec3(glm::ceil(extent / field.voxel_A)) + 1, glm::ivec3(2));
    field.value.assign(std::size_t(field.size.x) * field.size.y * field.size.z, 0.0f);

    const double cell = field.voxel_A * field.voxel_A * field.voxel_A;
    for (const Ball& b : balls) {
      const Vec3 g = (b.centre_A - field.low) / field.voxel_A - 0.5;
      const glm::ivec3 i = glm::clamp(glm::ivec3(glm::floor(g)), glm::ivec3(0), field.size - 2);
      const glm::vec3 f(g - Vec3(i));
      const float filled = float(4.18879 * b.radius_A * b.radius_A * b.radius_A / cell);
      for (int k = 0; k < 8; ++k)
        field.value[field.at(i.x + (k & 1), i.y + (k >> 1 & 1), i.z + (k >> 2))] +=
            filled * (k & 1 ? f.x : 1 - f.x) * (k & 2 ? f.y : 1 - f.y) * (k & 4 ? f.z : 1 - f.z);
    }
    blur(field, 0.6 * width.sigma_A);

    // Packed atoms fill space about once over (their spheres overlap); a flat surface then sees half of that.
    const float share = float(width.share);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const Ball& b = balls[i];
      const double reach = b.radius_A + 0.5 * width.sigma_A;
      const auto towards = [&](const Vec3& way) { return field.sample(b.centre_A + way * reach); };
      float mean = 0.0f;
      glm::vec3 slope;
      for (int axis = 0; axis < 3; ++axis) {
        Vec3 way(0.0);
        way[axis] = 1.0;
        const float ahead = towards(way), behind = towards(-way);
        slope[axis] = 0.5f * (ahead - behind);
        mean += (ahead + behind) / 6.0f;
      }
      out[i].level -= share * mean;
      out[i].slope -= share * slope;
    }
  }
  for (AmbientOcclusion& e : out) e.level = std::clamp(e.level + 0.12f, 0.0f, 1.0f);
  return out;
}

}  // namespace moltact
