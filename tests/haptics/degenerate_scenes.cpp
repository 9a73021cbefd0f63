#include "tests/haptics/degenerate_scenes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace moltact::test {
namespace {

using scenes::Random;

// 0, or plus or minus 1e-10 to 1e-16.
double hair(Random& random) {
  if (random.uniform(0, 1) < 0.2) return 0.0;
  return (random.uniform(0, 1) < 0.5 ? -1.0 : 1.0) * std::pow(10.0, random.uniform(-16, -10));
}
Vec3 hairs(Random& random) { return random.direction() * hair(random); }
int count(Random& random, int low, int high) { return low + int(random.uniform(0, high - low + 0.999)); }

// Two unit vectors at right angles to a third.
void across(const Vec3& axis, Vec3& u, Vec3& v) {
  u = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
  v = glm::cross(axis, u);
}

// The family functions fill in spheres (radii with the probe taken off) and special places.
struct Maker {
  Random random;
  DegenerateScene out;
  double probe;

  void sphere(const Vec3& centre, double inflated) {
    out.scene.spheres.push_back({centre, std::max(0.0, inflated - probe)});
  }
  void special(const Vec3& place) { out.special.push_back(place); }
  bool upright() { return random.uniform(0, 1) < 0.4; }  // along the axes rounding is least, and symmetry exact
  Vec3 axis() { return upright() ? Vec3(0, 0, 1) : random.direction(); }
};

void ring(Maker& m) {
  const int n = count(m.random, 3, 9);
  const double inflated = m.probe + m.random.uniform(1.0, 2.0), radius = inflated + hair(m.random);
  const Vec3 axis = m.axis();
  Vec3 u, v;
  across(axis, u, v);
  for (int k = 0; k < n; ++k) {
    const double t = 2 * std::numbers::pi * k / n;
    m.sphere(radius * (u * std::cos(t) + v * std::sin(t)) + (m.upright() ? Vec3(0) : hairs(m.random)), inflated);
  }
  m.special({0, 0, 0});
  m.special(axis);
  m.special(-axis * 0.3);
  m.special(u);
}

void tube(Maker& m) {
  const int n = count(m.random, 3, 6), rings = count(m.random, 2, 4);
  const double inflated = m.probe + m.random.uniform(1.0, 2.0), radius = inflated + hair(m.random);
  const double pitch = m.random.uniform(0.8, 2.0), twist = m.upright() ? 0.0 : m.random.uniform(0, 1);
  const Vec3 axis = m.axis();
  Vec3 u, v;
  across(axis, u, v);
  for (int j = 0; j < rings; ++j)
    for (int k = 0; k < n; ++k) {
      const double t = 2 * std::numbers::pi * (k + twist * j) / n;
      m.sphere(radius * (u * std::cos(t) + v * std::sin(t)) + axis * (pitch * (j - 0.5 * (rings - 1))), inflated);
      m.special(axis * (pitch * j));
    }
}

// Many spheres through one point.
void onePoint(Maker& m) {
  const int n = count(m.random, 3, 12);
  const bool same = m.upright();
  const double one = m.probe + m.random.uniform(1.0, 2.0);
  const Vec3 up = m.axis();
  for (int k = 0; k < n; ++k) {
    Vec3 way = m.random.direction();
    if (glm::dot(way, up) > 0.0) way = -way;  // a pit that opens upward
    const double inflated = same ? one : m.probe + m.random.uniform(0.5, 3.0);
    m.sphere(way * (inflated + hair(m.random)), inflated);
    m.special(way * (0.5 * inflated));
  }
  m.special({0, 0, 0});
  m.special(-up * 0.4);
}

void lattice(Maker& m) {
  const bool faces = m.random.uniform(0, 1) < 0.5;
  const double inflated = m.probe + m.random.uniform(0.5, 2.0);
  const double a = (faces ? inflated : 2 * inflated / std::sqrt(m.upright() ? 3.0 : 2.0)) + hair(m.random);
  const Vec3 axis = m.axis();
  Vec3 u, v;
  across(axis, u, v);
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        if (faces && (x + y + z) % 2) continue;
        m.sphere(a * (double(x) * u + double(y) * v + double(z) * axis) + (m.upright() ? Vec3(0) : hairs(m.random)),
                 inflated);
      }
  for (int k = 0; k < 8; ++k)
    m.special(a * ((k & 1 ? 1.5 : 0.5) * u + (k & 2 ? 1.5 : 0.5) * v + (k & 4 ? 1.0 : 0.5) * axis));
}

