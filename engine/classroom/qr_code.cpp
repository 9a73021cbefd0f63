#include "engine/classroom/qr_code.h"

#include <qrencode.h>

#include <memory>

#include "engine/core/markup.h"

namespace moltact {
namespace {

constexpr std::size_t kQuiet = 4;  // modules around the code, by ISO/IEC 18004

}  // namespace

QrCode qrCode(std::string_view text) {
  const std::string copy(text);
  const std::unique_ptr<QRcode, void (*)(QRcode*)> made(QRcode_encodeString8bit(copy.c_str(), 0, QR_ECLEVEL_M),
                                                        QRcode_free);
  QrCode out;
  if (!made) return out;
  out.width = std::size_t(made->width);
  for (std::size_t k = 0; k < out.width * out.width; ++k) out.dark.push_back(made->data[k] & 1);
  return out;
}

std::string qrText(const QrCode& code) {
  if (code.width == 0) return {};
  const std::size_t whole = code.width + 2 * kQuiet;
  const auto light = [&](std::size_t row, std::size_t column) {
    const bool inside = row >= kQuiet && row < kQuiet + code.width && column >= kQuiet && column < kQuiet + code.width;
    return row < whole && !(inside && code.at(row - kQuiet, column - kQuiet));
  };
  std::string out;
  for (std::size_t row = 0; row < whole; row += 2) {
    for (std::size_t column = 0; column < whole; ++column) {
      const bool upper = light(row, column), under = light(row + 1, column);
      out += upper ? (under ? "█" : "▀") : (under ? "▄" : " ");
    }
    out += '\n';
  }
  return out;
}

std::string qrSvg(const QrCode& code, std::string_view label) {
  if (code.width == 0) return {};
  const std::string size = std::to_string(code.width + 2 * kQuiet);
  std::string path;
  for (std::size_t row = 0; row < code.width; ++row)
    for (std::size_t column = 0; column < code.width; ++column)
      if (code.at(row, column))
        path += "M" + std::to_string(column + kQuiet) + " " + std::to_string(row + kQuiet) + "h1v1h-1z";
  return "<svg class=\"qr\" viewBox=\"0 0 " + size + " " + size + "\" role=\"img\" aria-label=\"" + escaped(label) +
         "\"><rect width=\"" + size + "\" height=\"" + size + "\" fill=\"#fff\"/><path d=\"" + path +
         "\" fill=\"#000\"/></svg>";
}

}  // namespace moltact
