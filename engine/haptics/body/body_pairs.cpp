#include "engine/haptics/body/body_pairs.h"

#include <cmath>
#include <numeric>

namespace moltact {
namespace {

constexpr std::int32_t kLeaf = 8;  // spheres of a leaf
// The near list is made anew where it covers less than this, the far list where it covers less than the near list needs.
constexpr double kMinCovered_A = 0.12;
constexpr double kMinRange_A = 1e-6;
constexpr std::uint64_t kMaxSearched = 1'000;  // spheres of one search
constexpr double kAhead_A = 0.9;               // a large body's next far list is begun where the last covers less
constexpr double kMaxSearch_A = 5.0, kMaxSearchedRadius_A = 8.0;

}  // namespace

BodyPairs::BodyPairs(std::shared_ptr<const SphereGrid> scene, const HeldBody& body)
    : scene_(std::move(scene)),
      origin_(1024.0 * glm::round((scene_->low_A() + scene_->high_A()) / 2048.0)),
      spheres_(body.spheres),
      max_work_(std::max(kMaxWork, kWorkPerSphere * std::uint64_t(body.spheres.size()))),
      bound_(body.reach_A),
      near_(kMaxNear),
      near_from_(kMaxNear) {
  far_.pairs.resize(kMaxFar);
  next_.pairs.resize(kMaxFar);
  for (const Sphere& s : spheres_) reach_ = std::max(reach_, glm::length(s.centre_A));
  order_.resize(spheres_.size());
  std::iota(order_.begin(), order_.end(), 0);
  if (!spheres_.empty()) makeTree(body.spheres, 0, std::int32_t(spheres_.size()));
}

void BodyPairs::makeTree(std::span<const Sphere> body, std::int32_t begin, std::int32_t end) {
  Vec3 low = spheres_[std::size_t(begin)].centre_A, high = low;
  for (std::int32_t k = begin; k < end; ++k) {
    low = glm::min(low, spheres_[std::size_t(k)].centre_A);
    high = glm::max(high, spheres_[std::size_t(k)].centre_A);
  }
  const std::size_t at = nodes_.size();
  Node node{.centre = 0.5 * (low + high), .begin = begin, .end = end, .leaf = end - begin <= kLeaf};
  for (std::int32_t k = begin; k < end; ++k)
    node.radius = std::max(
        node.radius, glm::distance(node.centre, spheres_[std::size_t(k)].centre_A) + spheres_[std::size_t(k)].radius_A);
  node.radius += 1e-9;
  nodes_.push_back(node);
  if (!node.leaf) {
    const Vec3 side = high - low;
    const int axis = side.x >= side.y ? (side.x >= side.z ? 0 : 2) : (side.y >= side.z ? 1 : 2);
    const std::int32_t middle = begin + (end - begin) / 2;
    const auto along = [&](std::int32_t k) { return body[std::size_t(k)].centre_A[axis]; };
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::int32_t a, std::int32_t b) { return along(a) < along(b); });
    for (std::int32_t k = begin; k < end; ++k) spheres_[std::size_t(k)] = body[std::size_t(order_[std::size_t(k)])];
    makeTree(body, begin, middle);
    makeTree(body, middle, end);
  }
  nodes_[at].next = std::int32_t(nodes_.size());
}

std::size_t BodyPairs::bytes() const noexcept {
  return spheres_.capacity() * sizeof(Sphere) + order_.capacity() * sizeof(std::int32_t) +
         nodes_.capacity() * sizeof(Node) +
         (far_.pairs.capacity() + next_.pairs.capacity() + near_.capacity()) * sizeof(BodyPair);
}

void BodyPairs::setMotion(const SphereMotion* motion) noexcept {
  // The far list of the motion before holds what comes near until its end, where the next one begins.
  const bool continued = motion && motion_ && motion->continues(*motion_) && far_.range >= 0.0;
  if (!continued) {
    far_.range = -1.0;
    far_.count = near_count_ = 0;
    urgent_ = true;
  } else if (far_.motion != motion_serial_) {
    far_.carried += motion_->maxMotion_A();
  }
  motion_ = motion;
  motion_serial_ = motion ? motion->serial() : 0;
  fraction_ = 0.0;
  near_range_ = -1.0;
  building_ = false;
  stale_ = motion_ != nullptr;
  for (Node& n : nodes_) n.clear = -1.0;
}

void BodyPairs::advanceTo(double fraction) noexcept {
  fraction_ = fraction;
  stale_ = motion_ != nullptr;
}

double BodyPairs::clearance_A(const BodyPose& pose) const noexcept {
  return clearance(grid(), bound_, origin_ + pose.place);
}

