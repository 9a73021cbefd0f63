#include "engine/lesson/touch_keys.h"

namespace moltact {
namespace {

KeySpec keyOf(const TouchProperty& property) {
  KeySpec key{.name = property.key, .meaning = property.meaning, .fallback = property.fallback};
  if (std::holds_alternative<double TouchSetup::*>(property.member)) {
    key.type = ValueType::Quantity;
    key.dimension = property.dimension;
    key.min = property.in_scenes.min;
    key.max = property.in_scenes.max;
    return key;
  }
  key.type = ValueType::Word;
  if (property.words)
    for (const OfferedWord& w : property.words()) key.words.push_back(w.name);
  else
    key.words = {"on", "off"};
  return key;
}

}  // namespace

std::vector<KeySpec> touchSceneKeys() {
  std::vector<KeySpec> out;
  for (const TouchProperty& p : touchProperties())
    if (isChoice(p)) out.push_back(keyOf(p));
  return out;
}

std::vector<KeySpec> comparedTouchKeys() {
  std::vector<KeySpec> out;
  for (const TouchProperty& p : touchProperties()) {
    if (p.compared.empty() || !isChoice(p)) continue;
    KeySpec& key = out.emplace_back(keyOf(p));
    key.meaning = p.compared;
    key.fallback = {};
  }
  return out;
}

TouchValue touchValueOf(const TouchProperty& property, const Value& value) {
  if (std::holds_alternative<double TouchSetup::*>(property.member)) return value.number;
  const std::string& word = value.words.front();
  if (std::holds_alternative<bool TouchSetup::*>(property.member)) return word == "on";
  return word;
}

}  // namespace moltact
