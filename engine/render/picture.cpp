#include "engine/render/picture.h"

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <memory>

#include "engine/language/catalogue.h"
#include "engine/platform/write_file.h"

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
    return Problem{.file = file.string(), .message = tr("the picture cannot be made into a PNG"), .remedy = {}};
  return writeWhole(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Expected<Picture> readPng(const std::filesystem::path& file) {
  Picture picture;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> data(
      stbi_load(file.string().c_str(), &picture.width_px, &picture.height_px, &channels, 3), stbi_image_free);
  if (!data)
    return Problem{.file = file.string(),
                   .message = trf("cannot be read as a picture: {0}", stbi_failure_reason()),
                   .remedy = tr("give a PNG file")};
  picture.rgb.assign(data.get(), data.get() + std::size_t(3) * picture.width_px * picture.height_px);
  return picture;
}

}  // namespace moltact
