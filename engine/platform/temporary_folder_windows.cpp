#include <windows.h>

#include <chrono>
#include <string>
#include <system_error>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/platform/temporary_folder.h"

namespace moltact {

// Folders inside the user's own inherit its permissions: other users have no access.
Expected<TemporaryFolder> TemporaryFolder::in(const std::filesystem::path& folder, std::string_view prefix) {
  std::error_code error;
  auto number = std::uint64_t(std::chrono::steady_clock::now().time_since_epoch().count()) ^
                (std::uint64_t{GetCurrentProcessId()} << 32);
  for (int tries = 0; tries < 100; ++tries, ++number) {
    std::filesystem::path name = folder / (std::string(prefix) + std::to_string(number));
    if (std::filesystem::create_directory(name, error)) return TemporaryFolder(std::move(name));
    if (error) break;
  }
  return Problem{folder.string(), 0, 0, trf("no folder can be made in it: {0}", error.message()),
                 tr("check that you may write there and that the disk has room")};
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

void sweepTemporaryFolders(const std::filesystem::path& folder, std::string_view prefix) {
  constexpr std::chrono::hours kForgotten{24};
  std::error_code error, ignored;
  std::vector<std::filesystem::path> forgotten;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().filename().string().starts_with(prefix) &&
        std::filesystem::last_write_time(it->path(), ignored) <
            std::filesystem::file_time_type::clock::now() - kForgotten)
      forgotten.push_back(it->path());
  for (const std::filesystem::path& path : forgotten) std::filesystem::remove_all(path, ignored);
}

}  // namespace moltact
