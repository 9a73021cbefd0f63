#include "app/commands/trajectory_info.h"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/commands/print_json.h"
#include "engine/language/quantity_text.h"
#include "engine/platform/terminal.h"
#include "engine/trajectory/trajectory_file.h"

namespace moltact {
namespace {

constexpr double kPicoseconds_per_nanosecond = 1000.0;

std::string frameTimeText(double ps) {
  return ps >= kPicoseconds_per_nanosecond
             ? quantityNumber(ps / kPicoseconds_per_nanosecond, Dimension::None, decimals(3)) + " ns"
             : quantityNumber(ps, Dimension::None, decimals(3)) + " ps";
}

}  // namespace

void printTrajectoryInfo(const std::string& name, bool json) {
  auto opened = openTrajectory(name);
  if (!opened) throw CommandError{opened.problem().text()};
  TrajectoryFile& file = **opened;
  file.findMore(~std::uint64_t{0} >> 1);
  const auto first = file.read(0), last = file.read(file.frames() - 1);
  for (const auto* frame : {&first, &last})
    if (!*frame) throw CommandError{frame->problem().text()};
  Vec3 edges(0.0);
  if (first->cell_A)
    for (int k = 0; k < 3; ++k) edges[k] = glm::length((*first->cell_A)[k]);
  if (json) {
    nlohmann::ordered_json document = {{"format", file.format()}, {"atoms", file.atoms()}, {"frames", file.frames()}};
    if (first->time_ps && last->time_ps) document["time_ps"] = {*first->time_ps, *last->time_ps};
    if (first->cell_A) document["cell_edges_A"] = {edges.x, edges.y, edges.z};
    document["warnings"] = file.warnings();
    return printDocument(document);
  }
  out() << "format    " << file.format() << '\n';
  out() << "atoms     " << file.atoms() << '\n';
  out() << "frames    " << file.frames() << '\n';
  if (first->time_ps && last->time_ps)
    out() << "time      " << frameTimeText(*first->time_ps) << " to " << frameTimeText(*last->time_ps) << '\n';
  if (first->cell_A)
    out() << "cell      " << quantityNumber(edges.x, Dimension::Length, decimals(1)) << " x "
          << quantityNumber(edges.y, Dimension::Length, decimals(1)) << " x "
          << quantityText(edges.z, Dimension::Length, decimals(1)) << '\n';
  for (const std::string& warning : file.warnings()) out() << "note      " << warning << '\n';
}

}  // namespace moltact
