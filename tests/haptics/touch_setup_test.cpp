// The table of a scene's touch properties, and what is generated from it.
#include "engine/haptics/touch_setup.h"

#include <doctest/doctest.h>

#include <set>

#include "engine/haptics/methods.h"

using namespace moltact;

namespace {

const TouchProperty& property(std::string_view key) {
  for (const TouchProperty& p : touchProperties())
    if (p.key == key) return p;
  FAIL("no property " << key);
  return touchProperties().front();
}

// Another value than the default, within all ranges.
TouchValue other(const TouchProperty& p) {
  const TouchValue usual = touchValue(TouchSetup(), p);
  if (const auto* on = std::get_if<bool>(&usual)) return !*on;
  if (std::holds_alternative<std::string>(usual)) return std::string("another");
  return 0.75 * p.in_scenes.min + 0.25 * p.in_scenes.max;
}

}  // namespace

TEST_CASE(
    "every property has a key and a field of its own, ranges that hold its default, and words of which one is it") {
  std::set<std::string_view> keys, fields;
  for (const TouchProperty& p : touchProperties()) {
    CAPTURE(std::string(p.key));
    CHECK(keys.insert(p.key).second);
    CHECK(fields.insert(p.field).second);
    CHECK_FALSE(p.meaning.empty());
    CHECK_FALSE(p.fallback.empty());
    // Properties that require a rebuild are labels of a recording; all others are in its ticks.
    CHECK(p.label.empty() != p.requires_rebuild);
    const TouchValue usual = touchValue(TouchSetup(), p);
    if (const auto* number = std::get_if<double>(&usual)) {
      for (const TouchRange& range : {p.in_scenes, p.in_files, p.control.range})
        CHECK((range.min <= *number && *number <= range.max));
      // A file can hold what an author writes and what a slider gives.
      CHECK((p.in_files.min <= p.in_scenes.min && p.in_scenes.max <= p.in_files.max));
      CHECK((p.in_files.min <= p.control.range.min && p.control.range.max <= p.in_files.max));
      CHECK((p.control.title.empty() || p.control.step > 0.0));
    }
    if (const auto* word = std::get_if<std::string>(&usual)) {
      REQUIRE(bool(p.words));
      int same = 0;
      for (const OfferedWord& w : p.words()) same += w.name == *word;
      CHECK(same == 1);
      CHECK(isChoice(p) == (p.words().size() > 1));
    }
  }
}

TEST_CASE(
    "each property is set alone, and two setups are equal when all are; a value of another type changes nothing") {
  for (const TouchProperty& p : touchProperties()) {
    CAPTURE(std::string(p.key));
    TouchSetup setup;
    setTouchValue(setup, p, other(p));
    CHECK(touchValue(setup, p) == other(p));
    CHECK_FALSE(setup == TouchSetup());
    CHECK(sameConstruction(setup, TouchSetup()) == !p.requires_rebuild);
    for (const TouchProperty& q : touchProperties())
      if (&q != &p) CHECK(touchValue(setup, q) == touchValue(TouchSetup(), q));
    const TouchSetup before = setup;
    if (std::holds_alternative<bool>(other(p)))
      setTouchValue(setup, p, std::string("on"));
    else
      setTouchValue(setup, p, true);
    CHECK(setup == before);
  }
}

TEST_CASE(
    "a recording's labels give back what it was felt with; the default of what is newer than recordings needs none") {
  CHECK(touchLabels({}) == std::map<std::string, std::string>{{"method", "exact"}});
  for (const TouchProperty& p : touchProperties()) {
    if (p.label.empty()) continue;
    CAPTURE(std::string(p.label));
    TouchSetup setup;
    setTouchValue(setup, p, other(p));
    CHECK(labelledTouch(touchLabels(setup)) == setup);
  }
  // What no label holds stays; what one could hold does not.
  TouchSetup now;
  now.probe_A = 2.0;
  now.method = "penalty";
  now.interaction = "another";
  const TouchSetup read = labelledTouch({{"method", "paper"}}, now);
  CHECK(read.probe_A == 2.0);
  CHECK(read.method == "paper");
  CHECK(read.interaction == "probe");
  CHECK(labelledTouch({}).method.empty());  // every recording names its method
}

TEST_CASE("a task's changes are taken back to the scene's values one by one, and what a person set besides stays") {
  TouchSetup scene, now;
  scene.stiffness_N_per_mm = 0.3;
  now = scene;
  now.probe_A = 2.5;  // by hand
  TouchChange none, softer, method;
  softer.set(property("stiffness"), 0.1);
  method.set(property("method"), std::string("penalty"));
  CHECK(none == TouchChange());
  CHECK_FALSE(softer == none);
  CHECK((softer.has(&TouchSetup::stiffness_N_per_mm) && !softer.has(&TouchSetup::probe_A)));

  softer.replace(none, scene, now);
  CHECK((now.stiffness_N_per_mm == 0.1 && now.probe_A == 2.5 && now.method == "exact"));
  method.replace(softer, scene, now);
  CHECK((now.stiffness_N_per_mm == 0.3 && now.probe_A == 2.5 && now.method == "penalty"));
  now.method = "paper";  // by hand, while the task continues
  method.replace(method, scene, now);
  CHECK(now.method == "paper");
  none.replace(method, scene, now);
  CHECK((now.method == "exact" && now.probe_A == 2.5));
  CHECK(method.over(scene).stiffness_N_per_mm == 0.3);
  CHECK(method.over(scene).method == "penalty");
}
