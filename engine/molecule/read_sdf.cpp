// Reads MOL and SDF files, V2000 and V3000, as written by PubChem and drawing programs: atoms with their bonds, one
// molecule after another, each a model. Positions in angstroms.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <gemmi/elem.hpp>
#include <map>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/molecule/elements.h"
#include "engine/molecule/parsed_structure.h"

namespace moltact {
namespace {

// A residue of its own, with the Protein Data Bank's code for an unknown ligand.
constexpr std::string_view kSdfResidue = "UNL", kSdfChain = "A";
constexpr std::size_t kMaxSdfAtoms = 1'000'000;
constexpr const char* kSdfRemedy =
    N_("take the file again from its source, or write it anew with the program that made it");

bool sdfInteger(std::string_view field, long& value) {
  field = trimmed(field);
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  return error == std::errc{} && end == field.data() + field.size();
}

BondOrder bondOrder(long type) {
  switch (type) {
    case 1:
      return BondOrder::Single;
    case 2:
      return BondOrder::Double;
    case 3:
      return BondOrder::Triple;
    case 4:
      return BondOrder::Aromatic;
    case 9:
      return BondOrder::Coordination;
    default:
      return BondOrder::Unknown;
  }
}

class SdfReader {
 public:
  SdfReader(TextSource& text, const ReadOptions& options)
      : text_(text), file_(text.file()), options_(options), builder_(text, options) {}

  Expected<Molecule> run() {
    if (!options_.assembly.empty()) return noAssembly(file_);
    while (nextRecord()) {
      ++head_.models;
      wanted_ = head_.models == options_.model;
      if (auto problem = record()) return *problem;
      if (text_.problem()) return *text_.problem();
    }
    if (text_.problem()) return *text_.problem();
    if (head_.models == 0) return Problem{file_, 0, 0, tr("the file holds no atoms"), tr(kSdfRemedy)};
    if (options_.model < 1 || options_.model > head_.models) return noSuchModel(file_, options_.model, head_.models);
    if (flat_)
      head_.warnings.push_back(
          tr("The file is a flat drawing: its atoms lie in a plane. PubChem gives the molecule in space as '3D "
             "Conformer'."));
    Expected<Molecule> out = builder_.finish(std::move(head_));
    if (!out) return out;
    out->listed_bonds = sortedBonds();
    if (std::any_of(formal_e_.begin(), formal_e_.end(), [](std::int8_t charge_e) { return charge_e != 0; })) {
      formal_e_.resize(out->atoms.size());
      out->formal_charges_e = std::move(formal_e_);
    }
    return out;
  }

 private:
  // Reads the four lines before a molecule's atoms; returns false at the end of the file, where blank lines are
  // allowed.
  bool nextRecord() {
    bool blank = true;
    lines_ = 0;
    for (std::string_view line; lines_ < 4 && next(line); ++lines_) {
      blank = blank && trimmed(line).empty();
      if (lines_ == 0) title_ = trimmed(line);
      if (lines_ == 1) flat_here_ = line.size() >= 22 && line.substr(20, 2) == "2D";
      counts_ = line;
    }
    return !blank;
  }

  bool next(std::string_view& line) {
    if (!text_.next(line)) return false;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return true;
  }
  Problem bad(std::size_t column, std::string what, const char* remedy = kSdfRemedy) const {
    return {file_, text_.number(), column, std::move(what), tr(remedy)};
  }
  Problem cut() const {
    return text_.problem() ? *text_.problem()
                           : Problem{file_, text_.number(), 0, tr("the file ends within a molecule"),
                                     tr("copy or download it again")};
  }

  std::optional<Problem> record() {
    if (lines_ < 4) return cut();
    const std::string_view line = counts_;
    if (line.find("V3000") != std::string_view::npos) {
      if (auto problem = v3000()) return problem;
    } else {
      long atoms = 0, bonds = 0;
      if (line.size() < 6 || !sdfInteger(line.substr(0, 3), atoms) || !sdfInteger(line.substr(3, 3), bonds) ||
          atoms < 0 || bonds < 0)
        return bad(
            1, trf("the fourth line of a molecule says how many atoms and bonds it has, in columns 1-6; this is {0}",
                   inQuotes(line)));
      if (auto problem = v2000(atoms, bonds)) return problem;
    }
    return dataItems();
  }

  std::optional<Problem> v2000(long atoms, long bonds) {
    std::string_view line;
    for (long k = 0; k < atoms; ++k) {
      if (!next(line)) return cut();
      if (!wanted_) continue;
      if (line.size() < 32) return bad(line.size() + 1, tr("the atom's line ends before its element does"));
      Vec3 place{0.0};
      for (int axis = 0; axis < 3; ++axis)
        if (!parseNumber(line.substr(std::size_t(10 * axis), 10), place[axis]))
          return bad(std::size_t(10 * axis + 1), trf("{0} is not a number: {1}", std::string(1, "xyz"[axis]),
                                                     inQuotes(line.substr(std::size_t(10 * axis), 10))));
      if (auto problem = addAtom(trimmed(line.substr(31, 3)), place)) return problem;
      // The charge's code: 4 is a radical.
      long code = 0;
      if (line.size() >= 39 && sdfInteger(line.substr(36, 3), code) && code >= 1 && code <= 7)
        setFormal(std::size_t(k), code == 4 ? 0 : 4 - code);
    }
    for (long k = 0; k < bonds; ++k) {
      if (!next(line)) return cut();
      if (!wanted_) continue;
      long first = 0, second = 0, type = 0;
      if (line.size() < 9 || !sdfInteger(line.substr(0, 3), first) || !sdfInteger(line.substr(3, 3), second) ||
          !sdfInteger(line.substr(6, 3), type))
        return bad(1,
                   trf("a bond is three numbers in columns 1-9: two atoms and an order; this is {0}", inQuotes(line)));
      if (auto problem = addBond(first, second, type)) return problem;
    }
    return properties();
  }

