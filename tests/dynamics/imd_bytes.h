// The bytes of an IMD server, and the messages of a client read back. Written from the protocol's description, without
// the program's own reader and writer.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/units.h"

namespace moltact::test {

using Bytes = std::vector<std::uint8_t>;

struct ImdServerBytes {
  int version = 2;
  bool little = true;
  bool wrapped = false;  // a flag of version 3

  template <class T>
  static void append(Bytes& to, T value, bool little_endian) {
    const auto raw = std::bit_cast<std::array<std::uint8_t, sizeof(T)>>(value);
    const bool turn = little_endian != (std::endian::native == std::endian::little);
    for (std::size_t k = 0; k < raw.size(); ++k) to.push_back(raw[turn ? raw.size() - 1 - k : k]);
  }
  static Bytes header(std::int32_t type, std::int32_t length) {
    Bytes out;
    append(out, type, false);
    append(out, length, false);
    return out;
  }
  Bytes greeting() const {
    Bytes out;
    append(out, std::int32_t(4), false);
    append(out, std::int32_t(version), little);
    if (version < 3) return out;
    const Bytes session = header(10, 7);
    out.insert(out.end(), session.begin(), session.end());
    for (const int flag : {1, 1, 1, 1, wrapped ? 1 : 0, 1, 1}) out.push_back(std::uint8_t(flag));
    return out;
  }
  Bytes energies(float kelvin, float potential) const {
    Bytes out = header(1, 1);
    append(out, std::int32_t(7), little);
    for (const float value : {kelvin, 0.0f, potential, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f}) append(out, value, little);
    return out;
  }
  Bytes time(double ps) const {
    Bytes out = header(12, 1);
    append(out, 0.002, little);
    append(out, ps, little);
    append(out, std::int64_t(ps / 0.002), little);
    return out;
  }
  Bytes box() const {
    Bytes out = header(13, 1);
    for (int k = 0; k < 9; ++k) append(out, k % 4 ? 0.0f : 50.0f, little);
    return out;
  }
  Bytes places(std::span<const Vec3> at_A, std::int32_t type = 2) const {
    Bytes out = header(type, std::int32_t(at_A.size()));
    for (const Vec3& v : at_A)
      for (int k = 0; k < 3; ++k) append(out, float(v[k]), little);
    return out;
  }
  /// A frame as a server of this version sends it.
  Bytes frame(std::span<const Vec3> at_A, double ps = 0.0) const {
    Bytes out;
    const auto add = [&](const Bytes& more) { out.insert(out.end(), more.begin(), more.end()); };
    if (version == 3) add(time(ps));
    if (version == 3) add(energies(300.0f, -41.84f));
    if (version == 3) add(box());
    add(places(at_A));
    if (version == 3) add(places(at_A, 14));
    if (version == 3) add(places(at_A, 15));
    return out;
  }
};

struct ImdSent {
  std::int32_t type = 0, value = 0;
  std::vector<std::int32_t> atoms;
  std::vector<Vec3> forces;
};

/// The whole messages at the front of what a client has sent, which are removed from it.
inline std::vector<ImdSent> takeSent(Bytes& bytes, bool little = true) {
  const auto number = [&](std::size_t at, bool little_endian) {
    std::uint32_t out = 0;
    for (std::size_t k = 0; k < 4; ++k) out |= std::uint32_t(bytes[at + k]) << 8 * (little_endian ? k : 3 - k);
    return out;
  };
  std::vector<ImdSent> out;
  std::size_t at = 0;
  while (bytes.size() - at >= 8) {
    ImdSent next{std::int32_t(number(at, false)), std::int32_t(number(at + 4, false)), {}, {}};
    const std::size_t count = next.type == 6 ? std::size_t(next.value) : 0;
    if (bytes.size() - at < 8 + 16 * count) break;
    at += 8;
    for (std::size_t k = 0; k < count; ++k) next.atoms.push_back(std::int32_t(number(at + 4 * k, little)));
    at += 4 * count;
    for (std::size_t k = 0; k < count; ++k, at += 12)
      next.forces.push_back({std::bit_cast<float>(number(at, little)), std::bit_cast<float>(number(at + 4, little)),
                             std::bit_cast<float>(number(at + 8, little))});
    out.push_back(std::move(next));
  }
  bytes.erase(bytes.begin(), bytes.begin() + std::ptrdiff_t(at));
  return out;
}

/// "3:0 6:0 8:10": the types and values of messages, in their order.
inline std::string wordsOf(std::span<const ImdSent> sent) {
  std::string out;
  for (const ImdSent& s : sent)
    out += (out.empty() ? "" : " ") + std::to_string(s.type) + ':' + std::to_string(s.value);
  return out;
}

}  // namespace moltact::test
