// The secrets of a class: its code, the teacher's token, the students' tokens. Pure functions; any thread but the haptic
// one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace moltact {

/// Text of `count` signs from random bytes, without signs that are easily confused (0 o, 1 l i). Each sign has 31
/// values, equally likely. `bytes(n)` supplies n random bytes.
template <class Bytes>
std::string secretText(std::size_t count, const Bytes& bytes) {
  static constexpr std::string_view kSigns = "23456789abcdefghjkmnpqrstuvwxyz";
  std::string out;
  while (out.size() < count)
    for (const char byte : bytes(count)) {
      const std::size_t value = static_cast<unsigned char>(byte);
      if (value < 256 / kSigns.size() * kSigns.size() && out.size() < count) out += kSigns[value % kSigns.size()];
    }
  return out;
}

/// Whether two texts are equal. The time depends on the length of `given` only, so that it tells nothing about `secret`.
inline bool sameSecret(std::string_view secret, std::string_view given) {
  unsigned differs = secret.size() == given.size() ? 0 : 1;
  for (std::size_t k = 0; k < given.size(); ++k)
    differs |= unsigned(static_cast<unsigned char>(given[k])) ^
               static_cast<unsigned char>(secret.empty() ? 0 : secret[k % secret.size()]);
  return differs == 0;
}

}  // namespace moltact
