// From the atoms of a file to a molecule: the rules of reader.h, the same for PDB and mmCIF.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

#include "engine/molecule/elements.h"
#include "engine/molecule/parsed_structure.h"
#include "engine/molecule/residue_kind.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxAtoms = 50'000'000;

bool samePlaceInChain(const ParsedAtom& a, const ParsedAtom& b) {
  return a.number == b.number && a.insertion == b.insertion && a.chain == b.chain &&
         a.label_chain == b.label_chain;
}

bool sameResidue(const ParsedAtom& a, const ParsedAtom& b) {
  return samePlaceInChain(a, b) && a.residue == b.residue;
}

/// Of alternative residues at one place, the name with the highest mean occupancy, the first on a tie.
std::string likeliestResidue(const ParsedAtom* first, const ParsedAtom* last) {
  struct Sum {
    std::string name;
    double occupancy;
    int count;
  };
  std::vector<Sum> sums;
  for (const ParsedAtom* a = first; a != last; ++a) {
    auto it = std::find_if(sums.begin(), sums.end(), [&](const Sum& s) { return s.name == a->residue; });
    if (it == sums.end()) it = sums.insert(sums.end(), {a->residue, 0.0, 0});
    it->occupancy += a->occupancy;
    ++it->count;
  }
  return std::max_element(
             sums.begin(), sums.end(),
             [](const Sum& a, const Sum& b) { return a.occupancy / a.count < b.occupancy / b.count; })
      ->name;
}

/// Marks which atoms of [first, last), one residue, are kept: of those with one name the likeliest.
void keepLikeliest(const ParsedAtom* first, const ParsedAtom* last, std::vector<char>& keep,
                   std::size_t offset) {
  std::unordered_map<std::string_view, std::size_t> best;
  for (const ParsedAtom* a = first; a != last; ++a) {
    const std::size_t i = offset + static_cast<std::size_t>(a - first);
    if (!keep[i]) continue;
    const auto [it, is_new] = best.emplace(a->name, i);
    if (is_new) continue;
    const ParsedAtom& rival = first[it->second - offset];
    if (a->alternate == rival.alternate) continue;  // a name used twice is no alternate location
    if (a->occupancy > rival.occupancy) {
      keep[it->second] = 0;
      it->second = i;
    } else {
      keep[i] = 0;
    }
  }
}

/// Leaves out the alternate locations that the rules do not keep; returns how many atoms that were.
std::size_t dropAlternates(std::vector<ParsedAtom>& atoms) {
  std::vector<char> keep(atoms.size(), 1);
  for (std::size_t begin = 0, end = 0; begin < atoms.size(); begin = end) {
    bool any = false, all = true, one_name = true;
    for (end = begin; end < atoms.size() && samePlaceInChain(atoms[begin], atoms[end]); ++end) {
      const bool alternate = atoms[end].alternate != ' ';
      any |= alternate;
      all &= alternate;
      one_name &= atoms[end].residue == atoms[begin].residue;
    }
    if (!any) continue;
    const ParsedAtom *first = &atoms[begin], *last = first + (end - begin);
    if (!one_name && all) {
      const std::string name = likeliestResidue(first, last);
      for (std::size_t i = begin; i < end; ++i) keep[i] = atoms[i].residue == name;
    }
    keepLikeliest(first, last, keep, begin);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < atoms.size(); ++i)
    if (keep[i]) {
      if (kept != i) atoms[kept] = std::move(atoms[i]);
      ++kept;
    }
  const std::size_t dropped = atoms.size() - kept;
  atoms.resize(kept);
  return dropped;
}

/// Leaves out water; returns how many molecules that were. A file of nothing but water keeps it.
std::size_t dropWaters(std::vector<ParsedAtom>& atoms) {
  std::vector<char> water(atoms.size(), 0);
  std::size_t molecules = 0, count = 0;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    const bool continues = i > 0 && sameResidue(atoms[i - 1], atoms[i]);
    water[i] = continues ? water[i - 1] : isWaterName(atoms[i].residue);
    count += water[i];
    molecules += water[i] && !continues;
  }
  if (count == atoms.size()) return 0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < atoms.size(); ++i)
    if (!water[i]) {
      if (kept != i) atoms[kept] = std::move(atoms[i]);
      ++kept;
    }
  atoms.resize(kept);
  return molecules;
}

