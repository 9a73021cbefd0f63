#include "engine/haptics/grid/distance_bricks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <vector>

namespace moltact {
namespace {

// Weights of the three nearest nodes at u in [-1/2, 1/2] from the middle one, and their derivatives.
struct Weights {
  double w[3], d[3];
  explicit Weights(double u)
      : w{0.5 * (0.5 - u) * (0.5 - u), 0.75 - u * u, 0.5 * (0.5 + u) * (0.5 + u)}, d{u - 0.5, -2.0 * u, u + 0.5} {}
};

}  // namespace

DistanceBricks::DistanceBricks(std::shared_ptr<const SphereGrid> scene, const Vec3& origin, double spacing_A,
                               double cap_A)
    : scene_(std::move(scene)),
      origin_(origin),
      spacing_(spacing_A),
      cap_(cap_A),
      bricks_(std::make_unique<Brick[]>(kBricks)),
      last_(&bricks_[0]),
      in_bricks_(std::make_unique<std::uint16_t[]>(scene_->size())),
      gathered_(std::make_unique<Near[]>(kMaxGathered)),
      close_(std::make_unique<Near[]>(kMaxGathered)),
      distance_(std::make_unique<double[]>(kSamples * kSamples * kSamples)) {}

void DistanceBricks::setCap(double cap_A) noexcept {
  const bool grows = cap_A > cap_;
  cap_ = cap_A;
  if (!grows) return;
  for (std::uint32_t k = 0; k < count_; ++k) forget(bricks_[k]);
}

void DistanceBricks::prepare(double level_A) {
  const double size = kCells * spacing_, half = 0.5 * size * std::sqrt(3.0), near = half + spacing_;
  std::vector<Key> keys;
  for (std::size_t i = 0; i < scene_->size(); ++i) {
    if (!scene_->touchable(i)) continue;
    const Sphere& sphere = (*scene_)[i];
    const Vec3 c = sphere.centre_A - origin_;
    const double r = sphere.radius_A + level_A;
    const Vec3 low = glm::floor((c - Vec3(r)) / size - 0.5), high = glm::floor((c + Vec3(r)) / size + 0.5);
    for (double x = low.x; x <= high.x; ++x)
      for (double y = low.y; y <= high.y; ++y)
        for (double z = low.z; z <= high.z; ++z) {
          const Vec3 middle = (Vec3(x, y, z) + 0.5 - Vec3(0.5 / kCells)) * size;
          if (std::abs(glm::distance(middle, c) - r) <= near)
            keys.push_back({std::int32_t(x), std::int32_t(y), std::int32_t(z)});
        }
  }
  const auto order = [](const Key& k) { return std::tuple(k.z, k.y, k.x); };
  std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) { return order(a) < order(b); });
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  std::erase_if(keys, [&](const Key& k) {  // bricks deep inside spheres
    const Vec3 middle = (Vec3(k.x, k.y, k.z) + 0.5 - Vec3(0.5 / kCells)) * size;
    bool deep = false;
    scene_->visitNear(origin_ + middle, level_A, [&](std::uint32_t, const Sphere& b) {
      deep = deep || glm::distance(middle, b.centre_A - origin_) < b.radius_A + level_A - near;
    });
    return deep;
  });
  count_ = std::max(kBricks, std::uint32_t(std::bit_ceil(2 * keys.size())));
  bricks_ = std::make_unique<Brick[]>(count_);
  last_ = &bricks_[0];
  std::fill_n(in_bricks_.get(), scene_->size(), std::uint16_t(0));
  remembered_ = 0;
  for (const Key& key : keys) make(key);
}

void DistanceBricks::forget(Brick& brick) noexcept {
  for (int k = 0; k < brick.labels; ++k)
    if (--in_bricks_[std::size_t(brick.label[std::size_t(k)])] == 0) --remembered_;
  brick.key = kNowhere;
  brick.age = 0;
  brick.labels = 0;
}

std::uint32_t DistanceBricks::set(const Key& key) const {
  std::uint64_t h = std::uint64_t(std::uint32_t(key.x)) * 0x9E3779B97F4A7C15ull;
  h = (h ^ std::uint64_t(std::uint32_t(key.y))) * 0xC2B2AE3D27D4EB4Full;
  h = (h ^ (h >> 29) ^ std::uint64_t(std::uint32_t(key.z))) * 0x165667B19E3779F9ull;
  return std::uint32_t(h >> 40) % (count_ / kWays) * kWays;
}

