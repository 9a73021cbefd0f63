// Reads MOL2, the format of Tripos' programs: atoms with SYBYL types and partial charges, bonds, and substructures, which
// are residues. One molecule after another, each a model. Positions in angstroms.
#include <algorithm>
#include <array>
#include <charconv>
#include <gemmi/elem.hpp>
#include <unordered_map>

#include "engine/language/catalogue.h"
#include "engine/molecule/element_of_name.h"
#include "engine/molecule/parsed_structure.h"
#include "engine/molecule/residue_kind.h"

namespace moltact {
namespace {

constexpr std::string_view kMol2Residue = "UNL", kMol2Chain = "A";
constexpr std::size_t kMaxMol2Atoms = 1'000'000;
constexpr const char* kMol2Remedy =
    N_("write the file anew with the program that made it; an atom is number, name, x, y, z, type, and where they are "
       "known substructure number, its name and charge");

bool mol2Integer(std::string_view text, int& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

/// Four asterisks stand for a text that is not given.
bool given(std::string_view text) { return !text.empty() && text.find_first_not_of('*') != std::string_view::npos; }

/// A lone pair or a dummy, which is no atom.
bool isNoAtom(std::string_view type) { return type == "LP" || type == "Du" || type.starts_with("Du."); }

/// The element of a SYBYL type, which starts with its symbol: C.3, N.ar, Cl. 0 for Any, Hal, Het, Hev and unknown ones.
int elementOfType(std::string_view type) {
  const std::string symbol(type.substr(0, type.find('.')));
  return symbol.empty() || symbol.size() > 2 ? 0 : gemmi::Element(symbol).atomic_number();
}

std::optional<BondOrder> mol2BondOrder(std::string_view type) {
  if (type == "1" || type == "am") return BondOrder::Single;
  if (type == "2") return BondOrder::Double;
  if (type == "3") return BondOrder::Triple;
  if (type == "ar") return BondOrder::Aromatic;
  if (type == "un" || type == "du") return BondOrder::Unknown;
  return std::nullopt;
}

class Mol2Reader {
 public:
  Mol2Reader(TextSource& text, const ReadOptions& options) : text_(text), file_(text.file()), options_(options) {}

  Expected<Molecule> run() {
    if (!options_.assembly.empty()) return noAssembly(file_);
    Section section = Section::Other;
    for (std::string_view line; next(line);) {
      if (line.starts_with("@<TRIPOS>")) {
        if (auto problem = endOf(section)) return *problem;
        const std::string_view name = trimmed(line.substr(9));
        attributes_ahead_ = 0;
        section = name == "MOLECULE"          ? Section::Molecule
                  : name == "ATOM"            ? Section::Atoms
                  : name == "BOND"            ? Section::Bonds
                  : name == "SUBSTRUCTURE"    ? Section::Substructures
                  : name == "UNITY_ATOM_ATTR" ? Section::Attributes
                                              : Section::Other;
        if (section == Section::Molecule) {
          ++head_.models;
          line_of_molecule_ = 0;
          wanted_ = head_.models == options_.model;
        }
        continue;
      }
      if (!wanted_ || (section != Section::Molecule && (trimmed(line).empty() || line.front() == '#'))) continue;
      std::optional<Problem> problem;
      if (section == Section::Molecule) problem = moleculeLine(line);
      if (section == Section::Atoms) problem = atomLine(line);
      if (section == Section::Bonds) problem = bondLine(line);
      if (section == Section::Substructures) substructureLine(line);
      if (section == Section::Attributes) problem = attributeLine(line);
      if (problem) return *problem;
    }
    if (text_.problem()) return *text_.problem();
    if (auto problem = endOf(section)) return *problem;
    if (head_.models == 0) return Problem{file_, 0, 0, tr("there is no @<TRIPOS>MOLECULE line in it"), tr(kMol2Remedy)};
    if (options_.model < 1 || options_.model > head_.models) return noSuchModel(file_, options_.model, head_.models);
    return built();
  }

 private:
  enum class Section { Other, Molecule, Atoms, Bonds, Substructures, Attributes };
  struct Row {
    std::string name, type;
    Vec3 position_A{0.0};
    double charge_e = 0.0;
    int formal_e = 0;
    std::size_t line = 0;
    int substructure = 1;
    std::string substructure_name;
  };
  struct Substructure {
    std::string type, chain;
  };

  // Reads a line; a backslash at its end joins the next one to it.
  bool next(std::string_view& line) {
    if (!text_.next(line)) return false;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.empty() || line.back() != '\\') return true;
    joined_.clear();
    while (!line.empty() && line.back() == '\\') {
      joined_ += line.substr(0, line.size() - 1);
      if (joined_.size() > kMaxMoleculeLineBytes || !text_.next(line)) break;
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    }
    if (line.empty() || line.back() != '\\') joined_ += line;
    line = joined_;
    return true;
  }

  Problem bad(std::size_t column, std::string what) const {
    return {file_, text_.number(), column, std::move(what), tr(kMol2Remedy)};
  }

  std::optional<Problem> moleculeLine(std::string_view line) {
    switch (++line_of_molecule_) {
      case 1:
        if (given(trimmed(line))) head_.title = trimmed(line);
        return std::nullopt;
      case 2: {
        const auto words = wordsOfLine(line);
        for (std::size_t k = 0; k < 2; ++k)
          if (words.size() > k ? !mol2Integer(words[k].text, counts_[k]) || counts_[k] < 0 : k == 0)
            return bad(1,
                       trf("the second line of a molecule starts with the numbers of its atoms and bonds; this is {0}",
                           inQuotes(line)));
        return std::nullopt;
      }
      case 4:
        has_charges_ = trimmed(line) != "NO_CHARGES";
        return std::nullopt;
      default:
        return std::nullopt;
    }
  }

  std::optional<Problem> atomLine(std::string_view line) {
    const auto words = wordsOfLine(line);
    if (words.size() < 6) return bad(1, trf("an atom has 6 words or more, this one {0}", words.size()));
    int number = 0;
    if (!mol2Integer(words[0].text, number))
      return bad(words[0].column, trf("the atom's number is not a number: {0}", inQuotes(words[0].text)));
    if (!of_number_.emplace(number, std::uint32_t(rows_.size())).second)
      return bad(words[0].column, trf("two atoms have the number {0}", number));
    Row row;
    for (std::size_t k = 0; k < 3; ++k)
      if (!parseNumber(words[2 + k].text, row.position_A[int(k)]))
        return bad(words[2 + k].column,
                   trf("expected a number for {0}, found {1}", std::string(1, "xyz"[k]), inQuotes(words[2 + k].text)));
    row.name = words[1].text;
    row.type = words[5].text;
    if (words.size() > 6 && !mol2Integer(words[6].text, row.substructure))
      return bad(words[6].column, trf("the substructure's number is not a number: {0}", inQuotes(words[6].text)));
    if (words.size() > 7) row.substructure_name = words[7].text;
    if (has_charges_) {
      if (words.size() < 9)
        return bad(line.size() + 1, tr("the atom has no charge, although the molecule's fourth line names charges"));
      if (std::string fault = partialChargeFault(words[8].text, row.charge_e); !fault.empty())
        return bad(words[8].column, std::move(fault));
    }
    row.line = text_.number();
    if (rows_.size() >= kMaxMol2Atoms)
      return Problem{file_, text_.number(), 0, tr("more than a million atoms"), tr("take a molecule of fewer atoms")};
    rows_.push_back(std::move(row));
    return std::nullopt;
  }

  // A section cut short has fewer lines than the molecule's second line says.
  std::optional<Problem> endOf(Section section) const {
    if (!wanted_) return std::nullopt;
    const auto cut = [&](std::string what) {
      return Problem{file_, text_.number(), 0, std::move(what), tr("copy or download it again")};
    };
    if (section == Section::Atoms && std::size_t(counts_[0]) != rows_.size())
      return cut(trf("the molecule is to have {0} atoms by its second line, and it has {1}", counts_[0], rows_.size()));
    if (section == Section::Bonds && std::size_t(counts_[1]) != bond_lines_)
      return cut(trf("the molecule is to have {0} bonds by its second line, and it has {1}", counts_[1], bond_lines_));
    return std::nullopt;
  }

  std::optional<Problem> bondLine(std::string_view line) {
    const auto words = wordsOfLine(line);
    int ends[2] = {};
    ++bond_lines_;
    if (words.size() < 4 || !mol2Integer(words[1].text, ends[0]) || !mol2Integer(words[2].text, ends[1]))
      return bad(1, trf("a bond is its number, two atoms and its type; this is {0}", inQuotes(line)));
    std::array<std::uint32_t, 2> at{};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto found = of_number_.find(ends[k]);
      if (found == of_number_.end())
        return bad(words[1 + k].column, trf("a bond names the atom {0}, which is not there", ends[k]));
      at[k] = found->second;
    }
    if (at[0] == at[1]) return bad(words[1].column, trf("the atom {0} is bonded to itself", ends[0]));
    if (words[3].text == "nc") return std::nullopt;
    const auto order = mol2BondOrder(words[3].text);
    if (!order)
      return bad(words[3].column,
                 trf("the bond's type {0} is none of 1, 2, 3, am, ar, du, un, nc", inQuotes(words[3].text)));
    if (bonds_.size() >= kMaxBondsAnAtom * rows_.size())
      return bad(1, trf("more than {0} bonds an atom", kMaxBondsAnAtom));
    const auto [low, high] = std::minmax(at[0], at[1]);
    bonds_.push_back({low, high, *order});
    return std::nullopt;
  }

