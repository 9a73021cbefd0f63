// The one way from the bytes of a file to a number in memory. Only numbers are made so: a bool, an enum, a pointer or a
// class takes values that not every pattern of bits is, and so is made from numbers, which are looked at first. Any
// thread.
#pragma once

#include <cstring>
#include <type_traits>

namespace moltact {

/// The number whose bytes, as this machine orders them, stand at `at`. `at` need not be aligned.
template <class T>
T numberAt(const void* at) noexcept {
  static_assert(std::is_arithmetic_v<T> && !std::is_same_v<std::remove_cv_t<T>, bool>,
                "only of numbers is every pattern of bits a value");
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

}  // namespace moltact
