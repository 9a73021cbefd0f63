#include "engine/haptics/exact/exact_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/haptics/exact/blocked_motion.h"
#include "engine/haptics/exact/cap.h"
#include "engine/haptics/exact/entry_angle.h"
#include "engine/haptics/hip_input.h"
#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

constexpr double kAtCentre = 1e-12;  // of a radius: a HIP this near a centre or axis has no direction; the SCP stays
constexpr double kMoved = 1e-12;     // of a radius: a shorter piece leaves the SCP where it was
constexpr double kTangent = 1e-12;   // a way along a rim; it counts as leaving a cap under a hemisphere

// Every ball that comes within kLook_A of the SCP is looked at before a way goes on; a list of them serves until the SCP
// has gone kMargin_A farther. Longer lists are dearer to gather, shorter ones are gathered more often.
constexpr double kLook_A = 0.5, kMargin_A = 1.0;

// The ball that holds all of `ball`'s sphere, or -1. Equal balls: the first in the file holds the others.
std::int32_t coveredBy(const BallScene& scene, std::int32_t ball) {
  const Ball& inner = scene[std::size_t(ball)];
  std::int32_t holder = -1;
  scene.visitCentresNear(inner.centre_A, scene.largestRadius_A() - inner.radius_A, [&](std::uint32_t index, const Ball& outer) {
    const auto j = static_cast<std::int32_t>(index);
    const double spare = outer.radius_A - inner.radius_A;
    if (j == ball || spare < 0.0) return;
    const Vec3 way = outer.centre_A - inner.centre_A;
    const double d2 = glm::dot(way, way);
    if (d2 <= spare * spare && (d2 > 0.0 || spare > 0.0 || j < ball)) holder = j;
  });
  return holder;
}

}  // namespace

bool ExactTracker::Touching::has(std::int32_t ball) const {
  return std::find(balls.begin(), balls.begin() + count, ball) != balls.begin() + count;
}

void ExactTracker::Touching::add(std::int32_t ball) {
  if (ball >= 0 && count < kMostTouching && !has(ball)) balls[std::size_t(count++)] = ball;
}

ExactTracker::ExactTracker(std::shared_ptr<const BallScene> scene, double probe_A) : near_(std::move(scene), kMargin_A) {
  near_.setProbe(usableProbe_A(probe_A, kWaterProbe_A));
}

void ExactTracker::reset() noexcept {
  armed_ = false;
  feature_ = Feature::Free;
  touching_.count = 0;
  rememberHolders();
  free_gap2_ = 0.0;
}

Footprint ExactTracker::footprint() const noexcept {
  return {near_.held(), sizeof(*this) + near_.scene().bytes()};
}

Contact ExactTracker::contact(const Vec3& hip) const noexcept {
  return {.scp = {feature_ == Feature::Free ? hip : near_.origin() + scp_}, .atoms = holders_, .feature = feature_};
}

// The balls that hold the SCP, in ascending order: they change only where the SCP flows.
void ExactTracker::rememberHolders() noexcept {
  holders_ = {-1, -1, -1};
  const int holding = std::min(static_cast<int>(feature_), touching_.count);  // free 0, sphere 1, circle 2, point 3
  for (int k = 0; k < holding; ++k) {
    const std::int32_t ball = touching_.balls[std::size_t(k)];
    int at = k;
    for (; at > 0 && holders_[std::size_t(at - 1)] > ball; --at) holders_[std::size_t(at)] = holders_[std::size_t(at - 1)];
    holders_[std::size_t(at)] = ball;
  }
}

Contact ExactTracker::step(PointA hip) noexcept {
  const Vec3& h = hip.A;
  // Most ticks of all: free, and nothing can be met yet. A HIP that is not a number fails the comparison.
  if (feature_ == Feature::Free && armed_) {
    const Vec3& o = near_.origin();
    const double x = h.x - o.x, y = h.y - o.y, z = h.z - o.z;  // one by one: as a vector they would go through memory
    const double way_x = x - free_from_.x, way_y = y - free_from_.y, way_z = z - free_from_.z;
    if (way_x * way_x + way_y * way_y + way_z * way_z < free_gap2_) {
      scp_.x = x, scp_.y = y, scp_.z = z;
      return {.scp = hip};
    }
  }
  return lookRound(h.x, h.y, h.z);
}

