// An address as a QR code, by libqrencode. Pure functions; any thread but the haptic one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace moltact {

/// The modules of the code, row by row, without the quiet zone; true is dark. Empty if the text is too long for one.
struct QrCode {
  std::size_t width = 0;
  std::vector<bool> dark;
  bool at(std::size_t row, std::size_t column) const { return dark[row * width + column]; }
};
QrCode qrCode(std::string_view text);

/// The code for a terminal, two rows of modules per line, with its quiet zone. Light modules are drawn, so that it is dark on
/// light in a dark terminal; telephones also read the inverse.
std::string qrText(const QrCode& code);
/// The code as SVG, dark on light whatever the page's colours are; `label` is its accessible name.
std::string qrSvg(const QrCode& code, std::string_view label);

}  // namespace moltact
