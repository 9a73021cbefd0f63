// A key and its lock, made of balls of argon's size: no molecule, but shapes that fit in one orientation only. The lock
// is a block of balls on a grid from which the key's own path out of it is cut.
#include <algorithm>

#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {
namespace {

constexpr double kStep_A = 1.8;   // between neighbours in either
constexpr double kClear_A = 3.5;  // the lock keeps balls whose centres are this far from the key's

}  // namespace

std::string makeKeyAndLock() {
  std::vector<Vec3> key;  // a shaft along z, and at its inner end a bit of two balls along y
  for (int k = -2; k <= 3; ++k) key.push_back({0, -1, k});
  key.push_back({0, 0, -2});
  key.push_back({0, 1, -2});
  for (Vec3& p : key) p *= kStep_A;

  std::vector<MadeAtom> atoms;
  int number = 0;
  for (int z = -4; z <= 0; ++z)
    for (int y = -4; y <= 4; ++y)
      for (int x = -3; x <= 3; ++x) {
        const Vec3 p = kStep_A * Vec3(x, y, z);
        // The key is drawn out along z: no ball may be in the way of any of its balls, from its place on.
        const bool in_the_way = std::any_of(key.begin(), key.end(), [&](const Vec3& k) {
          const Vec3 from = p - Vec3(k.x, k.y, std::max(k.z, p.z));
          return glm::length(from) < kClear_A;
        });
        if (!in_the_way) atoms.push_back({"AR", "AR", "AR", 'A', ++number, p, true});
      }
  number = 0;
  for (const Vec3& p : key) atoms.push_back({"AR", "AR", "AR", 'B', ++number, p, true});
  return writePdb("A KEY IN ITS LOCK, MADE OF BALLS",
                  {"NO MOLECULE: SHAPES MADE OF BALLS OF ARGON'S SIZE, 1.8 A APART",
                   "CHAIN A: THE LOCK. CHAIN B: THE KEY", "MADE BY MOLTACT_GENERATE_MOLECULES"},
                  atoms);
}

}  // namespace moltact::generator
