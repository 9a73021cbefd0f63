// moltact_hip_path MOLECULE PATH METHOD: moves the HIP along PATH (three numbers per line, angstrom). Prints for each
// tick whether there is contact, the SCP, the displacement and the atoms.
#include <cstdio>
#include <fstream>
#include <memory>

#include "engine/haptics/methods.h"
#include "engine/molecule/reader.h"

int main(int argc, char** argv) {
  using namespace moltact;
  if (argc != 4) return 2;
  const Expected<Molecule> molecule = readMolecule(MoleculeKey{argv[1], {}});
  const Method* method = findMethod(argv[3]);
  std::ifstream path(argv[2]);
  if (!molecule) std::fprintf(stderr, "%s\n", molecule.problem().text().c_str());
  if (!molecule || !method || !path) return 1;
  const auto tracker = method->make(std::make_shared<const SphereGrid>(molecule->spheres), kWaterProbe_A);
  for (Vec3 hip; path >> hip.x >> hip.y >> hip.z;) {
    const Contact c = tracker->step(PointA{hip});
    std::printf("%d %.17g %.17g %.17g %.17g %.17g %.17g %d %d %d\n", int(c.touching()), c.scp.A.x, c.scp.A.y, c.scp.A.z,
                c.displacement_A.x, c.displacement_A.y, c.displacement_A.z, c.atoms[0], c.atoms[1], c.atoms[2]);
  }
}
