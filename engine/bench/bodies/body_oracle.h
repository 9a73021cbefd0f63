// An oracle for a rigid body among spheres, in long double over all pairs of spheres; slow by design. It shares no code
// with the exact body. It judges a pose, and finds the rest beside a pose (rest()), but follows no path. Units: angstrom,
// radian; energies divided by the stiffness.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "engine/core/sphere.h"

namespace moltact::oracle {

class BodyOracle {
 public:
  using Real = long double;
  using Vec = std::array<Real, 3>;
  using Vec6 = std::array<Real, 6>;
  using Turn = std::array<Vec, 3>;  // rows

  struct Pose {
    Vec place{};
    Turn turn{};
  };

  /// `lever_A`: root of rotational stiffness over stiffness.
  BodyOracle(std::vector<Sphere> scene, std::vector<Sphere> body, double lever_A)
      : scene_(std::move(scene)), body_(std::move(body)), lever_(lever_A) {}

  static Pose pose(const PoseA& p) {
    Real q[4] = {p.orientation.w, p.orientation.x, p.orientation.y, p.orientation.z}, sum = 0;
    for (const Real c : q) sum += c * c;
    for (Real& c : q) c /= std::sqrt(sum);
    const Real w = q[0], x = q[1], y = q[2], z = q[3];
    return {{p.place.A.x, p.place.A.y, p.place.A.z},
            {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
              {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
              {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}}};
  }

  /// The smallest gap of all pairs; negative where spheres overlap.
  Real minGap_A(const Pose& at) const {
    Real least = 1e30L;
    for (const Sphere& b : body_) {
      const Vec c = centre(at, b);
      for (const Sphere& s : scene_) {
        const Real within = least + b.radius_A + s.radius_A;
        if (within > 0 && square(c, s) < within * within) least = std::min(least, gap(c, b, s));
      }
    }
    return least;
  }

  /// The spring's pull in scaled coordinates: (x_hand - x, L log(R_hand R^T)).
  Vec6 pull(const Pose& at, const Pose& hand) const {
    const Vec theta = rotationVector(at, hand);
    Vec6 out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = hand.place[i] - at.place[i], out[3 + i] = lever_ * theta[i];
    return out;
  }
  Real energy_A2(const Pose& at, const Pose& hand) const {
    const Vec6 d = pull(at, hand);
    return dot(d, d) / 2;
  }

  /// The rest of the force balance, relative to the pull (at least 1e-3 A). It is the distance of the negative pull
  /// from the cone of the normals of all pairs with a gap below `touching_A`, by non-negative least squares.
  Real residual(const Pose& at, const Pose& hand, Real touching_A = 1e-8L) const {
    const Vec6 d = pull(at, hand);
    std::vector<Vec6> normals;
    for (const Contact& c : contacts(at, touching_A)) normals.push_back(c.normal);
    Vec6 rest = d;
    nonNegative(normals, d, rest);
    return std::sqrt(dot(rest, rest)) / std::max<Real>(1e-3L, std::sqrt(dot(d, d)));
  }

  /// True if poses without overlap near this one have less energy. Tests `directions` random motions, half of which
  /// keep the contacts, one at both of the steps 1e-3 and 1e-4 A. Each is made free of overlap by least motions. (A
  /// lower pose at one step alone may lie behind a barrier.) Less by at most twice what closing the gaps of the
  /// contacts gains does not count: the sum of force times gap.
  bool hasLowerNeighbour(const Pose& at, const Pose& hand, int directions, std::mt19937_64& random) const {
    const Real here = energy_A2(at, hand);
    const std::vector<Contact> held = contacts(at, 1e-8L);
    std::vector<Vec6> basis, normals;
    for (const Contact& c : held) orthogonalize(basis, c.normal, 1e-9L), normals.push_back(c.normal);
    Vec6 left{};
    const auto [set, lambda] = nonNegative(normals, pull(at, hand), left);
    Real closing = 0;
    for (std::size_t k = 0; k < set.size(); ++k) closing += lambda[k] * std::max<Real>(0, held[set[k]].gap);
    std::normal_distribution<double> any;
    for (int k = 0; k < directions; ++k) {
      Vec6 u{};
      for (Real& x : u) x = any(random);
      if (k % 2 == 0)
        for (const Vec6& b : basis) add(u, -dot(u, b), b);
      const Real size = std::sqrt(dot(u, u));
      if (size < 1e-6L) continue;
      const auto lower = [&](Real step) {
        Vec6 by = u;
        for (Real& x : by) x *= step / size;
        Pose there = moved(at, by);
        return freed(there) && energy_A2(there, hand) < here - 2 * closing - 1e-3L * step * step - 1e-9L * step;
      };
      if (lower(1e-3L) && lower(1e-4L)) return true;
    }
    return false;
  }

  /// The rest beside a pose: force balance and closed contacts (to 1e-15 A) by Newton's method with the contacts within
  /// `touching_A` of the pose that carry force. Empty if it is more than 1e-3 A away, overlaps by more than 1e-9 A or pulls
  /// at a contact.
  std::optional<Pose> rest(const Pose& from, const Pose& hand, Real touching_A = 1e-7L) const {
    std::vector<Contact> held = contacts(from, touching_A);
    std::vector<Vec6> normals;
    for (const Contact& c : held) normals.push_back(c.normal);
    Vec6 left{};
    auto [set, lambda] = nonNegative(normals, pull(from, hand), left);
    const std::size_t n = set.size();
    const auto balance = [&](const Pose& at) {
      Vec6 f = pull(at, hand);
      for (std::size_t k = 0; k < n; ++k) add(f, lambda[k], contact(at, held[set[k]].body, held[set[k]].scene).normal);
      return f;
    };
    Pose at = from;
    Real way = 0;
    bool arrived = false;
    for (int round = 0; round < 20 && !arrived; ++round) {
      // Rows: the six of the balance, then the gaps. Columns: the motion, then the multipliers, then the right side.
      std::vector<std::vector<Real>> m(6 + n, std::vector<Real>(7 + n, 0));
      const Vec6 f = balance(at);
      for (std::size_t j = 0; j < 6; ++j) {
        constexpr Real kStep = 1e-6L;
        Vec6 by{};
        by[j] = kStep;
        const Vec6 more = balance(moved(at, by));
        by[j] = -kStep;
        const Vec6 less = balance(moved(at, by));
        for (std::size_t i = 0; i < 6; ++i) m[i][j] = (more[i] - less[i]) / (2 * kStep);
      }
      for (std::size_t i = 0; i < 6; ++i) m[i][6 + n] = -f[i];
      for (std::size_t k = 0; k < n; ++k) {
        const Contact c = contact(at, held[set[k]].body, held[set[k]].scene);
        for (std::size_t i = 0; i < 6; ++i) m[i][6 + k] = m[6 + k][i] = c.normal[i];
        m[6 + k][6 + n] = -c.gap;
      }
      std::vector<Real> x;
      if (!eliminate(m, x)) return std::nullopt;
      Vec6 step{};
      for (std::size_t i = 0; i < 6; ++i) step[i] = x[i];
      for (std::size_t k = 0; k < n; ++k) lambda[k] += x[6 + k];
      at = moved(at, step);
      const Real size = std::sqrt(dot(step, step));
      way += size;
      if (way > 1e-3L) return std::nullopt;
      arrived = size < 1e-15L;
    }
    for (const Real one : lambda)
      if (one < -1e-12L) return std::nullopt;
    if (!arrived || minGap_A(at) < -1e-9L) return std::nullopt;
    return at;
  }

  Pose moved(const Pose& at, const Vec6& by) const {
    Pose out = at;
    Vec w{by[3] / lever_, by[4] / lever_, by[5] / lever_};
    for (std::size_t i = 0; i < 3; ++i) out.place[i] += by[i];
    const Real angle = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    const Real a = angle > 0 ? std::sin(angle) / angle : 1,
               b = angle > 1e-5L ? (1 - std::cos(angle)) / (angle * angle) : 0.5L;
    const Turn cross{{{0, -w[2], w[1]}, {w[2], 0, -w[0]}, {-w[1], w[0], 0}}};
    Turn e{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        Real square = 0;
        for (std::size_t k = 0; k < 3; ++k) square += cross[i][k] * cross[k][j];
        e[i][j] = (i == j ? 1 : 0) + a * cross[i][j] + b * square;
      }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        out.turn[i][j] = 0;
        for (std::size_t k = 0; k < 3; ++k) out.turn[i][j] += e[i][k] * at.turn[k][j];
      }
    return out;
  }

