// A synthetic class: attempts at the program's lessons, with plausible times, answers and touches, written by the real
// log. For tests and demonstrations of the report.
#pragma once

#include <filesystem>

namespace moltact {

/// 24 attempts of 18 students at two lessons: 6 with a device, 9 with a mouse, 3 with the keyboard. Some give no name,
/// some stop early, one starts again. The same seed gives the same class.
void writeSyntheticClass(const std::filesystem::path& folder, unsigned seed);

}  // namespace moltact
