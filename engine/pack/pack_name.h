// Names in a pack: relative paths that denote the same file on every system. Any thread except the haptic one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace moltact {

inline constexpr std::size_t kMaxPackNameBytes = 200;  ///< path of an entry (unit: byte)
inline constexpr std::size_t kMaxPackDepth = 8;        ///< folders above a file

/// Returns why a name is not allowed in a pack, as the rest of a sentence ("leads out of the folder"); empty if it is
/// allowed. Rejected are absolute paths and drives, "..", hidden files, bytes that are not UTF-8 or control a terminal,
/// and names that Windows does not support.
std::string packNameFault(std::string_view name);

/// The name folded for case-insensitive systems (ASCII letters only).
std::string foldedPackName(std::string_view name);

}  // namespace moltact
