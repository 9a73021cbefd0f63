#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "engine/language/catalogue.h"
#include "engine/platform/temporary_folder.h"

namespace moltact {

Expected<TemporaryFolder> TemporaryFolder::in(const std::filesystem::path& folder, std::string_view prefix) {
  std::string name = (folder / prefix).string() + "XXXXXX";
  if (!::mkdtemp(name.data()))
    return Problem{folder.string(), 0, 0, trf("no folder can be made in it: {0}", std::strerror(errno)),
                   tr("check that you may write there and that the disk has room")};
  return TemporaryFolder(std::move(name));
}

std::error_code replaceFolder(const std::filesystem::path& fresh, const std::filesystem::path& place,
                              const std::filesystem::path& old) {
  std::error_code error, ignored;
  std::filesystem::rename(place, old, ignored);  // fails where there is none
  std::filesystem::rename(fresh, place, error);
  if (error) std::filesystem::rename(old, place, ignored);
  return error;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace moltact
