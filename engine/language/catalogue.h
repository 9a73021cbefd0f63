// Translation of every sentence that a person reads. The English sentence is its own id, as in GNU gettext:
// `tr("Open")` returns "Öffnen" if the language is German and its catalogue contains the text, else "Open". xgettext
// collects the sentences from the sources, assets/translations/de.po contains the German ones, and msgfmt compiles it
// to translations/de.mo (docs/translating.md).
//
// Any thread except the haptic one. Reading takes no lock. A result of tr() stays valid until the program ends, even if
// the language changes.
#pragma once

#include <concepts>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"

/// Marks a constant for xgettext; translate it with tr() where it is shown.
#define N_(text) text
/// The same with a context; translate it with trc() and the same context.
#define NC_(context, text) text

namespace moltact {

/// Translates a sentence; returns `english` itself if there is no translation.
const char* tr(const char* english) noexcept;
/// The same for a std::string_view from a table.
std::string_view tr(std::string_view english) noexcept;
/// Translates a sentence with several meanings; `context` (never shown) distinguishes them.
const char* trc(const char* context, const char* english) noexcept;
/// Selects and translates the plural form for `n`.
const char* trn(const char* one, const char* many, unsigned long n) noexcept;

/// The value for a placeholder: text or a whole number. A number with a fraction or a unit is a quantityText
/// (engine/language/quantity_text.h).
class FormatArg {
 public:
  FormatArg(std::string text) : text_(std::move(text)) {}
  FormatArg(std::string_view text) : text_(text) {}
  FormatArg(const char* text) : text_(text ? text : "") {}
  template <std::integral T>
  requires(!std::same_as<T, bool> && !std::same_as<T, char>) FormatArg(T number) : text_(std::to_string(number)) {}
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Replaces {0}, {1} … in `sentence` by the arguments (libfmt's rules; "{{" is a brace). An invalid `sentence` is
/// replaced by `english`; if that is invalid too, it is returned unchanged.
std::string filled(const char* sentence, const char* english, std::span<const FormatArg> pieces);

/// Translates a sentence with numbered placeholders, which a translation may reorder: trf("{0} of {1}", a, b).
template <class... A>
std::string trf(const char* english, A&&... pieces) {
  const FormatArg list[]{FormatArg(std::forward<A>(pieces))...};
  return filled(tr(english), english, list);
}

template <class... A>
std::string trcf(const char* context, const char* english, A&&... pieces) {
  const FormatArg list[]{FormatArg(std::forward<A>(pieces))...};
  return filled(trc(context, english), english, list);
}

/// As trf, with the plural form for `n`. `n` itself is not a placeholder: trnf("{0} atom", "{0} atoms", n, n).
template <class... A>
std::string trnf(const char* one, const char* many, unsigned long n, A&&... pieces) {
  const FormatArg list[]{FormatArg(std::forward<A>(pieces))...};
  return filled(trn(one, many, n), n == 1 ? one : many, list);
}

struct Language {
  std::string code;  ///< ISO 639-1 code and name of the catalogue's file: "de"
  std::string name;  ///< in the language itself: "Deutsch"
};

/// English and every language with a readable catalogue in the folder; English first, then by code.
std::vector<Language> languages(const std::filesystem::path& folder);

/// Sets the language: "en", or one whose catalogue CODE.mo is in the folder. Returns a Problem and keeps the present
/// language if the catalogue is missing or unreadable. Window's or command's thread.
std::optional<Problem> setLanguage(std::string_view code, const std::filesystem::path& folder);

/// The code of the language in use.
std::string language();

/// The languages requested by the environment, in order of preference, by gettext's rules. $LANGUAGE ("de:fr") counts
/// only if a locale is set. Next comes the first nonempty of $LC_ALL, $LC_MESSAGES and $LANG ("de_AT.UTF-8" is "de").
/// "C" and "POSIX" mean "en". If none is set, the locale `otherwise` ("de-DE") is used.
std::vector<std::string> systemLanguages(const std::string& otherwise = {});

/// The first of systemLanguages() that the folder contains, else "en".
std::string systemLanguage(const std::filesystem::path& folder, const std::string& otherwise = {});

}  // namespace moltact
