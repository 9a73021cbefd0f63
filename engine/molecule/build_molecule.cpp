// Builds a molecule from the atoms of a file by the rules of reader.h, which are common to all formats that name their
// atoms.
#include <algorithm>
#include <cmath>
#include <functional>
#include <unordered_map>

#include "engine/core/saturated.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/molecule/elements.h"
#include "engine/molecule/parsed_structure.h"
#include "engine/molecule/residue_kind.h"

namespace moltact {
namespace {

// A group with more atoms is not a residue: alternates are not searched beyond this number.
constexpr std::size_t kMaxAtPlace = 100'000;
constexpr std::size_t kMaxUnknownElements = 1000;

std::string countedAtoms(std::size_t n) { return trnf("{0} atom", "{0} atoms", n, n); }

/// Removes water and returns the number of molecules removed. A file that contains only water keeps it.
std::size_t dropWaters(MoleculeStorage& grown) {
  const MoleculeArrays& m = grown.arrays;
  const auto water = [](const Residue& r) { return r.kind == ResidueKind::Water; };
  const auto waters = static_cast<std::size_t>(std::count_if(m.residues.begin(), m.residues.end(), water));
  if (waters == 0 || waters == m.residues.size()) return 0;
  // Removing waters can make two ranges of one residue adjacent: all ranges are merged again, in place.
  MoleculeArrays old = std::move(grown.arrays);
  MoleculeStorage out(grown.namesLabelChains(), grown.hasCharges());
  MoleculeArrays& arrays = out.arrays;
  arrays.atoms = std::move(old.atoms);
  arrays.spheres = std::move(old.spheres);
  arrays.charges_e = std::move(old.charges_e);
  arrays.formal_charges_e = std::move(old.formal_charges_e);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < old.residues.size(); ++i) {
    const Residue& r = old.residues[i];
    if (water(r)) continue;
    for (std::uint32_t k = 0; k < r.atom_count; ++k) {
      const PlacedAtom atom = out.at(r.first_atom + k);
      const std::int8_t formal_e = out.formalCharge_e(r.first_atom + k);
      const std::uint32_t number =
          old.numbers_in_file.empty() ? r.first_atom + k : old.numbers_in_file[r.first_atom + k];
      out.put(kept, atom, out.charge_e(r.first_atom + k),
              {r.name, old.chains[r.chain].name, grown.labelChain(i), r.number, r.insertion}, grown.hetero_of[i]);
      out.setFormalCharge(kept, formal_e);
      out.setNumberInFile(kept++, number);
    }
  }
  arrays.atoms.resize(kept);
  arrays.spheres.resize(kept);
  if (out.hasCharges()) arrays.charges_e.resize(kept);
  if (arrays.formal_charges_e.size() > kept) arrays.formal_charges_e.resize(kept);
  if (!arrays.numbers_in_file.empty()) arrays.numbers_in_file.resize(kept);
  out.close();
  grown = std::move(out);
  return waters;
}

}  // namespace

MoleculeBuilder::MoleculeBuilder(const TextSource& text, const ReadOptions& options, bool has_charges)
    : options_(options),
      radii_(radiusTable(options.radii)),
      text_(text),
      file_(text.file()),
      out_(!options.assembly.empty(), has_charges) {}

// The length of a line is estimated from the first lines. The arrays of the molecule are then allocated once for all
// atoms, because growing a list holds both copies for a while.
void MoleculeBuilder::expectMore() {
  constexpr std::size_t kTelling = 10'000;
  if (atoms_++ == 0) before_ = text_.givenBytes();
  const std::vector<Atom>& kept = out_.arrays.atoms;
  if (atoms_ != kTelling && (atoms_ < kTelling || kept.size() + waiting_.size() < kept.capacity())) return;
  const double share = double(text_.expectedBytes() - std::min(before_, text_.expectedBytes())) /
                       double(text_.givenBytes() - before_ + 1);
  const double likely = double(kept.size() + waiting_.size()) * std::max(1.01 * share, 1.1);
  if (likely > double(kept.capacity()))
    out_.expect(static_cast<std::size_t>(std::min(likely, double(kMaxMoleculeAtoms))));
}

std::int32_t MoleculeBuilder::unknownElement(const ParsedAtom& atom) {
  if (radii_.knows(atom.atomic_number)) return -1;
  constexpr std::size_t kMaxShown = 25;
  const std::string_view symbol = atom.atomic_number > 0 && atom.atomic_number <= kElementCount
                                      ? element(atom.atomic_number).symbol
                                      : atom.element.substr(0, kMaxShown);
  const auto found = unknown_of_.find(symbol);
  if (found != unknown_of_.end()) return found->second;
  // Beyond the limit, one entry represents all further elements.
  const bool rest = unknown_.size() >= kMaxUnknownElements;
  if (!rest || unknown_.size() == kMaxUnknownElements) unknown_.push_back({rest ? std::string() : std::string(symbol)});
  if (rest) return static_cast<std::int32_t>(kMaxUnknownElements);
  const auto index = static_cast<std::int32_t>(unknown_.size() - 1);
  unknown_of_.emplace(symbol, index);
  return index;
}

