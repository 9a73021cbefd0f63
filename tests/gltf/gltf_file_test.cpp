// Files that the program writes are read back by tinygltf through our reader, which checks every range itself.
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>

#include "engine/molecule/reader.h"
#include "engine/platform/folders.h"
#include "engine/render/atom_style.h"
#include "engine/render/gltf_export.h"

using namespace moltact;
namespace fs = std::filesystem;

namespace {

struct Scratch {
  fs::path folder = fs::temp_directory_path() / ("moltact_gltf_" + std::to_string(getpid()));
  Scratch() { fs::create_directories(folder); }
  ~Scratch() { fs::remove_all(folder); }
};

Molecule library(const char* name) {
  auto m = readMolecule(moleculesFolder() / name);
  if (!m) FAIL(m.problem().text());
  return *std::move(m);
}

GltfScene exported(const Molecule& m, const ExportOptions& options) {
  auto scene = exportMolecule(m, options);
  if (!scene) FAIL(scene.problem().text());
  return *std::move(scene);
}

SolidModel writtenAndRead(const fs::path& file, const GltfScene& scene) {
  if (const auto problem = writeGlb(file, scene)) FAIL(problem->text());
  auto model = readGltf(file);
  if (!model) FAIL(model.problem().text());
  return *std::move(model);
}

std::string bytesOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("water as spheres reads back as 3 x 1280 triangles, 0.3152 nm wide in x, red and white, in nanometres") {
  const Scratch scratch;
  const Molecule water = library("water.pdb");
  REQUIRE(water.atoms.size() == 3);
  const SolidModel model = writtenAndRead(scratch.folder / "water.glb", exported(water, {}));
  CHECK(model.corners.size() == 3 * 3 * 1280);
  Vec3 low(1e9), high(-1e9);
  for (const Sphere& a : water.spheres) {
    low = glm::min(low, a.centre_A - a.radius_A);
    high = glm::max(high, a.centre_A + a.radius_A);
  }
  for (int k = 0; k < 3; ++k) {
    // The corners lie on the sphere, but none exactly at its side: 1 part in 200 of a radius of 0.17 nm.
    CHECK(std::abs(double(model.low[k]) + 0.05 * (high[k] - low[k])) < 0.001);
    CHECK(std::abs(double(model.high[k]) - 0.05 * (high[k] - low[k])) < 0.001);
  }
  std::size_t red = 0, white = 0;
  for (const auto& c : model.corners) {
    red += glm::distance(c.colour, elementColour(8)) < 4e-3f;
    white += glm::distance(c.colour, elementColour(1)) < 4e-3f;
    CHECK(glm::length(c.normal) == doctest::Approx(1.0).epsilon(1e-4));
  }
  CHECK(red == 3 * 1280);
  CHECK(white == 2 * 3 * 1280);
  const SolidModel tenfold = writtenAndRead(scratch.folder / "large.glb", exported(water, {.units_per_nm = 10}));
  CHECK(tenfold.high.x == doctest::Approx(10 * model.high.x).epsilon(1e-5));
}

TEST_CASE(
    "benzene as a surface inflated by 1.4 A reads back with the size of its inflated spheres to 1 step, in two "
    "colours") {
  const Scratch scratch;
  const Molecule benzene = library("benzene.pdb");
  const ExportOptions options{.print = true, .probe_A = 1.4, .step_A = 0.25};
  const SolidModel model = writtenAndRead(scratch.folder / "benzene.glb", exported(benzene, options));
  Vec3 low(1e9), high(-1e9);
  for (const Sphere& a : benzene.spheres) {
    low = glm::min(low, a.centre_A - a.radius_A - 1.4);
    high = glm::max(high, a.centre_A + a.radius_A + 1.4);
  }
  for (int k = 0; k < 3; ++k) {
    CHECK(double(model.high[k]) <= 0.05 * (high[k] - low[k]) + 1e-6);
    CHECK(double(model.high[k]) >= 0.05 * (high[k] - low[k]) - 0.025);
  }
  std::size_t grey = 0, white = 0;
  for (const auto& c : model.corners) {
    grey += glm::distance(c.colour, elementColour(6)) < 4e-3f;
    white += glm::distance(c.colour, elementColour(1)) < 4e-3f;
  }
  CHECK(grey > 300);
  CHECK(white > 300);
  CHECK(grey + white == model.corners.size());
}

TEST_CASE(
    "a protein of 602 atoms as spheres stores its sphere once: a file below 400 kB with a node for each atom and "
    "chain") {
  const Scratch scratch;
  const GltfScene scene = exported(library("1ubq.pdb"), {});
  CHECK(scene.nodes.size() == 602 + 1 + 1);
  CHECK(scene.nodes.back().name.find(" of ") != std::string::npos);
  REQUIRE_FALSE(writeGlb(scratch.folder / "p.glb", scene));
  CHECK(fs::file_size(scratch.folder / "p.glb") < 400000);
  // 770 000 triangles: too many for a model in the view, which is reported.
  CHECK(readGltf(scratch.folder / "p.glb").problem().text().find("more than 50000 triangles") != std::string::npos);
}

TEST_CASE(
    "a helix as cartoon, sticks or its solvent-excluded surface is saved with the shapes of the picture: within the "
    "atoms' "
    "reach, in the chain's colour; a faint style blends, hidden atoms are not there, and several styles stand "
    "together") {
  const Scratch scratch;
  const Molecule helix = library("alpha-helix.pdb");
  const auto list = [](std::vector<std::uint32_t> atoms) {
    return std::make_shared<const std::vector<std::uint32_t>>(std::move(atoms));
  };
  for (const DrawStyle style : {DrawStyle::Cartoon, DrawStyle::Sticks, DrawStyle::Surface}) {
    CAPTURE(nameOf(style));
    ExportOptions options{.colour_by = ColourBy::Chain};
    options.look.styles = {{.style = style, .atoms = nullptr, .opacity = 0.5f}};
    GltfScene scene = exported(helix, options);
    REQUIRE(scene.materials.size() == 1);
    CHECK(scene.materials[0].opacity == 0.5f);
    CHECK(glm::distance(scene.materials[0].colour, chainColour(0)) < 0.003f);
    REQUIRE(scene.nodes.size() > 1);
    std::erase_if(scene.nodes, [&](const GltfNode& n) { return n.name.find(" of ") != std::string::npos; });  // spheres
    const SolidModel model = writtenAndRead(scratch.folder / "helix.glb", scene);
    CHECK(model.corners.size() > 1000);
    // The helix is 20 residues of 1.5 A long; its middle is the origin, and 1 unit is 1 nm.
    const double longest =
        double(std::max({model.high.x - model.low.x, model.high.y - model.low.y, model.high.z - model.low.z}));
    CHECK(longest > 2.4);
    CHECK(longest < 3.6);
  }
  ExportOptions both;
  both.look.styles = {{.style = DrawStyle::Cartoon}, {.style = DrawStyle::Spheres, .atoms = list({0, 1, 2, 3})}};
  both.look.hidden = list({1});
  const GltfScene scene = exported(helix, both);
  const auto spheres = std::count_if(scene.nodes.begin(), scene.nodes.end(),
                                     [](const GltfNode& n) { return n.name.find(" of ") != std::string::npos; });
  CHECK(spheres == 3);
  std::vector<std::uint32_t> all;
  for (std::uint32_t a = 0; a < helix.atoms.size(); ++a) all.push_back(a);
  both.look.hidden = list(all);
  CHECK(exportMolecule(helix, both).problem().text() == "all atoms are hidden; show some of them");
}

TEST_CASE(
    "a hydrogen bond of 2.9 A is saved as six dashes of 0.32 A with gaps of 0.22 A between its atoms, a measure bears "
    "its "
    "value, and what is highlighted has the colour of targets; none of the lines is printed") {
  const Scratch scratch;
  const Molecule water = library("water.pdb");
  Annotations written;
  written.bonds = {{{Vec3(0, 0, 0)}, {Vec3(2.9, 0, 0)}}};
  written.measures = {{.places = {{Vec3(0, 5, 0)}, {Vec3(1.0, 5, 0)}}, .text = "1.00 A"}};
  ExportOptions options{.annotations = {std::make_shared<const Annotations>(written)}, .highlighted = {0}};
  const GltfScene scene = exported(water, options);
  const auto named = [&](std::string_view name) -> const GltfMesh& {
    const auto node =
        std::find_if(scene.nodes.begin(), scene.nodes.end(), [&](const GltfNode& n) { return n.name == name; });
    REQUIRE(node != scene.nodes.end());
    return scene.meshes[node->mesh];
  };
  Vec3 low(1e9), high(-1e9);
  for (const Sphere& a : water.spheres) {
    low = glm::min(low, a.centre_A - a.radius_A);
    high = glm::max(high, a.centre_A + a.radius_A);
  }
  const Vec3 middle = 0.5 * (low + high);
  const GltfMesh& bond = named("hydrogen bonds");
  double least = 1e9, most = -1e9;
  for (const glm::vec3& p : bond.places) {
    const double x = 10.0 * double(p.x) + middle.x;
    least = std::min(least, x);
    most = std::max(most, x);
  }
  CHECK(least == doctest::Approx(0.0).epsilon(1e-4));
  CHECK(most == doctest::Approx(2.9).epsilon(1e-4));
  std::vector<double> begins;
  for (const GltfPart& part : bond.parts)
    for (const std::uint32_t i : part.indices) {
      const double x = 10.0 * double(bond.places[i].x) + middle.x;
      if (std::none_of(begins.begin(), begins.end(), [&](double b) { return std::abs(b - x) < 0.01; }))
        begins.push_back(x);
    }
  std::sort(begins.begin(), begins.end());
  REQUIRE(begins.size() == 12);
  for (std::size_t k = 0; k < 6; ++k) {
    CHECK(begins[2 * k] == doctest::Approx(0.54 * double(k)).epsilon(1e-3));
    CHECK(begins[2 * k + 1] == doctest::Approx(std::min(2.9, 0.54 * double(k) + 0.32)).epsilon(1e-3));
  }
  CHECK(named("1.00 A").places.size() > 20);
  const std::uint32_t orange = 0x005AFFu;
  std::size_t targets = 0;
  for (const GltfMaterial& m : scene.materials)
    targets += glm::distance(m.colour, glm::vec3(orange & 255u, orange >> 8 & 255u, orange >> 16) / 255.0f) < 0.005f;
  CHECK(targets == 1);
  options.print = true;
  for (const GltfNode& node : exported(water, options).nodes) CHECK(node.name != "hydrogen bonds");
}

TEST_CASE("no atoms, too fine a surface, a folder that is not there: each is reported with its remedy") {
  CHECK(exportMolecule({}, {}).problem().text().find("no atoms") != std::string::npos);
  const auto fine = exportMolecule(library("1ubq.pdb"), {.print = true, .step_A = 0.01});
  REQUIRE_FALSE(bool(fine));
  CHECK(fine.problem().remedy.find("coarser") != std::string::npos);
  CHECK(writeGlb("/no/such/folder/x.glb", exported(library("water.pdb"), {}))
            .value()
            .text()
            .find("its folder is not there") != std::string::npos);
}

TEST_CASE(
    "a missing file, an empty one, plain text, JSON that is no glTF and one without triangles are "
    "reported, not drawn") {
  const Scratch scratch;
  const auto reported = [&](const std::string& bytes) {
    const fs::path file = scratch.folder / "bad.gltf";
    std::ofstream(file, std::ios::binary) << bytes;
    const auto model = readGltf(file);
    REQUIRE_FALSE(bool(model));
    CHECK(model.problem().file == file.string());
    return model.problem().text();
  };
  CHECK(readGltf(scratch.folder / "none.glb").problem().text().find("cannot be read") != std::string::npos);
  CHECK(reported("").find("no sound glTF") != std::string::npos);
  CHECK(reported("a pen").find("no sound glTF") != std::string::npos);
  CHECK(reported("[1, 2]").find("no sound glTF") != std::string::npos);
  CHECK(reported(R"({"asset": {"version": "2.0"}})").find("has no scene") != std::string::npos);
  CHECK(reported(R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{}]})")
            .find("holds no triangles") != std::string::npos);
  CHECK(reported(R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"children": [0]}]})")
            .find("without end") != std::string::npos);
  CHECK(reported(R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [7]}], "nodes": [{}]})").find("names a node") !=
        std::string::npos);
}

