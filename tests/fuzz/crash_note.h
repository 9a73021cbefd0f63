// Which run it was that crashed, was ended by a sanitizer or did not end: told on stderr, so that it can be run again
// alone.
#pragma once

#include <string>

namespace moltact::fuzz {

/// From now on the last run begun is told when the program ends in any of these ways.
void tellCrashes();
/// `hang_s`: a run that takes so long does not end.
void beginRun(const std::string& name, unsigned hang_s);
void endRun();

}  // namespace moltact::fuzz
