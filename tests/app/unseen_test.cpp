// A molecule that a scene does not draw: nothing on the screen names what the hand must find out.
#include <string>

#include "app/ui/widgets/widget_map.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

std::string unseenLessonWith(const std::string& hide) {
  return "---\ntitle: Unseen\nminutes: 1\ngoals: G\nmolecules: benzene\nauthor: A\nlicence: L\n---\n"
         "## One\n```scene\nmolecule: benzene\n" +
         hide +
         "```\n```touch\nreach: all\nsay: Touch it.\n```\n### Question: What is it?\n1. [x] A ring → Yes.\n"
         "2. [ ] A rod → No.\n";
}

// What the window says while the hand rests on the molecule.
std::string saidOfTouch(const std::string& hide) {
  ScratchFolder scratch;
  writeFile(scratch.path / "unseen.md", unseenLessonWith(hide));
  auto d = startWith((scratch.path / "unseen.md").string());
  d->frames(3);
  CHECK(d->point("view"));
  d->press();
  d->frames(120);
  CHECK(d->app().scene.log().touching());
  std::string all;
  for (const auto& [name, record] : widgets().all())
    if (name == "view/state" || name.starts_with("status/")) all += name + ": " + record.text + '\n';
  d->release();
  return all;
}

}  // namespace

TEST_CASE("what a scene does not draw is named neither where it is touched nor below; what it draws is") {
  const std::string drawn = saidOfTouch("");
  CHECK(drawn.find("carbon") != std::string::npos);
  CHECK(drawn.find("status/molecule: benzene") != std::string::npos);
  const std::string hidden = saidOfTouch("hide: all\n");
  CHECK(hidden.find("view/state: ") != std::string::npos);
  CHECK(hidden.find("carbon") == std::string::npos);
  CHECK(hidden.find("benzene") == std::string::npos);
  CHECK(hidden.find("status/molecule") == std::string::npos);
}

}  // namespace moltact
