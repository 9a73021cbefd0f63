// A catalogue of translations in the format of msgfmt (.mo; GNU gettext manual, "The Format of GNU MO Files"). It is
// read here and not by the system's gettext because the language changes while the program runs, needs no locale of the
// system, and must work where the system has no gettext. Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/language/plural_rule.h"

namespace moltact {

/// Limit on a catalogue (unit: byte); the program's own is a tenth of it.
inline constexpr std::size_t kMaxCatalogueBytes = 4 << 20;

class MoFile {
 public:
  /// Reads the bytes of a .mo file of either byte order. A Problem where they are none, where an offset leaves the file
  /// or a text is not closed by a NUL, where the texts are not UTF-8, or where the plural rule is none.
  static Expected<MoFile> parse(std::string bytes);

  /// The translation; null where there is none. Lives as long as the MoFile does (which may be moved).
  const char* find(std::string_view context, std::string_view english) const noexcept;
  /// The form that goes with `n`; `one` is the English singular.
  const char* findPlural(std::string_view one, unsigned long n) const noexcept;

  std::size_t size() const noexcept { return entries_.size(); }

 private:
  // Offsets and not views: short bytes move with their string.
  struct Text {
    std::size_t at = 0, size = 0;
  };
  struct Entry {
    Text context, english, translation;  // `english` without its plural; `translation` with all its forms
  };

  std::string_view view(Text t) const noexcept { return {bytes_.data() + t.at, t.size}; }
  const Entry* entry(std::string_view context, std::string_view english) const noexcept;

  std::string bytes_;
  std::vector<Entry> entries_;  // sorted by english, then context
  PluralRule plural_;
};

}  // namespace moltact