  // The properties after a V2000 molecule's bonds, up to "M  END" or, in files without it, the molecule's end. The first
  // line of charges or radicals replaces all charges of the atoms' lines.
  std::optional<Problem> properties() {
    bool replaced = false;
    for (std::string_view line; next(line);) {
      if (line.starts_with("M  END")) return std::nullopt;
      if (line.starts_with("$$$$")) {
        record_ended_ = true;
        return std::nullopt;
      }
      if (line.starts_with(">")) {
        name_follows_ = namesNext(line);
        return std::nullopt;
      }
      const bool charges = line.starts_with("M  CHG");
      if (!wanted_ || (!charges && !line.starts_with("M  RAD"))) continue;
      if (!replaced) formal_e_.clear();
      replaced = true;
      if (!charges) continue;
      long count = 0;
      if (line.size() < 9 || !sdfInteger(line.substr(6, 3), count) || count < 0 || count > 8) return badCharges(line);
      for (long k = 0; k < count; ++k) {
        long atom = 0, charge_e = 0;
        const std::size_t at = std::size_t(9 + 8 * k);
        if (line.size() < at + 8 || !sdfInteger(line.substr(at, 4), atom) ||
            !sdfInteger(line.substr(at + 4, 4), charge_e) || !isFormalCharge(charge_e))
          return badCharges(line);
        if (atom < 1 || std::size_t(atom) > atoms_)
          return bad(at + 1, trf("a charge names the atom {0}, which is not there", atom));
        setFormal(std::size_t(atom - 1), charge_e);
      }
    }
    return std::nullopt;
  }
  Problem badCharges(std::string_view line) const {
    return bad(1,
               trf("a line of charges is their count, at most 8, and for each the atom and a whole number from -15 to "
                   "15, in columns of four; this is {0}",
                   inQuotes(line)));
  }
  void setFormal(std::size_t atom, long charge_e) {
    if (atom >= formal_e_.size()) {
      if (charge_e == 0) return;
      formal_e_.resize(atom + 1);
    }
    formal_e_[atom] = static_cast<std::int8_t>(charge_e);
  }

  // Reads a line of a V3000 block without its "M  V30 "; lines that end in '-' continue on the next line.
  bool nextV30(std::string& out) {
    constexpr std::string_view kMark = "M  V30 ";
    out.clear();
    for (std::string_view line; next(line);) {
      if (!line.starts_with(kMark)) {
        out = line;
        return true;
      }
      line.remove_prefix(kMark.size());
      const bool continued = !line.empty() && line.back() == '-';
      if (continued) line.remove_suffix(1);
      if (out.size() + line.size() > kMaxMoleculeLineBytes) return false;
      out += line;
      if (!continued) return true;
    }
    return false;
  }

  static std::string_view takeWord(std::string_view& rest) {
    rest = trimmed(rest);
    std::size_t end = rest.find(' ');
    if (!rest.empty() && rest.front() == '"')
      end = rest.find('"', 1) == std::string_view::npos ? rest.size() : rest.find('"', 1) + 1;
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(word.size());
    return word;
  }

  std::optional<Problem> v3000() {
    enum class Block { None, Atoms, Bonds, Other } block = Block::None;
    std::map<long, std::uint32_t> of_number;  // atoms may have arbitrary numbers
    for (std::string line; nextV30(line);) {
      std::string_view rest = line;
      if (rest.starts_with("M  END")) return std::nullopt;
      const std::string_view word = takeWord(rest);
      if (word == "BEGIN") {
        const std::string_view what = takeWord(rest);
        block = what == "ATOM"   ? Block::Atoms
                : what == "BOND" ? Block::Bonds
                : what == "CTAB" ? Block::None
                                 : Block::Other;
      } else if (word == "END") {
        block = Block::None;
      } else if (wanted_ && block == Block::Atoms) {
        long number = 0;
        const std::string_view element = takeWord(rest);
        Vec3 place{0.0};
        bool sound = sdfInteger(word, number);
        for (int axis = 0; axis < 3; ++axis) sound = parseNumber(takeWord(rest), place[axis]) && sound;
        if (!sound) return bad(8, trf("an atom is its number, its element and x, y, z; this is {0}", inQuotes(line)));
        if (!of_number.emplace(number, static_cast<std::uint32_t>(atoms_)).second)
          return bad(8, trf("two atoms have the number {0}", number));
        if (auto problem = addAtom(element, place)) return problem;
        for (std::string_view item = takeWord(rest); !item.empty(); item = takeWord(rest)) {
          long charge_e = 0;
          if (!item.starts_with("CHG=")) continue;
          if (!sdfInteger(item.substr(4), charge_e) || !isFormalCharge(charge_e))
            return bad(8, trf("the formal charge is no whole number from -15 to 15: {0}", inQuotes(item.substr(4))));
          setFormal(atoms_ - 1, charge_e);
        }
      } else if (wanted_ && block == Block::Bonds) {
        long type = 0, ends[2] = {};
        bool sound = sdfInteger(takeWord(rest), type);
        for (long& end : ends) sound = sdfInteger(takeWord(rest), end) && sound;
        if (!sound) return bad(8, trf("a bond is its number, its order and two atoms; this is {0}", inQuotes(line)));
        for (long& end : ends) {
          const auto found = of_number.find(end);
          if (found == of_number.end()) return bad(8, trf("a bond names the atom {0}, which is not there", end));
          end = long(found->second) + 1;
        }
        if (auto problem = addBond(ends[0], ends[1], type)) return problem;
      }
    }
    return cut();
  }