std::optional<Problem> MoleculeBuilder::add(const ParsedAtom& from) {
  for (int k = 0; k < 3; ++k)
    if (!(std::abs(from.position_A[k]) <= kMaxCoordinate_A))
      return Problem{file_, from.line, 0,
                     trf("the atom {0} lies farther out than {1}", inQuotes(from.name),
                         quantityText(kMaxCoordinate_A, Dimension::Length, plain())),
                     tr("correct its coordinates")};
  if (auto problem = out_.full(file_, from.line)) return problem;
  expectMore();
  const bool same_place = !waiting_.empty() && from.number == number_ && from.insertion == insertion_ &&
                          from.chain == chain_ && from.label_chain == label_chain_;
  if (!same_place || waiting_.size() == kMaxAtPlace) {
    endPlace();
    chain_ = from.chain, label_chain_ = from.label_chain;
    number_ = from.number, insertion_ = from.insertion;
  }
  Waiting& waits = waiting_.emplace_back();
  if (residues_.empty() || residues_.back() != from.residue) {
    const auto known = std::find(residues_.begin(), residues_.end(), from.residue);
    waits.residue = static_cast<std::uint32_t>(known - residues_.begin());
    if (known == residues_.end()) residues_.emplace_back(from.residue);
  } else {
    waits.residue = static_cast<std::uint32_t>(residues_.size() - 1);
  }
  // A residue has few alternatives; a group with more is not a residue and is not searched for each of its atoms.
  constexpr std::size_t kMaxAlternatives = 100;
  waits.in_file = in_file_++;
  PlacedAtom& atom = waits.atom;
  atom.position.A = from.position_A;
  atom.atomic_number = static_cast<std::uint8_t>(std::clamp(from.atomic_number, 0, kElementCount));
  atom.radius_A = from.radius_A >= 0.0 ? from.radius_A : radii_.radius(atom.atomic_number);
  atom.b_factor_A2 = saturateToFloat(from.b_factor_A2);
  std::copy_n(from.name.data(), std::min(from.name.size(), atom.name.size() - 1), atom.name.data());
  waits.charge_e = saturateToFloat(from.charge_e);
  waits.name = from.name;
  waits.occupancy = from.occupancy;
  waits.unknown = from.radius_A >= 0.0 ? -1 : unknownElement(from);
  waits.alternate = from.alternate;
  waits.formal_e = static_cast<std::int8_t>(isFormalCharge(from.formal_e) ? from.formal_e : 0);
  waits.hetero = from.hetero;
  if (residues_.size() > kMaxAlternatives) endPlace();
  return std::nullopt;
}

/// Keeps the atoms of highest occupancy among those of one name.
void MoleculeBuilder::keepLikeliest() {
  std::vector<char> keep(waiting_.size(), 1);
  std::unordered_map<std::string_view, std::size_t> best;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    const auto [it, is_new] = best.emplace(waiting_[i].name, i);
    if (is_new) continue;
    const Waiting& rival = waiting_[it->second];
    if (waiting_[i].alternate == rival.alternate) continue;  // a repeated name is not an alternate location
    if (waiting_[i].occupancy > rival.occupancy) {
      keep[it->second] = 0;
      it->second = i;
    } else {
      keep[i] = 0;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < waiting_.size(); ++i)
    if (keep[i] && kept++ != i) waiting_[kept - 1] = std::move(waiting_[i]);
  waiting_.resize(kept);
}

/// Removes the alternate locations that the rules do not keep.
void MoleculeBuilder::dropAlternates() {
  const auto alternate = [](const Waiting& w) { return w.alternate != ' '; };
  if (std::none_of(waiting_.begin(), waiting_.end(), alternate)) return;
  const std::size_t before = waiting_.size();
  // Of alternative residues the one with the highest mean occupancy is kept, the first on a tie.
  if (residues_.size() > 1 && std::all_of(waiting_.begin(), waiting_.end(), alternate)) {
    std::vector<double> sum(residues_.size()), count(residues_.size());
    for (const Waiting& w : waiting_) sum[w.residue] += w.occupancy, ++count[w.residue];
    std::size_t likeliest = 0;
    for (std::size_t k = 1; k < residues_.size(); ++k)
      if (sum[k] / count[k] > sum[likeliest] / count[likeliest]) likeliest = k;
    std::erase_if(waiting_, [&](const Waiting& w) { return w.residue != likeliest; });
  }
  keepLikeliest();
  alternates_left_out_ += before - waiting_.size();
}

