// moltact_hip_path MOLECULE PATH METHOD: moves the HIP along PATH (three numbers per line, angstrom). Prints for each
// tick whether there is contact, the SCP, the displacement and the atoms.
// moltact_hip_path MOLECULE PATH INTERACTION FIRST LAST: the same for a body of the atoms FIRST to LAST (indices), with
// seven numbers per line, its position and a quaternion w, x, y, z. Prints for each tick whether there is contact, the
// body's pose, the displacement and the torque divided by the stiffness.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <numeric>

#include "engine/haptics/interactions.h"
#include "engine/haptics/methods.h"
#include "engine/molecule/reader.h"

namespace {

using namespace moltact;

int feelProbe(const Molecule& molecule, std::ifstream& path, const char* name) {
  const Method* method = findMethod(name);
  if (!method) return 1;
  const auto tracker = method->make(std::make_shared<const SphereGrid>(molecule.spheres), kWaterProbe_A);
  for (Vec3 hip; path >> hip.x >> hip.y >> hip.z;) {
    const Contact c = tracker->step(PointA{hip});
    std::printf("%d %.17g %.17g %.17g %.17g %.17g %.17g %d %d %d\n", int(c.touching()), c.scp.A.x, c.scp.A.y, c.scp.A.z,
                c.displacement_A.x, c.displacement_A.y, c.displacement_A.z, c.atoms[0], c.atoms[1], c.atoms[2]);
  }
  return 0;
}

int feelBody(const Molecule& molecule, std::ifstream& path, const char* name, std::uint32_t first, std::uint32_t last) {
  if (first > last || last >= molecule.atoms.size()) return 1;
  std::vector<std::uint32_t> atoms(last - first + 1);
  std::iota(atoms.begin(), atoms.end(), first);
  InteractionInput input{
      std::make_shared<const SphereGrid>(molecule.spheres, atoms), {}, heldBody(molecule.spheres, atoms)};
  input.touch.interaction = name;
  const auto felt = makeInteraction(input);
  if (!felt) return 1;
  PoseA hand;
  Vec3& at = hand.place.A;
  Quat& q = hand.orientation;
  while (path >> at.x >> at.y >> at.z >> q.w >> q.x >> q.y >> q.z) {
    const Response r = felt->respond(hand);
    const PoseA body = r.shownBody(hand);
    const Vec3 &x = body.place.A, &d = r.contact.displacement_A, &t = r.torque_A2;
    std::printf("%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n",
                int(r.contact.touching()), x.x, x.y, x.z, body.orientation.w, body.orientation.x, body.orientation.y,
                body.orientation.z, d.x, d.y, d.z, t.x, t.y, t.z);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4 && argc != 6) return 2;
  const Expected<Molecule> molecule = readMolecule(MoleculeKey{argv[1], {}});
  std::ifstream path(argv[2]);
  if (!molecule) std::fprintf(stderr, "%s\n", molecule.problem().text().c_str());
  if (!molecule || !path) return 1;
  if (argc == 4) return feelProbe(*molecule, path, argv[3]);
  return feelBody(*molecule, path, argv[3], std::uint32_t(std::atoi(argv[4])), std::uint32_t(std::atoi(argv[5])));
}