  // Number, name, root atom, type, dictionary, chain, and the name of its kind ("ALA").
  void substructureLine(std::string_view line) {
    const auto words = wordsOfLine(line);
    int number = 0;
    if (words.size() < 6 || !mol2Integer(words[0].text, number) || substructures_.size() >= rows_.size()) return;
    Substructure& s = substructures_[number];
    if (given(words[5].text)) s.chain = words[5].text;
    if (words.size() > 6 && given(words[6].text)) s.type = words[6].text;
  }

  // An atom's number and how many attributes follow, one a line: name and value. Formal charges are named "charge".
  std::optional<Problem> attributeLine(std::string_view line) {
    const auto words = wordsOfLine(line);
    if (attributes_ahead_ > 0) {
      --attributes_ahead_;
      if (words.size() < 2 || words[0].text != "charge") return std::nullopt;
      std::string_view charge = words[1].text;
      if (charge.front() == '+') charge.remove_prefix(1);
      int formal_e = 0;
      if (!mol2Integer(charge, formal_e) || !isFormalCharge(formal_e))
        return bad(words[1].column,
                   trf("the formal charge is no whole number from -15 to 15: {0}", inQuotes(words[1].text)));
      rows_[attributed_].formal_e = formal_e;
      return std::nullopt;
    }
    int number = 0;
    if (words.size() < 2 || !mol2Integer(words[0].text, number) || !mol2Integer(words[1].text, attributes_ahead_))
      return bad(1, trf("an atom's attributes begin with its number and their count; this is {0}", inQuotes(line)));
    const auto found = of_number_.find(number);
    if (found == of_number_.end())
      return bad(words[0].column, trf("attributes name the atom {0}, which is not there", number));
    attributed_ = found->second;
    return std::nullopt;
  }