  /// log(R_hand R^T) in the molecule's axes.
  static Vec rotationVector(const Pose& at, const Pose& hand) {
    Turn r{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) r[i][j] += hand.turn[i][k] * at.turn[j][k];
    const Vec twice{r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]};
    const Real sine = std::sqrt(twice[0] * twice[0] + twice[1] * twice[1] + twice[2] * twice[2]) / 2;
    const Real angle = std::atan2(sine, (r[0][0] + r[1][1] + r[2][2] - 1) / 2);
    const Real by = sine > 1e-30L ? angle / (2 * sine) : 0.5L;
    return {twice[0] * by, twice[1] * by, twice[2] * by};
  }

 private:
  struct Contact {
    Vec6 normal;
    Real gap;
    std::size_t body, scene;  // the spheres' indices
  };

  static Real dot(const Vec6& a, const Vec6& b) {
    Real sum = 0;
    for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
    return sum;
  }
  static void add(Vec6& a, Real by, const Vec6& b) {
    for (std::size_t i = 0; i < 6; ++i) a[i] += by * b[i];
  }
  static void orthogonalize(std::vector<Vec6>& basis, Vec6 a, Real least) {
    for (int pass = 0; pass < 2; ++pass)
      for (const Vec6& b : basis) add(a, -dot(a, b), b);
    const Real size = std::sqrt(dot(a, a));
    if (basis.size() == 6 || size < least) return;
    for (Real& x : a) x /= size;
    basis.push_back(a);
  }

