#include "engine/lesson/lesson_picture.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <memory>

#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/png_inflation.h"

namespace moltact {
namespace {

Problem fault(std::string message, std::string remedy) { return {{}, 0, 0, std::move(message), std::move(remedy)}; }

}  // namespace

Expected<LessonPicture> readLessonPicture(std::string_view bytes) {
  constexpr std::string_view kPng = "\x89PNG\r\n\x1A\n", kJpeg = "\xFF\xD8\xFF";
  if (bytes.size() > kLargestPictureFile)
    return fault(trf("a picture of more than {0} MiB", kLargestPictureFile >> 20),
                 tr("save it smaller, or as a JPEG file"));
  if (!bytes.starts_with(kPng) && !bytes.starts_with(kJpeg))
    return fault(tr("this is no picture that a lesson can show"), tr("save it as a PNG or JPEG file"));
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  // First the size: a picture with 65 000 pixels per side would need gigabytes.
  if (stbi_info_from_memory(data, size, &width, &height, &channels) && std::max(width, height) > kLargestPicture_px)
    return fault(trf("a picture of {0} x {1} pixels; {2} a side are the most", width, height, kLargestPicture_px),
                 tr("save it smaller"));
  // Then the inflated data, which the decoder below would store completely.
  const PngRows rows = bytes.starts_with(kPng) ? inflatedRows(bytes) : PngRows::Fit;
  if (rows == PngRows::TooMany)
    return fault(trf("the file holds more data than a picture of {0} x {1} pixels has", width, height),
                 tr("save it again as a PNG or JPEG file"));
  if (rows == PngRows::Damaged) return fault(tr("this picture is damaged"), tr("save it again as a PNG or JPEG file"));
  const std::unique_ptr<stbi_uc, void (*)(void*)> rgba(stbi_load_from_memory(data, size, &width, &height, &channels, 4),
                                                       stbi_image_free);
  if (!rgba || width < 1 || height < 1)
    return fault(tr("this picture is damaged"), tr("save it again as a PNG or JPEG file"));
  LessonPicture out{width, height, std::vector<std::uint8_t>(std::size_t(3) * width * height)};
  for (std::size_t k = 0; k < std::size_t(width) * height; ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const unsigned alpha = rgba.get()[4 * k + 3];
      out.rgb[3 * k + c] =
          static_cast<std::uint8_t>((rgba.get()[4 * k + c] * alpha + 255u * (255u - alpha) + 127u) / 255u);
    }
  return out;
}

Expected<LessonPicture> readLessonPicture(const std::filesystem::path& file) {
  const Expected<std::string> bytes =
      readBesideLesson(file, kLargestPictureFile, tr("name a picture, a file that ends in .png or .jpg"));
  if (!bytes) return bytes.problem();
  Expected<LessonPicture> out = readLessonPicture(std::string_view(*bytes));
  if (out) return out;
  Problem problem = out.problem();
  problem.file = file.string();
  return problem;
}

LessonPicture halvedTo(LessonPicture picture, int longest_px) {
  while (std::max(picture.width_px, picture.height_px) > longest_px) {
    const int width = std::max(1, picture.width_px / 2), height = std::max(1, picture.height_px / 2);
    std::vector<std::uint8_t> rgb(std::size_t(3) * width * height);
    const auto at = [&](int x, int y, int c) {
      return unsigned(picture.rgb[3 * (std::size_t(std::min(y, picture.height_px - 1)) * picture.width_px +
                                       std::size_t(std::min(x, picture.width_px - 1))) +
                                  std::size_t(c)]);
    };
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c)
          rgb[3 * (std::size_t(y) * width + x) + std::size_t(c)] =
              static_cast<std::uint8_t>((at(2 * x, 2 * y, c) + at(2 * x + 1, 2 * y, c) + at(2 * x, 2 * y + 1, c) +
                                         at(2 * x + 1, 2 * y + 1, c) + 2) /
                                        4);
    picture = {width, height, std::move(rgb)};
  }
  return picture;
}

}  // namespace moltact
