// Names in a pack: paths from the pack's top that mean the same file below it on every system. Any thread but the
// haptic one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace moltact {

inline constexpr std::size_t kLongestPackName = 200;  ///< of an entry, with its folders (unit: byte)
inline constexpr std::size_t kDeepestPackName = 8;    ///< folders above a file

/// Why a name cannot stand in a pack, as the rest of a sentence ("leads out of the folder"); empty where it can.
/// Refused are absolute paths and drives, ".." and other ways out, hidden files, bytes that are no UTF-8 or steer a
/// terminal, and what Windows cannot have in a name.
std::string packNameFault(std::string_view name);

/// The same file for a system that does not tell capitals from small letters (those of ASCII).
std::string foldedPackName(std::string_view name);

}  // namespace moltact
