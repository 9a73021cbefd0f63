#include "engine/fonts/font_files.h"

#include "engine/platform/folders.h"

namespace moltact {
namespace fs = std::filesystem;
namespace {

fs::path distributedOr(const fs::path& installed) {
  const fs::path beside = homeFolder() / "fonts" / installed.filename();
  std::error_code error;
  return fs::is_regular_file(beside, error) ? beside : installed;
}

}  // namespace

fs::path interFile(std::string_view name) { return distributedOr(fs::path("/usr/share/fonts/opentype/inter") / name); }

fs::path dejaVuFile() { return distributedOr("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"); }

}  // namespace moltact