void tangentOutside(Maker& m) {
  Vec3 at(0);
  double last = 0;
  for (int k = 0, n = count(m.random, 3, 6); k < n; ++k) {
    const double inflated = m.probe + m.random.uniform(0.3, 2.0);
    const Vec3 way = m.upright() ? Vec3(1, 0, 0) : m.random.direction();
    if (k > 0) {
      m.special(at + way * last);
      at += way * (last + inflated + hair(m.random));
    }
    m.sphere(at, inflated);
    m.special(at);
    last = inflated;
  }
}

void tangentInside(Maker& m) {
  const double outer = m.probe + m.random.uniform(1.5, 3.0);
  m.sphere({0, 0, 0}, outer);
  for (int k = 0, n = count(m.random, 2, 5); k < n; ++k) {
    const double inner = m.probe + m.random.uniform(0.1, 1.4);
    const Vec3 way = m.upright() ? Vec3(0.6, 0, 0.8) : m.random.direction();
    m.sphere(way * (outer - inner + hair(m.random)), inner);
    m.special(way * outer);
    m.special(way * (outer - 0.3));
  }
  m.special({0, 0, 0});
}

void nearlyTheSame(Maker& m) {
  const double offset = m.random.uniform(0, 1) < 0.1 ? 0.0 : std::pow(10.0, m.random.uniform(-16, -2));
  const int n = count(m.random, 3, 15);
  const double edge = std::cbrt(n * 10.0);
  for (int k = 0; k < n; ++k) {
    const Vec3 at(m.random.uniform(0, edge), m.random.uniform(0, edge), m.random.uniform(0, edge));
    const double inflated = m.probe + m.random.uniform(1.1, 2.0);
    m.sphere(at, inflated);
    m.sphere(at + m.random.direction() * offset, inflated + (m.upright() ? 0.0 : hair(m.random)));
    m.special(at);
  }
}

void sizes(Maker& m) {
  const int n = count(m.random, 4, 12);
  for (int k = 0; k < n; ++k) {
    const double radius = std::pow(10.0, m.random.uniform(-2, 1));
    const Vec3 at = m.random.direction() * m.random.uniform(0, 6);
    m.out.scene.spheres.push_back({at, radius});
    m.special(at);
    m.special(at + m.random.direction() * (radius + m.probe));
  }
}

// Many spheres through one circle: their centres on a line.
void oneCircle(Maker& m) {
  const Vec3 axis = m.axis();
  Vec3 u, v;
  across(axis, u, v);
  const double circle = m.probe + m.random.uniform(0.5, 2.0);
  for (int k = 0, n = count(m.random, 3, 6); k < n; ++k) {
    const double along = m.random.uniform(-1.5, 1.5);
    m.sphere(axis * along + (m.upright() ? Vec3(0) : hairs(m.random)), std::hypot(circle, along) + hair(m.random));
    m.special(axis * along);
  }
  m.special(u * (0.5 * circle));
  m.special(v * circle);
}

// Three or four spheres whose spheres' circle a further one just touches, from above or from below.
void grazed(Maker& m) {
  const double r = m.probe + m.random.uniform(1.0, 2.0), half = m.random.uniform(0.3, 0.9) * r;
  m.sphere({-half, 0, 0}, r);
  m.sphere({half, 0, 0}, r);
  const double circle = std::sqrt(r * r - half * half), third = m.probe + m.random.uniform(0.5, 1.5);
  const double t = m.random.uniform(0, 6);
  const Vec3 out(0, std::cos(t), std::sin(t));
  m.sphere(out * (circle + third + hair(m.random)), third);
  if (m.upright()) m.sphere(-out * std::abs(circle - third + hair(m.random)), third);
  m.special(out * circle);
  m.special({0, 0, 0});
  m.special(out * (0.4 * circle));
}

