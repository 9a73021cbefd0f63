// Trajectories by format. Accepted frames must be finite and have the stated number of atoms.
#include <cmath>

#include "engine/molecule/reader.h"
#include "engine/trajectory/trajectory_file.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {
namespace {

void readFrames(std::string_view bytes, const char* name) {
  auto file = openTrajectoryBytes(std::string(bytes), name);
  if (!file) return mustBe(!file.problem().message.empty(), "a message");
  mustBe((*file)->atoms() > 0 && (*file)->frames() > 0, "a frame with atoms");
  for (int k = 0; k < 20 && !(*file)->complete(); ++k) (*file)->findMore(1 << 16);
  for (std::size_t f = 0; f < std::min<std::size_t>((*file)->frames(), 5); ++f) {
    const auto frame = (*file)->read(f);
    if (!frame) {
      mustBe(!frame.problem().message.empty(), "a message");
      continue;
    }
    mustBe(frame->positions_A.size() == (*file)->atoms(), "a position of each atom");
    for (const Vec3& place : frame->positions_A)
      for (int k = 0; k < 3; ++k) mustBe(std::abs(place[k]) <= kMaxCoordinate_A, "a place within 1e9 A");
    if (frame->cell_A) mustBe(glm::determinant(*frame->cell_A) > 0.0, "a cell with a volume");
  }
}

}  // namespace

void dcd(std::string_view bytes) { readFrames(bytes, "a.dcd"); }
void xtc(std::string_view bytes) { readFrames(bytes, "a.xtc"); }
void trr(std::string_view bytes) { readFrames(bytes, "a.trr"); }
void models(std::string_view bytes) {
  for (const char* name : {"a.gro", "a.pdb", "a.cif"}) readFrames(bytes, name);
}

}  // namespace moltact::fuzz
