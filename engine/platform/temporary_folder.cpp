// The part of temporary_folder.h common to all systems.
#include "engine/platform/temporary_folder.h"

namespace moltact {

std::error_code replaceFolder(const std::filesystem::path& fresh, const std::filesystem::path& place,
                              const std::filesystem::path& old) {
  std::error_code error, ignored;
  std::filesystem::rename(place, old, ignored);  // fails if there is none
  std::filesystem::rename(fresh, place, error);
  if (error) std::filesystem::rename(old, place, ignored);
  return error;
}

}  // namespace moltact
