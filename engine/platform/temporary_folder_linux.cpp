#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <string>

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

}  // namespace moltact
