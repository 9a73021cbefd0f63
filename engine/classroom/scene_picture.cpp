#include "engine/classroom/scene_picture.h"

#include <cstdint>

namespace moltact {
namespace {

int base64Value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

}  // namespace

std::optional<std::string> fromBase64(std::string_view text) {
  if (text.size() % 4 != 0) return std::nullopt;
  std::size_t padding = 0;
  while (padding < 2 && text.ends_with('=')) {
    text.remove_suffix(1);
    ++padding;
  }
  std::string out;
  out.reserve(text.size() * 3 / 4);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int value = base64Value(c);
    if (value < 0) return std::nullopt;
    bits = bits << 6 | std::uint32_t(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    out += char(bits >> count & 0xFF);
  }
  // The bits that the padding leaves over are zero.
  if ((bits & ((1U << count) - 1)) != 0) return std::nullopt;
  return out;
}

bool isSmallJpeg(std::string_view bytes) {
  if (bytes.size() > kMaxPictureBytes || !bytes.starts_with("\xFF\xD8\xFF") || !bytes.ends_with("\xFF\xD9"))
    return false;
  const auto at = [&](std::size_t k) { return int(static_cast<unsigned char>(bytes[k])); };
  // Segments: FF, marker, length of the rest in two bytes.
  for (std::size_t k = 2; k + 9 <= bytes.size();) {
    if (at(k) != 0xFF) return false;
    const int marker = at(k + 1), length = at(k + 2) << 8 | at(k + 3);
    // Frame headers (SOF), but not the tables DHT, JPG and DAC that have numbers between them.
    if (marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC) {
      const int high = at(k + 5) << 8 | at(k + 6), wide = at(k + 7) << 8 | at(k + 8);
      return length >= 8 && high > 0 && wide > 0 && high <= kMaxPictureSide && wide <= kMaxPictureSide;
    }
    if (marker < 0xC4 || marker == 0xDA || length < 2) return false;  // no segment, or the scan before a frame
    k += 2 + std::size_t(length);
  }
  return false;
}

}  // namespace moltact
