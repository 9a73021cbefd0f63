// Selects the program's language: the requested one, else that of the environment. Window's or command's thread.
#pragma once

#include <optional>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

/// The locale chosen in the system's settings, "de-DE"; empty if the environment variables determine it.
std::string systemLocale();

/// $MOLTACT_LANGUAGE; empty if it is not set.
std::string languageOfEnvironment();

/// Sets the language to one that translationsFolder() contains: `wanted`; if that is empty $MOLTACT_LANGUAGE; if that
/// is empty too, the first available language of the system. Returns a Problem and keeps the present language if the
/// requested one has no translation.
std::optional<Problem> useLanguage(const std::string& wanted);

}  // namespace moltact
