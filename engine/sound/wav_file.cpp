#include "engine/sound/wav_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "engine/platform/write_file.h"

namespace moltact {
namespace {

void number(std::string& out, std::uint32_t value, int bytes) {
  for (int k = 0; k < bytes; ++k) out += char(value >> 8 * k & 255u);
}

}  // namespace

std::optional<Problem> writeWav(const std::filesystem::path& file, std::span<const float> samples, int samples_per_s) {
  const auto bytes = std::uint32_t(samples.size() * 2);
  std::string out = "RIFF";
  out.reserve(44 + bytes);
  number(out, 36 + bytes, 4);
  out += "WAVEfmt ";
  number(out, 16, 4);
  number(out, 1, 2);  // PCM
  number(out, 1, 2);  // one channel
  number(out, std::uint32_t(samples_per_s), 4);
  number(out, std::uint32_t(samples_per_s) * 2, 4);
  number(out, 2, 2);
  number(out, 16, 2);
  out += "data";
  number(out, bytes, 4);
  for (const float sample : samples)
    number(out, std::uint32_t(std::int32_t(std::lround(32767.0f * std::clamp(sample, -1.0f, 1.0f)))), 2);
  return writeWhole(file, out);
}

}  // namespace moltact