// A tick that is not plainly free; apart, so that those need not save its registers.
Contact ExactTracker::lookRound(double x, double y, double z) noexcept {
  const Vec3 h(x, y, z);
  const PointA hip{h};
  if (!usableHip(h)) return refusedHip(hip, near_.origin() + scp_);
  const Vec3 local = h - near_.origin();
  if (!armed_) {
    const double gap = gapRound(local);
    if (gap < 0.0) return {.scp = hip, .fault = Fault::StartedInside};
    free_gap2_ = gap * gap;
    armed_ = true;
    scp_ = free_from_ = local;
    return contact(h);
  }
  if (!holdsQuickly(local)) {
    flow(local);
    rememberHolders();
  }
  return contact(h);
}

void ExactTracker::flow(const Vec3& hip) noexcept {
  forced_ball_ = forced_pair_ = -1;
  forced_flight_ = false;
  int stuck = 0;
  for (int piece = 0; piece < kMostPieces; ++piece) {
    std::array<Vec3, kMostTouching> normals;
    for (int k = 0; k < touching_.count; ++k) normals[std::size_t(k)] = normalOf(touching_.balls[std::size_t(k)]);
    Blocked blocked;
    if (forced_ball_ < 0 && !forced_flight_) blocked = blockedMotion(hip - scp_, {normals.data(), std::size_t(touching_.count)});

    Went went;
    const auto by = [&](int k) { return touching_.balls[std::size_t(blocked.by[std::size_t(k)])]; };
    if (forced_ball_ >= 0 && forced_pair_ >= 0) {
      const std::int32_t i = std::exchange(forced_ball_, -1), j = std::exchange(forced_pair_, -1);
      went = slideOnCircle(hip, i, j);
    } else if (forced_ball_ >= 0) {
      went = slideOnSphere(hip, std::exchange(forced_ball_, -1));
    } else if (std::exchange(forced_flight_, false) || blocked.count == 0) {
      went = fly(hip);
    } else if (blocked.count == 1) {
      went = slideOnSphere(hip, by(0));
    } else if (blocked.count == 2) {
      went = slideOnCircle(hip, by(0), by(1));
    } else {
      holdAtPoint({by(0), by(1), by(2)});
      return;
    }
    if (went == Went::Rests) return;
    // Where balls meet in one point, pieces of no length gather all of them; when that leads nowhere the point holds.
    stuck = went == Went::Stuck ? stuck + 1 : 0;
    if (stuck > 2 * kMostTouching) break;
  }
  ++cut_short_;
  feature_ = touching_.count == 0 ? Feature::Free : static_cast<Feature>(std::min(touching_.count, 3));
  holds_known_ = false;
  patch_.clear = patch_.cosine = 2.0;
  circle_.i = -1;
  free_gap2_ = 0.0;
}

// A ball inside another, or equal to an earlier one, stands for the one that holds it.
std::int32_t ExactTracker::outermost(std::int32_t ball) const noexcept {
  for (int k = 0; k < 64 && ball >= 0; ++k) {
    const std::int32_t holder = coveredBy(near_.scene(), ball);
    if (holder < 0) break;
    ball = holder;
  }
  return ball;
}

// A lower bound of the way from a place to the nearest ball; negative or zero inside or on one.
double ExactTracker::gapRound(const Vec3& place) noexcept {
  double least = kFarthest_A;
  const double known = near_.each(place, kLook_A, [&](const NearBall& b) { lessenGap(least, place - b.centre, b.radius); });
  return least < known ? least : std::max(known, wayToBox(near_.scene(), near_.probe_A(), near_.origin() + place));
}

// The first ball on a straight way. A short one meets only what is known to be near.
Hit ExactTracker::firstMet(const Vec3& to, std::span<const std::int32_t> leaving) noexcept {
  const double length = glm::distance(scp_, to);
  if (!(length <= kLook_A)) return sweep(near_.scene(), near_.probe_A(), near_.origin() + scp_, near_.origin() + to, leaving);
  if (!(length > 0.0)) return {};
  FirstMet first(scp_, (to - scp_) / length, length, leaving);
  near_.each(scp_, length, [&](const NearBall& b) { first.look(b.index, b.centre, b.radius); });
  return first.ball() < 0 ? Hit{} : Hit{first.ball(), std::min(1.0, first.at() / length)};
}

