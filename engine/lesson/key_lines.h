// Parses the "key: value" lines of front matter and fenced blocks. Pure functions; any thread but the haptic one.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/lesson/keys.h"

namespace moltact {

/// A line of a block and the place of its first byte in the file.
struct BlockLine {
  std::string text;
  Place place;
};

struct ListItem {
  std::string text;
  Place place;
};

struct KeyLine {
  std::string key, value;
  Place key_place, value_place;
  std::vector<ListItem> items;  ///< the "- " lines below it
};

/// Splits lines into keys. Blank lines and lines that begin with # are ignored. A line that is neither a key nor a list
/// item adds a problem (without a file name).
std::vector<KeyLine> splitKeyLines(std::span<const BlockLine> lines, std::vector<Problem>& problems);

/// Returns the remedy for an unknown key; if it is empty, the nearest known key is suggested.
using UnknownKey = std::function<std::string(std::string_view key)>;

/// Reads the values of a block by its keys and fills in the defaults. Adds a problem for each unknown or repeated key,
/// invalid value and missing required key (at `block_place`). `block` is its name, as blockName() returns it.
KeyValues readKeyValues(std::span<const KeyLine> lines, std::span<const KeySpec* const> keys, const char* block,
                        Place block_place, std::vector<Problem>& problems, const UnknownKey& unknown = {});

/// Pointers to every key of a table, for readKeyValues().
std::vector<const KeySpec*> pointersTo(std::span<const KeySpec> keys);

}  // namespace moltact
