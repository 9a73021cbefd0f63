// Pictures of a lesson: PNG and JPEG files beside it. Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

/// Rows from the top, three bytes (red, green, blue; sRGB) a pixel. Where the file lets its ground through, it is white.
struct LessonPicture {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;
};

/// Larger files and pictures are refused (unit: byte; pixel a side).
inline constexpr std::size_t kLargestPictureFile = std::size_t{8} << 20;
inline constexpr int kLargestPicture_px = 4096;

/// Takes any bytes. A problem (without a file) where they are no whole PNG or JPEG, or too large.
Expected<LessonPicture> readLessonPicture(std::string_view bytes);

/// The same of a file.
Expected<LessonPicture> readLessonPicture(const std::filesystem::path& file);

/// With half the width and height, each pixel the mean of four, until neither side is longer than `longest_px`.
LessonPicture halvedTo(LessonPicture picture, int longest_px);

}  // namespace moltact
