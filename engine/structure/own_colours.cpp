// Colours by name and number, and their perceived difference.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/structure/colouring.h"

namespace moltact {
namespace {

constexpr NamedColour kOwnColours[] = {
    {"red", {204, 51, 63}},     {"rose", {238, 136, 150}}, {"brown", {136, 84, 48}},   {"yellow", {232, 214, 64}},
    {"olive", {136, 136, 34}},  {"green", {34, 136, 51}},  {"mint", {136, 212, 160}},  {"teal", {0, 150, 150}},
    {"sky", {102, 190, 232}},   {"blue", {52, 92, 196}},   {"violet", {136, 88, 190}}, {"magenta", {190, 60, 150}},
    {"white", {240, 240, 240}}, {"grey", {150, 150, 150}}, {"dark", {80, 80, 88}},
};

double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

}  // namespace

std::array<double, 3> linearRgb(const Rgb8& colour) {
  return {linear(colour[0]), linear(colour[1]), linear(colour[2])};
}

std::array<double, 3> labOfLinear(const std::array<double, 3>& rgb) {
  const auto [r, g, b] = rgb;
  const double white[3] = {0.95047, 1.0, 1.08883};
  const double xyz[3] = {0.4124564 * r + 0.3575761 * g + 0.1804375 * b, 0.2126729 * r + 0.7151522 * g + 0.0721750 * b,
                         0.0193339 * r + 0.1191920 * g + 0.9503041 * b};
  double f[3];
  for (int k = 0; k < 3; ++k) {
    const double t = xyz[k] / white[k];
    f[k] = t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
  }
  return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

std::span<const NamedColour> namedColours() { return kOwnColours; }

Expected<Rgb8> parseColour(std::string_view text) {
  for (const NamedColour& n : kOwnColours)
    if (n.name == text) return n.colour;
  if (text.size() == 7 && text[0] == '#') {
    Rgb8 out{};
    bool sound = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const char* const at = text.data() + 1 + 2 * k;
      unsigned value = 0;
      const auto [end, error] = std::from_chars(at, at + 2, value, 16);
      sound = sound && error == std::errc{} && end == at + 2;
      out[k] = static_cast<std::uint8_t>(value);
    }
    if (sound) return out;
  }
  std::string names;
  for (const NamedColour& n : kOwnColours) names += (names.empty() ? "" : ", ") + std::string(n.name);
  return Problem{
      {}, 0, 0, trf("'{0}' is no colour", text), trf("write one of {0}, or six digits as in #3366cc", names)};
}

double colourDistance(const Rgb8& a, const Rgb8& b) {
  const auto x = labOfLinear(linearRgb(a)), y = labOfLinear(linearRgb(b));
  return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

}  // namespace moltact