ExactTracker::Went ExactTracker::fly(const Vec3& hip) noexcept {
  // From free space a short way needs no search along it: a ball on it would be as near to its end as the way is long.
  if (touching_.count == 0) {
    const double gap = gapRound(hip);
    if (gap > 0.0 && gap * gap > glm::dot(hip - scp_, hip - scp_)) {
      scp_ = free_from_ = hip;
      free_gap2_ = gap * gap;
      feature_ = Feature::Free;
      return Went::Rests;
    }
  }
  // A ball inside one that the SCP leaves, or equal to it, is left with it.
  Touching leaving = touching_;
  Hit hit;
  std::int32_t ball = -1;
  do {
    hit = firstMet(hip, {leaving.balls.data(), std::size_t(leaving.count)});
    ball = outermost(hit.ball);
    if (!touching_.has(ball) || leaving.count == kMostTouching) break;
    leaving.add(hit.ball);
  } while (true);
  if (hit.ball < 0) {
    touching_.count = 0;
    feature_ = Feature::Free;
    scp_ = free_from_ = hip;
    const double gap = std::max(0.0, gapRound(hip));
    free_gap2_ = gap * gap;
    return Went::Rests;
  }
  const NearBall met = near_.ball(ball);
  const Vec3 c = met.centre, out = scp_ + (hip - scp_) * hit.t - c;
  const double r = met.radius, far = glm::length(out);
  if (hit.t * glm::length(hip - scp_) <= kMoved * r) {
    touching_.add(ball);
    return Went::Stuck;
  }
  touching_.set(ball);
  scp_ = far > 0.0 ? c + out * (r / far) : c;
  return Went::GoesOn;
}

// Case 1: the way on a sphere toward the place nearest to the HIP is a great circle.
ExactTracker::Went ExactTracker::slideOnSphere(const Vec3& hip, std::int32_t ball) noexcept {
  const NearBall on = near_.ball(ball);
  const Vec3 c = on.centre, m = hip - c;
  const double r = on.radius, d = glm::length(m);
  const Vec3 x = glm::normalize(scp_ - c);
  const auto rest = [&](const Vec3& direction) {
    touching_.set(ball);
    feature_ = Feature::Sphere;
    scp_ = c + direction * r;
    // How far one may turn until a cap is met, the nearest cap apart: a cosine changes by at most one a radian.
    patch_ = {.centre = direction};
    double nearest_slack = 1.5, slack = 1.5;  // under a hemisphere: ways between its places stay in it
    const double known = near_.each(scp_, kLook_A, [&](const NearBall& other) {
      if (farFrom(on, other, scp_, slack)) return;
      const Cap cap(on, other);
      const double gap = (cap.level - glm::dot(cap.way, direction)) / cap.distance;
      if (!cap.cuts || gap >= slack) return;
      slack = std::max(gap, nearest_slack);
      if (gap >= nearest_slack) return;
      nearest_slack = gap;
      patch_.axis = cap.way / cap.distance;
      patch_.rim = cap.level / cap.distance;
    });
    slack = std::min(slack, known / r);
    // Under so small a turn the cosine has no digits left: the next tick looks again.
    const auto cosine = [](double angle) { return angle > 1e-6 ? std::cos(angle) : 2.0; };
    patch_.cosine = cosine(slack);
    patch_.clear = cosine(std::min(slack, nearest_slack));
    return Went::Rests;
  };
  if (d <= kAtCentre * r) return rest(x);
  const Vec3 nearest = m / d;
  Vec3 sideways = nearest - x * glm::dot(nearest, x);
  const double sine = glm::length(sideways);
  if (sine <= 1e-15) return rest(glm::dot(nearest, x) > 0.0 ? nearest : x);  // straight behind the centre no way is shorter
  sideways /= sine;
  const double arrives = std::atan2(sine, glm::dot(nearest, x));

  // A HIP that has come out of the ball is seen from where the ball no longer hides it: there the flight begins.
  const double leaves = d > r ? std::max(0.0, arrives - std::acos(r / d)) : kNever;
  double end = std::min(arrives, leaves);
  std::int32_t meets = -1;
  const double known = near_.each(scp_, std::min(kLook_A, end * r), [&](const NearBall& other) {
    if (farFrom(on, other, scp_, end)) return;
    const Cap cap(on, other);
    if (!cap.cuts) return;
    const double a = glm::dot(cap.way, x);
    const bool on_rim = touching_.has(other.index);
    double b = glm::dot(cap.way, sideways);
    const double tangent = kTangent * cap.distance;
    if (on_rim && std::abs(b) < tangent) b = cap.level < 0.0 ? tangent : -tangent;
    const double t = entryAngle(a, b, cap.level, on_rim);
    if (t < end) end = t, meets = other.index;
  });
  // Beyond what has been looked at the way is taken up anew.
  const bool cut = end * r > known;
  if (cut) end = known / r, meets = -1;

  if (meets < 0 && end == arrives) return rest(nearest);
  const bool moved = end > kMoved;
  if (moved) {
    touching_.set(ball);
    scp_ = c + (x * std::cos(end) + sideways * std::sin(end)) * r;
  }
  if (cut) {
    forced_ball_ = ball;
    return Went::GoesOn;
  }
  if (meets < 0) {
    forced_flight_ = true;
    return Went::GoesOn;
  }
  meets = outermost(meets);
  if (!moved && touching_.has(meets)) forced_ball_ = ball, forced_pair_ = meets;  // the rim itself is the way
  touching_.add(meets);
  return moved ? Went::GoesOn : Went::Stuck;
}