/// Replaces the atoms by those of the assembly. Copies of a chain are named, …
std::optional<Problem> applyAssembly(ParsedStructure& parsed, const std::string& name,
                                     const std::string& file) {
  if (parsed.assemblies.empty())
    return Problem{file, 0, 0, "the file describes no biological assembly", "read it without one"};
  const auto found = std::find_if(parsed.assemblies.begin(), parsed.assemblies.end(),
                                  [&](const ParsedAssembly& a) { return a.name == name; });
  if (found == parsed.assemblies.end()) {
    std::string names;
    for (const ParsedAssembly& a : parsed.assemblies) names += (names.empty() ? "" : ", ") + a.name;
    return Problem{file, 0, 0, "there is no biological assembly " + inQuotes(name),
                   "the file describes: " + names};
  }
  constexpr double kSamePlace_A = 0.2;  // an atom on a symmetry axis is carried onto itself
  const auto contains = [](const std::vector<std::string>& list, const std::string& s) {
    return !s.empty() && std::find(list.begin(), list.end(), s) != list.end();
  };
  std::vector<ParsedAtom> out;
  std::vector<std::vector<Vec3>> places(parsed.atoms.size());
  std::map<std::string, int> copies;
  for (const ParsedAssembly::Part& part : found->parts) {
    std::vector<char> in_part(parsed.atoms.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < parsed.atoms.size(); ++i) {
      in_part[i] = contains(part.chains, parsed.atoms[i].chain) ||
                   contains(part.label_chains, parsed.atoms[i].label_chain);
      count += in_part[i];
    }
    if (count && part.operators.size() > (kMaxAtoms - out.size()) / count)
      return Problem{file, 0, 0, "the assembly " + inQuotes(name) + " has more than 50 million atoms",
                     "read it without one"};
    for (const ParsedOperator& op : part.operators) {
      std::map<std::string, int> copy_of;  // the number of this copy, by label where there is one
      for (std::size_t i = 0; i < parsed.atoms.size(); ++i) {
        if (!in_part[i]) continue;
        ParsedAtom atom = parsed.atoms[i];
        atom.position_A = op.turn * atom.position_A + op.shift_A;
        const bool here = std::any_of(places[i].begin(), places[i].end(), [&](Vec3 p) {
          return glm::distance(p, atom.position_A) < kSamePlace_A;
        });
        if (here) continue;
        places[i].push_back(atom.position_A);
        const std::string key = atom.label_chain.empty() ? atom.chain : atom.label_chain + '\n' + atom.chain;
        auto [it, is_new] = copy_of.emplace(key, 0);
        if (is_new) it->second = ++copies[key];
        if (it->second > 1) {
          const std::string suffix = '-' + std::to_string(it->second);
          atom.chain += suffix;
          if (!atom.label_chain.empty()) atom.label_chain += suffix;
        }
        out.push_back(std::move(atom));
      }
    }
  }
  if (out.empty())
    return Problem{file, 0, 0, "the assembly " + inQuotes(name) + " names no chain of the file",
                   "read it without one"};
  parsed.atoms = std::move(out);
  return std::nullopt;
}

