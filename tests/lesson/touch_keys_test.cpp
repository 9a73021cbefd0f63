// The keys for a scene's touch, as authors write them.
#include "engine/lesson/touch_keys.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/lesson/reading_keys.h"
#include "engine/lesson/tasks/registry.h"
#include "tests/molecule/other_reading.h"

using namespace moltact;

namespace {

const KeySpec* keyIn(const std::vector<KeySpec>& keys, std::string_view name) {
  const auto found = std::ranges::find(keys, name, &KeySpec::name);
  return found == keys.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("every property that leaves a choice is a key of scenes and can be locked; its fallback is the default") {
  const std::vector<KeySpec>& scene = keysOf(KeyBlock::Scene);
  const std::vector<std::string_view> lockable = keyIn(scene, "locked")->words;
  for (const TouchProperty& p : touchProperties()) {
    CAPTURE(std::string(p.key));
    const KeySpec* key = keyIn(scene, p.key);
    CHECK((key != nullptr) == isChoice(p));
    CHECK((std::ranges::find(lockable, p.key) != lockable.end()) == isChoice(p));
    if (!key) continue;
    const Expected<Value> usual = parseValue(*key, key->fallback);
    REQUIRE(bool(usual));
    CHECK(touchValueOf(p, *usual) == touchValue(TouchSetup(), p));
  }
}

TEST_CASE("a task that compares two things has a key for every property that one can differ in, without a fallback") {
  const TaskKind* same = findTaskKind("same");
  REQUIRE(same);
  std::size_t compared = 0;
  for (const TouchProperty& p : touchProperties()) {
    CAPTURE(std::string(p.key));
    const KeySpec* key = keyIn(same->keys, p.key);
    const bool differs = !p.compared.empty() && isChoice(p);
    CHECK((key != nullptr) == differs);
    if (!key) continue;
    ++compared;
    CHECK(key->fallback.empty());
    CHECK(key->meaning == p.compared);
  }
  CHECK(compared >= 3);
}

TEST_CASE("a lesson of an earlier version that names a method by its former name gets the present one") {
  const auto method = parseValue(*keyIn(keysOf(KeyBlock::Scene), "method"), "mesh960-tree");
  REQUIRE(bool(method));
  CHECK(method->words == std::vector<std::string>{"mesh960"});
  const auto compared = parseValue(*keyIn(findTaskKind("compare")->keys, "compare"), "exact, mesh960-tree");
  REQUIRE(bool(compared));
  CHECK(compared->words == std::vector<std::string>{"exact", "mesh960"});
}

TEST_CASE("every way of reading a molecule is a key of scenes whose fallback is the default") {
  for (const ReadingOption& option : readingOptions()) {
    CAPTURE(std::string(option.name));
    const KeySpec* key = keyIn(keysOf(KeyBlock::Scene), option.name);
    REQUIRE(key);
    CHECK(bool(parseValue(*key, key->fallback)));
    ReadOptions reading;
    REQUIRE(readText(reading, option, test::otherThanDefault(option)));
    REQUIRE(reading != ReadOptions());
    CHECK(readText(reading, option, key->fallback));
    CHECK(reading == ReadOptions());
  }
}

TEST_CASE("a reading option with two words is a key that accepts these and reports a third") {
  ReadingOption option = readingOptions().front();
  option.member = &ReadOptions::assembly;
  option.words = [] { return std::vector<OfferedWord>{{"bondi", "Bondi", ""}, {"alvarez", "Alvarez", ""}}; };
  const KeySpec key = readingKey(option);
  CHECK(key.type == ValueType::Word);
  CHECK_FALSE(bool(parseValue(key, "7")));
  const auto value = parseValue(key, "alvarez");
  REQUIRE(value);
  ReadOptions reading;
  CHECK(readValue(reading, option, *value));
  CHECK(reading.assembly == "alvarez");
}
