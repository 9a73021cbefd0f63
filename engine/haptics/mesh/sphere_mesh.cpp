#include "engine/haptics/mesh/sphere_mesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>

#include "engine/haptics/mesh/path_in_box.h"

namespace moltact {
namespace {

constexpr double kEdge = 1e-9;  // tolerance outside a triangle, so that there is no gap between two triangles
constexpr std::int32_t kLeaf = 4;

}  // namespace

std::shared_ptr<const SphereMesh> SphereMesh::ofTriangles(int count) {
  static std::mutex mutex;
  static std::map<int, std::shared_ptr<const SphereMesh>> made;
  const std::lock_guard lock(mutex);
  auto& one = made[count];
  if (!one) one.reset(new SphereMesh(count));
  return one;
}

SphereMesh::SphereMesh(int count) {
  if (count == 960) {
    makeBands(16, 32);
  } else {
    assert(count == 80 || count == 320 || count == 1280 || count == 5120);
    subdivide(count == 80 ? 1 : count == 320 ? 2 : count == 1280 ? 3 : 4);
  }
  assert(faces_.size() == std::size_t(count));
  finish();
}

void SphereMesh::addFace(std::int32_t a, std::int32_t b, std::int32_t c) { faces_.emplace_back().corners = {a, b, c}; }

void SphereMesh::subdivide(int levels) {
  const double g = std::numbers::phi;
  for (const Vec3& v :
       {Vec3(-1, g, 0), Vec3(1, g, 0), Vec3(-1, -g, 0), Vec3(1, -g, 0), Vec3(0, -1, g), Vec3(0, 1, g), Vec3(0, -1, -g),
        Vec3(0, 1, -g), Vec3(g, 0, -1), Vec3(g, 0, 1), Vec3(-g, 0, -1), Vec3(-g, 0, 1)})
    vertices_.push_back(glm::normalize(v));
  // Three vertices at the smallest mutual distance form a face; the order of the last two determines its orientation.
  std::vector<std::array<std::int32_t, 3>> triangles;
  const auto near = [&](int a, int b) { return glm::dot(vertices_[std::size_t(a)], vertices_[std::size_t(b)]) > 0.4; };
  for (int a = 0; a < 12; ++a)
    for (int b = a + 1; b < 12; ++b)
      for (int c = b + 1; c < 12; ++c) {
        if (!near(a, b) || !near(b, c) || !near(a, c)) continue;
        const Vec3 &p = vertices_[std::size_t(a)], &q = vertices_[std::size_t(b)], &r = vertices_[std::size_t(c)];
        if (glm::dot(glm::cross(q - p, r - p), p) > 0)
          triangles.push_back({a, b, c});
        else
          triangles.push_back({a, c, b});
      }
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
    const auto middle = [&](std::int32_t a, std::int32_t b) {
      const auto [at, fresh] = middles.try_emplace(std::minmax(a, b), std::int32_t(vertices_.size()));
      if (fresh) vertices_.push_back(glm::normalize(vertices_[std::size_t(a)] + vertices_[std::size_t(b)]));
      return at->second;
    };
    std::vector<std::array<std::int32_t, 3>> finer;
    for (const auto& [a, b, c] : triangles) {
      const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  for (const auto& [a, b, c] : triangles) addFace(a, b, c);
}

void SphereMesh::makeBands(int bands, int sectors) {
  const double pi = std::numbers::pi;
  vertices_.push_back({0, 0, 1});
  for (int b = 1; b < bands; ++b)
    for (int s = 0; s < sectors; ++s) {
      const double theta = pi * b / bands, azimuth = kTwoPi * s / sectors;
      vertices_.push_back({std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), std::cos(theta)});
    }
  const auto south = std::int32_t(vertices_.size());
  vertices_.push_back({0, 0, -1});
  const auto at = [&](int b, int s) { return std::int32_t(1 + (b - 1) * sectors + s % sectors); };
  for (int s = 0; s < sectors; ++s) {
    addFace(0, at(1, s), at(1, s + 1));
    for (int b = 1; b + 1 < bands; ++b) {
      addFace(at(b, s), at(b + 1, s), at(b + 1, s + 1));
      addFace(at(b, s), at(b + 1, s + 1), at(b, s + 1));
    }
    addFace(at(bands - 1, s), south, at(bands - 1, s + 1));
  }
}

void SphereMesh::finish() {
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> face_of_edge;
  double smallest = 1.0;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    Face& face = faces_[f];
    const auto corner = [&](std::size_t k) -> const Vec3& { return vertices_[std::size_t(face.corners[k % 3])]; };
    face.normal = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    face.height =
        (glm::dot(face.normal, corner(0)) + glm::dot(face.normal, corner(1)) + glm::dot(face.normal, corner(2))) / 3.0;
    assert(face.height > 0);
    for (std::size_t k = 0; k < 3; ++k) {
      face.out[k] = glm::normalize(glm::cross(corner(k + 1) - corner(k), face.normal));
      face.reach[k] = glm::dot(face.out[k], corner(k));
      face_of_edge[{face.corners[k], face.corners[(k + 1) % 3]}] = std::int32_t(f);
      tilt_ = std::max(tilt_, std::acos(std::min(1.0, glm::dot(face.normal, corner(k)))));
    }
    smallest = std::min(smallest, face.height);
    leaves_.push_back(std::int32_t(f));
  }
  for (Face& face : faces_)
    for (std::size_t k = 0; k < 3; ++k) face.across[k] = face_of_edge.at({face.corners[(k + 1) % 3], face.corners[k]});
  sagitta_ = 1.0 - smallest;
  nodes_.reserve(faces_.size());
  makeNode(0, std::int32_t(faces_.size()));
  about_.resize(6 * kTable * kTable);
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      for (int u = 0; u < kTable; ++u)
        for (int v = 0; v < kTable; ++v) {
          Vec3 d(0.0);
          d[axis] = side ? 1.0 : -1.0;
          d[(axis + 1) % 3] = (2 * u + 1.0) / kTable - 1.0;
          d[(axis + 2) % 3] = (2 * v + 1.0) / kTable - 1.0;
          about_[std::size_t(((2 * axis + side) * kTable + u) * kTable + v)] = faceToward(d);
        }
}

