// HIP paths, glTF models, the catalogue of molecules, the settings, and catalogues of translations.
#include <cmath>

#include "app/commands/hip_path_file.h"
#include "app/ui/files/settings.h"
#include "engine/gltf/closed_surface.h"
#include "engine/gltf/gltf_file.h"
#include "engine/language/catalogue.h"
#include "engine/language/mo_file.h"
#include "engine/molecule/catalogue.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {

void hipPath(std::string_view bytes) {
  const auto path = readHipPath(fileOf(bytes, "hip.csv"));
  if (!path) return mustBe(!path.problem().message.empty(), "a message");
  mustBe(path->size() > 0, "a place");  // which may be no number: the loop is led along it and gives no force there
  mustBe(path->orientations.empty() || path->orientations.size() == path->size(), "an orientation for each place");
  for (const Quat& q : path->orientations) mustBe(std::abs(glm::length(q) - 1.0) < 1e-12, "orientations of length 1");
}

void gltf(std::string_view bytes) {
  for (const char* name : {"a.glb", "a.gltf"}) {
    const auto model = readGltf(fileOf(bytes, name));
    if (!model) {
      mustBe(!model.problem().message.empty(), "a message");
      continue;
    }
    mustBe(!model->corners.empty() && model->corners.size() % 3 == 0 && model->corners.size() <= 3 * kMaxModelTriangles,
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

void translations(std::string_view bytes) {
  const auto texts = MoFile::parse(std::string(bytes));
  if (!texts) return mustBe(!texts.problem().message.empty(), "a message");
  // The parts of the file, and the rest.
  std::string_view rest = bytes;
  for (int k = 0; k < 50 && !rest.empty(); ++k) {
    const std::string_view word = rest.substr(0, rest.find('\0'));
    const std::string english(word);
    const FormatArg pieces[]{FormatArg(1), FormatArg("two")};
    if (const char* text = texts->find({}, word)) {
      mustBe(*text != '\0', "a text that is not empty");
      filled(text, english.c_str(), pieces);
    }
    for (const unsigned long n : {0ul, 1ul, 2ul, 5ul, ~0ul})
      if (const char* text = texts->findPlural(word, n)) mustBe(*text != '\0', "a form that is not empty");
    texts->find(word, "English");
    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
  }
}

}  // namespace moltact::fuzz
