#include "engine/bench/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace moltact::oracle {
namespace {

using Real = long double;

// Lengths in angstrom. A path may penetrate a sphere by kSink before it counts as entering; a sphere within kTouch is
// touched.
constexpr Real kSink = 1e-14L;
constexpr Real kTouch = 1e-12L;
constexpr Real kRest = 1e-13L;
constexpr int kRounds = 400;

PointL operator+(PointL a, PointL b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
PointL operator-(PointL a, PointL b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
PointL operator*(PointL a, Real f) { return {a.x * f, a.y * f, a.z * f}; }
Real dot(PointL a, PointL b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Real length(PointL a) { return std::sqrt(dot(a, a)); }
PointL unit(PointL a) { return a * (1 / length(a)); }
PointL wide(Vec3 p) { return {p.x, p.y, p.z}; }
Vec3 narrow(PointL p) { return {double(p.x), double(p.y), double(p.z)}; }

// d = sum a_k n_k + rest, with the rest perpendicular to every n_k of the set; empty if the normals are dependent.
struct Split {
  std::array<Real, 3> a{};
  PointL rest;
};
std::optional<Split> split(PointL d, const std::array<PointL, 3>& n, int count, Real dependent = 1e-12L) {
  // Gram-Schmidt, then back substitution: precise for any angle between the normals.
  std::array<PointL, 3> q;
  std::array<std::array<Real, 3>, 3> r{};
  for (int k = 0; k < count; ++k) {
    q[k] = n[k];
    for (int pass = 0; pass < 2; ++pass)
      for (int j = 0; j < k; ++j) {
        const Real c = dot(q[k], q[j]);
        r[j][k] += c;
        q[k] = q[k] - q[j] * c;
      }
    r[k][k] = length(q[k]);
    if (r[k][k] < dependent) return std::nullopt;
    q[k] = q[k] * (1 / r[k][k]);
  }
  Split out;
  out.rest = d;
  std::array<Real, 3> b{};
  for (int k = 0; k < count; ++k) {
    b[k] = dot(d, q[k]);
    out.rest = out.rest - q[k] * dot(out.rest, q[k]);
  }
  if (count == 3) out.rest = {};
  for (int k = count - 1; k >= 0; --k) {
    Real v = b[k];
    for (int j = k + 1; j < count; ++j) v -= r[k][j] * out.a[j];
    out.a[k] = v / r[k][k];
  }
  return out;
}

// A straight or circular path: place(t) for t in [0, end], where t is a length.
struct Path {
  PointL centre, u,
      w;            // circular: centre + radius (u cos(t / radius) + w sin(t / radius)); straight: centre + t w
  Real radius = 0;  // 0: straight
  Real end = 0;

  PointL place(Real t) const {
    if (radius == 0) return centre + w * t;
    return centre + (u * std::cos(t / radius) + w * std::sin(t / radius)) * radius;
  }
  PointL heading(Real t) const {
    if (radius == 0) return w;
    return w * std::cos(t / radius) - u * std::sin(t / radius);
  }
};

// The largest t (to the last bit) up to which good(t) is true, given good(from) and not good(to).
template <class Good>
Real lastGood(Real from, Real to, Good&& good) {
  for (int k = 0; k < 200; ++k) {
    const Real mid = from + (to - from) / 2;
    if (mid <= from || mid >= to) break;
    (good(mid) ? from : to) = mid;
  }
  return from;
}

struct Held {
  std::array<int, 3> sphere{-1, -1, -1};
  int count = 0;
};

struct Candidate {
  Held held;
  PointL v;
};

}  // namespace

Oracle::Oracle(std::vector<Sphere> spheres, double probe_A, bool perturbed) : flows_(perturbed ? 5 : 1) {
  // Relative to the first centre, so that a scene a million angstroms away keeps its precision.
  if (!spheres.empty()) origin_ = wide(spheres[0].centre_A);
  for (const Sphere& b : spheres) {
    if (b.radius_A + probe_A <= 0) continue;  // no interior
    centres_.push_back(wide(b.centre_A) - origin_);
    radii_.push_back(Real(b.radius_A) + Real(probe_A));
  }
}

void Oracle::reset() { been_outside_ = false; }

Oracle::Flow Oracle::flow(PointL s, PointL hip) const {
  const int spheres = int(centres_.size());
  const auto gap = [&](int k, PointL x) { return length(x - centres_[k]) - radii_[k]; };
  const auto normal = [&](int k, PointL x) { return unit(x - centres_[k]); };
  int idle = 0;
  for (int round = 0; round < kRounds; ++round) {
    const PointL d = hip - s;
    const Real left = length(d);
    if (left <= 1e-15L) return {hip, true, true};

    std::vector<int> touched;
    for (int k = 0; k < spheres; ++k)
      if (gap(k, s) <= kTouch) touched.push_back(k);

    // The downhill direction is the projection of d on {v : v.n_k >= 0}: try every set of up to three active spheres.
    std::vector<Candidate> candidates;
    const auto consider = [&](std::array<int, 3> set, int count) {
      std::array<PointL, 3> n;
      for (int k = 0; k < count; ++k) n[k] = normal(set[k], s);
      const auto parts = split(d, n, count);
      if (!parts) return;
      for (int k = 0; k < count; ++k)
        if (parts->a[k] > 1e-12L * left) return;  // a pull instead of a push
      for (const int k : touched)
        if (dot(parts->rest, normal(k, s)) < -1e-11L * left) return;
      candidates.push_back({{set, count}, parts->rest});
    };
    const int m = int(touched.size());
    consider({-1, -1, -1}, 0);
    for (int a = 0; a < m; ++a) {
      consider({touched[a], -1, -1}, 1);
      for (int b = a + 1; b < m; ++b) {
        consider({touched[a], touched[b], -1}, 2);
        for (int c = b + 1; c < m; ++c) consider({touched[a], touched[b], touched[c]}, 3);
      }
    }
    if (candidates.empty()) return {s, false, false};
    if (std::any_of(candidates.begin(), candidates.end(), [](const Candidate& c) { return length(c.v) <= kRest; }))
      return {s, false, true};

    // Rounding may admit several sets (a contact about to open, two spheres with one tangent plane). The right one is
    // the one that can be followed: the others enter a sphere or pull immediately.
    Real best = -1;
    PointL next = s;
    for (const Candidate& c : candidates) {
      const auto& held = c.held;
      Path path;
      path.w = unit(c.v);
      if (held.count == 0) {
        path.centre = s;
        path.end = left;
      } else {
        path.centre = centres_[held.sphere[0]];
        if (held.count == 2) {  // the circle's centre is the foot of s on the line through the two centres
          const PointL axis = unit(centres_[held.sphere[1]] - path.centre);
          path.centre = path.centre + axis * dot(s - path.centre, axis);
        }
        path.radius = length(s - path.centre);
        path.u = unit(s - path.centre);
        path.w = unit(path.w - path.u * dot(path.w, path.u));
        const PointL out = hip - path.centre;
        path.end = path.radius * std::atan2(dot(out, path.w), dot(out, path.u));
      }

      Real stop = path.end;
      // A contact opens where its push would become a pull; the push changes monotonically along the path.
      for (int k = 0; k < held.count; ++k) {
        const auto pushes = [&](Real t) {
          const PointL x = path.place(t);
          std::array<PointL, 3> n;
          for (int j = 0; j < held.count; ++j) n[j] = normal(held.sphere[j], x);
          const auto parts = split(hip - x, n, held.count);
          return parts && parts->a[k] <= 0;
        };
        if (pushes(stop)) continue;
        stop = pushes(0) ? lastGood(0, stop, pushes) : 0;
      }
      // The first sphere entered. Over at most half a turn the distance to a centre has at most one extremum inside.
      for (int k = 0; k < spheres && stop > 0; ++k) {
        if (std::find(held.sphere.begin(), held.sphere.end(), k) != held.sphere.end()) continue;
        const Real start = gap(k, s);
        if (start > stop) continue;
        const Real level = std::min(start, Real(0)) - kSink;
        const auto outside = [&](Real t) { return gap(k, path.place(t)) >= level; };
        const auto nearing = [&](Real t) { return dot(path.place(t) - centres_[k], path.heading(t)) < 0; };
        const Real lowest = nearing(0) && !nearing(stop) ? lastGood(0, stop, nearing) : stop;
        if (!outside(lowest)) stop = lastGood(0, lowest, outside);
      }
      if (stop > best) {
        best = stop;
        next = path.place(stop);
        // At the end: exactly the HIP, or exactly on the active surfaces.
        if (held.count == 0 && stop == path.end) next = hip;
      }
    }
    s = next;
    // Back onto the surfaces, below which rounding and kSink may have left the point.
    for (int pass = 0; pass < 4; ++pass)
      for (int k = 0; k < spheres; ++k)
        if (const Real g = gap(k, s); g < 0 && g > -kTouch) s = s - normal(k, s) * g;
    idle = best < 1e-15L ? idle + 1 : 0;
    if (idle > 8) return {s, false, false};
  }
  return {s, false, false};
}

Oracle::Answer Oracle::step(Vec3 hip_A) {
  // The perturbed copies lie at the corners of a tetrahedron, so that any threshold has some of them on either side.
  static const std::array<PointL, 5> kOffsets{PointL{0, 0, 0}, PointL{1, 1, 1}, PointL{1, -1, -1}, PointL{-1, 1, -1},
                                              PointL{-1, -1, 1}};
  const auto hipOf = [&](std::size_t c) {
    return wide(hip_A) - origin_ + kOffsets[c] * (Real(kPerturbation_A) / std::sqrt(Real(3)));
  };
  const auto insideAny = [&](PointL x) {
    for (std::size_t k = 0; k < centres_.size(); ++k)
      if (length(x - centres_[k]) < radii_[k]) return true;
    return false;
  };

  Answer answer;
  answer.scp_A = hip_A;
  if (!been_outside_) {
    const bool inside = insideAny(hipOf(0));
    for (std::size_t c = 1; c < flows_; ++c) answer.decided = answer.decided && insideAny(hipOf(c)) == inside;
    been_outside_ = !inside;
    answer.started_inside = inside;
    s_.fill(hipOf(0));
    return answer;
  }

  std::array<Flow, 5> ends;
  for (std::size_t c = 0; c < flows_; ++c) ends[c] = flow(s_[c], hipOf(c));
  answer.contact = !ends[0].arrived;
  if (answer.contact) answer.scp_A = narrow(ends[0].s + origin_);
  Real spread = 0;
  for (std::size_t c = 0; c < flows_; ++c) {
    const Flow& e = ends[c];
    spread = std::max(spread, length(e.s - ends[0].s));
    answer.decided = answer.decided && e.converged && e.arrived == ends[0].arrived;
  }
  // The arithmetic error is below 1e-4 of the perturbation, and grows like the spread of the copies.
  answer.decided = answer.decided && spread < 1000 * Real(kPerturbation_A);
  answer.accuracy_A = double(1e-4L * spread + 1e-13L);
  for (std::size_t c = 0; c < flows_; ++c) s_[c] = answer.decided ? ends[c].s : ends[0].s;
  return answer;
}

void Oracle::place(Vec3 scp) {
  PointL s = wide(scp) - origin_;
  for (int pass = 0; pass < 100; ++pass)
    for (std::size_t k = 0; k < centres_.size(); ++k) {
      const PointL out = s - centres_[k];
      const Real r = length(out);
      if (r < radii_[k] && r > 0) s = centres_[k] + out * (radii_[k] / r);
    }
  s_.fill(s);
  been_outside_ = true;
}

double deepest(const std::vector<Sphere>& spheres, double probe_A, Vec3 p) {
  Real largest = -std::numeric_limits<Real>::infinity();
  for (const Sphere& b : spheres)
    largest = std::max(largest, Real(b.radius_A) + Real(probe_A) - length(wide(p) - wide(b.centre_A)));
  return double(largest);
}

bool atRest(const std::vector<Sphere>& spheres, double probe_A, Vec3 scp, Vec3 hip, double tolerance_A) {
  std::vector<PointL> n;
  for (const Sphere& b : spheres) {
    const PointL out = wide(scp) - wide(b.centre_A);
    const Real r = length(out);
    if (r > 0 && std::abs(r - (Real(b.radius_A) + Real(probe_A))) <= tolerance_A) n.push_back(out * (1 / r));
  }
  const PointL d = wide(hip) - wide(scp);
  const auto holds = [&](std::array<PointL, 3> set, int count) {
    const auto parts = split(d, set, count, 1e-7L);  // the SCP's rounding rotates normals by less than this
    if (!parts) return false;
    PointL residual = parts->rest;
    for (int k = 0; k < count; ++k)
      if (parts->a[k] > 0) residual = residual + set[k] * parts->a[k];
    return length(residual) <= tolerance_A;
  };
  if (holds({}, 0)) return true;
  for (std::size_t a = 0; a < n.size(); ++a) {
    if (holds({n[a]}, 1)) return true;
    for (std::size_t b = a + 1; b < n.size(); ++b) {
      if (holds({n[a], n[b]}, 2)) return true;
      for (std::size_t c = b + 1; c < n.size(); ++c)
        if (holds({n[a], n[b], n[c]}, 3)) return true;
    }
  }
  return false;
}

}  // namespace moltact::oracle
