#include "engine/render/ambient_occlusion.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

constexpr double kMaxVoxels = 160, kMaxVisits = 1e8;

// The number of voxels visited when filling the spheres.
double visits(std::span<const Sphere> spheres, double voxel_A) {
  double sum = 0;
  for (const Sphere& b : spheres) sum += std::pow(2.0 * b.radius_A / voxel_A + 2.0, 3.0);
  return sum;
}

struct Filling {
  glm::ivec3 size{1};
  std::vector<float> value;
  std::size_t at(int x, int y, int z) const { return (std::size_t(z) * size.y + y) * size.x + x; }
};

// Where spheres overlap the larger fraction counts; of a sphere smaller than a voxel the volume is added.
void fill(Filling& field, std::span<const Sphere> spheres, const Vec3& low, double voxel_A) {
  for (const Sphere& b : spheres) {
    const Vec3 c = (b.centre_A - low) / voxel_A - 0.5;
    const double r = b.radius_A / voxel_A;
    if (r < 0.6) {
      const glm::ivec3 i = glm::clamp(glm::ivec3(glm::round(c)), glm::ivec3(0), field.size - 1);
      float& v = field.value[field.at(i.x, i.y, i.z)];
      v = std::min(1.0f, v + float(4.18879 * r * r * r));
      continue;
    }
    const glm::ivec3 from = glm::max(glm::ivec3(glm::floor(c - r)), glm::ivec3(0));
    const glm::ivec3 to = glm::min(glm::ivec3(glm::ceil(c + r)), field.size - 1);
    const double out2 = (r + 0.5) * (r + 0.5);
    for (int z = from.z; z <= to.z; ++z)
      for (int y = from.y; y <= to.y; ++y) {
        const double aside2 = (z - c.z) * (z - c.z) + (y - c.y) * (y - c.y);
        if (aside2 >= out2) continue;
        float* row = field.value.data() + field.at(0, y, z);
        const double reach = std::sqrt(out2 - aside2);
        const int last = std::min(to.x, int(std::floor(c.x + reach)));
        for (int x = std::max(from.x, int(std::ceil(c.x - reach))); x <= last; ++x) {
          const double share = 0.5 + r - std::sqrt(aside2 + (x - c.x) * (x - c.x));
          if (share > double(row[x])) row[x] = float(std::min(share, 1.0));
        }
      }
  }
}

// Three consecutive box filters along each axis approximate a Gaussian.
void blur(Filling& field, double sigma) {
  const int half = std::max(1, int(std::lround(sigma)));
  const float share = 1.0f / float(2 * half + 1);
  std::vector<float> sums;
  // Filters n lines of `width` adjacent values each, with neighbours `stride` apart, so that adjacent values are added
  // together.
  const auto along = [&](int n, std::size_t stride, std::size_t begin, int width) {
    sums.resize((std::size_t(n) + 1) * width);
    std::fill_n(sums.begin(), width, 0.0f);
    for (int i = 0; i < n; ++i) {
      const float *before = &sums[std::size_t(i) * width], *value = &field.value[begin + i * stride];
      float* const sum = &sums[(std::size_t(i) + 1) * width];
      for (int k = 0; k < width; ++k) sum[k] = before[k] + value[k];
    }
    for (int i = 0; i < n; ++i) {
      const float *to = &sums[std::size_t(std::min(n, i + half + 1)) * width],
                  *from = &sums[std::size_t(std::max(0, i - half)) * width];
      float* const value = &field.value[begin + i * stride];
      for (int k = 0; k < width; ++k) value[k] = (to[k] - from[k]) * share;
    }
  };
  // All filters along one axis run while a plane is in the cache.
  constexpr int kMeans = 3;
  const glm::ivec3 n = field.size;
  for (int z = 0; z < n.z; ++z) {
    for (int y = 0; y < n.y; ++y)
      for (int k = 0; k < kMeans; ++k) along(n.x, 1, field.at(0, y, z), 1);
    for (int k = 0; k < kMeans; ++k) along(n.y, std::size_t(n.x), field.at(0, 0, z), n.x);
  }
  for (int y = 0; y < n.y; ++y)
    for (int k = 0; k < kMeans; ++k) along(n.z, std::size_t(n.x) * n.y, field.at(0, y, 0), n.x);
}

