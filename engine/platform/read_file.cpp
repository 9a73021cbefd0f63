#include "engine/platform/read_file.h"

#include <algorithm>
#include <fstream>

namespace moltact {

Expected<std::string> readFile(const std::filesystem::path& path, std::size_t most_bytes,
                               const std::string& too_large_remedy) {
  const std::string file = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return Problem{file, 0, 0, "there is no such file", "check the name and the folder"};
  if (std::filesystem::is_directory(status))
    return Problem{file, 0, 0, "it is a folder", "name a file in it"};
  if (!std::filesystem::is_regular_file(status))
    return Problem{file, 0, 0, "it is not an ordinary file", "copy the data into one"};
  const auto size = std::filesystem::file_size(path, error);
  if (!error && size > most_bytes)
    return Problem{file, 0, 0, "it is larger than " + std::to_string(most_bytes >> 20) + " MiB", too_large_remedy};
  std::ifstream in(path, std::ios::binary);
  if (!in) return Problem{file, 0, 0, "it cannot be opened for reading", "check the file's permissions"};
  std::string bytes(error ? 0 : static_cast<std::size_t>(size), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  if (in.bad() || (!error && bytes.size() != size))
    return Problem{file, 0, 0, "reading it broke off after " + std::to_string(bytes.size()) + " bytes",
                   "check the disk, then try again"};
  return bytes;
}

}  // namespace moltact
