// At the start of a step of the program's lessons, the marks of its scene are in the picture and not all under the
// probe.
#include <doctest/doctest.h>

#include <filesystem>

#include "tests/lesson/scripted_learner/step_picture.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "as each step of each shipped lesson begins, every mark, label, arrow and highlight has an atom inside the "
    "picture, and "
    "of each mark and highlight one stands out by 0.5 A beside the probe in the middle of the view") {
  constexpr double kBare_A = 0.5;
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MOLTACT_SOURCE_DIR "/lessons")) {
    const std::string file = entry.path().filename().string();
    if (entry.path().extension() != ".md" || file == "README.md" || file.rfind("glossary", 0) == 0) continue;
    const Lesson lesson = shippedLesson(entry.path().stem().string());
    for (const Step& step : lesson.steps) {
      if (step.scene.molecule.name.empty() || !step.scene.molecule.reading.beside.empty()) continue;
      CAPTURE(file);
      CAPTURE(step.title);
      const StepPicture picture(step);
      const Camera& camera = picture.camera();
      const auto inView = [&](const Selection& of, bool beside_probe) {
        bool inside = false, bare = false;
        for (const std::uint32_t a : presentAtoms(of, picture.scene, *picture.molecule)) {
          const PlacedAtom atom = picture.molecule->at(a);
          const Vec3 at = camera.project(atom.position, StepPicture::kSize_px, StepPicture::kSize_px);
          inside = inside ||
                   (at.z > 0.0 && at.x > 0 && at.y > 0 && at.x < StepPicture::kSize_px && at.y < StepPicture::kSize_px);
          const Vec3 seen = camera.toView(atom.position);
          bare = bare || std::hypot(seen.x, seen.y) + atom.radius_A > picture.scene.touch.probe_A + kBare_A;
        }
        CHECK_MESSAGE(inside, of.text());
        CHECK_MESSAGE((bare || !beside_probe), of.text());
      };
      if (step.scene.highlight.given()) inView(step.scene.highlight, true);
      for (const MarkSpec& mark : step.scene.marks) inView(mark.atoms, true);
      for (const auto* list : {&step.scene.labels, &step.scene.arrows})
        for (const MarkSpec& mark : *list) inView(mark.atoms, false);
      ++scenes;
    }
  }
  CHECK(scenes > 150);
}
