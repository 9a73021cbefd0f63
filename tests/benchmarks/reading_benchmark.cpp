// Time and memory to read a large file, by Moltact's readers and by gemmi. Each runs in a process of its own, so that
// its peak memory is measured separately. The file consists of copies of ubiquitin. Times are CPU times. Run:
// build/release/reading_benchmark [ATOMS], default 1000000.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gemmi/assembly.hpp>
#include <gemmi/cif.hpp>
#include <gemmi/mmcif.hpp>
#include <gemmi/pdb.hpp>
#include <string>

#include "engine/molecule/reader.h"

namespace {

using namespace moltact;

constexpr double kApart_A = 60.0;
constexpr std::size_t kRow = 12;

// Of copy `k`, in a cube of copies.
Vec3 shifted(const Vec3& place, std::size_t k) {
  return place + kApart_A * Vec3(double(k % kRow), double(k / kRow % kRow), double(k / kRow / kRow));
}

void writePdb(const Molecule& molecule, std::size_t atoms, const std::filesystem::path& file) {
  std::ofstream out(file);
  for (std::size_t i = 0; i < atoms; ++i) {
    const std::size_t copy = i / molecule.atoms.size();
    const PlacedAtom a = molecule.at(i % molecule.atoms.size());
    const Residue& r = molecule.residues[a.residue];
    const Vec3 p = shifted(a.position.A, copy);
    char line[96];
    std::snprintf(line, sizeof line, "ATOM  %5zu  %-3.3s %3.3s %c%4d    %8.3f%8.3f%8.3f  1.00 10.00          %2.1s\n",
                  (i + 1) % 100000, a.name.data(), std::string(r.name).c_str(), char('A' + copy % 26), r.number, p.x,
                  p.y, p.z, a.name.data());
    out << line;
  }
  out << "END\n";
}

void writeMmcif(const Molecule& molecule, std::size_t atoms, const std::filesystem::path& file) {
  std::ofstream out(file);
  out << "data_copies\nloop_\n";
  for (const char* tag :
       {"group_PDB", "id", "type_symbol", "label_atom_id", "label_alt_id", "label_comp_id", "label_asym_id",
        "label_entity_id", "label_seq_id", "pdbx_PDB_ins_code", "Cartn_x", "Cartn_y", "Cartn_z", "occupancy",
        "B_iso_or_equiv", "auth_seq_id", "auth_asym_id", "pdbx_PDB_model_num"})
    out << "_atom_site." << tag << '\n';
  for (std::size_t i = 0; i < atoms; ++i) {
    const std::size_t copy = i / molecule.atoms.size();
    const PlacedAtom a = molecule.at(i % molecule.atoms.size());
    const Residue& r = molecule.residues[a.residue];
    const Vec3 p = shifted(a.position.A, copy);
    char line[160];
    std::snprintf(line, sizeof line, "ATOM %zu %.1s %s . %s C%zu 1 %d ? %.3f %.3f %.3f 1.00 10.00 %d C%zu 1\n", i + 1,
                  a.name.data(), a.name.data(), std::string(r.name).c_str(), copy, r.number, p.x, p.y, p.z, r.number,
                  copy);
    out << line;
  }
  out << "#\n";
}

// Prints what the work takes in a process of its own. The work returns the number of atoms.
void measure(const char* what, const std::function<std::size_t()>& work) {
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child < 0) return std::perror("fork");
  if (child == 0) {
    std::size_t atoms = 0;
    try {
      atoms = work();
    } catch (const std::exception& e) {
      std::printf("%-17s %s\n", what, e.what());
    }
    rusage used{};
    ::getrusage(RUSAGE_SELF, &used);
    if (atoms)
      std::printf("%-17s %10zu atoms %8.2f s %8.0f MB\n", what, atoms,
                  double(used.ru_utime.tv_sec) + 1e-6 * double(used.ru_utime.tv_usec), double(used.ru_maxrss) / 1024.0);
    std::fflush(stdout);
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
}

std::size_t atomsOf(const gemmi::Structure& structure) {
  std::size_t out = 0;
  for (const gemmi::Chain& chain : structure.models.at(0).chains)
    for (const gemmi::Residue& residue : chain.residues) out += residue.atoms.size();
  return out;
}

std::size_t byOurs(const std::filesystem::path& file, const std::string& assembly = {}) {
  ReadOptions options;
  options.assembly = assembly;
  const auto molecule = readMolecule(file, options);
  return molecule ? molecule->atoms.size() : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const auto atoms = argc > 1 ? std::size_t(std::strtoull(argv[1], nullptr, 10)) : std::size_t{1'000'000};
  const auto ubiquitin = readMolecule(MOLTACT_SOURCE_DIR "/molecules/1ubq.pdb");
  if (!ubiquitin) return std::fprintf(stderr, "molecules/1ubq.pdb cannot be read\n"), 1;
  std::string folder = (std::filesystem::temp_directory_path() / "moltact-reading-XXXXXX").string();
  if (!::mkdtemp(folder.data())) return std::perror(folder.c_str()), 1;
  const auto pdb = std::filesystem::path(folder) / "copies.pdb", mmcif = std::filesystem::path(folder) / "copies.cif";
  writePdb(*ubiquitin, atoms, pdb);
  writeMmcif(*ubiquitin, atoms, mmcif);
  measure("PDB, Moltact", [&] { return byOurs(pdb); });
  measure("PDB, gemmi", [&] { return atomsOf(gemmi::read_pdb_file(pdb.string())); });
  measure("mmCIF, Moltact", [&] { return byOurs(mmcif); });
  measure("mmCIF, gemmi", [&] { return atomsOf(gemmi::make_structure(gemmi::cif::read_file(mmcif.string()))); });
  // The coat of a virus: 60 copies of its four chains.
  const std::filesystem::path virus = MOLTACT_SOURCE_DIR "/molecules/1rb8.pdb";
  measure("assembly, Moltact", [&] { return byOurs(virus, "1"); });
  measure("assembly, gemmi", [&] {
    gemmi::Structure structure = gemmi::read_pdb_file(virus.string());
    gemmi::transform_to_assembly(structure, "1", gemmi::HowToNameCopiedChain::AddNumber, nullptr);
    return atomsOf(structure);
  });
  std::filesystem::remove_all(folder);
}
