// The language of a command's output: --language, else $MOLTACT_LANGUAGE, else the system's language.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace moltact {

/// Selects $MOLTACT_LANGUAGE or the system's language before the arguments are parsed. Reports a fault in it and then
/// uses English.
void selectLanguage();

/// The codes of all languages with translations, separated by ", " and before the last one by `last_separator`:
/// "en, de", "en or de".
std::string languageCodes(const std::string& last_separator);

/// Adds --language, which takes effect as soon as it is parsed. A code that is not a language or has no translations is
/// a parse error.
void addLanguageOption(CLI::App& app);
/// Adds --language in the same way and also stores the code in `into`.
void addLanguageOption(CLI::App& app, std::string& into);

}  // namespace moltact
