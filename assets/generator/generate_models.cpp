// Writes the models for the hand into a folder: moltact_generate_models FOLDER
#include <cstdio>

#include "assets/generator/hand_models.h"

int main(int argc, char** argv) {
  using namespace moltact;
  if (argc != 2) {
    std::fprintf(stderr, "usage: moltact_generate_models FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  for (const GltfScene& scene : {generator::makeStylus()})
    if (const auto problem = writeGlb(folder / (scene.title + ".glb"), scene)) {
      std::fprintf(stderr, "%s\n", problem->text().c_str());
      return 1;
    }
  return 0;
}
