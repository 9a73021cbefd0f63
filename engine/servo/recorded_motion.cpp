#include "engine/servo/recorded_motion.h"

#include <algorithm>
#include <utility>

#include "engine/servo/recording_bytes.h"

namespace moltact {
namespace {

constexpr std::uint8_t kFrom = 1, kGrowth = 2;  // which values follow

template <class Each, class S>
void sphereFields(Each& each, S& sphere) {
  visitVector(each, sphere.centre_A);
  each(sphere.radius_A);
}

// Whether the motion starts at the end of the other, to the last bit, and what MotionReplay then makes of it continues the
// other if this one does.
bool startsAtEndOf(const SphereMotion& motion, const SphereMotion& before) {
  if (motion.continues(before)) return true;
  if (motion.size() != before.size() || motion.sweptSpheres().untouchable() == before.sweptSpheres().untouchable())
    return false;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Sphere &from = motion[i].from, end = before[i].at(1.0);
    if (from.centre_A != end.centre_A || from.radius_A != end.radius_A) return false;
  }
  return true;
}

}  // namespace

RecordedMotion recordedMotion(const SphereMotion& motion, const SphereMotion* before) {
  RecordedMotion out;
  out.ticks = motion.ticks();
  const bool follows = before && startsAtEndOf(motion, *before);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const SphereMotion::Moving& s = motion[i];
    if (!follows) out.from.push_back(s.from);
    out.changes.push_back({s.displacement_A, s.growth_A});
  }
  return out;
}

std::string bytesOf(const RecordedMotion& motion) {
  std::string out;
  BytesPutter put{out};
  const bool grows =
      std::any_of(motion.changes.begin(), motion.changes.end(), [](const auto& c) { return c.growth_A != 0.0; });
  put(std::int32_t(motion.ticks));
  put(std::uint8_t((motion.from.empty() ? 0 : kFrom) | (grows ? kGrowth : 0)));
  put(std::uint32_t(motion.changes.size()));
  for (const Sphere& s : motion.from) sphereFields(put, s);
  for (const RecordedMotion::Change& c : motion.changes) {
    visitVector(put, c.displacement_A);
    if (grows) put(c.growth_A);
  }
  return out;
}

std::optional<RecordedMotion> motionOfBytes(std::string_view bytes) {
  BytesGetter get{bytes.data(), bytes.data() + bytes.size()};
  std::int32_t ticks = 0;
  std::uint8_t flags = 0;
  std::uint32_t count = 0;
  get(ticks), get(flags), get(count);
  const std::size_t each = (flags & kFrom ? 32u : 0u) + (flags & kGrowth ? 32u : 24u);
  if (!get.ok || flags & ~(kFrom | kGrowth) || get.left() != std::uint64_t(count) * each) return std::nullopt;
  RecordedMotion out;
  out.ticks = ticks;
  out.from.resize(flags & kFrom ? count : 0);
  out.changes.resize(count);
  for (Sphere& s : out.from) sphereFields(get, s);
  for (RecordedMotion::Change& c : out.changes) {
    visitVector(get, c.displacement_A);
    if (flags & kGrowth) get(c.growth_A);
  }
  return out;
}

std::string bytesOf(std::span<const Sphere> spheres) {
  std::string out;
  BytesPutter put{out};
  for (const Sphere& s : spheres) sphereFields(put, s);
  return out;
}

std::optional<std::vector<Sphere>> spheresOfBytes(std::string_view bytes) {
  constexpr std::size_t kEach = 32;
  if (bytes.size() % kEach != 0) return std::nullopt;
  BytesGetter get{bytes.data(), bytes.data() + bytes.size()};
  std::vector<Sphere> out(bytes.size() / kEach);
  for (Sphere& s : out) sphereFields(get, s);
  return out;
}

std::optional<MotionPhase> MotionReplay::at(std::uint32_t number, std::int32_t tick) {
  if (number == 0 && number_ == 0) return MotionPhase{};
  if (number < number_ || number > motions_.size()) return std::nullopt;
  while (number_ < number) {
    const RecordedMotion& next = motions_[number_];
    const std::size_t count = next.changes.size();
    const bool follows = next.from.empty() && now_;
    const std::vector<Sphere> from = follows ? now_->at(1.0) : next.from;
    if (count != scene_.size() || from.size() != count) return std::nullopt;
    std::vector<SphereMotion::Moving> spheres(count);
    for (std::size_t i = 0; i < count; ++i)
      spheres[i] = {from[i], next.changes[i].displacement_A, next.changes[i].growth_A};
    auto made =
        SphereMotion::make(std::move(spheres), next.ticks, scene_.untouchable(), follows ? now_.get() : nullptr);
    if (!made) return std::nullopt;
    before_ = std::exchange(now_, *std::move(made));
    ++number_;
  }
  if (tick < 0 || tick > now_->ticks()) return std::nullopt;
  return MotionPhase{now_.get(), double(tick) / now_->ticks()};
}

}  // namespace moltact
