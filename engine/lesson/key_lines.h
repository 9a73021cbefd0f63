// The "key: value" lines of front matter and of fenced blocks. Pure functions; any thread but the haptic one.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/lesson/keys.h"

namespace moltact {

/// A line of a block and where its first byte stands in the file.
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

/// Splits lines into keys. Blank lines and lines that start with # are passed over; a line that is neither a key nor
/// an item of a list adds a problem (without a file name).
std::vector<KeyLine> splitKeyLines(std::span<const BlockLine> lines, std::vector<Problem>& problems);

/// The remedy for a key that the block does not have; where it gives nothing, the nearest of its keys is suggested.
using UnknownKey = std::function<std::string(std::string_view key)>;

/// Reads the values of a block by its keys: adds a problem for each unknown or doubled key, bad value and missing
/// required key (at `block_place`), and fills in the fallbacks. `block` is its name, as blockName gives it.
KeyValues readKeyValues(std::span<const KeyLine> lines, std::span<const KeySpec* const> keys, const char* block,
                        Place block_place, std::vector<Problem>& problems, const UnknownKey& unknown = {});

/// Pointers to every key of a table, as readKeyValues takes them.
std::vector<const KeySpec*> pointersTo(std::span<const KeySpec> keys);

}  // namespace moltact
