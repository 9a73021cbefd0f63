// The only conversion from a file's bytes to a number in memory. Only numbers are made so: a bool, an enum, a pointer
// or a class does not have a value for every pattern of bits, and so is made from numbers that are checked first. Any
// thread.
#pragma once

#include <cstring>
#include <type_traits>

namespace moltact {

/// The number whose bytes, in this machine's order, lie at `at`, which need not be aligned.
template <class T>
T numberAt(const void* at) noexcept {
  static_assert(std::is_arithmetic_v<T> && !std::is_same_v<std::remove_cv_t<T>, bool>,
                "only of numbers is every pattern of bits a value");
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

}  // namespace moltact
