#include "engine/trajectory/trajectory_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/reader.h"
#include "engine/trajectory/frame_formats.h"

namespace moltact {
namespace {

using OpenBytes = OpenedTrajectory (*)(RandomAccessFile);
using OpenPath = OpenedTrajectory (*)(const std::filesystem::path&);

struct Format {
  std::string_view ending, name;
  OpenBytes open;
  OpenPath open_path;  ///< for a format that its own library opens; then `open` is null
  bool describes_atoms;
  std::string_view content = {};  ///< the first bytes of a file without a known name
  std::size_t at = 0;             ///< their place
};

using namespace std::string_view_literals;

constexpr Format kFormats[] = {
    {".dcd", "DCD", openDcd, nullptr, false, "CORD"sv, 4},
    {".xtc", "XTC", openXtc, nullptr, false, "\0\0\x07\xcb"sv},
    {".trr", "TRR", openTrr, nullptr, false, "\0\0\x07\xc9"sv},
    {".nc", "NetCDF", nullptr, openAmberNetcdf, false, "CDF"sv},
    {".ncdf", "NetCDF", nullptr, openAmberNetcdf, false, "\x89HDF"sv},
    {".gro", "GRO", openGroFrames, nullptr, true},
    {".pdb", "PDB", openPdbModels, nullptr, true},
    {".ent", "PDB", openPdbModels, nullptr, true},
    {".cif", "mmCIF", openMmcifModels, nullptr, true},
};

/// "DCD, XTC, TRR, NetCDF": the names of the formats with or without a description of their atoms.
std::string namesOf(bool describes_atoms) {
  std::string out;
  std::string_view last;
  for (const Format& format : kFormats)
    if (format.describes_atoms == describes_atoms && format.name != std::exchange(last, format.name))
      out += (out.empty() ? "" : ", ") + std::string(format.name);
  return out;
}

const Format* formatOf(const std::filesystem::path& file) {
  std::string ending = lower(file.extension().string());
  if (ending == ".gz") ending = lower(file.stem().extension().string());
  for (const Format& format : kFormats)
    if (format.ending == ending) return &format;
  return nullptr;
}

const Format* formatOf(RandomAccessFile& file) {
  char bytes[8] = {};
  const std::size_t n = file.readSome(0, bytes, sizeof bytes);
  for (const Format& format : kFormats)
    if (!format.content.empty() &&
        std::string_view(bytes, n).substr(std::min(format.at, n)).starts_with(format.content))
      return &format;
  return nullptr;
}

OpenedTrajectory opened(RandomAccessFile bytes, const std::filesystem::path& file) {
  const Format* format = formatOf(file);
  if (!format) format = formatOf(bytes);
  if (!format)
    return Problem{file.string(), 0, 0, tr("this is no trajectory that can be read"),
                   trf("take a file in one of these formats: {0}; or several models in one of these: {1}",
                       namesOf(false), namesOf(true))};
  return format->open ? format->open(std::move(bytes)) : format->open_path(file);
}

}  // namespace

std::vector<TrajectoryFormat> trajectoryFormats() {
  std::vector<TrajectoryFormat> out;
  for (const Format& format : kFormats) out.push_back({format.ending, format.name, format.describes_atoms});
  return out;
}

bool hasTrajectoryName(const std::filesystem::path& file) {
  const Format* format = formatOf(file);
  return format && !format->describes_atoms;
}

OpenedTrajectory openTrajectory(const std::filesystem::path& file) {
  Expected<RandomAccessFile> bytes = RandomAccessFile::open(file);
  if (!bytes) return bytes.problem();
  return opened(*std::move(bytes), file);
}

OpenedTrajectory openTrajectoryBytes(std::string bytes, const std::filesystem::path& file) {
  return opened(RandomAccessFile(std::move(bytes), file.string()), file);
}

void FoundFrames::findMore(std::uint64_t bytes) {
  const std::uint64_t until = searched_ + bytes;
  do {
    if (complete_) return;
    auto ending = endOf(searched_);
    if (!ending) {
      warnings_.push_back(ending.problem().text());
      complete_ = true;
      return;
    }
    if (!*ending) {
      complete_ = true;
      return;
    }
    if (!(*ending)->skipped) {
      if (frames_ == kMaxTrajectoryFrames) {
        warnings_.push_back(trf("Only the first {0} million frames are read.", kMaxTrajectoryFrames / 1'000'000));
        complete_ = true;
        return;
      }
      begins_.push_back(searched_);
      ++frames_;
    }
    searched_ = (*ending)->end;
  } while (frames_ == 0 || searched_ < until);
}

std::optional<Problem> FoundFrames::findFirst() {
  findMore(0);
  if (frames_ > 0) return std::nullopt;
  if (warnings_.empty())
    return Problem{file_.name(), 0, 0, tr("the file holds no frame with positions"), tr("copy or download it again")};
  auto ending = endOf(searched_);
  return ending ? notOfFormat(file_.name(), format()) : ending.problem();
}

Problem frameProblem(const std::string& file, std::size_t frame, const std::string& what) {
  return {file, 0, 0, trf("frame {0}: {1}", frame + 1, what), tr("copy or download it again")};
}

Problem frameCutShort(const std::string& file, std::size_t frame) {
  return frameProblem(file, frame, tr("the file ends within it"));
}

Problem notOfFormat(const std::string& file, std::string_view format) {
  return {file, 0, 0, trf("this is no {0} file, or it is damaged", std::string(format)),
          tr("copy or download it again")};
}

std::optional<Problem> checkPositions(const std::string& file, std::size_t frame, std::span<const Vec3> positions_A) {
  for (std::size_t i = 0; i < positions_A.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (!(std::abs(positions_A[i][k]) <= kMaxCoordinate_A))
        return frameProblem(file, frame, trf("the position of atom {0} is not finite or too far away", i + 1));
  return std::nullopt;
}

std::optional<glm::dmat3> cellOf(const glm::dmat3& vectors_A) {
  for (int k = 0; k < 9; ++k)
    if (!(std::abs(vectors_A[k / 3][k % 3]) <= kMaxCoordinate_A)) return std::nullopt;
  return glm::determinant(vectors_A) > 0.0 ? std::optional(vectors_A) : std::nullopt;
}

std::optional<glm::dmat3> cellOf(const Vec3& edges, const Vec3& angles_deg) {
  for (int k = 0; k < 3; ++k)
    if (!(edges[k] > 0.0 && edges[k] <= kMaxCoordinate_A && angles_deg[k] > 1.0 && angles_deg[k] < 179.0))
      return std::nullopt;
  const auto cosine = [&](int k) {
    // A right angle is exact.
    return angles_deg[k] == 90.0 ? 0.0 : std::cos(angles_deg[k] * std::numbers::pi / 180.0);
  };
  const double ca = cosine(0), cb = cosine(1), cc = cosine(2), sc = std::sqrt(1.0 - cc * cc), y = (ca - cb * cc) / sc,
               z2 = 1.0 - cb * cb - y * y;
  if (!(z2 > 0.0)) return std::nullopt;
  glm::dmat3 out(0.0);
  out[0] = {edges[0], 0.0, 0.0};
  out[1] = {edges[1] * cc, edges[1] * sc, 0.0};
  out[2] = {edges[2] * cb, edges[2] * y, edges[2] * std::sqrt(z2)};
  return out;
}

}  // namespace moltact