  static Vec arm(const Pose& at, const Sphere& b) {
    const Real l[3] = {b.centre_A.x, b.centre_A.y, b.centre_A.z};
    Vec out{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) out[i] += at.turn[i][j] * l[j];
    return out;
  }
  static Vec centre(const Pose& at, const Sphere& b) {
    Vec out = arm(at, b);
    for (std::size_t i = 0; i < 3; ++i) out[i] += at.place[i];
    return out;
  }
  // The squared distance of a point from a sphere's centre.
  static Real square(const Vec& c, const Sphere& s) {
    const Real x = c[0] - s.centre_A.x, y = c[1] - s.centre_A.y, z = c[2] - s.centre_A.z;
    return x * x + y * y + z * z;
  }
  static Real gap(const Vec& c, const Sphere& b, const Sphere& s) {
    return std::sqrt(square(c, s)) - b.radius_A - s.radius_A;
  }

  Contact contact(const Pose& at, std::size_t body, std::size_t scene) const {
    const Sphere &b = body_[body], &s = scene_[scene];
    const Vec a = arm(at, b), c = centre(at, b);
    const Real far = std::sqrt(square(c, s));
    const Vec n{(c[0] - s.centre_A.x) / far, (c[1] - s.centre_A.y) / far, (c[2] - s.centre_A.z) / far};
    return {{n[0], n[1], n[2], (a[1] * n[2] - a[2] * n[1]) / lever_, (a[2] * n[0] - a[0] * n[2]) / lever_,
             (a[0] * n[1] - a[1] * n[0]) / lever_},
            far - b.radius_A - s.radius_A,
            body,
            scene};
  }
  std::vector<Contact> contacts(const Pose& at, Real within_A) const {
    std::vector<Contact> out;
    for (std::size_t i = 0; i < body_.size(); ++i) {
      const Vec c = centre(at, body_[i]);
      for (std::size_t j = 0; j < scene_.size(); ++j) {
        const Real within = within_A + body_[i].radius_A + scene_[j].radius_A;
        if (square(c, scene_[j]) <= within * within) out.push_back(contact(at, i, j));
      }
    }
    return out;
  }

  // Least squares of d + sum lambda N = 0 over the columns marked as free, by orthogonalization. False if dependent.
  static bool solve(const std::vector<Vec6>& normals, const std::vector<std::size_t>& set, const Vec6& d,
                    std::vector<Real>& lambda) {
    std::vector<Vec6> q;
    std::vector<std::vector<Real>> r;
    for (const std::size_t k : set) {
      Vec6 a = normals[k];
      std::vector<Real> column(q.size() + 1, 0);
      for (int pass = 0; pass < 2; ++pass)
        for (std::size_t i = 0; i < q.size(); ++i) {
          const Real c = dot(q[i], a);
          column[i] += c;
          add(a, -c, q[i]);
        }
      const Real size = std::sqrt(dot(a, a));
      if (q.size() == 6 || size < 1e-9L) return false;
      for (Real& x : a) x /= size;
      column[q.size()] = size;
      q.push_back(a);
      r.push_back(column);
    }
    lambda.assign(set.size(), 0);
    for (std::size_t i = set.size(); i-- > 0;) {
      Real sum = -dot(q[i], d);
      for (std::size_t j = i + 1; j < set.size(); ++j) sum -= r[j][i] * lambda[j];
      lambda[i] = sum / r[i][i];
    }
    return true;
  }

  struct Multipliers {
    std::vector<std::size_t> set;  // indices of normals
    std::vector<Real> lambda;
  };

