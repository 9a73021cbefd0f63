#include "tests/fuzz/attempt_maker.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "engine/results/attempt_ranges.h"
#include "tests/results/sample_attempt.h"

namespace moltact::fuzz {
namespace {

using Json = nlohmann::ordered_json;

// A number, or what stands between two quotes, becomes another; the line may then be no JSON any more.
void changeText(std::string& line, Choices& choices) {
  const std::size_t from = choices.pick(line.size()), at = line.find_first_of(":[,", from);
  if (at == std::string::npos || at + 1 >= line.size()) return;
  const std::size_t end = line.find_first_of(",]}\n", at + 1);
  if (line[at + 1] == '{' || line[at + 1] == '[')
    line.insert(at + 1, line[at + 1] == '[' && choices.pick(2) ? "[" : "");
  else
    line.replace(at + 1, end - at - 1, oddNumber(choices));
}

struct Place {
  Json* at;
  std::string key;
};

void walk(Json& at, const std::string& key, std::vector<Place>& places) {
  places.push_back({&at, key});
  if (at.is_object())
    for (auto& [name, value] : at.items()) walk(value, name, places);
  else if (at.is_array())
    for (auto& value : at) walk(value, key, places);
}

Json numberInRange(const std::string& key, Choices& choices) {
  const AttemptRange* range = attemptRange(key);
  if (!range) return choices.pick(2);
  const double share[] = {0.0, 1.0, 0.5, 0.999999, 1e-9};
  const double number = range->min + share[choices.pick(std::size(share))] * (range->max - range->min);
  switch (choices.pick(4)) {
    case 0:
      return range->min <= 0.0 ? 0.0 : range->min;
    case 1:
      if (!range->whole && range->min < 0.0) return std::numeric_limits<double>::denorm_min();
      [[fallthrough]];
    default:
      return range->whole ? Json(static_cast<long long>(number)) : Json(number);
  }
}

std::string oddWords(Choices& choices) {
  const std::string kOdd[] = {"",
                              " ",
                              std::string(1, '\0'),
                              "##",
                              "%s%n%d",
                              "\n\n",
                              "\x1b[2J",
                              "../../1ubq.pdb",
                              "1hel.pdb",
                              "1ubq.pdb",
                              "one",
                              "two",
                              "which",
                              "how-much",
                              "\xe2\x80\xae\xd7\x90",
                              std::string(3000, 'W'),
                              "a/b",
                              "exact",
                              "grid",
                              "=1+1",
                              "mouse",
                              "keyboard",
                              "\xf0\x9f\xa7\xac"};
  return kOdd[choices.pick(std::size(kOdd))];
}

// One of the line's values becomes another of its type; a list grows or shrinks.
void changeValue(std::string& line, Choices& choices) {
  Json json = Json::parse(line, nullptr, false);
  if (json.is_discarded()) return;
  std::vector<Place> places;
  walk(json, "", places);
  const Place& place = places[choices.pick(places.size())];
  Json& value = *place.at;
  if (value.is_number())
    value = numberInRange(place.key, choices);
  else if (value.is_string())
    value = oddWords(choices);
  else if (value.is_boolean())
    value = !value.get<bool>();
  else if (value.is_array() && !value.empty()) {
    const std::size_t how = choices.pick(4);
    if (how == 0)
      value = Json::array();
    else if (how == 1)
      value.erase(value.size() - 1);
    else
      for (std::size_t n = how == 2 ? 1 : choices.pick(300); n > 0; --n) value.push_back(Json(value[0]));
  } else if (value.is_object() && !value.empty()) {
    auto it = value.begin();
    std::advance(it, static_cast<std::ptrdiff_t>(choices.pick(value.size())));
    value.erase(it.key());
  }
  line = json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string madeAttempt(Choices& choices) {
  static const std::vector<AttemptEvent> events = sampleEvents();
  std::string text = lineOf(sampleHeader());
  if (choices.pick(8) == 7) changeValue(text, choices);
  if (choices.pick(4)) text += lineOf(events[1]);  // a molecule to play on
  for (std::size_t n = 1 + choices.pick(24); n > 0; --n) {
    std::string line = lineOf(events[choices.pick(events.size())]);
    for (std::size_t changes = choices.pick(6); changes > 0; --changes)
      if (choices.pick(4) == 3)
        changeText(line, choices);
      else
        changeValue(line, choices);
    text += line;
  }
  return text;
}

}  // namespace moltact::fuzz
