#include "engine/platform/read_file.h"

#include <algorithm>

namespace moltact {

Expected<OpenFile> openFile(const std::filesystem::path& path, std::size_t most_bytes,
                            const std::string& too_large_remedy) {
  const std::string file = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return Problem{file, 0, 0, "there is no such file", "check the name and the folder"};
  if (std::filesystem::is_directory(status)) return Problem{file, 0, 0, "it is a folder", "name a file in it"};
  if (!std::filesystem::is_regular_file(status))
    return Problem{file, 0, 0, "it is not an ordinary file", "copy the data into one"};
  const auto size = std::filesystem::file_size(path, error);
  if (error)
    return Problem{file, 0, 0, "its size cannot be told: " + error.message(), "check the disk, then try again"};
  if (size > most_bytes)
    return Problem{file, 0, 0, "it is larger than " + std::to_string(most_bytes >> 20) + " MiB", too_large_remedy};
  OpenFile out{std::ifstream(path, std::ios::binary), static_cast<std::size_t>(size)};
  if (!out.in) return Problem{file, 0, 0, "it cannot be opened for reading", "check the file's permissions"};
  return out;
}

Problem brokenOff(const std::string& file, std::size_t bytes) {
  return {file, 0, 0, "reading it broke off after " + std::to_string(bytes) + " bytes",
          "check the disk, then try again"};
}

Expected<std::string> readFile(const std::filesystem::path& path, std::size_t most_bytes,
                               const std::string& too_large_remedy) {
  auto open = openFile(path, most_bytes, too_large_remedy);
  if (!open) return open.problem();
  std::string bytes(open->size, '\0');
  open->in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(open->in.gcount(), 0)));
  if (open->in.bad() || bytes.size() != open->size) return brokenOff(path.string(), bytes.size());
  return bytes;
}

}  // namespace moltact