std::int32_t SphereMesh::faceAbout(const Vec3& direction) const noexcept {
  const Vec3 a = glm::abs(direction);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  const double far = a[axis];
  if (!(far > 0.0)) return 0;
  const auto cell = [&](int k) { return std::min(kTable - 1, int((direction[k % 3] / far + 1.0) * (0.5 * kTable))); };
  return about_[std::size_t(((2 * axis + (direction[axis] > 0.0)) * kTable + cell(axis + 1)) * kTable +
                            cell(axis + 2))];
}

std::int32_t SphereMesh::makeNode(std::int32_t first, std::int32_t count) {
  const auto at = std::int32_t(nodes_.size());
  Node node{Vec3(2.0), Vec3(-2.0), first, count};
  for (std::int32_t k = first; k < first + count; ++k)
    for (const std::int32_t v : faces_[std::size_t(leaves_[std::size_t(k)])].corners) {
      node.low = glm::min(node.low, vertices_[std::size_t(v)] - Vec3(kEdge));
      node.high = glm::max(node.high, vertices_[std::size_t(v)] + Vec3(kEdge));
    }
  nodes_.push_back(node);
  if (count <= kLeaf) return at;
  const Vec3 size = node.high - node.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto middle = [&](std::int32_t f) {
    const auto& c = faces_[std::size_t(f)].corners;
    return vertices_[std::size_t(c[0])][axis] + vertices_[std::size_t(c[1])][axis] + vertices_[std::size_t(c[2])][axis];
  };
  const auto begin = leaves_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](std::int32_t a, std::int32_t b) {
    const double x = middle(a), y = middle(b);
    return x < y || (x == y && a < b);
  });
  makeNode(first, count / 2);
  const std::int32_t right = makeNode(first + count / 2, count - count / 2);
  nodes_[std::size_t(at)].first = right;
  nodes_[std::size_t(at)].count = 0;
  return at;
}

std::size_t SphereMesh::bytes() const {
  return sizeof(*this) + vertices_.capacity() * sizeof(Vec3) + faces_.capacity() * sizeof(Face) +
         nodes_.capacity() * sizeof(Node) + (leaves_.capacity() + about_.capacity()) * sizeof(std::int32_t);
}

SphereMesh::Entry SphereMesh::enter(const Vec3& from, const Vec3& path, double before) const noexcept {
  Entry best{before, -1};
  const Vec3 per_path = 1.0 / path;
  std::int32_t stack[32];
  int waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const std::int32_t at = stack[--waiting];
    const Node& node = nodes_[std::size_t(at)];
    if (!pathMeetsBox(from, path, per_path, node.low, node.high, best.t)) continue;
    if (node.count == 0) {
      stack[waiting++] = node.first;
      stack[waiting++] = at + 1;
      continue;
    }
    for (std::int32_t k = node.first; k < node.first + node.count; ++k) {
      const std::int32_t f = leaves_[std::size_t(k)];
      const Face& face = faces_[std::size_t(f)];
      const double falls = -glm::dot(face.normal, path);
      if (!(falls > 0.0)) continue;
      const double above = glm::dot(face.normal, from) - face.height;
      if (above < -kSkin) continue;
      const double t = above <= kSkin ? 0.0 : above / falls;
      if (t >= best.t) continue;
      const Vec3 x = from + path * t;
      if (glm::dot(face.out[0], x) <= face.reach[0] + kEdge && glm::dot(face.out[1], x) <= face.reach[1] + kEdge &&
          glm::dot(face.out[2], x) <= face.reach[2] + kEdge)
        best = {t, f};
    }
  }
  return best;
}

std::int32_t SphereMesh::faceToward(const Vec3& direction) const noexcept {
  const Entry inward =
      enter(direction * (2.0 / glm::length(direction)), direction * (-2.0 / glm::length(direction)), 1.0);
  return std::max(inward.face, 0);
}

}  // namespace moltact