void MoleculeBuilder::endPlace() {
  dropAlternates();
  for (const Waiting& w : waiting_) {
    const std::string& residue = residues_[w.residue];
    out_.add(w.atom, w.charge_e, {residue, chain_, label_chain_, number_, insertion_}, w.hetero);
    out_.setNumberInFile(out_.arrays.atoms.size() - 1, w.in_file);
    out_.setFormalCharge(out_.arrays.atoms.size() - 1, w.formal_e);
    if (w.unknown >= 0) {
      Unknown& unknown = unknown_[static_cast<std::size_t>(w.unknown)];
      ++(isWaterName(residue) ? unknown.in_water : unknown.elsewhere);
    }
  }
  waiting_.clear();
  residues_.clear();
}

/// Adds one warning for each element without a published radius, and for each unknown element.
void MoleculeBuilder::warnOfElements(bool waters, std::vector<std::string>& warnings) const {
  constexpr std::size_t kMaxNamed = 50;
  std::size_t named = 0, rest = 0;
  std::map<std::string_view, std::size_t> counts;
  for (const Unknown& u : unknown_)
    if (const std::size_t count = u.elsewhere + (waters ? u.in_water : 0)) {
      if (&u - unknown_.data() < std::ptrdiff_t(kMaxUnknownElements))
        counts[u.symbol] += count;
      else
        rest += count;
    }
  for (const auto& [symbol, count] : counts) {
    if (++named > kMaxNamed) {
      rest += count;
      continue;
    }
    warnings.push_back(trf("No van der Waals radius is known for the element {0} ({1}); {2} was taken.",
                           inQuotes(symbol), countedAtoms(count), quantityText(kDefaultRadius_A, Dimension::Length)));
  }
  if (rest)
    warnings.push_back(trf("{0} was also taken for {1} of further unknown elements.",
                           quantityText(kDefaultRadius_A, Dimension::Length), countedAtoms(rest)));
}

Expected<Molecule> MoleculeBuilder::finish(ParsedHeader head) {
  endPlace();
  out_.close();
  if (out_.arrays.atoms.empty())
    return Problem{
        file_, 0, 0,
        head.models > 1 ? trf("the file holds no atoms in model {0}", options_.model) : tr("the file holds no atoms"),
        tr("take a coordinate file from the PDB (www.rcsb.org)")};
  const std::size_t waters = options_.waters ? 0 : dropWaters(out_);
  std::vector<std::string> of_elements;
  warnOfElements(waters == 0, of_elements);
  if (std::string missing = markElements(out_.arrays, head.elements); !missing.empty())
    head.warnings.push_back(std::move(missing));
  Molecule out;
  out.has_recorded_structure =
      std::any_of(out_.arrays.residues.begin(), out_.arrays.residues.end(),
                  [](const Residue& r) { return r.recorded.kind != SecondaryStructure::Coil; });
  if (!options_.assembly.empty())
    if (auto problem = applyAssembly(out_, head.assemblies, options_.assembly, file_)) return *problem;
  out.id = std::move(head.id);
  out.title = std::move(head.title);
  out.models_in_file = static_cast<std::uint32_t>(head.models);
  out.alternates_left_out = static_cast<std::uint32_t>(alternates_left_out_);
  out.waters_left_out = static_cast<std::uint32_t>(waters);
  std::vector<std::string> warnings;
  if (head.models > 1)
    warnings.push_back(trf("The file has {0} models; this is model {1}.", head.models, options_.model));
  if (alternates_left_out_)
    warnings.push_back(trnf("{0} atom at a less occupied alternate location left out.",
                            "{0} atoms at a less occupied alternate location left out.", alternates_left_out_,
                            alternates_left_out_));
  if (waters) warnings.push_back(trnf("{0} water molecule left out.", "{0} water molecules left out.", waters, waters));
  warnings.insert(warnings.end(), head.warnings.begin(), head.warnings.end());
  warnings.insert(warnings.end(), of_elements.begin(), of_elements.end());
  out.warnings = std::move(warnings);
  out.atoms = std::move(out_.arrays.atoms);
  out.spheres = std::move(out_.arrays.spheres);
  out.charges_e = std::move(out_.arrays.charges_e);
  if (std::vector<std::int8_t>& formal = out_.arrays.formal_charges_e;
      std::any_of(formal.begin(), formal.end(), [](std::int8_t charge_e) { return charge_e != 0; })) {
    formal.resize(out.atoms.size());
    out.formal_charges_e = std::move(formal);
  }
  if (options_.assembly.empty()) {
    out.numbers_in_file = std::move(out_.arrays.numbers_in_file);
    out.atoms_in_file = in_file_;
  }
  out.body_overlap_A = radii_.body_overlap_A;
  out.residues = std::move(out_.arrays.residues);
  out.chains = std::move(out_.arrays.chains);
  return out;
}

}  // namespace moltact