OcclusionLevel levelOf(std::span<const Sphere> spheres, const Vec3& low, const Vec3& extent, double sigma_A,
                       double voxel_A) {
  voxel_A = std::max(voxel_A, std::max({extent.x, extent.y, extent.z}) / kMaxVoxels);
  while (voxel_A < 2.0 * sigma_A && visits(spheres, voxel_A) > kMaxVisits) voxel_A *= 1.25;
  if (voxel_A > 1.3 * sigma_A && sigma_A < 2.0) return {};  // too coarse to resolve a crease
  Filling field;
  field.size = glm::max(glm::ivec3(glm::ceil(extent / voxel_A)), glm::ivec3(1));
  field.value.assign(std::size_t(field.size.x) * field.size.y * field.size.z, 0.0f);
  fill(field, spheres, low, voxel_A);
  blur(field, 0.6 * sigma_A / voxel_A);
  OcclusionLevel level{field.size, voxel_A, std::vector<std::uint8_t>(field.value.size())};
  std::transform(field.value.begin(), field.value.end(), level.filled.begin(),
                 [](float v) { return std::uint8_t(std::clamp(v, 0.0f, 1.0f) * 255.0f + 0.5f); });
  return level;
}

double shade(double filled, double none, double full) { return std::clamp((filled - none) / (full - none), 0.0, 1.0); }

}  // namespace

double OcclusionLevel::at(const Vec3& place) const {
  const Vec3 g = glm::clamp(place / voxel_A - 0.5, Vec3(0.0), Vec3(size - 1));
  const glm::ivec3 i = glm::min(glm::ivec3(glm::floor(g)), glm::max(size - 2, glm::ivec3(0)));
  const Vec3 f = g - Vec3(i);
  const glm::ivec3 next = glm::min(i + 1, size - 1);
  // Interpolates along x, then between the two rows, then between the two planes.
  const auto row = [&](int y, int z) {
    const std::uint8_t* const at = filled.data() + (std::size_t(z) * size.y + y) * size.x;
    return at[i.x] * (1.0 - f.x) + at[next.x] * f.x;
  };
  const auto plane = [&](int z) { return row(i.y, z) * (1.0 - f.y) + row(next.y, z) * f.y; };
  return (plane(i.z) * (1.0 - f.z) + plane(next.z) * f.z) / 255.0;
}

glm::vec4 OcclusionField::wideRound(const Vec3& centre_A, double radius_A) const {
  const double out = radius_A + kWideOut_A;
  glm::vec4 round(0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 offset(0.0);
    offset[axis] = out;
    const double plus = wide.at(centre_A - low_A + offset), minus = wide.at(centre_A - low_A - offset);
    round[axis] = float(0.5 * (plus - minus));
    round.w += float((plus + minus) / 6.0);
  }
  return round;
}

double OcclusionField::open(const Vec3& place_A, const Vec3& normal) const {
  const Vec3 at = place_A - low_A;
  return (1.0 - kFineShade * shade(fine.at(at + normal * kFineOut_A), kMinFineFill, kMaxFineFill)) *
         (1.0 - kWideShade * shade(wide.at(at + normal * kWideOut_A), kMinWideFill, kMaxWideFill));
}

OcclusionField occlusionField(std::span<const Sphere> spheres) {
  OcclusionField field;
  if (spheres.size() < 2) return field;
  constexpr double kMargin_A = 9.0;  // range of the smoothing
  Vec3 low = spheres[0].centre_A, high = low;
  for (const Sphere& b : spheres) {
    low = glm::min(low, b.centre_A - b.radius_A);
    high = glm::max(high, b.centre_A + b.radius_A);
  }
  field.low_A = low - kMargin_A;
  const Vec3 extent = high - low + 2.0 * kMargin_A;
  field.fine = levelOf(spheres, field.low_A, extent, 1.0, 0.6);
  field.wide = levelOf(spheres, field.low_A, extent, 4.0, 1.6);
  return field;
}

}  // namespace moltact
