#include "engine/render/picture.h"

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <cstdio>
#include <cstring>
#include <memory>

namespace moltact {

std::optional<Problem> writePng(const std::filesystem::path& file, const Picture& picture) {
  const auto append = [](void* to, void* data, int size) {
    auto& bytes = *static_cast<std::vector<std::uint8_t>*>(to);
    const auto* from = static_cast<const std::uint8_t*>(data);
    bytes.insert(bytes.end(), from, from + size);
  };
  std::vector<std::uint8_t> bytes;
  if (!stbi_write_png_to_func(append, &bytes, picture.width_px, picture.height_px, 3, picture.rgb.data(),
                              3 * picture.width_px))
    return Problem{.file = file.string(), .message = "the picture cannot be made into a PNG", .remedy = {}};
  // Written beside and then renamed, so that a full disk leaves no half picture in place of a whole one.
  std::filesystem::path beside = file;
  beside += ".part";
  std::FILE* out = std::fopen(beside.c_str(), "wb");
  if (!out)
    return Problem{.file = file.string(), .message = std::string("cannot be written: ") + std::strerror(errno),
                   .remedy = "give a file in a folder that exists and that you may write to"};
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size();
  const bool closed = std::fclose(out) == 0;
  std::error_code error;
  if (written && closed) std::filesystem::rename(beside, file, error);
  if (written && closed && !error) return std::nullopt;
  const std::string why = error ? error.message() : std::strerror(errno);
  std::filesystem::remove(beside, error);
  return Problem{.file = file.string(), .message = "cannot be written: " + why,
                 .remedy = "is there room on the disk, and is it not a folder?"};
}

Expected<Picture> readPng(const std::filesystem::path& file) {
  Picture picture;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> data(
      stbi_load(file.c_str(), &picture.width_px, &picture.height_px, &channels, 3), stbi_image_free);
  if (!data)
    return Problem{.file = file.string(),
                   .message = std::string("cannot be read as a picture: ") + stbi_failure_reason(),
                   .remedy = "give a PNG file"};
  picture.rgb.assign(data.get(), data.get() + std::size_t(3) * picture.width_px * picture.height_px);
  return picture;
}

}  // namespace moltact
