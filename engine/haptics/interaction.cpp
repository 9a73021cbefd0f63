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

Pushes pushesAlong(const Contact& contact, const Vec3& force) noexcept {
  std::array<Vec3, 3> normals{};
  std::array<std::size_t, 3> of{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (contact.atoms[k] < 0) continue;
    normals[count] = contact.normals[k];
    of[count++] = k;
  }
  // Of the seven sets of pushes, the one with the smallest remainder.
  Shares best{};
  double smallest = glm::dot(force, force);
  const auto left = [&](const Shares& shares) {
    Vec3 rest = force;
    for (std::size_t k = 0; k < count; ++k) rest -= normals[k] * shares[k];
    return rest;
  };
  for (unsigned subset = 1; subset < 1u << count; ++subset) {
    Shares shares{};
    if (!pushes(force, normals, subset, shares)) continue;
    const Vec3 rest = left(shares);
    if (glm::dot(rest, rest) < smallest) smallest = glm::dot(rest, rest), best = shares;
  }
  Pushes out{.rest = left(best)};
  for (std::size_t k = 0; k < count; ++k) out.along[of[k]] = best[k];
  return out;
}

std::size_t contactReactions(const Contact& contact, double spring_N_per_A, std::span<AtomForce> out) noexcept {
  std::array<std::size_t, 3> blocking{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (contact.atoms[k] >= 0) blocking[count++] = k;
  if (count == 0 || !finite(contact.displacement_A)) return 0;
  const Pushes found = pushesAlong(contact, contact.displacement_A);
  const double sum = found.sum();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t n = blocking[k];
    const double part = sum > 0.0 ? found.along[n] / sum : 1.0 / double(count);
    out[k] = {contact.atoms[n], -spring_N_per_A * (contact.normals[n] * found.along[n] + found.rest * part)};
  }
  return count;
}

std::size_t Interaction::reactions(const Response& last, double spring_N_per_A, double,
                                   std::span<AtomForce> out) const noexcept {
  return contactReactions(last.contact, spring_N_per_A, out);
}

}  // namespace moltact
