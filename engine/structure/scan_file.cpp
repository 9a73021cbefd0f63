#include "engine/structure/scan_file.h"

#include <bit>
#include <cstdint>
#include <cstdio>

namespace moltact {
namespace {

constexpr double kMetre_per_A = 1e-10;

void appendDigits(std::string& text, double value, int digits) {
  char buffer[40];
  const int size = std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
  text.append(buffer, std::size_t(size));
}

}  // namespace

std::string scanTable(const HeightField& field) {
  std::string out = "x_A,y_A,height_A,atom\n";
  for (int row = 0; row < field.rows; ++row)
    for (int column = 0; column < field.columns; ++column) {
      appendDigits(out, field.spacing_A * column, 9);
      out += ',';
      appendDigits(out, field.spacing_A * row, 9);
      out += ',';
      appendDigits(out, field.at(column, row), 17);
      out += ',';
      out += std::to_string(field.atoms[field.index(column, row)] + 1);
      out += '\n';
    }
  return out;
}

std::string gwyddionField(const HeightField& field, std::string_view title) {
  std::string out = "Gwyddion Simple Field 1.0\nXRes = " + std::to_string(field.columns) +
                    "\nYRes = " + std::to_string(field.rows) + "\nXReal = ";
  appendDigits(out, kMetre_per_A * field.spacing_A * field.columns, 9);
  out += "\nYReal = ";
  appendDigits(out, kMetre_per_A * field.spacing_A * field.rows, 9);
  out += "\nXYUnits = m\nZUnits = m\nTitle = ";
  for (const char c : title) out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  out += '\n';
  out.append(4 - out.size() % 4, '\0');  // one to four zeros, up to a multiple of four
  for (int row = field.rows - 1; row >= 0; --row)
    for (int column = 0; column < field.columns; ++column) {
      const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(kMetre_per_A * field.at(column, row)));
      for (int k = 0; k < 4; ++k) out += static_cast<char>(bits >> (8 * k) & 0xFF);
    }
  return out;
}

}  // namespace moltact
