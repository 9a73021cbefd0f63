// The only conversion from a file's bytes to a number in memory. It is restricted to numbers: for a bool, an enum, a
// pointer or a class not every bit pattern is a valid value, so these are built from checked numbers. Any thread.
#pragma once

#include <cstring>
#include <type_traits>

namespace moltact {

/// Reads the number stored at `at` in native byte order; `at` need not be aligned.
template <class T>
T numberAt(const void* at) noexcept {
  static_assert(std::is_arithmetic_v<T> && !std::is_same_v<std::remove_cv_t<T>, bool>,
                "only of numbers is every pattern of bits a value");
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

}  // namespace moltact
