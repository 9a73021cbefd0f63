#include "engine/lesson/reading_keys.h"

#include <string>
#include <variant>

namespace moltact {

KeySpec readingKey(const ReadingOption& option) {
  KeySpec key{.name = option.name, .meaning = option.meaning, .fallback = option.fallback};
  if (std::holds_alternative<int ReadOptions::*>(option.member)) {
    key.type = ValueType::Count;
    key.min = 1;
    key.max = kMaxReadNumber;
  } else if (std::holds_alternative<bool ReadOptions::*>(option.member)) {
    key.type = ValueType::Word;
    key.words = {"yes", "no"};
  } else if (option.words) {
    key.type = ValueType::Word;
    for (const OfferedWord& w : option.words()) key.words.push_back(w.name);
  }
  return key;
}

bool readValue(ReadOptions& reading, const ReadingOption& option, const Value& value) {
  const bool counts = std::holds_alternative<int ReadOptions::*>(option.member);
  return readText(reading, option, counts ? std::to_string(static_cast<int>(value.number)) : value.text);
}

}  // namespace moltact
