// Compares the committed models with their generator's output and with the view's requirements.
#include "assets/generator/hand_models.h"

#include <doctest/doctest.h>
#include <unistd.h>

using namespace moltact;

TEST_CASE("the stylus is as its generator makes it: closed round the tip at the origin, 50 to 120 mm along +y") {
  for (const GltfScene& scene : {generator::makeStylus()}) {
    CAPTURE(scene.title);
    const auto made_file =
        std::filesystem::temp_directory_path() / ("moltact_model_" + std::to_string(getpid()) + ".glb");
    REQUIRE_FALSE(writeGlb(made_file, scene));
    const auto made = readGltf(made_file);
    std::filesystem::remove(made_file);
    const auto kept = readGltf(std::filesystem::path(MOLTACT_SOURCE_DIR) / "assets/models" / (scene.title + ".glb"));
    if (!made) FAIL(made.problem().text());
    if (!kept) FAIL(kept.problem().text());
    REQUIRE(made->corners.size() == kept->corners.size());
    float worst = 0;
    for (std::size_t k = 0; k < made->corners.size(); ++k) {
      worst = std::max(worst, glm::distance(made->corners[k].place, kept->corners[k].place));
      worst = std::max(worst, glm::distance(made->corners[k].colour, kept->corners[k].colour));
    }
    CHECK(worst < 1e-5f);
    CHECK(std::abs(kept->low.y) < 0.001f);
    CHECK(kept->high.y > 0.05f);
    CHECK(kept->high.y < 0.12f);
    // Faces turn outward: the volume under them is positive.
    double volume = 0;
    for (std::size_t k = 0; k < kept->corners.size(); k += 3)
      volume += glm::dot(glm::dvec3(kept->corners[k].place),
                         glm::cross(glm::dvec3(kept->corners[k + 1].place), glm::dvec3(kept->corners[k + 2].place))) /
                6;
    CHECK(volume > 1e-6);
    CHECK(kept->corners.size() / 3 < 16000);
  }
}