DistanceBricks::Brick* DistanceBricks::find(const Key& key) const noexcept {
  if (last_->key == key) return last_;
  const std::uint32_t first = set(key);
  for (std::uint32_t k = first; k < first + kWays; ++k)
    if (bricks_[k].key == key) return last_ = &bricks_[k];
  return nullptr;
}

DistanceBricks::Brick* DistanceBricks::make(const Key& key) noexcept {
  const std::uint32_t first = set(key);
  Brick* brick = &bricks_[first];
  for (std::uint32_t k = first; k < first + kWays; ++k)
    if (bricks_[k].age < brick->age) brick = &bricks_[k];
  forget(*brick);
  brick->key = key;
  brick->age = ++made_;

  const Vec3 corner = Vec3(key.x, key.y, key.z) * double(kCells) - Vec3(2.0);  // first sample, in nodes
  const double half = 0.5 * (kSamples - 1) * spacing_ * std::sqrt(3.0);
  const Vec3 middle = (corner + Vec3(0.5 * (kSamples - 1))) * spacing_;
  std::size_t gathered = 0;
  double nearest = cap_ + half;
  const auto gather = [&] {
    bool all = true;
    gathered = 0;
    scene_->visitNear(origin_ + middle, cap_ + half, [&](std::uint32_t i, const Sphere& b) {
      const Near n{b.centre_A - origin_, b.radius_A, std::int32_t(i)};
      const double gap = glm::distance(n.centre, middle) - n.radius;
      nearest = std::min(nearest, gap);
      if (gap > nearest + 2.0 * half) return;
      if (gathered < kMaxGathered)
        gathered_[gathered++] = n;
      else
        all = false;
    });
    return all;
  };
  // With a very large probe the list overflows before the nearest sphere is known; the second call knows it.
  if (!gather()) gather();

  // Octants of the block: each keeps only the spheres that can be nearest somewhere in it.
  constexpr int kPart = kSamples / 2;
  const double part_half = 0.5 * (kPart - 1) * spacing_ * std::sqrt(3.0);
  for (int part = 0; part < 8; ++part) {
    const int x0 = part & 1 ? kPart : 0, y0 = part & 2 ? kPart : 0, z0 = part & 4 ? kPart : 0;
    const Vec3 part_middle = (corner + Vec3(x0, y0, z0) + Vec3(0.5 * (kPart - 1))) * spacing_;
    double smallest = cap_ + part_half;
    for (std::size_t k = 0; k < gathered; ++k)
      smallest = std::min(smallest, glm::distance(gathered_[k].centre, part_middle) - gathered_[k].radius);
    std::size_t close = 0;
    for (std::size_t k = 0; k < gathered; ++k)
      if (glm::distance(gathered_[k].centre, part_middle) - gathered_[k].radius <= smallest + 2.0 * part_half)
        close_[close++] = gathered_[k];
    for (int z = z0; z < z0 + kPart; ++z)
      for (int y = y0; y < y0 + kPart; ++y) {
        double row[kPart];
        std::fill(row, row + kPart, cap_);
        for (std::size_t k = 0; k < close; ++k) {
          const Near& n = close_[k];
          const double dy = (corner.y + y) * spacing_ - n.centre.y, dz = (corner.z + z) * spacing_ - n.centre.z;
          for (int x = 0; x < kPart; ++x) {
            const double dx = (corner.x + x0 + x) * spacing_ - n.centre.x;
            row[x] = std::min(row[x], std::sqrt(dx * dx + dy * dy + dz * dz) - n.radius);
          }
        }
        std::copy(row, row + kPart, &distance_[std::size_t(x0 + kSamples * (y + kSamples * z))]);
      }
    for (std::size_t k = 0; k < close && brick->labels < kLabels; ++k) {
      const auto begin = brick->label.begin(), end = begin + brick->labels;
      if (std::find(begin, end, close_[k].index) == end) {
        brick->label[std::size_t(brick->labels++)] = close_[k].index;
        if (in_bricks_[std::size_t(close_[k].index)]++ == 0) ++remembered_;
      }
    }
  }

  constexpr int kX = 1, kY = kSamples, kZ = kSamples * kSamples;
  for (int z = 0; z < kSide; ++z)
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const double* f = &distance_[std::size_t((x + 1) * kX + (y + 1) * kY + (z + 1) * kZ)];
        const double curved = f[-kX] + f[kX] + f[-kY] + f[kY] + f[-kZ] + f[kZ] - 6.0 * f[0];
        brick->coefficient[std::size_t(x + kSide * (y + kSide * z))] = float(f[0] - curved / 8.0);
      }
  return last_ = brick;
}

