// Appends numbers to a row of a CSV file, each after a comma. With 17 digits, reading restores the same value.
#pragma once

#include <charconv>
#include <string>

#include "engine/core/units.h"

namespace moltact {

inline void appendNumber(std::string& row, double value) {
  char digits[40];
  digits[0] = ',';
  const auto end = std::to_chars(digits + 1, digits + sizeof digits, value, std::chars_format::general, 17).ptr;
  row.append(digits, end);
}

inline void appendNumbers(std::string& row, const Vec3& v) {
  for (int k = 0; k < 3; ++k) appendNumber(row, v[k]);
}

}  // namespace moltact