void ordinary(Maker& m) {
  const int n = count(m.random, 3, 30);
  const double edge = std::cbrt(n * 10.0);
  for (int k = 0; k < n; ++k) {
    const Vec3 at(m.random.uniform(0, edge), m.random.uniform(0, edge), m.random.uniform(0, edge));
    m.sphere(at, m.probe + m.random.uniform(1.1, 2.0));
    m.special(at);
    if (k > 0) m.special(0.5 * (at + m.out.scene.spheres[std::size_t(k - 1)].centre_A));
  }
}

struct Family {
  const char* name;
  void (*make)(Maker&);
};
constexpr Family kFamilies[] = {
    {"ring that just closes", ring},
    {"tube", tube},
    {"many spheres through a point", onePoint},
    {"lattice", lattice},
    {"tangent from outside", tangentOutside},
    {"tangent from inside", tangentInside},
    {"nearly the same balls", nearlyTheSame},
    {"radii 1 : 1000", sizes},
    {"many spheres through a circle", oneCircle},
    {"a crease just touched by a third", grazed},
    {"ordinary", ordinary},
};

}  // namespace

int degenerateFamilies() { return int(std::size(kFamilies)); }

DegenerateScene degenerateScene(std::uint64_t seed) {
  const Family& family = kFamilies[seed % std::size(kFamilies)];
  Maker m{Random(seed * 7919 + 13), {}, 0.0};
  const double kind = m.random.uniform(0, 1);
  m.probe = kind < 0.5 ? 1.4 : kind < 0.6 ? 0.0 : kind < 0.9 ? m.random.uniform(0, 4) : m.random.uniform(4, 20);
  m.out.family = family.name;
  m.out.scene.probe_A = m.probe;
  family.make(m);
  const double where = m.random.uniform(0, 1);
  const Vec3 off = where < 0.6 ? Vec3(0) : m.random.direction() * (where < 0.75 ? 30.0 : where < 0.87 ? 1e3 : 1e6);
  for (Sphere& b : m.out.scene.spheres) b.centre_A += off;
  for (Vec3& p : m.out.special) p += off;
  m.out.scene.name = std::string(family.name) + ", seed " + std::to_string(seed);
  return m.out;
}

std::vector<Vec3> degeneratePath(const DegenerateScene& s, int ticks, std::uint64_t seed) {
  Random random(seed * 104729 + 5);
  const std::uint64_t kind = seed / std::size(kFamilies) % 3;
  if (kind == 2) return scenes::passes(s.scene, ticks, seed);
  Vec3 middle(0);
  double half = 0;
  for (const Sphere& b : s.scene.spheres) middle += b.centre_A / double(s.scene.spheres.size());
  for (const Sphere& b : s.scene.spheres)
    half = std::max(half, glm::distance(b.centre_A, middle) + b.radius_A + s.scene.probe_A);
  const auto somewhere = [&] { return middle + random.direction() * random.uniform(0, 1.3 * half); };
  const auto special = [&] {
    const Vec3 p = s.special[std::size_t(random.uniform(0, double(s.special.size()) - 1e-9))];
    return random.uniform(0, 1) < 0.3 ? p : p + random.direction() * std::pow(10.0, random.uniform(-14, -1));
  };
  std::vector<Vec3> path{middle + random.direction() * (half + 1.0)};
  while (int(path.size()) < ticks) {
    if (kind == 0) {  // jumps
      path.push_back(random.uniform(0, 1) < 0.6 ? special() : somewhere());
      if (random.uniform(0, 1) < 0.1) path.push_back(middle + random.direction() * (half + 1.0));
    } else {  // glides from place to place
      const Vec3 to = random.uniform(0, 1) < 0.6 ? special() : somewhere(), from = path.back();
      const double step = std::pow(10.0, random.uniform(-2.5, -0.3));
      const int steps = std::min(60, std::max(1, int(std::ceil(glm::distance(from, to) / step))));
      for (int k = 1; k <= steps; ++k) path.push_back(k == steps ? to : from + (to - from) * (double(k) / steps));
    }
  }
  path.resize(std::size_t(ticks));
  return path;
}

}  // namespace moltact::test
