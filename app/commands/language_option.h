// The language in which a command speaks: --language, else $MOLTACT_LANGUAGE, else the system's.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace moltact {

/// Before the arguments are read: $MOLTACT_LANGUAGE or the system's language. A fault in it is reported, and the
/// language is English.
void speakAsAsked();

/// Adds --language, which is followed as soon as it is read; a code that is none, or has no texts, ends the reading as
/// other faulty arguments do.
void addLanguageOption(CLI::App& app);
/// The same, and keeps the code.
void addLanguageOption(CLI::App& app, std::string& into);

}  // namespace moltact
