// A class that never was: attempts at the shipped lessons, with plausible times, answers and touches, written by the
// real log. For tests of the report and for looking at it.
#pragma once

#include <filesystem>

namespace moltact {

/// 24 attempts of 18 students at two lessons: 6 at a device, 9 with a mouse, 3 with the keyboard; some give no name,
/// some stop early, one begins anew. The same seed gives the same class.
void writeSyntheticClass(const std::filesystem::path& folder, unsigned seed);

}  // namespace moltact
