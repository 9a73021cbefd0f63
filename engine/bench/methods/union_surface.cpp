#include "engine/bench/methods/union_surface.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace moltact {
namespace {

constexpr int kBlock = 8;                // cells along an edge of a block
constexpr int kNodes = kBlock + 1;       // nodes along it
constexpr std::int64_t kHalf = 1 << 19;  // cells per axis on either side of the grid's origin
constexpr double kInset =
    0.002;  // relative to the spacing: minimum distance of a vertex from its cell's border, so that no two coincide
constexpr double kDamping = 1e-3;  // of the steps that place a vertex
constexpr double kBuried =
    0.05;  // weight of lying inside a sphere relative to lying outside: a dent lets the SCP pass, a dam stops it
constexpr int kMaxRounds = 40;
constexpr double kDent = 0.5;  // the same for repaired vertices
constexpr double kBad = 0.05;  // relative to the spacing: a vertex with a larger error is repaired
constexpr int kMendings = 4;
constexpr double kOutside_A = 1e-7;  // tolerated depth of a vertex in a sphere

// Corner k of a cell lies at (k & 1, k >> 1 & 1, k >> 2). Edge 4 a + m runs along axis a from the corner whose offset
// along the next axis is m & 1 and along the one after it m >> 1.
constexpr int lowCorner(int edge) {
  const int a = edge / 4, m = edge % 4, b = (a + 1) % 3, c = (a + 2) % 3;
  return (m & 1) << b | (m >> 1) << c;
}
constexpr int highCorner(int edge) { return lowCorner(edge) | 1 << (edge / 4); }
constexpr int edgeBetween(int p, int q) {
  for (int e = 0; e < 12; ++e)
    if ((lowCorner(e) == p && highCorner(e) == q) || (lowCorner(e) == q && highCorner(e) == p)) return e;
  return -1;
}

// For each pattern of inner corners: the sheet to which each crossed edge belongs.
struct Sheets {
  std::array<std::int8_t, 12> of_edge;  // -1: not crossed
  int count;
  std::array<bool, 3> four;  // the face at the cell's low side along this axis has four crossings
};

// The corners of a face, in cyclic order.
std::array<int, 4> faceCorners(int axis, int side) {
  const int b = 1 << (axis + 1) % 3, c = 1 << (axis + 2) % 3, at = side << axis;
  return {at, at | b, at | b | c, at | c};
}

std::array<Sheets, 256> makeSheets() {
  std::array<Sheets, 256> all{};
  for (int mask = 0; mask < 256; ++mask) {
    Sheets& s = all[std::size_t(mask)];
    std::array<int, 12> parent;
    for (int e = 0; e < 12; ++e) parent[std::size_t(e)] = e;
    const auto root = [&](int e) {
      while (parent[std::size_t(e)] != e) e = parent[std::size_t(e)];
      return e;
    };
    const auto inside = [&](int corner) { return (mask >> corner & 1) != 0; };
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        const auto q = faceCorners(axis, side);
        std::vector<int> crossed;
        for (std::size_t k = 0; k < 4; ++k)
          if (inside(q[k]) != inside(q[(k + 1) % 4])) crossed.push_back(edgeBetween(q[k], q[(k + 1) % 4]));
        if (crossed.size() == 2) parent[std::size_t(root(crossed[0]))] = root(crossed[1]);
        if (crossed.size() < 4) continue;
        if (side == 0) s.four[std::size_t(axis)] = true;
        for (std::size_t k = 0; k < 4; ++k)  // each inner corner is cut off separately, equally from both sides
          if (inside(q[k]))
            parent[std::size_t(root(edgeBetween(q[k], q[(k + 1) % 4])))] = root(edgeBetween(q[k], q[(k + 3) % 4]));
      }
    s.of_edge.fill(-1);
    std::array<int, 12> number;
    number.fill(-1);
    for (int e = 0; e < 12; ++e) {
      if (inside(lowCorner(e)) == inside(highCorner(e))) continue;
      int& n = number[std::size_t(root(e))];
      if (n < 0) n = s.count++;
      s.of_edge[std::size_t(e)] = std::int8_t(n);
    }
  }
  return all;
}