// Walks the tree of bounding spheres at the pose. `excludes(node, centre)` is asked for each node that is reached; the
// subtree of an excluded node is skipped. `visit(k, centre)` is called for each sphere of the other leaves and ends the
// walk by returning false. Returns false if it did. `nodes` is nodes_, const or not.
template <class Nodes, class Excludes, class Visit>
bool BodyPairs::walk(Nodes& nodes, const BodyPose& pose, Excludes excludes, Visit visit) const noexcept {
  const auto last = std::int32_t(nodes.size());
  for (std::int32_t at = 0; at < last;) {
    auto& node = nodes[std::size_t(at)];
    if (excludes(node, pose.place + pose.axes * node.centre)) {
      at = node.next;
      continue;
    }
    ++at;
    if (!node.leaf) continue;
    for (std::int32_t k = node.begin; k < node.end; ++k)
      if (!visit(k, pose.place + pose.axes * spheres_[std::size_t(k)].centre_A)) return false;
  }
  return true;
}

bool BodyPairs::overlaps(const BodyPose& pose) const noexcept {
  const auto excludes = [&](const Node& node, const Vec3& centre) {
    return distanceToBox(grid(), node.radius, origin_ + centre) > 0.0;
  };
  return !walk(nodes_, pose, excludes, [&](std::int32_t k, const Vec3& c) {
    const double radius_A = spheres_[std::size_t(k)].radius_A;
    bool found = false;
    grid().visitNear(origin_ + c, radius_A, [&](std::uint32_t i, const Sphere&) {
      const Sphere b = now(std::int32_t(i));
      const Vec3 m = c - b.centre_A;
      const double radii = radius_A + b.radius_A;
      found = glm::dot(m, m) < radii * radii;
      return !found;
    });
    return !found;
  });
}

// A lower bound of the gap between the scene and the node's sphere at `centre`. Where a search finds nothing, the next one
// of the same node looks twice as far, so that a node far from the scene is searched for seldom.
double BodyPairs::nodeClearance_A(Node& node, const Vec3& centre, double range) noexcept {
  const double to_box = distanceToBox(grid(), node.radius, origin_ + centre);
  if (to_box > range || node.radius > kMaxSearchedRadius_A) return to_box;
  const double search = std::max(node.search, 2.0 * range);
  double best = search;
  const std::uint64_t end = work_count_ + kMaxSearched;
  grid().visitNear(origin_ + centre, node.radius + search, [&](std::uint32_t, const Sphere& b) {
    ++work_count_;
    reduceGap(best, centre - (b.centre_A - origin_), b.radius_A + node.radius);
    return best > range && work_count_ < end;
  });
  if (best > range && work_count_ >= end) {  // too many to look at
    node.search = 0.5 * search;
    return to_box;
  }
  node.search = best < search ? std::max(0.0, best) : std::min(2.0 * search, kMaxSearch_A);
  return best;
}

// What the far list is known to hold at a pose: every pair nearer than this.
double BodyPairs::farRange_A(const BodyPose& pose) const noexcept {
  double out = far_.range - surfaceMotion_A(far_.pose, pose, reach_);
  if (motion_ && far_.motion != motion_serial_) out -= far_.carried + fraction_ * motion_->maxMotion_A();
  return out;
}

// Begins the list of the pairs within `range` at the pose.
void BodyPairs::beginNext(const BodyPose& pose, double range) noexcept {
  building_ = true;
  next_.count = 0;
  next_.pose = pose;
  next_.range = range;
  next_.carried = next_.max_motion = 0.0;
  next_.motion = motion_serial_;
  next_from_ = work_count_;
  at_node_ = 0;
  at_sphere_ = -1;
}

// Goes on with the next list until it is complete (true) or the work count has reached `until`. Pairs that exceed the
// capacity begin a list of half the range.
bool BodyPairs::buildNext(std::uint64_t until) noexcept {
  const SphereGrid& in = grid();
  const auto last = std::int32_t(nodes_.size());
  const BodyPose& pose = next_.pose;
  while (at_node_ < last) {
    if (work_count_ >= until) return false;
    Node& node = nodes_[std::size_t(at_node_)];
    if (at_sphere_ < 0) {
      ++work_count_;
      const Vec3 centre = pose.place + pose.axes * node.centre;
      if (node.clear - glm::distance(centre, node.seen_from) <= next_.range) {
        node.seen_from = centre;
        node.clear = nodeClearance_A(node, centre, next_.range);
      }
      const bool excluded = node.clear - glm::distance(centre, node.seen_from) > next_.range;
      if (excluded || !node.leaf) {
        at_node_ = excluded ? node.next : at_node_ + 1;
        continue;
      }
      at_sphere_ = node.begin;
    }
    const std::int32_t k = at_sphere_;
    const double radius_A = spheres_[std::size_t(k)].radius_A;
    const Vec3 c = pose.place + pose.axes * spheres_[std::size_t(k)].centre_A;
    bool fits = true;
    in.visitNear(origin_ + c, radius_A + next_.range, [&](std::uint32_t i, const Sphere& b) {
      ++work_count_;
      const Vec3 m = c - (b.centre_A - origin_);
      const double within = radius_A + b.radius_A + next_.range;
      if (glm::dot(m, m) > within * within) return true;
      fits = next_.count < kMaxFar;
      if (!fits) return false;
      const Sphere is = now(std::int32_t(i));
      next_.pairs[next_.count++] = {is.centre_A, radius_A + is.radius_A, k, std::int32_t(i)};
      if (motion_) next_.max_motion = std::max(next_.max_motion, (*motion_)[i].moved_A());
      return true;
    });
    if (!fits) {
      const double half = 0.5 * next_.range;
      if (half > kMinRange_A) {
        beginNext(pose, half);
        continue;
      }
      // Too many spheres at one point: nothing around is known.
      next_.range = 0.0;
      return true;
    }
    if (++at_sphere_ == node.end) at_sphere_ = -1, ++at_node_;
  }
  return true;
}

