// A translation catalogue in the format of msgfmt (.mo; GNU gettext manual, "The Format of GNU MO Files"). The program
// reads it without the system's gettext: the language changes at run time, needs no system locale, and must work on
// systems without gettext. Any thread except the haptic one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/language/plural_rule.h"

namespace moltact {

/// Limit on a catalogue (unit: byte); the program's own catalogue is a tenth of it.
inline constexpr std::size_t kMaxCatalogueBytes = 4 << 20;

class MoFile {
 public:
  /// Parses the bytes of a .mo file of either byte order. Returns a Problem if the format is wrong, an offset is
  /// outside the file, a text has no terminating NUL or is not UTF-8, or the plural rule is invalid.
  static Expected<MoFile> parse(std::string bytes);

  /// The translation, or null. Valid as long as the MoFile, which may be moved.
  const char* find(std::string_view context, std::string_view english) const noexcept;
  /// The plural form for `n`, or null; `one` is the English singular. Valid as for find().
  const char* findPlural(std::string_view one, unsigned long n) const noexcept;

  std::size_t size() const noexcept { return entries_.size(); }

 private:
  // Offsets instead of views, because a short string moves its bytes with itself.
  struct Text {
    std::size_t at = 0, size = 0;
  };
  struct Entry {
    Text context, english, translation;  // `english` without its plural; `translation` with all forms
  };

  std::string_view view(Text t) const noexcept { return {bytes_.data() + t.at, t.size}; }
  const Entry* entry(std::string_view context, std::string_view english) const noexcept;

  std::string bytes_;
  std::vector<Entry> entries_;  // sorted by english, then context
  PluralRule plural_;
};

}  // namespace moltact
