#include "engine/haptics/interaction.h"

#include <array>
#include <cmath>

namespace moltact {
namespace {

constexpr double kIndependent = 1e-9;  // determinant of unit normals below which they count as dependent

using Shares = std::array<double, 3>;

// The least-squares shares of `pull` along the normals whose bits are set in `subset`. Returns false if they are
// dependent or one share would pull instead of push.
bool pushes(const Vec3& pull, const std::array<Vec3, 3>& normals, unsigned subset, Shares& shares) {
  std::array<int, 3> in{};
  int n = 0;
  for (int k = 0; k < 3; ++k)
    if (subset >> k & 1u) in[std::size_t(n++)] = k;
  const auto normal = [&](int k) { return normals[std::size_t(in[std::size_t(k)])]; };
  const Vec3 into(n > 0 ? glm::dot(pull, normal(0)) : 0.0, n > 1 ? glm::dot(pull, normal(1)) : 0.0,
                  n > 2 ? glm::dot(pull, normal(2)) : 0.0);
  glm::dmat3 gram(1.0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) gram[i][j] = glm::dot(normal(i), normal(j));
  if (!(std::abs(glm::determinant(gram)) > kIndependent)) return false;
  const Vec3 found = glm::inverse(gram) * into;
  shares = {};
  for (int k = 0; k < n; ++k) {
    if (!(found[k] >= 0.0)) return false;
    shares[std::size_t(in[std::size_t(k)])] = found[k];
  }
  return true;
}

}  // namespace

std::size_t contactReactions(const Contact& contact, double spring_N_per_A, std::span<AtomForce> out) noexcept {
  std::array<Vec3, 3> normals{};
  std::array<std::int32_t, 3> atoms{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (contact.atoms[k] < 0) continue;
    normals[count] = contact.normals[k];
    atoms[count++] = contact.atoms[k];
  }
  const Vec3& pull = contact.displacement_A;
  if (count == 0 || !finite(pull)) return 0;

  // Of the seven sets of pushes, the one with the smallest remainder.
  Shares best{};
  double smallest = glm::dot(pull, pull);
  const auto left = [&](const Shares& shares) {
    Vec3 rest = pull;
    for (std::size_t k = 0; k < count; ++k) rest -= normals[k] * shares[k];
    return rest;
  };
  for (unsigned subset = 1; subset < 1u << count; ++subset) {
    Shares shares{};
    if (!pushes(pull, normals, subset, shares)) continue;
    const Vec3 rest = left(shares);
    if (glm::dot(rest, rest) < smallest) smallest = glm::dot(rest, rest), best = shares;
  }
  const Vec3 rest = left(best);
  const double sum = best[0] + best[1] + best[2];
  for (std::size_t k = 0; k < count; ++k) {
    const double part = sum > 0.0 ? best[k] / sum : 1.0 / double(count);
    out[k] = {atoms[k], -spring_N_per_A * (normals[k] * best[k] + rest * part)};
  }
  return count;
}

std::size_t Interaction::reactions(const Response& last, double spring_N_per_A, double,
                                   std::span<AtomForce> out) const noexcept {
  return contactReactions(last.contact, spring_N_per_A, out);
}

}  // namespace moltact
