// Feels a molecule along a straight path: feel_a_path FILE METHOD X,Y,Z X,Y,Z
// Prints one line per tick: the hand (the HIP), the contact (the SCP) in A, the force in N with a spring of 1 N/A, and
// the atom that is touched.
#include <cstdio>
#include <memory>

#include "engine/haptics/interactions.h"
#include "engine/molecule/reader.h"

using namespace moltact;

namespace {

constexpr int kTicks = 100;
constexpr double kSpring_N_per_A = 1.0;

bool readPoint(const char* text, Vec3& out_A) {
  return std::sscanf(text, "%lf,%lf,%lf", &out_A.x, &out_A.y, &out_A.z) == 3;
}

}  // namespace

int main(int argc, char** argv) {
  Vec3 from_A, to_A;
  if (argc != 5 || !readPoint(argv[3], from_A) || !readPoint(argv[4], to_A)) {
    std::fprintf(stderr, "usage: feel_a_path FILE METHOD X,Y,Z X,Y,Z\n");
    return 2;
  }
  const Expected<Molecule> molecule = readMolecule(argv[1]);
  if (!molecule) {
    std::fprintf(stderr, "%s\n", molecule.problem().text().c_str());
    return 1;
  }
  InteractionInput input{.spheres = std::make_shared<const SphereGrid>(molecule->spheres)};
  input.touch.method = argv[2];
  input.touch.probe_A = kWaterProbe_A;
  const std::unique_ptr<Interaction> probe = makeInteraction(input);
  if (!probe) {
    std::fprintf(stderr, "there is no method \"%s\"\n", argv[2]);
    return 1;
  }
  for (int tick = 0; tick <= kTicks; ++tick) {
    const Vec3 hip_A = from_A + (to_A - from_A) * (double(tick) / kTicks);
    const Response felt = probe->respond({{hip_A}});
    const Vec3 scp_A = felt.contact.scp.A, force_N = felt.total(kSpring_N_per_A).force_N;
    const int atom = felt.contact.atoms[0];
    std::printf("%.3f %.3f %.3f  %.3f %.3f %.3f  %.3f %.3f %.3f  %s\n", hip_A.x, hip_A.y, hip_A.z, scp_A.x, scp_A.y,
                scp_A.z, force_N.x, force_N.y, force_N.z,
                atom < 0 ? "-" : molecule->describe(std::size_t(atom)).c_str());
  }
}