  /// The residue of an atom. The name of a substructure is that of the residue and its number: "MET1".
  void setResidue(const Row& row, ParsedAtom& atom) const {
    const auto found = substructures_.find(row.substructure);
    const Substructure* s = found == substructures_.end() ? nullptr : &found->second;
    std::string_view name = row.substructure_name;
    atom.number = row.substructure;
    atom.chain = s && !s->chain.empty() ? std::string_view(s->chain) : kMol2Chain;
    const bool typed = s && !s->type.empty() && name.starts_with(s->type);
    const std::size_t digits = typed ? s->type.size() : name.find_last_not_of("0123456789") + 1;
    int number = 0;
    if (digits > 0 && digits < name.size() && mol2Integer(name.substr(digits), number)) {
      atom.number = number;
      name = name.substr(0, digits);
    }
    // Some programs write "<0>" where they know no name.
    atom.residue = given(name) && name.front() != '<' ? name : kMol2Residue;
  }

  Expected<Molecule> built() {
    const bool any_charge = std::any_of(rows_.begin(), rows_.end(), [](const Row& r) { return r.charge_e != 0.0; });
    MoleculeBuilder builder(text_, options_, has_charges_ && any_charge);
    std::size_t no_atoms = 0;
    std::vector<char> is_water(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Row& row = rows_[i];
      if (isNoAtom(row.type)) {
        ++no_atoms;
        continue;
      }
      ParsedAtom atom;
      setResidue(row, atom);
      is_water[i] = isWaterName(atom.residue);
      atom.name = row.name;
      atom.position_A = row.position_A;
      atom.charge_e = row.charge_e;
      atom.formal_e = row.formal_e;
      atom.atomic_number = elementOfType(row.type);
      atom.element = row.type;
      atom.line = row.line;
      atom.hetero = !isNucleotideName(atom.residue);
      if (auto problem = builder.add(atom)) return *problem;
    }
    if (no_atoms)
      head_.warnings.push_back(
          trnf("{0} lone pair or dummy left out.", "{0} lone pairs and dummies left out.", no_atoms, no_atoms));
    if (has_charges_ && !any_charge && !rows_.empty()) head_.warnings.push_back(allChargesZero());
    Expected<Molecule> out = builder.finish(std::move(head_));
    if (out) out->listed_bonds = bondsOf(is_water, out->waters_left_out > 0);
    return out;
  }

