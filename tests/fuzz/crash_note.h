// Prints to stderr which run crashed, was ended by a sanitizer or hung, so that it can be repeated alone.
#pragma once

#include <string>

namespace moltact::fuzz {

/// Installs the handlers that print the last run begun.
void tellCrashes();
/// `hang_s`: a longer run counts as a hang.
void beginRun(const std::string& name, unsigned hang_s);
void endRun();

}  // namespace moltact::fuzz
