// The panel that compares methods, as a student uses it.
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

std::string lessonFile() { return std::string(MOLTACT_SOURCE_DIR) + "/lessons/how-touch-is-computed.md"; }

}  // namespace

TEST_CASE("the methods panel is closed until the View menu opens it, and a tab leads back to the touch panel") {
  auto d = startWith("argon");
  CHECK_FALSE(d->shows("method/Mesh"));
  CHECK_FALSE(d->shows("tab/Methods"));
  CHECK(d->click("menu/view"));
  CHECK(d->click("menu/view/methods"));
  d->frames(2);
  CHECK(d->shows("plot/tradeoff"));
  CHECK_FALSE(d->shows("probe"));
  CHECK(d->click("tab/Touch"));
  d->frames(2);
  CHECK(d->shows("probe"));
  CHECK_FALSE(d->shows("plot/tradeoff"));
  CHECK(d->click("menu/view"));
  CHECK(d->click("menu/view/methods"));
  d->frames(2);
  CHECK_FALSE(d->shows("tab/Methods"));
}

TEST_CASE("switching through families and grades while pressing keeps the contact and leaves a mark for each") {
  auto d = startWith("argon-pair");
  d->app().panels.tabs.open("methods");
  d->frames(2);
  d->point("view", 0.45, 0.5);
  d->hold("Space");
  d->frames(40);
  for (int k = 0; k < 6; ++k) d->tap("plus");  // 0.54 A under the surface: deeper than the flat of a triangle lies
  REQUIRE(d->app().scene.log().touching());
  const struct {
    const char *family, *grade, *method;
  } walk[] = {{"Mesh", "80", "mesh80"},         {"Exact", nullptr, "exact"}, {"Mesh", "320", "mesh320"},
              {"Grid", "0.8\u00a0Å", "grid08"}, {"Exact", nullptr, "exact"}, {"Paper", nullptr, "paper"},
              {"Grid", "0.2\u00a0Å", "grid02"}, {"Mesh", "5120", "mesh5120"}};
  for (const auto& [family, grade, method] : walk) {
    CAPTURE(method);
    CHECK(d->click(std::string("method/") + family));
    if (grade) {
      d->frames(1);
      CHECK(d->click(std::string("grade/") + grade));
    }
    CHECK(d->app().scene.touch().method == method);
    d->point("view", 0.45, 0.5);
    d->frames(12);
    CHECK(d->app().scene.log().touching());
    CHECK(d->shows(std::string("plot/tradeoff/") + method));
  }
  REQUIRE(d->app().scene.watch().find("exact"));
  CHECK(d->app().scene.watch().find("exact")->error_A < 1e-9);
  CHECK(d->app().scene.watch().find("mesh80")->error_A > 10.0 * d->app().scene.watch().find("mesh5120")->error_A);
  CHECK(contains(d->text("plot/times"), "half within"));
}

TEST_CASE("facets are drawn with a mesh and its switch on, and with no other method") {
  auto d = startWith("argon");
  d->app().panels.tabs.open("methods");
  useMethod(d->app().scene, "mesh80");
  d->frames(20);
  REQUIRE(d->text("show/facets") == "on");
  const Picture with = d->picture();
  CHECK(d->click("show/facets"));
  d->point("plot/force");
  d->frames(20);
  CHECK(difference(with, d->picture()) > 0.005);
  useMethod(d->app().scene, "exact");
  d->frames(2);
  CHECK_FALSE(d->shows("show/facets"));
}

TEST_CASE("a lesson's step opens the panel with its method, and another lesson closes it again") {
  auto d = startWith("");
  d->app().open(lessonFile());
  d->frames(10);
  CHECK(d->shows("plot/tradeoff"));
  CHECK(d->text("method/Mesh") == "on");
  CHECK(d->text("grade/80") == "on");
  openFirst(*d);
  d->frames(10);
  CHECK_FALSE(d->shows("tab/Methods"));
  CHECK(d->app().scene.touch().method == "exact");
}

TEST_CASE("the key of methods does not switch, for a frame either, what a lesson has locked") {
  const Scratch scratch;
  const auto file = scratch.file("locked.md",
                                 "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\n---\n"
                                 "## One\n```scene\nmolecule: argon\npanels: methods\nlocked: method\n```\nText.\n");
  auto d = startWith(file.string());
  const auto family = d->app().scene.touch().method;
  REQUIRE(d->text("method/Exact") == "on");
  d->hold("M");
  // As it was drawn in the very frame of the key.
  CHECK(d->text("method/Exact") == "on");
  d->letGo("M");
  CHECK(d->app().scene.touch().method == family);
}

TEST_CASE("the lesson's failures of paper, penalty and grid are met with a mouse") {
  auto d = startWith("");
  d->app().open(lessonFile());
  d->frames(20);
  // Steps of the core and extra ones, as links lead to them.
  const auto doStep = [&](std::size_t step, const char* script) {
    CAPTURE(step);
    REQUIRE(d->app().lesson.follow('#' + d->app().lesson.session()->lesson().steps[step].id));
    d->frames(20);
    if (const std::optional<Problem> problem = d->run(script, "failures")) FAIL(problem->text());
  };
  doStep(4, R"(
expect method/Paper on
point view 0.5 0.54
press
wait 60
wheel 20
wait 90
expect task/0 done
release
wait 2
)");
  doStep(5, R"(
expect method/Penalty on
point view 0.5 0.54
press
wait 30
wheel 20
wait 60
expect task/0 done
release
wait 2
)");
  doStep(7, R"(
expect method/Grid on
point view 0.5 0.5
press
wait 30
wheel 5
wait 90
expect task/0 done
)");
}

}  // namespace moltact