bool DistanceBricks::sample(const Vec3& place, Sample& out, int& fills_left) noexcept {
  const Vec3 at = place / spacing_, node = glm::floor(at + 0.5), brick_at = glm::floor(node / double(kCells));
  if (!(std::max({std::abs(brick_at.x), std::abs(brick_at.y), std::abs(brick_at.z)}) < 2e9)) return false;
  const Key key{std::int32_t(brick_at.x), std::int32_t(brick_at.y), std::int32_t(brick_at.z)};
  const Brick* brick = find(key);
  if (!brick) {
    if (fills_left <= 0) return false;
    --fills_left;
    brick = make(key);
  }
  const Weights x(at.x - node.x), y(at.y - node.y), z(at.z - node.z);
  const Vec3 in = node - brick_at * double(kCells);  // 0 to 3; coefficients start one node earlier
  const float* c = &brick->coefficient[std::size_t(int(in.x) + kSide * (int(in.y) + kSide * int(in.z)))];
  double f = 0, fx = 0, fy = 0, fz = 0, xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  constexpr double dd[3] = {1.0, -2.0, 1.0};
  for (int k = 0; k < 3; ++k) {
    double p = 0, px = 0, py = 0, pxx = 0, pyy = 0, pxy = 0;
    for (int j = 0; j < 3; ++j) {
      const float* at_row = c + kSide * (j + kSide * k);
      const double row[3] = {at_row[0], at_row[1], at_row[2]};
      const double r = x.w[0] * row[0] + x.w[1] * row[1] + x.w[2] * row[2];
      const double rx = x.d[0] * row[0] + x.d[1] * row[1] + x.d[2] * row[2];
      const double rxx = row[0] - 2.0 * row[1] + row[2];
      p += y.w[j] * r;
      px += y.w[j] * rx;
      pxx += y.w[j] * rxx;
      py += y.d[j] * r;
      pxy += y.d[j] * rx;
      pyy += dd[j] * r;
    }
    f += z.w[k] * p;
    fx += z.w[k] * px;
    fy += z.w[k] * py;
    xx += z.w[k] * pxx;
    yy += z.w[k] * pyy;
    xy += z.w[k] * pxy;
    fz += z.d[k] * p;
    xz += z.d[k] * px;
    yz += z.d[k] * py;
    zz += dd[k] * p;
  }
  const double per = 1.0 / spacing_, per2 = per * per;
  out.value = f;
  out.gradient = Vec3(fx, fy, fz) * per;
  out.hessian = glm::dmat3(xx, xy, xz, xy, yy, yz, xz, yz, zz) * per2;
  return true;
}

std::int32_t DistanceBricks::nearestSphere(const Vec3& place) const noexcept {
  const Vec3 brick_at = glm::floor(glm::floor(place / spacing_ + 0.5) / double(kCells));
  const Brick* brick = find({std::int32_t(brick_at.x), std::int32_t(brick_at.y), std::int32_t(brick_at.z)});
  if (!brick) return -1;
  double smallest = 1e300;
  std::int32_t nearest = -1;
  for (int k = 0; k < brick->labels; ++k) {
    const std::int32_t i = brick->label[std::size_t(k)];
    const Sphere& b = (*scene_)[std::size_t(i)];
    const double gap = glm::distance(place, b.centre_A - origin_) - b.radius_A;
    if (gap < smallest) smallest = gap, nearest = i;
  }
  return nearest;
}

std::size_t DistanceBricks::bytes() const noexcept {
  return count_ * sizeof(Brick) + 2 * kMaxGathered * sizeof(Near) + kSamples * kSamples * kSamples * sizeof(double) +
         scene_->size() * sizeof(std::uint16_t);
}

std::size_t DistanceBricks::wholeMoleculeBytes() const noexcept {
  const Vec3 bricks = glm::ceil((scene_->high_A() - scene_->low_A() + Vec3(2.0 * cap_)) / (kCells * spacing_));
  return std::size_t(bricks.x * bricks.y * bricks.z) * sizeof(Brick);
}

}  // namespace moltact
