// NetCDF by AMBER's convention (ambermd.org/netcdf/nctraj.xhtml), of MDTraj, cpptraj and OpenMM too. The NetCDF library is
// loaded when such a file is opened; its C functions are the same in all its versions. It is not safe for several
// threads: one lock serves all files.
#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>

#include "engine/language/catalogue.h"
#include "engine/molecule/reader.h"
#include "engine/platform/shared_library.h"
#include "engine/trajectory/frame_formats.h"

namespace moltact {
namespace {

/// The functions of the library's C interface that are used.
struct NetcdfLibrary {
  int (*open)(const char* path, int mode, int* file) = nullptr;
  int (*close)(int file) = nullptr;
  int (*dimension)(int file, const char* name, int* id) = nullptr;
  int (*length)(int file, int id, std::size_t* length) = nullptr;
  int (*variable)(int file, const char* name, int* id) = nullptr;
  int (*dimensions)(int file, int id, int* count) = nullptr;
  int (*read)(int file, int id, const std::size_t* start, const std::size_t* count, double* values) = nullptr;
  int (*attributeLength)(int file, int id, const char* name, std::size_t* length) = nullptr;
  int (*attribute)(int file, int id, const char* name, double* values) = nullptr;
  const char* (*error)(int status) = nullptr;
};

std::mutex& netcdfLock() {
  static std::mutex lock;
  return lock;
}

template <class Function>
bool found(const SharedLibrary& library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(library.symbol(name));
  return function != nullptr;
}

Expected<NetcdfLibrary> loadNetcdf() {
  // Debian 13, Debian 12, others.
  const std::string names[] = {"libnetcdf.so.22", "libnetcdf.so.19", "libnetcdf.so"};
  Expected<SharedLibrary> library = SharedLibrary::open(names);
  NetcdfLibrary out;
  if (!library || !found(*library, "nc_open", out.open) || !found(*library, "nc_close", out.close) ||
      !found(*library, "nc_inq_dimid", out.dimension) || !found(*library, "nc_inq_dimlen", out.length) ||
      !found(*library, "nc_inq_varid", out.variable) || !found(*library, "nc_inq_varndims", out.dimensions) ||
      !found(*library, "nc_get_vara_double", out.read) || !found(*library, "nc_inq_attlen", out.attributeLength) ||
      !found(*library, "nc_get_att_double", out.attribute) || !found(*library, "nc_strerror", out.error))
    return Problem{{},
                   0,
                   0,
                   tr("the NetCDF library is missing"),
                   tr("install it (Debian: libnetcdf22 or libnetcdf19), or convert the file to DCD or XTC")};
  return out;
}

const Expected<NetcdfLibrary>& netcdf() {
  static const Expected<NetcdfLibrary> library = loadNetcdf();
  return library;
}

class AmberNetcdf final : public TrajectoryFile {
 public:
  explicit AmberNetcdf(std::string name) : name_(std::move(name)) {}
  ~AmberNetcdf() override {
    const std::lock_guard lock(netcdfLock());
    if (file_ >= 0) nc_.close(file_);
  }
  std::string_view format() const override { return "NetCDF"; }
  void findMore(std::uint64_t) override {}
  std::optional<Problem> open();
  Expected<TrajectoryFrame> read(std::size_t frame) override;

 private:
  struct Variable {
    int id = -1;
    double scale = 1.0;
  };
  Variable variable(const char* name, int dimensions) const {
    Variable out;
    int count = 0;
    if (nc_.variable(file_, name, &out.id) != 0 || nc_.dimensions(file_, out.id, &count) != 0 || count != dimensions)
      return {};
    double scale = 1.0;
    std::size_t values = 0;
    if (nc_.attributeLength(file_, out.id, "scale_factor", &values) == 0 && values == 1 &&
        nc_.attribute(file_, out.id, "scale_factor", &scale) == 0 && std::isfinite(scale))
      out.scale = scale;
    return out;
  }
  std::optional<std::size_t> length(const char* name) const {
    int id = 0;
    std::size_t out = 0;
    if (nc_.dimension(file_, name, &id) != 0 || nc_.length(file_, id, &out) != 0) return std::nullopt;
    return out;
  }
  bool get(const Variable& from, std::size_t frame, std::size_t rows, std::size_t columns,
           std::span<double> values) const {
    const std::size_t start[] = {frame, 0, 0}, count[] = {1, rows, columns};
    if (from.id < 0 || nc_.read(file_, from.id, start, count, values.data()) != 0) return false;
    for (double& value : values) value *= from.scale;
    return true;
  }

  std::string name_;
  NetcdfLibrary nc_;
  int file_ = -1;
  Variable places_, time_, edges_, angles_;
};

std::optional<Problem> AmberNetcdf::open() {
  const std::lock_guard lock(netcdfLock());
  const Expected<NetcdfLibrary>& library = netcdf();
  if (!library) {
    Problem problem = library.problem();
    problem.file = name_;
    return problem;
  }
  nc_ = *library;
  if (const int status = nc_.open(name_.c_str(), 0, &file_); status != 0) {
    file_ = -1;
    return Problem{name_, 0, 0, trf("the NetCDF library cannot open it: {0}", std::string(nc_.error(status))),
                   tr("copy or download it again")};
  }
  const auto frames = length("frame"), atoms = length("atom"), axes = length("spatial");
  places_ = variable("coordinates", 3);
  if (!frames || !atoms || axes != 3u || places_.id < 0 || *atoms < 1 || *atoms > kMaxMoleculeAtoms)
    return Problem{name_, 0, 0, tr("the file is no trajectory by AMBER's convention"),
                   tr("it needs the dimensions frame, atom and spatial, and the variable coordinates")};
  if (*frames == 0)
    return Problem{name_, 0, 0, tr("the file holds no frame with positions"), tr("copy or download it again")};
  atoms_ = *atoms;
  frames_ = std::min(*frames, kMaxTrajectoryFrames);
  complete_ = true;
  time_ = variable("time", 1);
  edges_ = variable("cell_lengths", 2);
  angles_ = variable("cell_angles", 2);
  return std::nullopt;
}

Expected<TrajectoryFrame> AmberNetcdf::read(std::size_t frame) {
  const std::lock_guard lock(netcdfLock());
  TrajectoryFrame out;
  std::vector<double> values(3 * atoms_);
  if (!get(places_, frame, atoms_, 3, values)) return frameProblem(name_, frame, tr("it is damaged"));
  out.positions_A.resize(atoms_);
  for (std::size_t i = 0; i < values.size(); ++i) out.positions_A[i / 3][int(i % 3)] = values[i];
  double time = 0.0;
  if (get(time_, frame, 1, 1, {&time, 1}) && std::isfinite(time)) out.time_ps = time;
  double edges[3], angles[3];
  if (get(edges_, frame, 3, 1, edges) && get(angles_, frame, 3, 1, angles))
    out.cell_A = cellOf({edges[0], edges[1], edges[2]}, {angles[0], angles[1], angles[2]});
  if (auto problem = checkPositions(name_, frame, out.positions_A)) return *problem;
  return out;
}

}  // namespace

OpenedTrajectory openAmberNetcdf(const std::filesystem::path& file) {
  auto out = std::make_unique<AmberNetcdf>(file.string());
  if (auto problem = out->open()) return *problem;
  return std::unique_ptr<TrajectoryFile>(std::move(out));
}

}  // namespace moltact
