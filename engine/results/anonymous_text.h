// Takes people's names out of texts that students have typed, for reports without names. Pure functions; any thread but
// the haptic one.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace moltact {

/// Replaces names in a text: a whole name, and each of its words of at least two letters, wherever they stand as words,
/// in either case of ASCII letters.
class NameCover {
 public:
  /// `codes`: for each name, what replaces it.
  explicit NameCover(const std::map<std::string, std::string>& codes);
  std::string covered(std::string_view text) const;

 private:
  struct Hidden {
    std::string name, code;  // the name in lower case
  };
  std::vector<Hidden> longest_first_;
};

/// Whether the text contains the name as a word, in either case of ASCII letters.
bool mentions(std::string_view text, std::string_view name);

/// Whether the text is a number, also with a unit: "2.5 Å". It then tells nothing about who wrote it.
bool isMeasurement(std::string_view text);

/// What replaces a typed text: "(7 words left out)"; a measurement or an empty text stays.
std::string wordsLeftOut(const std::string& text);

}  // namespace moltact
