#include "engine/haptics/exact/blocked_motion.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

constexpr double kRounding = 1e-12;  // of the pull's length: a way along a sphere counts as not leading into it
constexpr double kParallel = 1e-18;  // squared sine under which two normals block the same way

bool allowed(const Vec3& v, double rounding, std::span<const Vec3> normals) {
  for (const Vec3& n : normals)
    if (glm::dot(v, n) < -rounding) return false;
  return true;
}

}  // namespace

Blocked blockedMotion(const Vec3& pull, std::span<const Vec3> normals) noexcept {
  const int count = static_cast<int>(normals.size());
  const double rounding = kRounding * glm::length(pull);
  if (allowed(pull, rounding, normals)) return {};

  for (int i = 0; i < count; ++i) {
    const double push = glm::dot(pull, normals[i]);
    if (push < 0.0 && allowed(pull - push * normals[i], rounding, normals)) return {1, {i, -1, -1}};
  }
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j) {
      const Vec3 line = glm::cross(normals[i], normals[j]);
      const double sine2 = glm::dot(line, line);
      if (sine2 < kParallel) continue;
      // The pull's shares in n_i and n_j must both be pushes: mu_i, mu_j >= 0.
      const double c = glm::dot(normals[i], normals[j]);
      const double a = -glm::dot(pull, normals[i]), b = -glm::dot(pull, normals[j]);
      if (a - b * c < -rounding || b - a * c < -rounding) continue;
      if (allowed(line * (glm::dot(pull, line) / sine2), rounding, normals)) return {2, {i, j, -1}};
    }
  // Three hold the point wherever the pull lies in the cone of their inward normals.
  Blocked best;
  double best_share = -INFINITY;
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      for (int k = j + 1; k < count; ++k) {
        const Vec3 ij = glm::cross(normals[i], normals[j]), jk = glm::cross(normals[j], normals[k]);
        const Vec3 ki = glm::cross(normals[k], normals[i]);
        const double volume = glm::dot(ij, normals[k]);
        if (volume * volume < kParallel) continue;
        const double least = std::min({-glm::dot(pull, jk) / volume, -glm::dot(pull, ki) / volume, -glm::dot(pull, ij) / volume});
        if (least > best_share) {
          best_share = least;
          best = {3, {i, j, k}};
        }
      }
  if (best.count == 3) return best;
  // Normals in one plane and rounding on every side: the one that faces the pull most holds it.
  int i = 0;
  for (int k = 1; k < count; ++k)
    if (glm::dot(pull, normals[k]) < glm::dot(pull, normals[i])) i = k;
  return {1, {i, -1, -1}};
}

}  // namespace moltact
