#include "app/ui/extensions/displacement_text.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace moltact {

std::string textOfDisplacements(std::span<const Vec3> displacements_A) {
  std::string out;
  for (const Vec3& v : displacements_A)
    for (int c = 0; c < 3; ++c) {
      if (!out.empty()) out += ' ';
      out += std::to_string(std::lround(v[c] / kRecorded_A));
    }
  return out;
}

std::vector<Vec3> displacementsOfText(std::string_view text) {
  std::vector<Vec3> out;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int c = 0; at < end; c = (c + 1) % 3) {
    int value = 0;
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc() || value < -1'000'000 || value > 1'000'000) return {};
    if (c == 0) out.emplace_back(0.0);
    out.back()[c] = value * kRecorded_A;
    at = read.ptr;
    if (at < end && *at++ != ' ') return {};
  }
  return out;
}

}  // namespace moltact
