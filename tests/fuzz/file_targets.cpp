// HIP paths, glTF models, the catalogue of molecules and the settings.
#include <cmath>

#include "app/commands/hip_path_file.h"
#include "app/ui/files/settings.h"
#include "engine/gltf/closed_surface.h"
#include "engine/gltf/gltf_file.h"
#include "engine/molecule/catalogue.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {

void hipPath(std::string_view bytes) {
  const auto path = readHipPath(fileOf(bytes, "hip.csv"));
  if (!path) return mustBe(!path.problem().message.empty(), "a message");
  mustBe(!path->empty(), "a place");  // which may be no number: the loop is led along it and gives no force there
}

void gltf(std::string_view bytes) {
  for (const char* name : {"a.glb", "a.gltf"}) {
    const auto model = readGltf(fileOf(bytes, name));
    if (!model) {
      mustBe(!model.problem().message.empty(), "a message");
      continue;
    }
    mustBe(
        !model->corners.empty() && model->corners.size() % 3 == 0 && model->corners.size() <= 3 * kMostModelTriangles,
        "whole triangles");
    for (const SolidModel::Corner& c : model->corners)
      for (int k = 0; k < 3; ++k)
        mustBe(std::isfinite(c.place[k]) && std::isfinite(c.normal[k]), "corners that are numbers");
  }
}

void catalogue(std::string_view bytes) {
  const std::filesystem::path folder = std::filesystem::path(fileOf(bytes, "catalogue.json")).parent_path();
  const auto entries = readCatalogue(folder);
  if (!entries) return mustBe(!entries.problem().message.empty(), "a message");
  for (const CatalogueEntry& e : *entries)
    mustBe(!e.id.empty() && e.file.find('/') == std::string::npos, "a name in the folder");
  findMolecule("1ubp", {folder, {}});
}

void settings(std::string_view bytes) {
  const Settings s = loadSettings(fileOf(bytes, "settings.json")).settings;
  mustBe(s.scale >= 0.75 && s.scale <= 3 && s.text_size >= 1 && s.text_size <= 1.5, "sizes in their ranges");
  mustBe(s.lesson_width >= 240 && s.lesson_width <= 700 && s.touch_width >= 220 && s.touch_width <= 600,
         "widths in their ranges");
  mustBe(s.recent.size() <= Settings::kRecent, "no more files than are remembered");
}

}  // namespace moltact::fuzz
