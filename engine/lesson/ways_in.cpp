#include "engine/lesson/ways_in.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/even_directions.h"

namespace moltact {
namespace {

constexpr double kRounding_A = 1e-9;

const std::vector<Vec3>& restDirections() {
  static const std::vector<Vec3> kDirections = evenDirections(WaysIn::kRests);
  return kDirections;
}

// Whether the way of this length, or without end, from a place outside of the sphere comes into it.
bool meets(const Sphere& sphere, const Vec3& from, const Vec3& way, double length_A) {
  const Vec3 to = sphere.centre_A - from;
  const double along = glm::dot(to, way);
  if (along <= 0.0) return false;
  const double nearest = std::min(along, length_A);
  const Vec3 off = to - way * nearest;
  return glm::dot(off, off) < (sphere.radius_A - kRounding_A) * (sphere.radius_A - kRounding_A);
}

// The directions from a place in which lines meet a sphere.
struct Cone {
  Vec3 axis;
  double cosine;  // slightly too narrow, so that it holds no direction that is free
};
constexpr std::size_t kCones = 60;

Cone shadow(const Sphere& sphere, const Vec3& from) {
  const Vec3 to = sphere.centre_A - from;
  const double away_A = glm::length(to), part = std::min(1.0, sphere.radius_A / away_A);
  return {to / away_A, std::sqrt(1.0 - part * part) + 1e-9};
}

}  // namespace

WaysIn::WaysIn(std::span<const Sphere> spheres, double sphere_A) : grown_(spheres.begin(), spheres.end()) {
  Vec3 high(-1e9);
  low_A_ = Vec3(1e9);
  for (Sphere& b : grown_) {
    b.radius_A += sphere_A;
    low_A_ = glm::min(low_A_, b.centre_A - Vec3(b.radius_A + 2 * kCell_A));
    high = glm::max(high, b.centre_A + Vec3(b.radius_A + 2 * kCell_A));
  }
  for (int k = 0; k < 3; ++k)
    count_[k] = 2 + static_cast<int>(std::clamp((high[k] - low_A_[k]) / kCell_A, 0.0, double(kMaxCells)));
}

bool WaysIn::searchable() const {
  return double(count_[0]) * double(count_[1]) * double(count_[2]) <= double(kMaxCells);
}

std::vector<std::uint32_t> WaysIn::nearestTo(std::uint32_t atom) const {
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t i = 0; i < grown_.size(); ++i)
    if (i != atom) order.emplace_back(glm::distance(grown_[i].centre_A, grown_[atom].centre_A), i);
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> out;
  for (const auto& [away, i] : order) out.push_back(i);
  return out;
}

std::vector<Vec3> WaysIn::freeRests(std::uint32_t atom, const std::vector<std::uint32_t>& nearest) const {
  const Sphere& own = grown_[atom];
  std::vector<const Sphere*> near;
  for (const std::uint32_t i : nearest)
    if (glm::distance(grown_[i].centre_A, own.centre_A) < grown_[i].radius_A + own.radius_A) near.push_back(&grown_[i]);
  std::vector<Vec3> out;
  for (const Vec3& d : restDirections()) {
    const Vec3 place = own.centre_A + d * own.radius_A;
    if (std::none_of(near.begin(), near.end(),
                     [&](const Sphere* b) { return glm::distance(place, b->centre_A) < b->radius_A - kRounding_A; }))
      out.push_back(place);
  }
  return out;
}

bool WaysIn::straight(std::uint32_t atom) const {
  const std::vector<std::uint32_t> nearest = nearestTo(atom);
  const std::vector<Vec3> rests = freeRests(atom, nearest);
  const auto open = [&](const Vec3& rest, const Vec3& way) {
    return std::none_of(nearest.begin(), nearest.end(),
                        [&](std::uint32_t i) { return meets(grown_[i], rest, way, 1e9); });
  };
  const Vec3& centre = grown_[atom].centre_A;
  for (const Vec3& rest : rests)
    if (open(rest, glm::normalize(rest - centre))) return true;
  static const std::vector<Vec3> kWays = evenDirections(2 * kLines);
  std::vector<Cone> cones;
  for (std::size_t k = 0; k < rests.size(); k += rests.size() < 1000 ? 1 : 10) {
    // Most lines meet a near sphere, which a cone finds in one product.
    cones.clear();
    for (std::size_t n = 0; n < std::min(nearest.size(), kCones); ++n)
      cones.push_back(shadow(grown_[nearest[n]], rests[k]));
    std::sort(cones.begin(), cones.end(), [](const Cone& a, const Cone& b) { return a.cosine < b.cosine; });
    for (const Vec3& way : kWays)
      if (glm::dot(way, rests[k] - centre) > 0.0 &&
          std::none_of(cones.begin(), cones.end(), [&](const Cone& c) { return glm::dot(way, c.axis) > c.cosine; }) &&
          open(rests[k], way))
        return true;
  }
  return false;
}