  std::optional<Problem> addAtom(std::string_view symbol, const Vec3& place) {
    ParsedAtom atom;
    const std::string element = symbol == "T" ? "H" : std::string(symbol);
    atom.atomic_number = element.size() > 2 ? 0 : gemmi::Element(element).atomic_number();
    std::string name = lower(std::string(symbol));
    for (char& c : name)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    name += std::to_string(++count_of_[atom.atomic_number]);
    atom.name = name;
    atom.residue = kSdfResidue;
    atom.chain = kSdfChain;
    atom.element = symbol;
    atom.position_A = place;
    atom.line = text_.number();
    atom.number = 1;
    atom.hetero = true;
    if (++atoms_ > kMaxSdfAtoms) return bad(0, tr("more than a million atoms"), N_("take a molecule of fewer atoms"));
    if (atoms_ == 1) {
      head_.id = title_;
      flat_ = flat_here_;
    }
    return builder_.add(atom);
  }

  std::optional<Problem> addBond(long first, long second, long type) {
    constexpr long kHydrogenBond = 10;
    for (const long end : {first, second})
      if (end < 1 || std::size_t(end) > atoms_)
        return bad(1, trf("a bond names the atom {0}, which is not there", end));
    if (first == second) return bad(1, trf("the atom {0} is bonded to itself", first));
    if (type == kHydrogenBond) return std::nullopt;
    if (bonds_.size() >= kMaxBondsAnAtom * atoms_) return bad(1, trf("more than {0} bonds an atom", kMaxBondsAnAtom));
    const auto [low, high] = std::minmax(first, second);
    bonds_.push_back({static_cast<std::uint32_t>(low - 1), static_cast<std::uint32_t>(high - 1), bondOrder(type)});
    return std::nullopt;
  }

  std::vector<Bond> sortedBonds() {
    const auto ends = [](const Bond& b) { return std::pair(b.first, b.second); };
    std::stable_sort(bonds_.begin(), bonds_.end(), [&](const Bond& a, const Bond& b) { return ends(a) < ends(b); });
    bonds_.erase(
        std::unique(bonds_.begin(), bonds_.end(), [&](const Bond& a, const Bond& b) { return ends(a) == ends(b); }),
        bonds_.end());
    return std::move(bonds_);
  }

  // Reads the data after a molecule up to "$$$$"; uses the name that PubChem provides.
  std::optional<Problem> dataItems() {
    if (std::exchange(record_ended_, false)) return std::nullopt;
    for (std::string_view line; next(line);) {
      if (line.starts_with("$$$$")) return std::nullopt;
      if (name_follows_ && wanted_ && head_.title.empty()) head_.title = std::string(trimmed(line));
      name_follows_ = namesNext(line);
    }
    return std::nullopt;
  }
  static bool namesNext(std::string_view line) {
    return line.starts_with(">") && line.find("<PUBCHEM_IUPAC_NAME>") != std::string_view::npos;
  }

  TextSource& text_;
  const std::string& file_;
  const ReadOptions& options_;
  MoleculeBuilder builder_;
  ParsedHeader head_{.id = {}, .title = {}, .elements = {}, .assemblies = {}, .warnings = {}, .models = 0};
  std::string title_, counts_;  // of this molecule: its first line and its fourth
  int lines_ = 0;               // number of its first four lines that are present
  bool wanted_ = false, flat_ = false, flat_here_ = false;
  std::size_t atoms_ = 0;  // of the wanted molecule
  std::map<int, int> count_of_;
  std::vector<Bond> bonds_;
  std::vector<std::int8_t> formal_e_;  // of the wanted molecule's first atoms; the others' are 0
  bool record_ended_ = false;          // its "$$$$" has been read
  bool name_follows_ = false;          // the next line is a molecule's name
};

}  // namespace

Expected<Molecule> readSdf(TextSource& text, const ReadOptions& options) { return SdfReader(text, options).run(); }

}  // namespace moltact