void BodyPairs::takeNext() noexcept {
  std::swap(far_, next_);
  last_work_ = work_count_ - next_from_;
  fits_ = std::clamp(2.0 * far_.range, 4.0 * kMinRange_A, kFar_A);
  building_ = urgent_ = false;
  near_range_ = -1.0;
  near_count_ = 0;
  if (motion_) refresh();
}

bool BodyPairs::gatherNear(const BodyPose& pose, double range) noexcept {
  near_count_ = 0;
  near_pose_ = pose;
  near_range_ = range;
  near_fraction_ = fraction_;
  work_count_ += far_.count;
  std::int32_t sphere = -1;
  Vec3 c(0.0);
  for (std::size_t k = 0; k < far_.count; ++k) {
    const BodyPair& pair = far_.pairs[k];
    if (pair.sphere != sphere) {
      sphere = pair.sphere;
      c = pose.place + pose.axes * spheres_[std::size_t(sphere)].centre_A;
    }
    const Vec3 m = c - pair.centre;
    const double within = pair.radii + range;
    if (glm::dot(m, m) > within * within) continue;
    if (near_count_ == kMaxNear) return false;
    near_from_[near_count_] = std::int32_t(k);
    near_[near_count_++] = pair;
  }
  return true;
}

// Recomputes the listed spheres of the scene at the present fraction.
void BodyPairs::refresh() noexcept {
  stale_ = false;
  work_count_ += far_.count;
  for (std::size_t k = 0; k < far_.count; ++k) {
    BodyPair& pair = far_.pairs[k];
    const Sphere b = now(pair.atom);
    pair.centre = b.centre_A;
    pair.radii = spheres_[std::size_t(pair.sphere)].radius_A + b.radius_A;
  }
  for (std::size_t k = 0; k < near_count_; ++k) near_[k] = far_.pairs[std::size_t(near_from_[k])];
}

void BodyPairs::look(const BodyPose& pose) noexcept {
  if (stale_) refresh();
  exhausted_ = false;
  const auto lacking = [&] {
    return !(near_range_ >= 0.0 && covered_A(pose) >= std::min(kMinCovered_A, 0.3 * near_range_));
  };
  // While the next list of a large body is being made, the last one serves a little longer.
  const auto farLacking = [&] {
    const double least = building_ && last_work_ > kSlice ? kMinCovered_A : kNear_A;
    return !(far_.range >= 0.0 && farRange_A(pose) >= std::min(least, 0.25 * far_.range));
  };
  bool lacks = lacking();
  if (!lacks || !farLacking()) {
    // The next list of a large body is made ahead, and that of a motion that continues the last.
    const bool carried = motion_ && far_.motion != motion_serial_;
    if (!building_ && (carried || (last_work_ > kSlice && farRange_A(pose) < kAhead_A))) beginNext(pose, fits_);
    if (building_ && ahead_left_ > 0) {
      const std::uint64_t before = work_count_;
      if (buildNext(before + ahead_left_)) {
        takeNext();
        lacks = true;
      }
      ahead_left_ -= std::min(ahead_left_, work_count_ - before);
    }
    if (!lacks) return;
  }
  // Spheres that have moved into what is not known do not wait.
  const std::uint64_t until = urgent_ || (motion_ && farRange_A(pose) < 0.0) ? kUnlimited : tick_end_;
  while (farLacking()) {
    if (!building_) beginNext(pose, fits_);
    if (!buildNext(until)) {
      exhausted_ = true;
      break;
    }
    takeNext();
  }
  lacks = lacking();
  const double range = std::max(0.0, farRange_A(pose));
  if (!lacks || far_.range < 0.0) return;
  if (near_range_ >= 0.0 && covered_A(pose) >= 0.0) {
    // A list that could not be better, or one more than the tick's work.
    if (exhausted_ && !(range > covered_A(pose))) return;
    if (work_count_ >= until) {
      exhausted_ = true;
      return;
    }
  }
  double near = std::min(range, kNear_A);
  while (!gatherNear(pose, near) && near > kMinRange_A) near *= 0.5;
  if (near <= kMinRange_A) near_range_ = 0.0;
}

}  // namespace moltact