void WaysIn::fill() const {
  if (!cells_.empty() || !searchable()) return;
  cells_.assign(std::size_t(count_[0]) * std::size_t(count_[1]) * std::size_t(count_[2]), Free);
  for (const Sphere& b : grown_) {
    const auto low = [&](double from, int k) { return static_cast<int>(std::ceil((from - low_A_[k]) / kCell_A)); };
    const auto high = [&](double to, int k) { return static_cast<int>(std::floor((to - low_A_[k]) / kCell_A)); };
    const Vec3& c = b.centre_A;
    for (int x = low(c.x - b.radius_A, 0); x <= high(c.x + b.radius_A, 0); ++x) {
      const double dx = low_A_.x + x * kCell_A - c.x, disc = b.radius_A * b.radius_A - dx * dx;
      if (disc <= 0.0) continue;
      const double ry = std::sqrt(disc);
      for (int y = low(c.y - ry, 1); y <= high(c.y + ry, 1); ++y) {
        const double dy = low_A_.y + y * kCell_A - c.y, row = disc - dy * dy;
        if (row <= 0.0) continue;
        const double rz = std::sqrt(row) - kRounding_A;
        for (int z = low(c.z - rz, 2); z <= high(c.z + rz, 2); ++z) cells_[index(x, y, z)] = Shut;
      }
    }
  }
  // Every face of the box lies outside of all atoms, so one corner of it leads to all that is outside.
  std::vector<std::array<int, 3>> open;
  const auto take = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= count_[0] || y >= count_[1] || z >= count_[2]) return;
    char& cell = cells_[index(x, y, z)];
    if (cell != Free) return;
    cell = Filled;
    open.push_back({x, y, z});
  };
  take(0, 0, 0);
  while (!open.empty()) {
    const auto [x, y, z] = open.back();
    open.pop_back();
    for (const int step : {-1, 1}) {
      take(x + step, y, z);
      take(x, y + step, z);
      take(x, y, z + step);
    }
  }
}

bool WaysIn::reached(const Vec3& rest, std::uint32_t atom, const std::vector<std::uint32_t>& nearest) const {
  int cell[3];
  for (int k = 0; k < 3; ++k) cell[k] = static_cast<int>(std::lround((rest[k] - low_A_[k]) / kCell_A));
  for (int x = cell[0] - 1; x <= cell[0] + 1; ++x)
    for (int y = cell[1] - 1; y <= cell[1] + 1; ++y)
      for (int z = cell[2] - 1; z <= cell[2] + 1; ++z) {
        if (cells_[index(x, y, z)] != Filled) continue;
        const Vec3 way = at(x, y, z) - rest;
        const double length_A = glm::length(way);
        if (length_A < kRounding_A) return true;
        const auto shut = [&](std::uint32_t i) { return meets(grown_[i], rest, way / length_A, length_A); };
        // Only those whose spheres meet that of this atom can stand between places this near to it, but for a cell's diagonal.
        bool free = !shut(atom);
        for (std::size_t k = 0; free && k < nearest.size(); ++k) {
          const Sphere& b = grown_[nearest[k]];
          if (glm::distance(b.centre_A, grown_[atom].centre_A) > 2.0 * grown_[atom].radius_A + b.radius_A) break;
          free = !shut(nearest[k]);
        }
        if (free) return true;
      }
  return false;
}

bool WaysIn::crooked(std::uint32_t atom) const {
  fill();
  if (cells_.empty()) return false;
  const std::vector<std::uint32_t> nearest = nearestTo(atom);
  const std::vector<Vec3> rests = freeRests(atom, nearest);
  return std::any_of(rests.begin(), rests.end(), [&](const Vec3& r) { return reached(r, atom, nearest); });
}

double WaysIn::share(std::uint32_t atom) const {
  fill();
  if (cells_.empty()) return 0.0;
  const std::vector<std::uint32_t> nearest = nearestTo(atom);
  const std::vector<Vec3> rests = freeRests(atom, nearest);
  const auto n = std::count_if(rests.begin(), rests.end(), [&](const Vec3& r) { return reached(r, atom, nearest); });
  return double(n) / kRests;
}

std::vector<std::uint32_t> WaysIn::straight(std::span<const std::uint32_t> atoms) const {
  std::vector<std::uint32_t> out;
  std::copy_if(atoms.begin(), atoms.end(), std::back_inserter(out), [&](std::uint32_t a) { return straight(a); });
  return out;
}

std::vector<std::uint32_t> WaysIn::crooked(std::span<const std::uint32_t> atoms) const {
  std::vector<std::uint32_t> out;
  std::copy_if(atoms.begin(), atoms.end(), std::back_inserter(out), [&](std::uint32_t a) { return crooked(a); });
  return out;
}

}  // namespace moltact
