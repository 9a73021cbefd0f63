// Attempts put together by choices: lines of the right form, with numbers at the ends of their ranges, and with
// numbers, texts and lists that no program of ours writes.
#pragma once

#include <string>

#include "tests/fuzz/target.h"

namespace moltact::fuzz {

/// The text of an attempt at ubiquitin: a header and up to 25 lines, most of which can be read.
std::string madeAttempt(Choices& choices);

}  // namespace moltact::fuzz
