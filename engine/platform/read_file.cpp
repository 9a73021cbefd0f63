#include "engine/platform/read_file.h"

#include <algorithm>

#include "engine/language/catalogue.h"
#include "engine/platform/file_guard.h"

namespace moltact {

Expected<OpenFile> openFile(const std::filesystem::path& path, std::size_t max_bytes,
                            const std::string& too_large_remedy) {
  const std::string file = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return Problem{file, 0, 0, tr("there is no such file"), tr("check the name and the folder")};
  if (std::filesystem::is_directory(status)) return Problem{file, 0, 0, tr("it is a folder"), tr("name a file in it")};
  if (!std::filesystem::is_regular_file(status))
    return Problem{file, 0, 0, tr("it is not an ordinary file"), tr("copy the data into one")};
  noteRead(path);  // also if it turns out to be too large, because it is an input
  const auto size = std::filesystem::file_size(path, error);
  if (error)
    return Problem{file, 0, 0, trf("its size cannot be determined: {0}", error.message()),
                   tr("check the disk, then try again")};
  if (size > max_bytes) return Problem{file, 0, 0, trf("it is larger than {0} MiB", max_bytes >> 20), too_large_remedy};
  OpenFile out{std::ifstream(path, std::ios::binary), static_cast<std::size_t>(size)};
  if (!out.in) return Problem{file, 0, 0, tr("it cannot be opened for reading"), tr("check the file's permissions")};
  return out;
}

Problem brokenOff(const std::string& file, std::size_t bytes) {
  return {file, 0, 0, trf("reading it broke off after {0} bytes", bytes), tr("check the disk, then try again")};
}

Expected<std::string> readFile(const std::filesystem::path& path, std::size_t max_bytes,
                               const std::string& too_large_remedy) {
  auto open = openFile(path, max_bytes, too_large_remedy);
  if (!open) return open.problem();
  std::string bytes(open->size, '\0');
  open->in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(open->in.gcount(), 0)));
  if (open->in.bad() || bytes.size() != open->size) return brokenOff(path.string(), bytes.size());
  return bytes;
}

}  // namespace moltact
