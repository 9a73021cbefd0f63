// Every sentence that a person reads, in the language in use. The English sentence is its own id, as GNU gettext has
// it: `tr("Open")` gives "Öffnen" where the language is German and its catalogue has that text, else "Open". xgettext
// finds the sentences in the sources, assets/translations/de.po holds the German ones, msgfmt makes the build's
// translations/de.mo of it (docs/translating.md).
// Any thread but the haptic one: reading takes no lock, and what tr() once returned stays valid until the program ends,
// also where the language changes.
#pragma once

#include <concepts>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"

/// Marks a constant for xgettext; tr() where it is shown.
#define N_(text) text
/// The same with a context; trc() with the same context where it is shown.
#define NC_(context, text) text

namespace moltact {

/// The sentence in the language in use; `english` itself where there is none.
const char* tr(const char* english) noexcept;
/// The same for what stands in a table of std::string_view.
std::string_view tr(std::string_view english) noexcept;
/// A sentence that means different things in different places: `context` (never shown) distinguishes them.
const char* trc(const char* context, const char* english) noexcept;
/// The form that goes with `n`.
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

/// `sentence` with {0}, {1} … replaced by the pieces (libfmt's rules; "{{" is a brace). Where it is faulty, `english`
/// is filled instead; where that is faulty too, it comes back as it stands.
std::string filled(const char* sentence, const char* english, std::span<const FormatArg> pieces);

/// A sentence with numbered placeholders, so that a translator can put them in another order: trf("{0} of {1}", a, b).
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

/// As trf, in the form that goes with `n`; `n` is no placeholder itself: trnf("{0} atom", "{0} atoms", n, n).
template <class... A>
std::string trnf(const char* one, const char* many, unsigned long n, A&&... pieces) {
  const FormatArg list[]{FormatArg(std::forward<A>(pieces))...};
  return filled(trn(one, many, n), n == 1 ? one : many, list);
}

struct Language {
  std::string code;  ///< "de"; ISO 639-1, which is also the catalogue's file name
  std::string name;  ///< as those who speak it call it: "Deutsch"
};

/// English and every language that has a catalogue in the folder; English first, then by code. A catalogue that cannot
/// be read is left out.
std::vector<Language> languages(const std::filesystem::path& folder);

/// Uses the language from here on: "en", or one whose catalogue CODE.mo is in the folder. A Problem, and the language
/// stays as it was, where there is none or it cannot be read. Window's or command's thread.
std::optional<Problem> setLanguage(std::string_view code, const std::filesystem::path& folder);

/// The code of the language in use.
std::string language();

/// The codes that the environment asks for, most wanted first, as gettext reads it: $LANGUAGE ("de:fr"), which counts
/// only where a locale is set, then the first of $LC_ALL, $LC_MESSAGES and $LANG that is not empty ("de_AT.UTF-8" is
/// "de"). "C" and "POSIX" are "en". Where none is set it is `otherwise`, a locale too ("de-DE").
std::vector<std::string> systemLanguages(const std::string& otherwise = {});

/// The first of the system's languages that the folder has; "en" where it has none of them.
std::string systemLanguage(const std::filesystem::path& folder, const std::string& otherwise = {});

}  // namespace moltact
