// A student's whole way: the welcome page, a lesson, a wrong answer, a hint, preferences, back, and on where he was.
#include "tests/app/driver_fixture.h"

namespace moltact {

TEST_CASE("a student goes from the welcome page through a step, a wrong and a right answer, a hint and the preferences") {
  auto d = startWith("");
  d->app().panels.welcome = true;
  const std::optional<Problem> problem = d->run(R"(
wait 40
expect welcome/lesson/first-touch First touch
click welcome/lesson/first-touch
wait 20
expect lesson/place Step 1 of
expect task/0 current: Touch the argon atom.
point view 0.5 0.5
press
wait 150
release
expect task/0 done:
click lesson/next
wait 20
expect lesson/place Step 2 of
click question/0/0
wait 3
expect question/0/feedback That is what you feel on a round face.
click question/0/1
wait 3
expect question/0/feedback Yes. It touches both
key Alt+Left
wait 3
expect lesson/place Step 1 of
)", "walk");
  REQUIRE_MESSAGE(!problem, problem->text());

  // The first hint of the step opens and closes.
  std::string hint;
  for (const auto& [name, record] : widgets().all())
    if (hint.empty() && name.ends_with("/hint")) hint = name;
  REQUIRE_FALSE(hint.empty());
  CHECK(d->text(hint) == "closed");
  CHECK(d->click(hint));
  CHECK(d->text(hint) == "open");
  CHECK_FALSE(d->text(hint + " text").empty());

  const std::optional<Problem> later = d->run(R"(
key Ctrl+,
wait 3
click preferences/theme/Dark
click preferences/numbers/1,4
wait 3
key Escape
wait 3
expect probe 1,4 Å
key Alt+Right
wait 3
point question/0/feedback
expect question/0/feedback Yes. It touches both
key Ctrl+H
wait 3
expect welcome/next Back to First touch
click welcome/molecule/benzene
wait 10
expect status/molecule benzene
)", "walk on");
  REQUIRE_MESSAGE(!later, later->text());
  CHECK(d->app().settings.theme == ThemeChoice::Dark);
}

TEST_CASE("with keys alone the preferences are reached, walked through and changed") {
  auto d = startWith("argon");
  d->tap("Ctrl+,");
  d->frames(3);
  REQUIRE(d->shows("preferences/close"));
  const Settings before = d->app().settings;
  bool changed = false;
  for (int k = 0; k < 12 && !changed; ++k) {
    d->tap("Down");
    d->frames(2);
    d->tap("Space");
    d->frames(2);
    changed = !(d->app().settings == before);
  }
  CHECK(changed);
  d->tap("Escape");
  d->frames(3);
  CHECK_FALSE(d->shows("preferences/close"));
}

}  // namespace moltact
