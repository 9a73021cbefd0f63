// A picture in memory and as a PNG file. Plain data; usable on every thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

/// Rows from the top, three bytes (red, green, blue; sRGB) per pixel.
struct Picture {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;

  const std::uint8_t* at(int x, int y) const { return rgb.data() + 3 * (std::size_t(y) * width_px + x); }
};

/// Writes a PNG file; returns a Problem on failure.
std::optional<Problem> writePng(const std::filesystem::path& file, const Picture& picture);

/// Reads a PNG file of any colour type as RGB.
Expected<Picture> readPng(const std::filesystem::path& file);

}  // namespace moltact
