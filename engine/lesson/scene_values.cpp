#include "engine/lesson/scene_values.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include "engine/core/utf8.h"
#include "engine/dynamics/normal_modes.h"
#include "engine/haptics/height_field/scanning_tip.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/quantity.h"
#include "engine/lesson/source_text.h"

namespace moltact {
namespace {

Problem problemOf(std::string_view whole, std::string_view part, std::string message, std::string remedy) {
  const std::string_view before = whole.substr(0, std::size_t(part.data() - whole.data()));
  return {{}, 0, characterCount(before) + 1, std::move(message), std::move(remedy)};
}

std::vector<std::string_view> partsOf(std::string_view text) {
  std::vector<std::string_view> out;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    out.push_back(stripped(text.substr(from, to - from)));
    from = to + 1;
  }
  return out;
}

std::optional<std::size_t> modeOf(std::string_view written) {
  std::size_t mode = 0;
  const auto [end, error] = std::from_chars(written.data(), written.data() + written.size(), mode);
  if (error != std::errc{} || end != written.data() + written.size() || mode < 1 || mode > kElasticModes) return {};
  return mode - 1;
}

}  // namespace

Expected<std::vector<std::size_t>> parseModes(std::string_view text) {
  std::vector<std::size_t> out;
  if (stripped(text) == "all") return out;
  for (const std::string_view part : partsOf(text)) {
    const auto mode = modeOf(part);
    if (!mode)
      return problemOf(text, part, trf("'{0}' is no motion of an elastic molecule", part),
                       trf("write numbers from 1 (the softest) to {0}, as in '1, 3', or 'all'", int(kElasticModes)));
    out.push_back(*mode);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

Expected<ScanValue> parseScan(std::string_view text) {
  const std::vector<std::string_view> parts = partsOf(text);
  ScanValue out;
  const auto tip_A = parseQuantity(parts[0], Dimension::Length);
  if (!tip_A) return problemOf(text, parts[0], tip_A.problem().message, tip_A.problem().remedy);
  if (!(*tip_A >= 0.0 && *tip_A <= kMaxSceneTip_A))
    return problemOf(text, parts[0], trf("'{0}' is no radius of a tip", parts[0]),
                     trf("write a length from 0 to {0} Å", int(kMaxSceneTip_A)));
  out.tip_A = *tip_A;
  if (parts.size() == 1) return out;
  if (parts.size() > 2)
    return problemOf(text, parts[2], trf("'{0}' is too much", parts[2]),
                     tr("write the tip's radius, and its force if it has one: '10 Å, 100 pN'"));
  const std::string_view force = parts[1];
  const auto wrong = [&] {
    return problemOf(text, force, trf("'{0}' is no force of a tip", force),
                     trf("write piconewtons from 0 to {0}, as in '100 pN'", int(kMaxScanForce_pN)));
  };
  if (!force.ends_with("pN")) return wrong();
  const auto number = parseNumber(stripped(force.substr(0, force.size() - 2)));
  if (!number || !(*number >= 0.0 && *number <= kMaxScanForce_pN)) return wrong();
  out.force_pN = *number;
  return out;
}

}  // namespace moltact