  // Lawson & Hanson's non-negative least squares; `rest` becomes d + sum lambda N.
  static Multipliers nonNegative(const std::vector<Vec6>& normals, const Vec6& d, Vec6& rest) {
    std::vector<std::size_t> set;
    std::vector<Real> lambda;
    std::vector<bool> refused(normals.size(), false);
    for (int round = 0; round < 300; ++round) {
      rest = d;
      for (std::size_t k = 0; k < set.size(); ++k) add(rest, lambda[k], normals[set[k]]);
      std::size_t best = normals.size();
      Real most = 1e-16L;
      for (std::size_t k = 0; k < normals.size(); ++k) {
        const Real gain = -dot(normals[k], rest);
        if (gain > most && !refused[k]) most = gain, best = k;
      }
      if (best == normals.size()) break;
      set.push_back(best);
      lambda.push_back(0);
      std::vector<Real> found;
      if (!solve(normals, set, d, found)) {
        refused[best] = true;
        set.pop_back(), lambda.pop_back();
        continue;
      }
      refused.assign(normals.size(), false);
      for (;;) {
        Real part = 1;
        std::size_t leaves = set.size();
        for (std::size_t k = 0; k < set.size(); ++k)
          if (found[k] <= 0 && lambda[k] / (lambda[k] - found[k]) < part)
            part = lambda[k] / (lambda[k] - found[k]), leaves = k;
        if (leaves == set.size()) break;
        for (std::size_t k = 0; k < set.size(); ++k) lambda[k] += part * (found[k] - lambda[k]);
        set.erase(set.begin() + std::ptrdiff_t(leaves));
        lambda.erase(lambda.begin() + std::ptrdiff_t(leaves));
        solve(normals, set, d, found);
      }
      lambda = found;
    }
    return {std::move(set), std::move(lambda)};
  }

  // Solves a x = b with row exchanges; b is the last column. False if a is singular.
  static bool eliminate(std::vector<std::vector<Real>>& m, std::vector<Real>& x) {
    const std::size_t n = m.size();
    for (std::size_t i = 0; i < n; ++i) {
      std::size_t best = i;
      for (std::size_t k = i + 1; k < n; ++k)
        if (std::abs(m[k][i]) > std::abs(m[best][i])) best = k;
      std::swap(m[i], m[best]);
      if (std::abs(m[i][i]) < 1e-9L) return false;
      for (std::size_t k = i + 1; k < n; ++k) {
        const Real by = m[k][i] / m[i][i];
        for (std::size_t j = i; j <= n; ++j) m[k][j] -= by * m[i][j];
      }
    }
    x.assign(n, 0);
    for (std::size_t i = n; i-- > 0;) {
      Real sum = m[i][n];
      for (std::size_t j = i + 1; j < n; ++j) sum -= m[i][j] * x[j];
      x[i] = sum / m[i][i];
    }
    return true;
  }

  // Moves a pose out of overlaps by least motions; false if that fails.
  bool freed(Pose& at) const {
    for (int round = 0; round < 40; ++round) {
      std::vector<Contact> over;
      for (const Contact& c : contacts(at, 1e-9L))
        if (c.gap < 0) over.push_back(c);
      if (over.empty()) return true;
      // The deepest first, each by its own least motion.
      const Contact* deepest = &over.front();
      for (const Contact& c : over)
        if (c.gap < deepest->gap) deepest = &c;
      if (round < 30 && over.size() <= 6) {
        std::vector<Vec6> normals;
        std::vector<std::size_t> set;
        for (const Contact& c : over) set.push_back(normals.size()), normals.push_back(c.normal);
        // The least step with N . step = -gap: a combination of the normals, from its Gram matrix by elimination.
        const std::size_t n = normals.size();
        std::vector<std::vector<Real>> m(n, std::vector<Real>(n + 1));
        for (std::size_t i = 0; i < n; ++i) {
          for (std::size_t j = 0; j < n; ++j) m[i][j] = dot(normals[i], normals[j]) + (i == j ? 1e-14L : 0);
          m[i][n] = -over[i].gap + 1e-13L;
        }
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t k = i + 1; k < n; ++k) {
            const Real by = m[k][i] / m[i][i];
            for (std::size_t j = i; j <= n; ++j) m[k][j] -= by * m[i][j];
          }
        Vec6 step{};
        std::vector<Real> share(n);
        for (std::size_t i = n; i-- > 0;) {
          Real sum = m[i][n];
          for (std::size_t j = i + 1; j < n; ++j) sum -= m[i][j] * share[j];
          share[i] = sum / m[i][i];
          add(step, share[i], normals[i]);
        }
        at = moved(at, step);
        continue;
      }
      Vec6 step{};
      add(step, (1e-13L - deepest->gap) / dot(deepest->normal, deepest->normal), deepest->normal);
      at = moved(at, step);
    }
    return false;
  }

  std::vector<Sphere> scene_, body_;
  Real lever_;
};

}  // namespace moltact::oracle
