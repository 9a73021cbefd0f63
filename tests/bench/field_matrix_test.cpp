// The matrix of forces between atoms: the coupled field is sound in every scene, its rivals fail as the literature expects.
#include "engine/bench/energies/field_matrix.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace moltact;
using namespace moltact::bench;

namespace {

const FieldScene& fieldSceneNamed(const std::vector<FieldScene>& all, std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const FieldScene& s) { return s.name == name; });
  REQUIRE(found != all.end());
  return *found;
}

}  // namespace

TEST_CASE("in the eight scenes of forces, as defined and in one draw, the coupled field is sound") {
  for (const std::size_t draw : {0u, 1u})
    for (const FieldScene& scene : fieldScenes(1, draw)) {
      CAPTURE(scene.name);
      const FieldResult r = runFieldScene(scene, "coupled");
      CHECK(failuresOf(r).empty());
      CHECK(r.overlap_A < 1e-9);
      CHECK(r.ticks == scene.path.size());
    }
}

TEST_CASE("at each gain of weak forces that the panel offers the coupled field is sound in the eight scenes") {
  for (double gain = 1.5; gain <= 8.0; gain += 0.5)
    for (FieldScene scene : fieldScenes(1, 0)) {
      CAPTURE(gain);
      CAPTURE(scene.name);
      scene.model.weak_gain = gain;
      const FieldResult r = runFieldScene(scene, "coupled");
      CHECK(failuresOf(r) == "");
      CHECK(r.overlap_A < 1e-9);
    }
}

TEST_CASE(
    "a field that is given at the hand: it goes into an atom at speed, makes energy from a start inside, vibrates by "
    "over "
    "1 mm in a well deeper than the device bears; a trilinear grid steps by over 1 N at a cell's face") {
  const std::vector<FieldScene> all = fieldScenes(1, 0);
  const auto fails = [&](const char* scene, std::string_view method, char criterion) {
    return failuresOf(runFieldScene(fieldSceneNamed(all, scene), method)).find(criterion) != std::string::npos;
  };
  for (const std::string_view m : {"direct", "bounded", "trilinear", "tricubic"}) {
    CAPTURE(m);
    CHECK(fails("steep wall at speed", m, 'O'));
    CHECK(fails("jump by 5 A", m, 'O'));
    CHECK(fails("overlapping hydrogen", m, 'O'));
    CHECK(fails("start inside an atom", m, 'E'));
    CHECK(fails("well deeper than the device bears", m, 'J'));
  }
  CHECK(runFieldScene(fieldSceneNamed(all, "well deeper than the device bears"), "direct").jitter_mm > 1.0);
  CHECK(fails("face of a cell, to and fro", "trilinear", 'S'));
  CHECK_FALSE(fails("face of a cell, to and fro", "tricubic", 'S'));
}

TEST_CASE("the table of the matrix has a row per scene, and a draw moves scene and hand together") {
  const std::vector<FieldResult> results = measureFieldMatrix({.seed = 1, .draws = 2}, {});
  CHECK(results.size() == 8 * kFieldMethods.size() * 2);
  const ReportTable table = fieldMatrix(results);
  CHECK(table.rows.size() == 8);
  CHECK(table.columns.size() == 1 + kFieldMethods.size());
  CHECK(fieldMatrixSentences(results).starts_with("* `coupled` is sound in 8 of 8 scenes."));
  const FieldScene a = fieldScenes(1, 0)[2], b = fieldScenes(1, 1)[2];
  CHECK(glm::distance(b.atoms[0].centre_A, b.path[100]) ==
        doctest::Approx(glm::distance(a.atoms[0].centre_A, a.path[100])));
  CHECK(b.path[100] != a.path[100]);
}