const std::array<Sheets, 256>& sheets() {
  static const std::array<Sheets, 256> all = makeSheets();
  return all;
}

struct Inflated {
  Vec3 centre;
  double radius;
  std::int32_t index;
};

struct Crossing {
  Vec3 place;
  int sphere;  // index in the block's list
};

// A polygon's corner: the grid edge that the polygon surrounds, the position around it, and the vertex.
struct Corner {
  std::uint64_t edge;
  std::uint8_t place;  // twice the number of the cell around the edge; odd: the segment between that cell and the next
  bool low_inside;
  std::int32_t vertex, sphere;
};

class Maker {
 public:
  Maker(const SphereGrid& scene, double probe, double spacing, const Vec3& origin)
      : scene_(scene), probe_(probe), h_(spacing), origin_(origin) {}

  UnionSurface make() {
    if (scene_.size() == 0) return {};
    // Away from round numbers, at which spheres are often placed.
    zero_ = 0.5 * (scene_.low_A() + scene_.high_A()) - origin_ + Vec3(0.371, 0.289, 0.433) * h_;
    std::vector<std::uint64_t> blocks = crossedBlocks();
    for (const std::uint64_t block : blocks) contour(block);
    blocks = {};
    join();
    mend();
    return std::move(out_);
  }

 private:
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    return std::uint64_t(x + kHalf) << 40 | std::uint64_t(y + kHalf) << 20 | std::uint64_t(z + kHalf);
  }
  Vec3 node(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return {zero_.x + h_ * double(x), zero_.y + h_ * double(y), zero_.z + h_ * double(z)};
  }

  // The blocks that the surface of some sphere crosses.
  std::vector<std::uint64_t> crossedBlocks() const {
    std::vector<std::uint64_t> out;
    const double size = h_ * kBlock;
    for (std::size_t i = 0; i < scene_.size(); ++i) {
      if (!scene_.touchable(i)) continue;
      const Sphere& sphere = scene_[i];
      const double r = sphere.radius_A + probe_;
      if (r <= 0.0) continue;
      const Vec3 c = (sphere.centre_A - origin_ - zero_) / size;
      const double reach = r / size + 1e-6;
      const auto low = glm::floor(c - Vec3(reach)), high = glm::floor(c + Vec3(reach));
      for (double x = low.x; x <= high.x; ++x)
        for (double y = low.y; y <= high.y; ++y)
          for (double z = low.z; z <= high.z; ++z) {
            const Vec3 corner(x, y, z), nearest = glm::clamp(c, corner, corner + 1.0) - c,
                                        farthest = glm::max(glm::abs(corner - c), glm::abs(corner + 1.0 - c));
            if (glm::length(nearest) > reach || glm::length(farthest) < reach - 2e-6) continue;
            out.push_back(key(std::int64_t(x), std::int64_t(y), std::int64_t(z)));
          }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  void contour(std::uint64_t block) {
    constexpr std::uint64_t kPart = (1 << 20) - 1;
    first_ = {(std::int64_t(block >> 40) - kHalf) * kBlock, (std::int64_t(block >> 20 & kPart) - kHalf) * kBlock,
              (std::int64_t(block & kPart) - kHalf) * kBlock};
    const double half = 0.5 * h_ * kBlock * std::sqrt(3.0) + 0.1 * h_;
    const Vec3 middle = node(first_[0], first_[1], first_[2]) + Vec3(0.5 * h_ * kBlock);
    near_.clear();
    bool covered = false;
    scene_.visitNear(origin_ + middle, probe_ + half, [&](std::uint32_t i, const Sphere& b) {
      const Inflated n{b.centre_A - origin_, b.radius_A + probe_, std::int32_t(i)};
      const double far = glm::distance(n.centre, middle);
      if (far > n.radius + half || n.radius <= 0.0) return;
      covered = covered || far + half < n.radius;
      near_.push_back(n);
    });
    if (covered) return;
    inside_.fill(false);
    for (const Inflated& n : near_) {
      const double r2 = n.radius * n.radius;
      bool* row = inside_.data();
      for (int z = 0; z < kNodes; ++z)
        for (int y = 0; y < kNodes; ++y, row += kNodes) {
          const double dy = zero_.y + h_ * double(first_[1] + y) - n.centre.y,
                       dz = zero_.z + h_ * double(first_[2] + z) - n.centre.z, apart2 = dy * dy + dz * dz;
          for (int x = 0; x < kNodes; ++x) {
            const double dx = zero_.x + h_ * double(first_[0] + x) - n.centre.x;
            row[x] = row[x] || dx * dx + apart2 < r2;
          }
        }
    }
    for (int z = 0; z < kBlock; ++z)
      for (int y = 0; y < kBlock; ++y)
        for (int x = 0; x < kBlock; ++x) {
          int mask = 0;
          for (int k = 0; k < 8; ++k) mask |= int(isInside(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2))) << k;
          if (mask != 0 && mask != 255) cell(x, y, z, mask);
        }
  }

  bool isInside(int x, int y, int z) const { return inside_[std::size_t(x + kNodes * (y + kNodes * z))]; }

  // Where an edge, from its outer end, first enters a sphere.
  Crossing crossing(const Vec3& outside, const Vec3& inside) const {
    const Vec3 edge = inside - outside;
    const double a = glm::dot(edge, edge);
    Crossing out{inside, -1};
    double smallest = 1.0;
    for (std::size_t k = 0; k < near_.size(); ++k) {
      const Vec3 m = outside - near_[k].centre;
      const double b = glm::dot(m, edge), c = glm::dot(m, m) - near_[k].radius * near_[k].radius, root2 = b * b - a * c;
      if (b >= 0.0 || root2 < 0.0) continue;
      const double t = std::max(0.0, c / (-b + std::sqrt(root2)));  // (-b - root) / a without loss of precision
      if (t <= smallest) smallest = t, out.sphere = int(k);
    }
    out.place = outside + edge * smallest;
    return out;
  }

  void cell(int x, int y, int z, int mask) {
    const Sheets& s = sheets()[std::size_t(mask)];
    const std::array<std::int64_t, 3> at{first_[0] + x, first_[1] + y, first_[2] + z};
    const Vec3 low = node(at[0], at[1], at[2]);
    std::array<Crossing, 12> cross;
    for (int e = 0; e < 12; ++e) {
      if (s.of_edge[std::size_t(e)] < 0) continue;
      const auto corner = [&](int k) { return node(at[0] + (k & 1), at[1] + (k >> 1 & 1), at[2] + (k >> 2)); };
      const int p = lowCorner(e), q = highCorner(e);
      const bool low_inside = mask >> p & 1;
      cross[std::size_t(e)] = low_inside ? crossing(corner(q), corner(p)) : crossing(corner(p), corner(q));
    }
    const auto first_vertex = std::int32_t(out_.vertices.size());
    for (int sheet = 0; sheet < s.count; ++sheet) {
      std::array<Crossing, 12> mine;
      std::size_t count = 0;
      for (int e = 0; e < 12; ++e)
        if (s.of_edge[std::size_t(e)] == sheet) mine[count++] = cross[std::size_t(e)];
      Vec3 place = placeOf({mine.data(), count}, low + Vec3(kInset * h_), low + Vec3((1.0 - kInset) * h_));
      for (std::int32_t v = first_vertex; v < std::int32_t(out_.vertices.size());
           ++v)  // two sheets with the same vertex
        if (glm::distance(out_.vertices[std::size_t(v)], place) < kInset * h_) place = meanOf({mine.data(), count});
      out_.vertices.push_back(place);
    }
    for (int e = 0; e < 12; ++e) {
      if (s.of_edge[std::size_t(e)] < 0) continue;
      const int db = e % 4 & 1, dc = e % 4 >> 1;
      // The cell lies at (-db, -dc) of the edge; in cyclic order: (0, 0), (-1, 0), (-1, -1), (0, -1).
      const int round_edge = dc ? (db ? 2 : 3) : (db ? 1 : 0);
      const int sphere = cross[std::size_t(e)].sphere;
      corners_.push_back({edgeKey(at, e), std::uint8_t(2 * round_edge), (mask >> lowCorner(e) & 1) != 0,
                          first_vertex + s.of_edge[std::size_t(e)],
                          sphere < 0 ? -1 : near_[std::size_t(sphere)].index});
    }
    for (int axis = 0; axis < 3; ++axis)
      if (s.four[std::size_t(axis)]) segments(at, axis, mask, cross);
  }

  std::uint64_t edgeKey(const std::array<std::int64_t, 3>& cell, int e) const {
    const int k = lowCorner(e);
    return std::uint64_t(e / 4) << 60 | key(cell[0] + (k & 1), cell[1] + (k >> 1 & 1), cell[2] + (k >> 2));
  }

  // The two segments across the cell's low face along this axis, which has four crossings: one vertex each.
  void segments(const std::array<std::int64_t, 3>& at, int axis, int mask, const std::array<Crossing, 12>& cross) {
    const auto q = faceCorners(axis, 0);
    for (std::size_t k = 0; k < 4; ++k) {
      if (!(mask >> q[k] & 1)) continue;
      const int ends[2] = {edgeBetween(q[k], q[(k + 1) % 4]), edgeBetween(q[k], q[(k + 3) % 4])};
      const auto vertex = std::int32_t(out_.vertices.size());
      const std::array<Crossing, 2> two{cross[std::size_t(ends[0])], cross[std::size_t(ends[1])]};
      Vec3 low = node(at[0], at[1], at[2]), high = low + Vec3(h_);
      high[axis] = low[axis];
      Vec3 inset(kInset * h_);
      inset[axis] = 0.0;
      out_.vertices.push_back(placeOf(two, low + inset, high - inset));
      for (const int e : ends) {
        const int a = e / 4, db = e % 4 & 1, dc = e % 4 >> 1;
        const int between = axis == (a + 1) % 3 ? (dc ? 2 : 0) : (db ? 1 : 3);  // between this cell and the next
        corners_.push_back(
            {edgeKey(at, e), std::uint8_t(2 * between + 1), (mask >> lowCorner(e) & 1) != 0, vertex, -1});
      }
    }
  }

  static Vec3 meanOf(std::span<const Crossing> cross) {
    Vec3 sum(0.0);
    for (const Crossing& c : cross) sum += c.place;
    return sum / double(cross.size());
  }

  double depth(const Vec3& x, int sphere) const {
    const Inflated& n = near_[std::size_t(sphere)];
    return n.radius - glm::distance(x, n.centre);
  }

  // The sphere in which the point lies deepest, if deeper than rounding; else -1.
  int deepest(const Vec3& x) const {
    int out = -1;
    double largest = kOutside_A;
    for (std::size_t k = 0; k < near_.size(); ++k)
      if (const double d = depth(x, int(k)); d > largest) largest = d, out = int(k);
    return out;
  }

  // The point of the box with the smallest distance from all of the spheres together: on their common circle or point,
  // if it is there. Damped Gauss-Newton steps from x, limited to the box.
  Vec3 bestOn(std::span<const int> spheres, Vec3 x, const Vec3& low, const Vec3& high) const {
    for (int round = 0; round < kMaxRounds; ++round) {
      // (J^T J + damping) step = -J^T off; the rows of J are the normals.
      double xx = kDamping, yy = kDamping, zz = kDamping, xy = 0, xz = 0, yz = 0;
      Vec3 down(0.0);
      for (const int k : spheres) {
        const Vec3 m = x - near_[std::size_t(k)].centre;
        const double d = glm::length(m);
        if (d < 1e-6) continue;
        const double off = d - near_[std::size_t(k)].radius;
        const Vec3 n = m / d, u = n * (off > 0.0 ? 1.0 : kBuried);
        down -= u * off;
        xx += u.x * n.x, yy += u.y * n.y, zz += u.z * n.z, xy += u.x * n.y, xz += u.x * n.z, yz += u.y * n.z;
      }
      const glm::dmat3 whole(xx, xy, xz, xy, yy, yz, xz, yz, zz);
      Vec3 step = glm::inverse(whole) * down;
      const Vec3 low_step = low - x, high_step = high - x;
      if (glm::clamp(step, low_step, high_step) != step) {  // the best step within the box, one axis at a time
        step = glm::clamp(step, low_step, high_step);
        for (int sweep = 0; sweep < kMaxRounds; ++sweep)
          for (int k = 0; k < 3; ++k)
            step[k] =
                std::clamp(step[k] + (down[k] - glm::dot(whole[k], step)) / whole[k][k], low_step[k], high_step[k]);
      }
      x += step;
      if (glm::dot(step, step) < 1e-22) break;
    }
    return x;
  }

  // The vertex of a sheet. If it lies in a sphere that crosses none of the cell's edges, that sphere protrudes into the
  // crease and is included.
  Vec3 placeOf(std::span<const Crossing> cross, const Vec3& low, const Vec3& high) const {
    std::array<int, 16> spheres;
    std::size_t count = 0;
    const auto known = [&](int k) {
      return std::find(spheres.begin(), spheres.begin() + count, k) != spheres.begin() + count;
    };
    for (const Crossing& c : cross)
      if (c.sphere >= 0 && !known(c.sphere)) spheres[count++] = c.sphere;
    const Vec3 mean = glm::clamp(meanOf(cross), low, high);
    Vec3 x = bestOn({spheres.data(), count}, mean, low, high);
    for (int more = 0; more < 3; ++more) {
      const int other = deepest(x);
      if (other < 0 || known(other)) break;
      spheres[count++] = other;
      x = bestOn({spheres.data(), count}, mean, low, high);
    }
    return x;
  }

  // Assembles polygons from their corners and divides them into triangles.
  void join() {
    std::sort(corners_.begin(), corners_.end(),
              [](const Corner& a, const Corner& b) { return a.edge != b.edge ? a.edge < b.edge : a.place < b.place; });
    std::vector<std::int32_t> ring;
    for (std::size_t first = 0, last; first < corners_.size(); first = last) {
      ring.clear();
      std::int32_t sphere = -1;
      for (last = first; last < corners_.size() && corners_[last].edge == corners_[first].edge; ++last) {
        ring.push_back(corners_[last].vertex);
        if (corners_[last].sphere >= 0) sphere = corners_[last].sphere;
      }
      if (!corners_[first].low_inside) std::reverse(ring.begin(), ring.end());
      if (sphere < 0) sphere = 0;
      cut(ring, sphere);
    }
    corners_ = {};
  }

  // The quality of a triangle's orientation relative to its sphere (1: equal to the direction of its corners).
  double facing(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t sphere) const {
    const Vec3 &p = out_.vertices[std::size_t(a)], &q = out_.vertices[std::size_t(b)],
               &r = out_.vertices[std::size_t(c)];
    const Vec3 normal = glm::cross(q - p, r - p),
               out = (p + q + r) / 3.0 - (scene_[std::size_t(sphere)].centre_A - origin_);
    const double size = glm::length(normal) * glm::length(out);
    return size > 1e-30 ? glm::dot(normal, out) / size : -1.0;
  }

  void cut(const std::vector<std::int32_t>& ring, std::int32_t sphere) {
    // A fan from the corner that gives the best value for the worst triangle.
    std::size_t from = 0;
    double best = -2.0;
    const std::size_t n = ring.size();
    for (std::size_t start = 0; start < (n == 4 ? 2 : n); ++start) {
      double worst = 2.0;
      for (std::size_t k = 1; k + 1 < n; ++k)
        worst = std::min(worst, facing(ring[start], ring[(start + k) % n], ring[(start + k + 1) % n], sphere));
      if (worst > best) best = worst, from = start;
    }
    for (std::size_t k = 1; k + 1 < n; ++k)
      out_.triangles.push_back({{ring[from], ring[(from + k) % n], ring[(from + k + 1) % n]}, sphere});
  }

  // Where creases are closer than a cell, one vertex cannot lie on all of them, and its triangles block the SCP or
  // overlap. Such a vertex is moved to where the worst of its triangles is best, inside the cell or outside.
  void mend() {
    std::vector<std::int32_t> begin(out_.vertices.size() + 1, 0), star(3 * out_.triangles.size());
    for (const auto& t : out_.triangles)
      for (const std::int32_t v : t.corners) ++begin[std::size_t(v) + 1];
    for (std::size_t v = 0; v + 1 < begin.size(); ++v) begin[v + 1] += begin[v];
    std::vector<std::int32_t> fill(begin.begin(), begin.end() - 1);
    for (std::size_t k = 0; k < out_.triangles.size(); ++k)
      for (const std::int32_t v : out_.triangles[k].corners)
        star[std::size_t(fill[std::size_t(v)]++)] = std::int32_t(k);
    for (int pass = 0; pass < kMendings; ++pass)
      for (std::size_t v = 0; v < out_.vertices.size(); ++v)
        mend(v, {star.data() + begin[v], std::size_t(begin[v + 1] - begin[v])});
  }

  // The error of a vertex at its present position: the larger of its distance from its triangles' spheres and their
  // misorientation.
  double badness(std::size_t v, std::span<const std::int32_t> star) const {
    const Vec3& x = out_.vertices[v];
    double worst = 0.0;
    for (const std::int32_t k : star) {
      const auto& t = out_.triangles[std::size_t(k)];
      for (const std::int32_t c : t.corners)  // no two vertices at one point
        if (std::size_t(c) != v && glm::distance(x, out_.vertices[std::size_t(c)]) < kInset * h_) return 1e3;
      const Sphere& b = scene_[std::size_t(t.sphere)];
      const double off = glm::distance(x, b.centre_A - origin_) - b.radius_A - probe_;
      worst = std::max({worst, (off > 0.0 ? 1.0 : -kDent) * off / h_,
                        0.5 * (1.0 - facing(t.corners[0], t.corners[1], t.corners[2], t.sphere))});
    }
    return worst;
  }

  void mend(std::size_t v, std::span<const std::int32_t> star) {
    double smallest = badness(v, star);
    if (smallest < kBad) return;
    const Vec3 was = out_.vertices[v];
    Vec3 best = was, middle(0.0);
    near_.clear();
    std::array<int, 16> all;
    for (const std::int32_t k : star) {
      const auto& t = out_.triangles[std::size_t(k)];
      for (const std::int32_t c : t.corners)
        middle += out_.vertices[std::size_t(c)] * (std::size_t(c) == v ? 0.0 : 0.5 / double(star.size()));
      const Sphere& b = scene_[std::size_t(t.sphere)];
      if (near_.size() < all.size() &&
          std::none_of(near_.begin(), near_.end(), [&](const Inflated& there) { return there.index == t.sphere; }))
        near_.push_back({b.centre_A - origin_, b.radius_A + probe_, t.sphere});
    }
    const auto attempt = [&](std::span<const int> of) {
      for (const Vec3& from : {was, middle}) {
        out_.vertices[v] = bestOn(of, from, middle - Vec3(1.5 * h_), middle + Vec3(1.5 * h_));
        if (const double bad = badness(v, star); bad < smallest) smallest = bad, best = out_.vertices[v];
      }
    };
    const int n = std::min(int(near_.size()), 6);
    for (int k = 0; k < n; ++k) all[std::size_t(k)] = k;
    attempt({all.data(), std::size_t(n)});
    for (int i = 0; i < n; ++i) {
      attempt(std::array{i});
      for (int j = i + 1; j < n; ++j) {
        attempt(std::array{i, j});
        for (int k = j + 1; k < n; ++k) attempt(std::array{i, j, k});
      }
    }
    out_.vertices[v] = best;
  }

  const SphereGrid& scene_;
  double probe_, h_;
  Vec3 origin_, zero_{0.0};
  std::array<std::int64_t, 3> first_{};  // the block's first node
  std::vector<Inflated> near_;
  std::array<bool, kNodes * kNodes * kNodes> inside_{};
  std::vector<Corner> corners_;
  UnionSurface out_;
};

}  // namespace

UnionSurface unionSurface(const SphereGrid& scene, double probe_A, double spacing_A, const Vec3& origin) {
  const Vec3 wide = scene.high_A() - scene.low_A();
  const double widest = std::max({wide.x, wide.y, wide.z}) + 2.0 * probe_A;
  return Maker(scene, probe_A, std::max(spacing_A, widest / double(kHalf)), origin).make();
}

}  // namespace moltact
