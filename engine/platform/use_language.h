// Which language the program speaks: what was asked for, else what the environment says. Window's or command's thread.
#pragma once

#include <optional>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

/// The locale that a person has chosen in the system's own settings, "de-DE"; empty where those are the environment's.
std::string systemLocale();

/// $MOLTACT_LANGUAGE; empty where it is not set.
std::string languageOfEnvironment();

/// Uses a language that translationsFolder() has texts for: `wanted`, or where that is empty $MOLTACT_LANGUAGE, or
/// where that is empty too the first of the system's languages that there is. A Problem, and the language stays as it
/// was, where there are no texts in the one that was asked for.
std::optional<Problem> useLanguage(const std::string& wanted);

}  // namespace moltact
