// What keys of a scene do in the window: what is taken from the hand and the eye.
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

const std::string kHead = "---\ntitle: Mine\nminutes: 5\ngoals: G\nmolecules: 1ubq\nauthor: A\nlicence: L\n---\n";

}  // namespace

TEST_CASE(
    "a hand that presses where it met ubiquitin meets nothing once all of it is untouchable, and the molecule again in "
    "the next step; what is removed is not in the picture either") {
  Scratch scratch;
  const auto file =
      scratch.file("mine.md", kHead +
                                  "## One\n```scene\nmolecule: 1ubq\n```\nText.\n"
                                  "## Two\n```scene\nuntouchable: all\n```\nText.\n"
                                  "## Three\n```scene\nuntouchable: none\nremove: residue 1-40\n```\nText.\n");
  auto d = startWith(file.string());
  const auto presses = [&] {
    d->point("view");
    d->press();
    d->frames(40);
    const bool touching = d->app().scene.log().touching();
    d->release();
    d->frames(10);
    return touching;
  };
  CHECK(presses());
  const Picture whole = d->picture();
  d->app().lesson.next();
  d->frames(20);
  CHECK(difference(whole, d->picture()) < 0.3);  // it is still seen
  CHECK_FALSE(presses());
  d->app().lesson.next();
  d->frames(20);
  const Stage& stage = d->app().scene.stage();
  CHECK(presses());
  CHECK(d->app().scene.look.hidden->size() == stage.balls->untouchable().size());
  for (const std::int32_t atom : d->app().scene.log().latest().contact.atoms)
    if (atom >= 0) CHECK(stage.balls->touchable(std::size_t(atom)));
  d->app().lesson.back();
  d->app().lesson.back();
  d->frames(20);
  CHECK_FALSE(d->app().scene.stage().balls->hasUntouchable());
  CHECK(presses());
}

}  // namespace moltact
