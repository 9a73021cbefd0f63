// The assignment of students to the groups of a study. Equal on every machine. Pure functions; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace moltact {

/// The group (0 to groups - 1) of each of n students, by permuted blocks: each block of `block` students in turn contains
/// every group equally often, in a random order. `block` is a multiple of `groups`, which is not 0.
std::vector<std::size_t> permutedBlocks(std::size_t n, std::size_t groups, std::size_t block, std::uint64_t seed);

/// n different codes of five letters and digits without those that are easily confused: "K4QT7". Any two differ at two
/// places or more, so that one wrong letter gives no other student's code. At most kMaxStudyStudents.
std::vector<std::string> studyCodes(std::size_t n, std::uint64_t seed);

inline constexpr std::size_t kMaxStudyStudents = 2000;

}  // namespace moltact
