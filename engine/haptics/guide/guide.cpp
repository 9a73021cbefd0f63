#include "engine/haptics/guide/guide.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moltact {
namespace {

constexpr std::size_t kGroup = 16;  // pieces that share a bounding sphere

}  // namespace

GuidePath::GuidePath(const std::vector<std::vector<Vec3>>& parts_A) {
  std::size_t points = 0;
  for (const std::vector<Vec3>& part : parts_A) {
    const Vec3* last = nullptr;
    for (const Vec3& point : part) {
      if (!finite(point) || (last && *last == point) || points == kMaxPoints) continue;
      ++points;
      if (last) {
        pieces_.push_back({*last, point, length_A_});
        length_A_ += glm::distance(*last, point);
      }
      last = &point;
    }
  }
  for (std::size_t begin = 0; begin < pieces_.size(); begin += kGroup) {
    Group group{.begin = begin, .end = std::min(begin + kGroup, pieces_.size())};
    const double share = 0.5 / double(group.end - group.begin);
    for (std::size_t k = group.begin; k < group.end; ++k) group.centre += share * (pieces_[k].from + pieces_[k].to);
    for (std::size_t k = group.begin; k < group.end; ++k)
      group.radius_A = std::max(
          {group.radius_A, glm::distance(group.centre, pieces_[k].from), glm::distance(group.centre, pieces_[k].to)});
    groups_.push_back(group);
  }
}

GuidePath::Nearest GuidePath::nearest(const Vec3& hand_A) const noexcept {
  Nearest best{.distance_A = std::numeric_limits<double>::infinity()};
  for (const Group& group : groups_) {
    if (glm::distance(hand_A, group.centre) - group.radius_A >= best.distance_A) continue;
    for (std::size_t k = group.begin; k < group.end; ++k) {
      const Piece& piece = pieces_[k];
      const Vec3 way = piece.to - piece.from;
      const double part = std::clamp(glm::dot(hand_A - piece.from, way) / glm::dot(way, way), 0.0, 1.0);
      const Vec3 place = piece.from + way * part;
      const double distance_A = glm::distance(hand_A, place);
      if (distance_A < best.distance_A) best = {place, distance_A, piece.along_A + part * glm::length(way)};
    }
  }
  return best;
}

Vec3 GuidePath::at(double along_A) const noexcept {
  // The last piece that begins at or before this length.
  const auto after = std::upper_bound(pieces_.begin() + 1, pieces_.end(), along_A,
                                      [](double length, const Piece& piece) { return length < piece.along_A; });
  const Piece& piece = *(after - 1);
  const Vec3 way = piece.to - piece.from;
  const double part = std::clamp((along_A - piece.along_A) / glm::length(way), 0.0, 1.0);
  return piece.from + way * (std::isfinite(part) ? part : 0.0);
}

double guideStretch_A(GuideKind kind, double radius_A, double distance_A) noexcept {
  return kind == GuideKind::Tube ? std::max(0.0, distance_A - radius_A) : distance_A;
}

FeltForce guideForce(const Guide& guide, const Vec3& hand_A) noexcept {
  if (!guide.path || guide.path->empty() || !finite(hand_A)) return {};
  const GuidePath::Nearest near = guide.path->nearest(hand_A);
  const double stretch_A = guideStretch_A(guide.kind, guide.radius_A, near.distance_A);
  const double k = guide.stiffness_N_per_A, F = guide.max_N;
  if (!(stretch_A > 0.0) || !(k > 0.0)) return {};
  FeltForce out;
  const double size_N = std::min(k * stretch_A, F);
  out.force_N = (near.place_A - hand_A) * (size_N / near.distance_A);
  out.energy_N_A = k * stretch_A <= F ? 0.5 * k * stretch_A * stretch_A : F * stretch_A - 0.5 * F * F / k;
  // Along the distance k up to F and 0 beyond; across it the force turns with the hand: size / distance, at most k.
  out.stiffness_N_per_A = k * stretch_A <= F ? k : size_N / near.distance_A;
  return out;
}

}  // namespace moltact