/// Groups the atoms into residues and chains, by runs, so that the order of the file stays.
void group(Molecule& out, const std::vector<ParsedAtom>& atoms) {
  out.atoms.reserve(atoms.size());
  for (std::size_t begin = 0, end = 0; begin < atoms.size(); begin = end) {
    const ParsedAtom& first = atoms[begin];
    if (out.chains.empty() || out.chains.back().name != first.chain)
      out.chains.push_back({first.chain, static_cast<std::uint32_t>(out.residues.size()), 0});
    Residue residue;
    residue.name = first.residue;
    residue.number = first.number;
    residue.insertion = first.insertion;
    residue.chain = static_cast<std::uint32_t>(out.chains.size() - 1);
    residue.first_atom = static_cast<std::uint32_t>(begin);
    for (end = begin; end < atoms.size() && sameResidue(first, atoms[end]); ++end) {
      const ParsedAtom& from = atoms[end];
      Atom atom;
      atom.position.A = from.position_A;
      atom.atomic_number = static_cast<std::uint8_t>(std::clamp(from.atomic_number, 0, kElementCount));
      atom.radius_A = element(atom.atomic_number).radius_A;
      atom.residue = static_cast<std::uint32_t>(out.residues.size());
      std::copy_n(from.name.data(), std::min(from.name.size(), atom.name.size() - 1), atom.name.data());
      out.atoms.push_back(atom);
    }
    residue.atom_count = static_cast<std::uint32_t>(end - begin);
    residue.kind = residueKind(residue, out.atoms, first.hetero);
    out.residues.push_back(std::move(residue));
    ++out.chains.back().residue_count;
  }
}

std::string counted(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

/// One sentence for each element without a published radius, and for each that is not known.
void warnOfElements(Molecule& out, const std::vector<ParsedAtom>& atoms) {
  std::map<std::string, std::size_t> unknown;
  for (const ParsedAtom& atom : atoms)
    if (element(atom.atomic_number).source == RadiusSource::Default)
      ++unknown[atom.atomic_number ? std::string(element(atom.atomic_number).symbol) : atom.element];
  constexpr std::size_t kMostNamed = 50;
  std::size_t named = 0, rest = 0;
  for (const auto& [symbol, count] : unknown) {
    if (++named > kMostNamed) {
      rest += count;
      continue;
    }
    out.warnings.push_back("No van der Waals radius is known for the element " + inQuotes(symbol) + " (" +
                           counted(count, "atom", "atoms") + "); 1.70 A was taken.");
  }
  if (rest)
    out.warnings.push_back("1.70 A was also taken for " + counted(rest, "atom", "atoms") +
                           " of further unknown elements.");
}

}  // namespace

Expected<Molecule> buildMolecule(ParsedStructure parsed, const std::string& file,
                                 const ReadOptions& options) {
  if (parsed.atoms.empty())
    return Problem{
        file, 0, 0,
        "the file holds no atoms" + (parsed.models > 1 ? " in model " + std::to_string(options.model) : ""),
        "take a coordinate file from the PDB (www.rcsb.org)"};
  Molecule out;
  out.id = parsed.id;
  out.title = parsed.title;
  out.models_in_file = static_cast<std::uint32_t>(parsed.models);
  out.alternates_left_out = static_cast<std::uint32_t>(dropAlternates(parsed.atoms));
  if (!options.waters) out.waters_left_out = static_cast<std::uint32_t>(dropWaters(parsed.atoms));
  if (!options.assembly.empty())
    if (auto problem = applyAssembly(parsed, options.assembly, file)) return *problem;
  if (parsed.atoms.size() > kMaxAtoms)
    return Problem{file, 0, 0, "more than 50 million atoms", "split the file"};
  for (const ParsedAtom& atom : parsed.atoms)
    for (int k = 0; k < 3; ++k)
      if (!(std::abs(atom.position_A[k]) <= kMaxCoordinate_A))
        return Problem{file, atom.line, 0, "the atom " + inQuotes(atom.name) + " lies farther out than 1e9 A",
                       "correct its coordinates"};

  if (parsed.models > 1)
    out.warnings.push_back("The file has " + std::to_string(parsed.models) + " models; this is model " +
                           std::to_string(options.model) + ".");
  if (out.alternates_left_out)
    out.warnings.push_back(counted(out.alternates_left_out, "atom", "atoms") +
                           " at a less occupied alternate location left out.");
  if (out.waters_left_out)
    out.warnings.push_back(counted(out.waters_left_out, "water molecule", "water molecules") + " left out.");
  out.warnings.insert(out.warnings.end(), parsed.warnings.begin(), parsed.warnings.end());
  warnOfElements(out, parsed.atoms);
  group(out, parsed.atoms);
  return out;
}

}  // namespace moltact
