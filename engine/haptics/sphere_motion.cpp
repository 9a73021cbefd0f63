#include "engine/haptics/sphere_motion.h"

#include <algorithm>
#include <atomic>
#include <string>

#include "engine/haptics/tracker.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

bool usable(const Sphere& b) {
  return finite(b.centre_A) && glm::length(b.centre_A) <= kMaxPosition_A && std::isfinite(b.radius_A) &&
         b.radius_A >= 0.0 && b.radius_A <= kMaxPosition_A;
}

// Unique, so that motions are distinguished even if an address is reused.
std::uint64_t nextSerial() {
  static std::atomic<std::uint64_t> serial{0};
  return ++serial;
}

Problem problem(std::string what, std::string remedy) { return {"", 0, 0, std::move(what), std::move(remedy)}; }

Expected<std::vector<SphereMotion::Moving>> movingBetween(std::span<const Sphere> from, std::span<const Sphere> to) {
  if (from.size() != to.size())
    return problem(trf("a motion begins with {0} spheres and ends with {1}", from.size(), to.size()),
                   tr("give as many places as there are spheres"));
  std::vector<SphereMotion::Moving> out(from.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    out[i] = {from[i], to[i].centre_A - from[i].centre_A, to[i].radius_A - from[i].radius_A};
  return out;
}

bool gone(const SphereMotion::Moving& s) { return s.from.radius_A == 0.0 && s.growth_A == 0.0; }

// The spheres of `untouchable`, and those that are gone. Ascending.
std::vector<std::uint32_t> unfelt(std::span<const SphereMotion::Moving> spheres,
                                  std::span<const std::uint32_t> untouchable) {
  std::vector<std::uint32_t> out(untouchable.begin(), untouchable.end());
  for (std::uint32_t i = 0; i < spheres.size(); ++i)
    if (gone(spheres[i])) out.push_back(i);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace

SphereMotion::SphereMotion(std::vector<Moving> spheres, std::vector<Sphere> bounds,
                           std::span<const std::uint32_t> untouchable, int ticks, double max_motion_A)
    : spheres_(std::move(spheres)),
      bounds_(std::move(bounds), untouchable, SphereGrid::Duplicates::VisitEach),
      ticks_(ticks),
      max_motion_(max_motion_A),
      serial_(nextSerial()) {}

Expected<std::unique_ptr<const SphereMotion>> SphereMotion::after(const SphereMotion& before,
                                                                  std::span<const Sphere> to, int ticks) {
  auto spheres = movingBetween(before.at(1.0), to);
  if (!spheres) return spheres.problem();
  // What was gone in the motion before may be felt again, unless the scene makes it untouchable.
  return make(*std::move(spheres), ticks, before.untouchable_, &before);
}

Expected<std::unique_ptr<const SphereMotion>> SphereMotion::make(std::span<const Sphere> from,
                                                                 std::span<const Sphere> to, int ticks,
                                                                 std::span<const std::uint32_t> untouchable) {
  auto spheres = movingBetween(from, to);
  if (!spheres) return spheres.problem();
  return make(*std::move(spheres), ticks, untouchable, nullptr);
}

Expected<std::unique_ptr<const SphereMotion>> SphereMotion::make(std::vector<Moving> spheres, int ticks,
                                                                 std::span<const std::uint32_t> untouchable,
                                                                 const SphereMotion* before) {
  if (ticks < 1 || ticks > kMaxTicks)
    return problem(trf("a motion of spheres cannot take {0} ticks", ticks), trf("give it 1 to {0}", kMaxTicks));
  std::vector<Sphere> bounds(spheres.size());
  double max_A = 0.0;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const Moving& s = spheres[i];
    const Sphere to = s.at(1.0);
    if (!usable(s.from) || !usable(to))
      return problem(trf("sphere {0} of a motion is at no place, or has no radius", i + 1),
                     trf("give finite coordinates within {0} and radii that are not negative",
                         quantityText(kMaxPosition_A, Dimension::Length, plain())));
    if (!gone(s)) max_A = std::max(max_A, s.moved_A());
    // Enlarges the bounding sphere by more than the rounding of a point on the path.
    const double spare = 1e-12 * (glm::length(s.from.centre_A) + glm::length(to.centre_A));
    bounds[i] = {s.from.centre_A + 0.5 * s.displacement_A,
                 std::max(s.from.radius_A, to.radius_A) + 0.5 * glm::length(s.displacement_A) + spare};
    if (s.displacement_A == Vec3(0.0) && s.growth_A == 0.0) bounds[i] = s.from;
  }
  const std::vector<std::uint32_t> not_felt = unfelt(spheres, untouchable);
  std::unique_ptr<SphereMotion> made(new SphereMotion(std::move(spheres), std::move(bounds), not_felt, ticks, max_A));
  made->untouchable_.assign(untouchable.begin(), untouchable.end());
  // Lists of near spheres outlast a motion only if the same ones are felt.
  if (before && not_felt == before->bounds_.untouchable()) made->continues_ = before->serial_;
  return std::unique_ptr<const SphereMotion>(std::move(made));
}

std::vector<Sphere> SphereMotion::at(double fraction) const {
  std::vector<Sphere> out(spheres_.size());
  std::transform(spheres_.begin(), spheres_.end(), out.begin(), [&](const Moving& s) { return s.at(fraction); });
  return out;
}

}  // namespace moltact