TEST_CASE("a good file with 1 to 4 bytes changed at random, or cut short, never ends the program; 400 files, seed 5") {
  const Scratch scratch;
  const fs::path file = scratch.folder / "m.glb";
  GltfScene scene;
  scene.materials = {{"red", {1, 0, 0}}};
  scene.meshes = {{.name = "t",
                   .places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                   .normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                   .parts = {{.indices = {0, 1, 2}, .material = 0}}}};
  scene.nodes = {{.name = "n", .mesh = 0, .place = {2, 0, 0}, .scale = 3}};
  REQUIRE_FALSE(writeGlb(file, scene));
  const auto whole = readGltf(file);
  REQUIRE(bool(whole));
  CHECK(whole->high == glm::vec3(5, 3, 0));
  const std::string good = bytesOf(file);
  std::mt19937 random(5);
  int refused = 0;
  for (int round = 0; round < 400; ++round) {
    std::string bad = good;
    if (round % 4 == 0)
      bad.resize(random() % good.size());
    else
      for (unsigned k = 0; k <= random() % 4; ++k) bad[random() % bad.size()] = char(random() % 256);
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bad;
    const auto model = readGltf(file);
    refused += !model;
    if (model) CHECK(model->corners.size() % 3 == 0);
  }
  CHECK(refused > 100);
}
