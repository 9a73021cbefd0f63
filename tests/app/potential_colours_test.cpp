// The colouring `potential` in the window: computed beside the frames, the same as computed at once, cancelled by a change.
#include "app/ui/extensions/potential_colours.h"

#include <thread>

#include "app/ui/extensions/extensions.h"
#include "engine/render/molecule_model.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

struct PotentialWindow {
  Scratch scratch;
  std::unique_ptr<ScriptedUser> d;

  explicit PotentialWindow(const std::string& molecule, const std::string& more = {}) {
    d = startWith(scratch
                      .file("mine.md", "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules:\n  - " + molecule +
                                           "\nauthor: A\nlicence: L\n---\n## One\n```scene\nmolecule: " + molecule +
                                           "\n" + more + "```\nText.\n")
                      .string());
  }
  HapticSession& scene() { return d->app().scene; }
  PotentialColours& colours() { return d->app().extensions().potential_colours; }
  // Frames until the colours are there; at most a minute.
  int framesUntilKnown() {
    for (int frames = 0; frames < 6000; ++frames) {
      if (scene().look.atoms.colouring && !scene().look.atoms.colouring->pending) return frames;
      d->frames(1);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return -1;
  }
};

}  // namespace

TEST_CASE(
    "a scene with 'colour: potential' shows grey atoms and a line that says so, and then the colours that are computed "
    "at "
    "once; the user has nothing to undo") {
  PotentialWindow w("2hhb", "colour: potential\n");
  // The fixture's frames may have been enough for a quick machine; a new medium begins anew.
  TouchSetup touch = w.scene().touch();
  touch.dielectric = "distance";
  w.scene().setTouch(touch);
  REQUIRE(w.scene().look.atoms.colouring);
  CHECK(w.scene().look.atoms.colouring->pending);
  CHECK_FALSE(w.scene().look.atoms.colouring->legend.entries.empty());
  w.d->frames(1);
  CHECK(w.colours().live());
  CHECK(w.colours().progress());
  CHECK(w.d->shows("view/surface"));
  REQUIRE(w.framesUntilKnown() >= 0);
  w.d->frames(2);
  CHECK_FALSE(w.d->shows("view/surface"));
  const std::vector<std::uint32_t> held = w.scene().stage().spheres->untouchable();
  const auto at_once =
      schemeColouring(*w.scene().stage().molecule, "potential", {.dielectric = "distance", .held = held});
  CHECK(w.scene().look.atoms.colouring->of_atom == at_once->of_atom);
  CHECK(w.scene().look.atoms.colouring->legend.gradient);
  const std::size_t entries = w.scene().look.atoms.colouring->legend.entries.size();
  CHECK(entries == 5);
  w.d->app().extensions().history.undo();  // the medium
  w.d->frames(2);
  CHECK_FALSE(w.d->app().extensions().history.canUndo());
}

TEST_CASE("another colouring, and another medium, end the computation of the first; the last one asked for is shown") {
  PotentialWindow w("2hhb");
  w.scene().look.atoms.colouring = w.scene().look.colouring("potential");
  w.d->frames(1);
  CHECK(w.colours().live());
  w.scene().look.atoms.colouring = w.scene().look.colouring("charge");
  w.d->frames(1);
  CHECK_FALSE(w.colours().live());
  CHECK_FALSE(w.colours().progress());
  CHECK(w.scene().look.atoms.colouring->scheme == "charge");
  w.scene().look.atoms.colouring = w.scene().look.colouring("potential");
  w.d->frames(1);
  TouchSetup touch = w.scene().touch();
  touch.dielectric = "vacuum";
  w.scene().setTouch(touch);
  w.d->frames(1);
  REQUIRE(w.framesUntilKnown() >= 0);
  const auto at_once = schemeColouring(*w.scene().stage().molecule, "potential", {.dielectric = "vacuum"});
  CHECK(w.scene().look.atoms.colouring->of_atom == at_once->of_atom);
  // Known colours are shown in the next frame.
  w.scene().look.atoms.colouring = w.scene().look.colouring("potential");
  w.d->frames(1);
  CHECK_FALSE(w.colours().live());
  CHECK_FALSE(w.scene().look.atoms.colouring->pending);
}

}  // namespace moltact
