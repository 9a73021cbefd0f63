// Reads a lesson's pictures: PNG and JPEG files beside it. Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

/// Rows from the top, three bytes (red, green, blue; sRGB) per pixel. Transparent parts are blended with white.
struct LessonPicture {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;
};

/// Larger files and pictures are rejected (unit: byte; pixels per side).
inline constexpr std::size_t kLargestPictureFile = std::size_t{8} << 20;
inline constexpr int kLargestPicture_px = 4096;

/// Accepts any bytes. A Problem (without a file) if they are not a complete PNG or JPEG, or too large.
Expected<LessonPicture> readLessonPicture(std::string_view bytes);

/// Reads a picture from a file.
Expected<LessonPicture> readLessonPicture(const std::filesystem::path& file);

/// Halves width and height, averaging four pixels each, until neither side exceeds `longest_px`.
LessonPicture halvedTo(LessonPicture picture, int longest_px);

}  // namespace moltact