  // The bonds between atoms that were kept.
  std::vector<Bond> bondsOf(const std::vector<char>& is_water, bool without_waters) {
    std::vector<std::uint32_t> place(rows_.size(), kNoResidue);
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (!isNoAtom(rows_[i].type) && !(without_waters && is_water[i])) place[i] = kept++;
    std::vector<Bond> out;
    for (const Bond& b : bonds_)
      if (place[b.first] != kNoResidue && place[b.second] != kNoResidue)
        out.push_back({place[b.first], place[b.second], b.order});
    const auto ends = [](const Bond& b) { return std::pair(b.first, b.second); };
    std::stable_sort(out.begin(), out.end(), [&](const Bond& a, const Bond& b) { return ends(a) < ends(b); });
    out.erase(std::unique(out.begin(), out.end(), [&](const Bond& a, const Bond& b) { return ends(a) == ends(b); }),
              out.end());
    return out;
  }

  TextSource& text_;
  const std::string& file_;
  const ReadOptions& options_;
  ParsedHeader head_{.id = {}, .title = {}, .elements = {}, .assemblies = {}, .warnings = {}, .models = 0};
  std::string joined_;
  int line_of_molecule_ = 0;
  std::array<int, 2> counts_{};  // atoms and bonds
  std::size_t bond_lines_ = 0;
  int attributes_ahead_ = 0;      // lines
  std::uint32_t attributed_ = 0;  // the atom that has them
  bool wanted_ = false, has_charges_ = false;
  std::vector<Row> rows_;
  std::unordered_map<int, std::uint32_t> of_number_;
  std::unordered_map<int, Substructure> substructures_;
  std::vector<Bond> bonds_;
};

}  // namespace

Expected<Molecule> readMol2(TextSource& text, const ReadOptions& options) { return Mol2Reader(text, options).run(); }

}  // namespace moltact
