#include "engine/pack/pack_name.h"

#include <algorithm>
#include <array>

#include "engine/core/printable.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/pack/pack_file.h"

namespace moltact {
namespace {

constexpr std::string_view kNotOnWindows = "<>:\"|?*\\";

// "con", "con.md", "com1": device names of Windows, with any ending.
bool isDevice(std::string_view part) {
  const std::string stem = lower(std::string(part.substr(0, part.find('.'))));
  static constexpr std::array<std::string_view, 4> kDevices{"con", "prn", "aux", "nul"};
  if (std::find(kDevices.begin(), kDevices.end(), stem) != kDevices.end()) return true;
  return stem.size() == 4 && (stem.starts_with("com") || stem.starts_with("lpt")) && stem[3] >= '0' && stem[3] <= '9';
}

bool steers(std::string_view name) {
  bool found = false;
  splitHarmful(
      name, [](std::string_view) {}, [&](std::uint32_t, bool) { found = true; },
      [](std::uint32_t code) { return code == '\n' || code == '\t'; });
  return found;
}

}  // namespace

std::string packNameFault(std::string_view name) {
  if (name.empty()) return tr("is empty");
  if (name.size() > kMaxPackNameBytes) return trf("is longer than {0} bytes", kMaxPackNameBytes);
  if (steers(name)) return tr("holds bytes that are no UTF-8, or signs that cannot be seen");
  if (name.front() == '/' || name.front() == '\\' || (name.size() > 1 && name[1] == ':'))
    return tr("begins at the top of a disk");
  std::size_t folders = 0;
  for (std::string_view rest = name;;) {
    const std::size_t slash = rest.find('/');
    const std::string_view part = rest.substr(0, slash);
    if (part == "..") return tr("leads out of the folder");
    if (part.empty() || part == ".") return tr("has a folder without a name");
    if (part.front() == '.') return tr("begins with a point, as hidden files do");
    if (part.find_first_of(kNotOnWindows) != std::string_view::npos || part.back() == '.' || part.back() == ' ' ||
        isDevice(part))
      return tr("is none that every system can have");
    if (slash == std::string_view::npos) break;
    if (++folders > kMaxPackDepth) return trf("has more than {0} folders", kMaxPackDepth);
    rest.remove_prefix(slash + 1);
  }
  return {};
}

std::string foldedPackName(std::string_view name) { return lower(std::string(name)); }

bool hasPackName(const std::filesystem::path& file) { return lower(file.extension().string()) == kPackEnding; }

}  // namespace moltact
