// Generates attempts from choices: well-formed lines with numbers at the ends of their ranges, and with numbers, texts
// and lists that the program never writes.
#pragma once

#include <string>

#include "tests/fuzz/target.h"

namespace moltact::fuzz {

/// An attempt at ubiquitin: a header and up to 25 lines, most of which are readable.
std::string madeAttempt(Choices& choices);

}  // namespace moltact::fuzz