// The circle of balls i and j (paper, equations 2 to 4) and the arc of it, round the SCP, that no third ball covers.
bool ExactTracker::makeCircle(std::int32_t i, std::int32_t j) noexcept {
  Circle& c = circle_;
  const NearBall ball_i = near_.ball(i), ball_j = near_.ball(j);
  const Vec3 ci = ball_i.centre, between = ball_j.centre - ci;
  const double ri = ball_i.radius, rj = ball_j.radius;
  c.i = -1;
  c.between = glm::length(between);
  if (!(c.between > 0.0)) return false;
  c.axis = between / c.between;
  c.to_i = (c.between * c.between + (ri - rj) * (ri + rj)) / (2.0 * c.between);
  c.to_j = c.between - c.to_i;
  const double radius2 = (ri - c.to_i) * (ri + c.to_i);
  c.centre = ci + c.axis * c.to_i;
  Vec3 out = scp_ - c.centre;
  out -= c.axis * glm::dot(out, c.axis);
  const double far = glm::length(out);
  if (!(radius2 > 0.0) || !(far > 0.0)) return false;
  c.radius = std::sqrt(radius2);
  c.axis_1 = out / far;
  c.axis_2 = glm::cross(c.axis, c.axis_1);
  c.angle = 0.0;
  c.along_1 = 1.0;
  c.along_2 = 0.0;
  c.high = kTurn;
  c.low = -kTurn;
  c.high_ball = c.low_ball = -1;
  const double known = near_.each(scp_, kLook_A, [&](const NearBall& other) {
    if (other.index == i || other.index == j) return;
    const Vec3 way = other.centre - c.centre;
    const double a = glm::dot(way, c.axis_1), b = glm::dot(way, c.axis_2);
    // It covers the angles whose a cos + b sin is greater than q.
    const double q = (glm::dot(way, way) + (c.radius - other.radius) * (c.radius + other.radius)) / (2.0 * c.radius);
    const double past = q + kTangent * other.radius;
    if (past >= 0.0 && past * past >= a * a + b * b) return;  // none of the circle, or it shares its rim
    const auto [forward, backward] = entryAngles(a, b, q, touching_.has(other.index));
    if (forward < c.high) c.high = forward, c.high_ball = other.index;
    if (-backward > c.low) c.low = -backward, c.low_ball = other.index;
  });
  // Beyond what has been looked at the circle is made anew.
  const double seen = known / c.radius;
  if (seen < c.high) c.high = seen, c.high_ball = -1;
  if (-seen > c.low) c.low = -seen, c.low_ball = -1;
  c.narrow = c.high - c.low < 3.0;
  if (c.narrow) {
    c.low_1 = std::cos(c.low);
    c.low_2 = std::sin(c.low);
    c.high_1 = std::cos(c.high);
    c.high_2 = std::sin(c.high);
  }
  c.i = i;
  c.j = j;
  return true;
}

void ExactTracker::moveAlongCircle(double turned, std::int32_t meets) noexcept {
  Circle& c = circle_;
  if (std::abs(turned) * c.radius > kMoved * c.between) {
    c.angle += turned;
    c.along_1 = std::cos(c.angle);
    c.along_2 = std::sin(c.angle);
    scp_ = c.centre + (c.axis_1 * c.along_1 + c.axis_2 * c.along_2) * c.radius;
    touching_.set(c.i);
    touching_.add(c.j);
  }
  touching_.add(meets);
}

