// Parts without graphics: names of shapes, ambient occlusion, the molecular surface, PNG files. Oracles: closed forms.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "engine/render/ambient_occlusion.h"
#include "engine/render/picture.h"
#include "engine/render/solvent_excluded.h"
#include "engine/render/view_scene.h"

using namespace moltact;

TEST_CASE("every shape is switched by its own name, and 'haptic' is the group of the seven haptic ones") {
  for (const ViewPartInfo& s : viewParts()) {
    const auto set = parseViewParts(s.name);
    REQUIRE(bool(set));
    for (const ViewPartInfo& other : viewParts()) CHECK(set->has(other.part) == (other.part == s.part));
  }
  const auto haptic = parseViewParts("haptic");
  int count = 0;
  for (const ViewPartInfo& s : viewParts()) {
    CHECK(haptic->has(s.part) == s.haptic);
    count += s.haptic;
  }
  CHECK(count == 7);
}

TEST_CASE("an unknown shape names the known ones") {
  const auto set = parseViewParts("atoms,conez");
  REQUIRE_FALSE(bool(set));
  CHECK(set.problem().text().find("conez") != std::string::npos);
  CHECK(set.problem().text().find("circles, points, cones") != std::string::npos);
}

TEST_CASE(
    "a sphere alone has full light; of a block of 1000 the top of an atom has more than the crease between two, and a "
    "face in a pit 6 A wide and 10 A deep less than half of the outside's") {
  const Vec3 up(0, 0, 1);
  CHECK(occlusionField(std::vector<Sphere>{{Vec3(0), 1.7}}).open(1.7 * up, up) == 1.0);
  std::vector<Sphere> block;
  const auto inPit = [](int x, int y, int z) { return x >= 4 && x < 7 && y >= 4 && y < 7 && z >= 6; };
  for (int x = 0; x < 11; ++x)
    for (int y = 0; y < 11; ++y)
      for (int z = 0; z < 11; ++z)
        if (!inPit(x, y, z)) block.push_back({2.2 * Vec3(x, y, z), 1.7});
  const OcclusionField light = occlusionField(block);
  const auto over = [&](double x, double y, double z) { return light.open(2.2 * Vec3(x, y, z) + 1.7 * up, up); };
  const double top = over(2, 2, 10), pit = over(5, 5, 5);
  const double crease_z = std::sqrt(1.7 * 1.7 - 1.1 * 1.1);
  const double crease = light.open(2.2 * Vec3(2.5, 2, 10) + crease_z * up, glm::normalize(Vec3(1.1, 0, crease_z)));
  CHECK(crease < 0.9 * top);
  CHECK(pit < 0.5 * top);
}

TEST_CASE("two spheres 2 million A apart are lit without a field of that size") {
  const OcclusionField light = occlusionField(std::vector<Sphere>{{Vec3(-1e6, 0, 0), 1.7}, {Vec3(1e6, 0, 0), 1.7}});
  CHECK(light.open(Vec3(1e6, 0, 1.7), Vec3(0, 0, 1)) == 1.0);
  CHECK(light.wide.filled.size() < 200 * 200 * 200);
}

TEST_CASE("a picture of 5 x 3 pixels comes back from its PNG file byte for byte") {
  Picture picture{5, 3, {}};
  for (int i = 0; i < 45; ++i) picture.rgb.push_back(std::uint8_t(i * 5));
  const auto file = std::filesystem::temp_directory_path() / "moltact-picture-test.png";
  const auto problem = writePng(file, picture);
  CHECK_FALSE(problem);
  const auto back = readPng(file);
  REQUIRE(bool(back));
  CHECK(back->width_px == 5);
  CHECK(back->rgb == picture.rgb);
  std::filesystem::remove(file);
}

TEST_CASE("a PNG in a folder that is not there, and one that is no PNG, give problems that name the file") {
  const auto problem = writePng("/no/such/folder/a.png", Picture{1, 1, {0, 0, 0}});
  REQUIRE(problem);
  CHECK(problem->text().find("/no/such/folder/a.png") != std::string::npos);
  const auto file = std::filesystem::temp_directory_path() / "moltact-not-a-picture.png";
  std::ofstream(file) << "not a picture";
  CHECK_FALSE(bool(readPng(file)));
  std::filesystem::remove(file);
}

