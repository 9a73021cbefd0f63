// Colour differences for each kind of colour vision, computed independently. Colour vision is simulated after Brettel,
// Viénot and Mollon (1997) for tritanopia and Viénot, Brettel and Mollon (1999) for protanopia and deuteranopia;
// engine/structure/colour_sight.cpp uses Machado, Oliveira and Fernandes (2009).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace moltact::test {

using Three = std::array<double, 3>;
enum class Sight { Normal, Protanopia, Deuteranopia, Tritanopia };
inline constexpr Sight kSights[] = {Sight::Normal, Sight::Protanopia, Sight::Deuteranopia, Sight::Tritanopia};
inline std::string nameOf(Sight s) {
  const char* const names[] = {"normal sight", "protanopia", "deuteranopia", "tritanopia"};
  return names[int(s)];
}

inline Three times(const double (&m)[9], const Three& v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
          m[6] * v[0] + m[7] * v[1] + m[8] * v[2]};
}

/// A colour in linear sRGB as this kind of vision perceives it, in the same space.
inline Three simulated(Sight sight, const Three& rgb) {
  // The matrices for the cone fundamentals of Smith and Pokorny (1975) and the primaries of sRGB.
  constexpr double protan[9] = {0.11238, 0.88762, 0, 0.11238, 0.88762, 0, 0.00401, -0.00401, 1};
  constexpr double deutan[9] = {0.29275, 0.70725, 0, 0.29275, 0.70725, 0, -0.02234, 0.02234, 1};
  constexpr double tritan_1[9] = {1.01277, 0.13548, -0.14826, -0.01243, 0.86812, 0.14431, 0.07589, 0.80500, 0.11911};
  constexpr double tritan_2[9] = {0.93678, 0.18979, -0.12657, 0.06154, 0.81526, 0.12320, -0.37562, 1.12767, 0.24796};
  switch (sight) {
    case Sight::Normal:
      return rgb;
    case Sight::Protanopia:
      return times(protan, rgb);
    case Sight::Deuteranopia:
      return times(deutan, rgb);
    case Sight::Tritanopia:
      return times(0.03901 * rgb[0] - 0.02788 * rgb[1] - 0.01113 * rgb[2] >= 0.0 ? tritan_1 : tritan_2, rgb);
  }
  return rgb;
}

/// CIE L*a*b* (1976) of linear sRGB under the white of D65.
inline Three labOf(const Three& rgb) {
  constexpr double to_xyz[9] = {0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522,
                                0.0721750, 0.0193339, 0.1191920, 0.9503041};
  Three clamped;
  for (int k = 0; k < 3; ++k) clamped[std::size_t(k)] = std::clamp(rgb[std::size_t(k)], 0.0, 1.0);
  const Three xyz = times(to_xyz, clamped), white = {0.95047, 1.0, 1.08883};
  Three f;
  for (std::size_t k = 0; k < 3; ++k) {
    const double t = xyz[k] / white[k];
    f[k] = t > std::pow(6.0 / 29.0, 3) ? std::cbrt(t) : t * 841.0 / 108.0 + 4.0 / 29.0;
  }
  return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

/// CIEDE2000 after G. Sharma, W. Wu and E. N. Dalal, Color Res. Appl. 30, 21 (2005), formulas 2 to 22.
inline double ciede2000(const Three& lab1, const Three& lab2) {
  const double rad = std::acos(-1.0) / 180.0;
  const double c_bar = 0.5 * (std::hypot(lab1[1], lab1[2]) + std::hypot(lab2[1], lab2[2]));
  const double stretch = 1.5 - 0.5 * std::sqrt(std::pow(c_bar, 7) / (std::pow(c_bar, 7) + std::pow(25.0, 7)));
  const double a1 = stretch * lab1[1], a2 = stretch * lab2[1];
  const double c1 = std::hypot(a1, lab1[2]), c2 = std::hypot(a2, lab2[2]);
  double h1 = std::atan2(lab1[2], a1) / rad, h2 = std::atan2(lab2[2], a2) / rad;
  if (h1 < 0) h1 += 360;
  if (h2 < 0) h2 += 360;
  const bool grey = c1 == 0.0 || c2 == 0.0;
  double dh = grey ? 0.0 : h2 - h1;
  if (dh > 180) dh -= 360;
  if (dh < -180) dh += 360;
  double h_bar = h1 + h2;
  if (!grey) h_bar = std::abs(h1 - h2) <= 180 ? h_bar / 2 : h_bar < 360 ? (h_bar + 360) / 2 : (h_bar - 360) / 2;
  const double dL = lab2[0] - lab1[0], dC = c2 - c1, dH = 2 * std::sqrt(c1 * c2) * std::sin(0.5 * dh * rad);
  const double L = 0.5 * (lab1[0] + lab2[0]) - 50, C = 0.5 * (c1 + c2);
  const double T = 1 - 0.17 * std::cos((h_bar - 30) * rad) + 0.24 * std::cos(2 * h_bar * rad) +
                   0.32 * std::cos((3 * h_bar + 6) * rad) - 0.20 * std::cos((4 * h_bar - 63) * rad);
  const double SL = 1 + 0.015 * L * L / std::sqrt(20 + L * L), SC = 1 + 0.045 * C, SH = 1 + 0.015 * C * T;
  const double RC = 2 * std::sqrt(std::pow(C, 7) / (std::pow(C, 7) + std::pow(25.0, 7)));
  const double RT = -RC * std::sin(60 * rad * std::exp(-std::pow((h_bar - 275) / 25, 2)));
  const double l = dL / SL, c = dC / SC, h = dH / SH;
  return std::sqrt(l * l + c * c + h * h + RT * c * h);
}

template <class Rgb8>
Three linearOf(const Rgb8& colour) {
  Three out;
  for (std::size_t k = 0; k < 3; ++k) {
    const double c = colour[k] / 255.0;
    out[k] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return out;
}

template <class Rgb8>
double seenDistance(Sight sight, const Rgb8& a, const Rgb8& b) {
  return ciede2000(labOf(simulated(sight, linearOf(a))), labOf(simulated(sight, linearOf(b))));
}

}  // namespace moltact::test