// Case 2: the way along the circle of two spheres, the short way round to the place nearest to the HIP.
ExactTracker::Went ExactTracker::slideOnCircle(const Vec3& hip, std::int32_t i, std::int32_t j) noexcept {
  const bool same = feature_ == Feature::Circle && touching_.count == 2 && ((circle_.i == i && circle_.j == j) || (circle_.i == j && circle_.j == i));
  if (!same && !makeCircle(i, j)) {
    forced_ball_ = i;  // the balls touch in a point only: there is no circle to follow
    return Went::Stuck;
  }
  Circle& c = circle_;
  if (same && c.narrow) c.angle = std::atan2(c.along_2, c.along_1);
  const Vec3 m = hip - c.centre;
  const double along = glm::dot(m, c.axis), y1 = glm::dot(m, c.axis_1), y2 = glm::dot(m, c.axis_2);
  const double out = std::sqrt(y1 * y1 + y2 * y2);
  const auto rest = [&] {
    touching_.set(c.i);
    touching_.add(c.j);
    feature_ = Feature::Circle;
    return Went::Rests;
  };
  double turn = 0.0;
  if (out > kAtCentre * c.radius) {
    turn = std::atan2(y2, y1) - c.angle;
    turn -= kTurn * std::round(turn / kTurn);
  }
  const double way = std::abs(turn), sign = turn < 0.0 ? -1.0 : 1.0;

  // mu_i = (S to_j - along) / between and mu_j = (S to_i + along) / between, with S = 1 - out cos(turn left) / radius,
  // are the balls' shares in holding the SCP; where one falls to nothing the SCP leaves that ball.
  const auto released = [&](double to_other, double lean) {
    const double now = 1.0 - out * std::cos(way) / c.radius;
    if (now * to_other - lean < 0.0) return 0.0;
    if (to_other <= 0.0) return kNever;  // S falls on the way: this share grows
    const double cosine = (1.0 - lean / to_other) * c.radius / std::max(out, 1e-300);
    if (cosine >= 1.0) return kNever;
    return std::max(0.0, way - std::acos(std::max(-1.0, cosine)));
  };
  const double leaves_i = released(c.to_j, along), leaves_j = released(c.to_i, -along);
  const double meets_at = std::max(0.0, sign > 0.0 ? c.high - c.angle : c.angle - c.low);
  const std::int32_t meets = sign > 0.0 ? c.high_ball : c.low_ball;
  const double leaves = std::min(leaves_i, leaves_j);

  if (way < meets_at && way <= leaves) {
    c.angle += turn;
    if (out > kAtCentre * c.radius) {
      c.along_1 = y1 / out;
      c.along_2 = y2 / out;
      scp_ = c.centre + (c.axis_1 * y1 + c.axis_2 * y2) * (c.radius / out);
    }
    return rest();
  }
  const double end = std::min(leaves, meets_at);
  const bool moved = end * c.radius > kMoved * c.between;
  if (leaves < meets_at) {
    const std::int32_t stays = leaves_i < leaves_j ? c.j : c.i;
    moveAlongCircle(sign * end, -1);
    forced_ball_ = stays;
  } else {
    moveAlongCircle(sign * end, outermost(meets));
    if (meets < 0) forced_ball_ = c.i, forced_pair_ = c.j;
  }
  feature_ = Feature::Point;  // no feature yet: the cached circle is that of another place
  return moved ? Went::GoesOn : Went::Stuck;
}

// Case 3: three spheres hold the SCP in a point.
void ExactTracker::holdAtPoint(const std::array<std::int32_t, 3>& balls) noexcept {
  const Vec3 a = normalOf(balls[0]), b = normalOf(balls[1]), c = normalOf(balls[2]);
  const double volume = glm::dot(glm::cross(a, b), c);
  holds_ = {glm::cross(b, c) / volume, glm::cross(c, a) / volume, glm::cross(a, b) / volume};
  holds_known_ = touching_.count == 3;  // where more balls meet, another three may hold for the next pull
  // The three that hold come first; the others that meet here stay known.
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = std::find(touching_.balls.begin(), touching_.balls.begin() + touching_.count, balls[k]);
    std::swap(*at, touching_.balls[k]);
  }
  feature_ = Feature::Point;
}

}  // namespace moltact