namespace {

double volume_A3(const MeshPiece& piece) {
  double six = 0;
  for (std::size_t k = 0; k < piece.indices.size(); k += 3) {
    const auto at = [&](std::size_t c) { return Vec3(piece.vertices[piece.indices[k + c]].place); };
    six += glm::dot(at(0), glm::cross(at(1), at(2)));
  }
  return six / 6;
}

bool closed(const MeshPiece& piece) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t k = 0; k < piece.indices.size(); k += 3)
    for (std::size_t c = 0; c < 3; ++c) ++edges[{piece.indices[k + c], piece.indices[k + (c + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (back == edges.end() || back->second != count) return false;
  }
  return !edges.empty();
}

}  // namespace

TEST_CASE(
    "the molecular surface of one sphere is the sphere: closed, places within 0.06 A, normals outward, and a little "
    "smaller for its flat faces") {
  const Vec3 centre(1.23, -4.5, 0.77);
  for (const double radius : {1.2, 1.7, 3.1}) {
    const SolventExcluded made = solventExcluded(std::vector<Sphere>{{centre, radius}}, 1.4);
    REQUIRE(made.piece.vertices.size() > 20);
    double worst = 0, least_facing = 1;
    for (const MeshPiece::Vertex& v : made.piece.vertices) {
      const Vec3 out = made.piece.origin_A + Vec3(v.place) - centre;
      worst = std::max(worst, std::abs(glm::length(out) - radius));
      least_facing = std::min(least_facing, glm::dot(glm::normalize(out), Vec3(v.normal)));
    }
    CAPTURE(radius);
    CHECK(worst < 0.06);
    CHECK(least_facing > 0.97);
    CHECK(closed(made.piece));
    const double share = volume_A3(made.piece) / (4.18879 * radius * radius * radius);
    CHECK(share > 0.8);
    CHECK(share < 1.0);
  }
}

TEST_CASE(
    "between two spheres of radius r, 2 a apart, the surface has a neck of radius sqrt((r + p)^2 - a^2) - p, where the "
    "probe cannot pass, to within 0.06 A") {
  constexpr double kRadius_A = 1.7, kHalf_A = 2.0, kProbe_A = 1.4;
  const std::vector<Sphere> pair{{Vec3(-kHalf_A, 0, 0), kRadius_A}, {Vec3(kHalf_A, 0, 0), kRadius_A}};
  const SolventExcluded made = solventExcluded(pair, kProbe_A);
  const double neck_A = std::sqrt(std::pow(kRadius_A + kProbe_A, 2) - kHalf_A * kHalf_A) - kProbe_A;
  int at_neck = 0;
  for (std::size_t k = 0; k < made.piece.vertices.size(); ++k) {
    const Vec3 p = made.piece.origin_A + Vec3(made.piece.vertices[k].place);
    CHECK(made.owner[k] == (p.x < 0 ? 0u : 1u));
    if (std::abs(p.x) > 0.3) continue;
    // A circle of the probe's radius round the place of its middle.
    const double across = std::hypot(p.y, p.z),
                 expected = neck_A + kProbe_A - std::sqrt(kProbe_A * kProbe_A - p.x * p.x);
    CHECK(std::abs(across - expected) < 0.06);
    ++at_neck;
  }
  CHECK(at_neck >= 6);
  CHECK(closed(made.piece));
}

TEST_CASE(
    "no place of the molecular surface of 200 spheres lies deeper than 0.06 A in a sphere, or farther out than a probe "
    "reaches") {
  std::vector<Sphere> spheres;
  unsigned seed = 11;
  const auto next = [&] { return double((seed = seed * 1664525u + 1013904223u) >> 8) / double(1 << 24); };
  for (int k = 0; k < 200; ++k) spheres.push_back({14.0 * Vec3(next(), next(), next()), 1.2 + 0.6 * next()});
  const SolventExcluded made = solventExcluded(spheres, 1.4);
  REQUIRE(made.piece.vertices.size() > 500);
  double deepest = 0;
  for (const MeshPiece::Vertex& v : made.piece.vertices) {
    const Vec3 p = made.piece.origin_A + Vec3(v.place);
    double gap = 1e9;
    for (const Sphere& b : spheres) gap = std::min(gap, glm::length(p - b.centre_A) - b.radius_A);
    deepest = std::min(deepest, gap);
    CHECK(gap < 1.4);
  }
  CHECK(deepest > -0.06);
}

TEST_CASE(
    "the surface of one atom is its sphere to 0.05 A for a probe of 20 A, and of two atoms its neck is the probe's") {
  const std::vector<Sphere> one{{Vec3(0.0), 1.7}};
  const SolventExcluded alone = solventExcluded(one, 20.0);
  REQUIRE(alone.piece.vertices.size() > 50);
  CHECK(alone.step_A == 0.5);
  for (const MeshPiece::Vertex& v : alone.piece.vertices)
    CHECK(std::abs(glm::length(alone.piece.origin_A + Vec3(v.place)) - 1.7) < 0.05);
  CHECK(closed(alone.piece));
  // Two atoms 6 A apart: in the middle the probe of 20 A stands off the axis by R sin a and reaches in by its radius.
  const std::vector<Sphere> two{{Vec3(-3, 0, 0), 1.7}, {Vec3(3, 0, 0), 1.7}};
  const SolventExcluded pair = solventExcluded(two, 20.0);
  const double neck_A = std::sqrt(21.7 * 21.7 - 9.0) - 20.0;
  std::size_t at_neck = 0;
  for (const MeshPiece::Vertex& v : pair.piece.vertices) {
    const Vec3 p = pair.piece.origin_A + Vec3(v.place);
    if (std::abs(p.x) > 0.3) continue;
    ++at_neck;
    CHECK(std::hypot(p.y, p.z) == doctest::Approx(neck_A).epsilon(0.03));
  }
  CHECK(at_neck >= 6);
}

TEST_CASE("a surface that is no longer needed is empty; the progress of one that is needed grows to 1") {
  const std::vector<Sphere> spheres{{Vec3(0.0), 1.7}, {Vec3(3, 0, 0), 1.5}};
  SurfaceProgress progress;
  CHECK_FALSE(solventExcluded(spheres, 1.4, &progress).piece.vertices.empty());
  CHECK(progress.share > 0.95f);
  progress.cancelled = true;
  CHECK(solventExcluded(spheres, 1.4, &progress).piece.vertices.empty());
}

TEST_CASE(
    "where grown spheres would hold too many nodes together the grid is coarser: 216 spheres, probe 20 A, 16 million "
    "nodes") {
  std::vector<Sphere> spheres;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      for (int z = 0; z < 6; ++z) spheres.push_back({2.0 * Vec3(x, y, z), 1.7});
  const SolventExcluded made = solventExcluded(spheres, 20.0, nullptr, 1.6e7);
  CHECK(made.step_A == doctest::Approx(std::cbrt(216.0 * std::pow(2 * 21.7, 3.0) / 1.6e7)));
  CHECK(closed(made.piece));
}
