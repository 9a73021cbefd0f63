#include "app/commands/hip_path_file.h"

#include <array>
#include <cmath>
#include <string_view>

#include "app/commands/number_rows.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::array<std::string_view, 2> kHeaders{"x,y,z", "x,y,z,qw,qx,qy,qz"};
constexpr std::size_t kMaxPlaces = 25'000'000;  // seven hours of ticks

}  // namespace

Expected<HipPath> readHipPath(const std::filesystem::path& file) {
  HipPath path;
  const auto problem = readNumberRows(
      file, kHeaders, tr("split it into shorter paths"), [&](const NumberRow& row) -> std::optional<Problem> {
        const auto& n = row.numbers;
        if (path.size() == kMaxPlaces)
          return Problem{file.string(), row.line, 1, tr("more than 25 million rows"),
                         tr("split it into shorter paths")};
        path.places.push_back({{n[0], n[1], n[2]}});
        if (row.header == 0) return std::nullopt;
        // Divides by the largest component first, so that squares neither overflow nor underflow.
        double greatest = 0.0;
        bool numbers = true;
        for (std::size_t k = 3; k < 7; ++k) {
          numbers = numbers && std::isfinite(n[k]);
          greatest = std::max(greatest, std::abs(n[k]));
        }
        if (!numbers || !(greatest > 0.0))
          return Problem{file.string(), row.line, row.columns[3], tr("these four numbers are no rotation"),
                         tr("write a quaternion qw,qx,qy,qz; without a rotation it is 1,0,0,0")};
        path.orientations.push_back(
            glm::normalize(Quat(n[3] / greatest, n[4] / greatest, n[5] / greatest, n[6] / greatest)));
        return std::nullopt;
      });
  if (problem) return *problem;
  return path;
}

}  // namespace moltact
