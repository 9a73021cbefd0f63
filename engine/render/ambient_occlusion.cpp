#include "engine/render/ambient_occlusion.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

constexpr double kMostVoxels = 160, kMostVisits = 1e8;

// The voxels that filling the balls visits.
double visits(std::span<const Ball> balls, double voxel_A) {
  double sum = 0;
  for (const Ball& b : balls) sum += std::pow(2.0 * b.radius_A / voxel_A + 2.0, 3.0);
  return sum;
}

struct Filling {
  glm::ivec3 size{1};
  std::vector<float> value;
  std::size_t at(int x, int y, int z) const { return (std::size_t(z) * size.y + y) * size.x + x; }
};

// Where balls grow into each other the larger share counts; of one smaller than a voxel the volume is added.
void fill(Filling& field, std::span<const Ball> balls, const Vec3& low, double voxel_A) {
  for (const Ball& b : balls) {
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
    for (int z = from.z; z <= to.z; ++z)
      for (int y = from.y; y <= to.y; ++y) {
        const double aside2 = (z - c.z) * (z - c.z) + (y - c.y) * (y - c.y);
        if (aside2 > (r + 0.5) * (r + 0.5)) continue;
        float* row = field.value.data() + field.at(0, y, z);
        for (int x = from.x; x <= to.x; ++x) {
          const double share = 0.5 + r - std::sqrt(aside2 + (x - c.x) * (x - c.x));
          if (share > double(row[x])) row[x] = float(std::min(share, 1.0));
        }
      }
  }
}

// Three running means in a row along each axis come close to a Gaussian.
void blur(Filling& field, double sigma) {
  const int half = std::max(1, int(std::lround(sigma)));
  std::vector<float> line;
  const auto along = [&](int n, std::size_t stride, std::size_t begin) {
    line.resize(std::size_t(n) + 1);
    line[0] = 0.0f;
    for (int i = 0; i < n; ++i) line[i + 1] = line[i] + field.value[begin + i * stride];
    for (int i = 0; i < n; ++i)
      field.value[begin + i * stride] =
          (line[std::min(n, i + half + 1)] - line[std::max(0, i - half)]) / float(2 * half + 1);
  };
  for (int pass = 0; pass < 3; ++pass) {
    for (int z = 0; z < field.size.z; ++z)
      for (int y = 0; y < field.size.y; ++y) along(field.size.x, 1, field.at(0, y, z));
    for (int z = 0; z < field.size.z; ++z)
      for (int x = 0; x < field.size.x; ++x) along(field.size.y, field.size.x, field.at(x, 0, z));
    for (int y = 0; y < field.size.y; ++y)
      for (int x = 0; x < field.size.x; ++x)
        along(field.size.z, std::size_t(field.size.x) * field.size.y, field.at(x, y, 0));
  }
}

OcclusionLevel levelOf(std::span<const Ball> balls, const Vec3& low, const Vec3& extent, double sigma_A,
                       double voxel_A) {
  voxel_A = std::max(voxel_A, std::max({extent.x, extent.y, extent.z}) / kMostVoxels);
  while (voxel_A < 2.0 * sigma_A && visits(balls, voxel_A) > kMostVisits) voxel_A *= 1.25;
  if (voxel_A > 1.3 * sigma_A && sigma_A < 2.0) return {};  // too coarse to tell a crease
  Filling field;
  field.size = glm::max(glm::ivec3(glm::ceil(extent / voxel_A)), glm::ivec3(1));
  field.value.assign(std::size_t(field.size.x) * field.size.y * field.size.z, 0.0f);
  fill(field, balls, low, voxel_A);
  blur(field, 0.6 * sigma_A / voxel_A);
  OcclusionLevel level{field.size, voxel_A, std::vector<std::uint8_t>(field.value.size())};
  std::transform(field.value.begin(), field.value.end(), level.filled.begin(),
                 [](float v) { return std::uint8_t(std::lround(std::clamp(v, 0.0f, 1.0f) * 255.0f)); });
  return level;
}

double shade(double filled, double least, double most) {
  return std::clamp((filled - least) / (most - least), 0.0, 1.0);
}

}  // namespace

double OcclusionLevel::at(const Vec3& place) const {
  const Vec3 g = glm::clamp(place / voxel_A - 0.5, Vec3(0.0), Vec3(size - 1));
  const glm::ivec3 i = glm::min(glm::ivec3(glm::floor(g)), glm::max(size - 2, glm::ivec3(0)));
  const Vec3 f = g - Vec3(i);
  double sum = 0;
  for (int k = 0; k < 8; ++k) {
    const glm::ivec3 step(k & 1, k >> 1 & 1, k >> 2), p = glm::min(i + step, size - 1);
    sum += filled[(std::size_t(p.z) * size.y + p.y) * size.x + p.x] / 255.0 * (step.x ? f.x : 1 - f.x) *
           (step.y ? f.y : 1 - f.y) * (step.z ? f.z : 1 - f.z);
  }
  return sum;
}

glm::vec4 OcclusionField::wideRound(const Vec3& centre_A, double radius_A) const {
  const double out = radius_A + kWideOut_A;
  glm::vec4 round(0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 way(0.0);
    way[axis] = out;
    const double plus = wide.at(centre_A - low_A + way), minus = wide.at(centre_A - low_A - way);
    round[axis] = float(0.5 * (plus - minus));
    round.w += float((plus + minus) / 6.0);
  }
  return round;
}

double OcclusionField::open(const Vec3& place_A, const Vec3& normal) const {
  const Vec3 at = place_A - low_A;
  return (1.0 - kFineShade * shade(fine.at(at + normal * kFineOut_A), kFineLeast, kFineMost)) *
         (1.0 - kWideShade * shade(wide.at(at + normal * kWideOut_A), kWideLeast, kWideMost));
}

OcclusionField occlusionField(std::span<const Ball> balls) {
  OcclusionField field;
  if (balls.size() < 2) return field;
  constexpr double kMargin_A = 9.0;  // beyond it nothing is smoothed
  Vec3 low = balls[0].centre_A, high = low;
  for (const Ball& b : balls) {
    low = glm::min(low, b.centre_A - b.radius_A);
    high = glm::max(high, b.centre_A + b.radius_A);
  }
  field.low_A = low - kMargin_A;
  const Vec3 extent = high - low + 2.0 * kMargin_A;
  field.fine = levelOf(balls, field.low_A, extent, 1.0, 0.6);
  field.wide = levelOf(balls, field.low_A, extent, 4.0, 1.6);
  return field;
}

}  // namespace moltact
