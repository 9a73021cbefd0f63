#include "engine/haptics/exact/cap_cache.h"

#include <algorithm>
#include <cmath>

namespace moltact {

CapCache::CapCache(std::shared_ptr<const BallScene> scene)
    : scene_(std::move(scene)),
      origin_(1024.0 * glm::round((scene_->low_A() + scene_->high_A()) / 2048.0)),
      lists_(std::make_unique<List[]>(kLists)),
      last_(&lists_[0]),
      x_(std::make_unique<double[]>(kCaps)),
      y_(std::make_unique<double[]>(kCaps)),
      z_(std::make_unique<double[]>(kCaps)),
      cos_rim_(std::make_unique<double[]>(kCaps)),
      ball_(std::make_unique<std::int32_t[]>(kCaps)) {}

void CapCache::setProbe(double probe_A) noexcept {
  probe_ = probe_A;
  for (std::uint32_t k = 0; k < kLists; ++k) lists_[k] = List{};
  held_ = 0;
  last_ = &lists_[0];
  next_list_ = next_cap_ = 0;
}

const CapCache::List& CapCache::lookUp(std::int32_t ball) noexcept {
  for (std::uint32_t k = 0; k < kLists; ++k)
    if (lists_[k].ball == ball) {
      last_ = &lists_[k];
      return *last_;
    }
  last_ = &lists_[next_list_];
  next_list_ = (next_list_ + 1) % kLists;
  gather(ball, *last_);
  return *last_;
}

std::int32_t CapCache::coveredBy(std::int32_t ball) const noexcept {
  const Ball& inner = (*scene_)[std::size_t(ball)];
  std::int32_t holder = -1;
  scene_->visitCentresNear(inner.centre_A, scene_->largestRadius_A() - inner.radius_A, [&](std::uint32_t index, const Ball& outer) {
    const auto j = static_cast<std::int32_t>(index);
    const double spare = outer.radius_A - inner.radius_A;
    if (j == ball || spare < 0.0) return;
    const Vec3 way = outer.centre_A - inner.centre_A;
    const double d2 = glm::dot(way, way);
    if (d2 <= spare * spare && (d2 > 0.0 || spare > 0.0 || j < ball)) holder = j;
  });
  return holder;
}

void CapCache::gather(std::int32_t ball, List& list) noexcept {
  // The new list goes behind the newest one, at the ring's start when it might not fit before the end.
  if (next_cap_ + kLongest > kCaps) next_cap_ = 0;
  const std::uint32_t begin = next_cap_;
  std::uint32_t count = 0;
  bool too_long = false;
  eachCapInGrid(ball, [&](const Cap& cap) {
    if (count == kLongest) {
      too_long = true;
      return;
    }
    const std::uint32_t k = begin + count++;
    x_[k] = cap.axis.x;
    y_[k] = cap.axis.y;
    z_[k] = cap.axis.z;
    cos_rim_[k] = cap.cos_rim;
    ball_[k] = cap.ball;
  });
  // Lists whose caps were written over are gone.
  for (std::uint32_t k = 0; k < kLists; ++k)
    if (lists_[k].begin < begin + count && begin < lists_[k].begin + lists_[k].count) lists_[k] = List{};
  if (too_long) count = 0;
  list = {ball, begin, count, too_long};
  held_ = 0;
  for (std::uint32_t k = 0; k < kLists; ++k) held_ += lists_[k].ball >= 0;
  next_cap_ = begin + count;
}

double CapCache::slack(std::int32_t ball, const Vec3& x) noexcept {
  const List& list = find(ball);
  if (!list.too_long) return slackOfList(list.begin, list.count, x);
  double least = 2.0;
  eachCapInGrid(ball, [&](const Cap& cap) { least = std::min(least, cap.cos_rim - glm::dot(cap.axis, x)); });
  return least;
}

double CapCache::slackOfList(std::uint32_t begin, std::uint32_t count, const Vec3& x) const noexcept {
  const double *ax = &x_[begin], *ay = &y_[begin], *az = &z_[begin], *rim = &cos_rim_[begin];
  // Four running minima: the additions and comparisons of one cap need not wait for the last one's.
  double least[4] = {2.0, 2.0, 2.0, 2.0};
  std::uint32_t k = 0;
  for (; k + 4 <= count; k += 4)
    for (std::uint32_t lane = 0; lane < 4; ++lane) {
      const double gap = rim[k + lane] - (ax[k + lane] * x.x + ay[k + lane] * x.y + az[k + lane] * x.z);
      least[lane] = gap < least[lane] ? gap : least[lane];
    }
  for (; k < count; ++k) {
    const double gap = rim[k] - (ax[k] * x.x + ay[k] * x.y + az[k] * x.z);
    least[0] = gap < least[0] ? gap : least[0];
  }
  return std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
}

std::size_t CapCache::bytes() const noexcept {
  return sizeof(*this) + kLists * sizeof(List) + kCaps * (4 * sizeof(double) + sizeof(std::int32_t));
}

}  // namespace moltact
