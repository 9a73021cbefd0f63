// Reads the CIF of small molecules and minerals, as published by journals and the Crystallography Open Database:
// positions as fractions of the unit cell. The asymmetric unit is the molecule; its assembly "cell" is the whole unit
// cell. Of alternatives (disorder groups) the one of highest occupancy is kept. gemmi 0.5.7 (smcif.hpp) derives the
// symmetry only from the name of the space group, reads neither lists of operators nor disorder assemblies, and reports
// no line. It is used here for cells, operators and elements.
#include <algorithm>
#include <array>
#include <cmath>
#include <gemmi/elem.hpp>
#include <gemmi/symmetry.hpp>
#include <gemmi/unitcell.hpp>
#include <map>
#include <numbers>

#include "engine/language/catalogue.h"
#include "engine/molecule/cif_document.h"
#include "engine/molecule/parsed_structure.h"

namespace moltact {
namespace {

constexpr std::string_view kSmallResidue = "UNL", kSmallChain = "A";
constexpr std::size_t kMaxSites = 1'000'000, kMaxSymmetry = 1'000;
constexpr const char* kSmallRemedy = N_("correct the file, or take it again from its source");

enum SiteColumn { kLabel, kSymbol, kFractX, kFractY, kFractZ, kSiteOccupancy, kDisorderGroup, kAssembly, kUiso, kBiso };
constexpr std::string_view kSiteTags[] = {"_atom_site_label",          "_atom_site_type_symbol",
                                          "_atom_site_fract_x",        "_atom_site_fract_y",
                                          "_atom_site_fract_z",        "_atom_site_occupancy",
                                          "_atom_site_disorder_group", "_atom_site_disorder_assembly",
                                          "_atom_site_u_iso_or_equiv", "_atom_site_b_iso_or_equiv"};
constexpr std::string_view kCellTags[] = {"_cell_length_a",    "_cell_length_b",   "_cell_length_c",
                                          "_cell_angle_alpha", "_cell_angle_beta", "_cell_angle_gamma"};
constexpr std::string_view kSymmetryTags[] = {"_symmetry_equiv_pos_as_xyz", "_space_group_symop_operation_xyz"};
constexpr std::string_view kNameTags[] = {"_chemical_name_common", "_chemical_name_mineral",
                                          "_chemical_name_systematic", "_chemical_formula_moiety",
                                          "_chemical_formula_sum"};

template <std::size_t N>
std::size_t indexIn(const std::string_view (&tags)[N], const std::string& tag) {
  return std::size_t(std::find(std::begin(tags), std::end(tags), tag) - std::begin(tags));
}

/// The element denoted by the leading letters of "Fe3+", "C12", "O1W"; 0 if there is none.
int siteElement(std::string_view symbol) {
  const auto letter = [&](std::size_t k) {
    return k < symbol.size() && ((symbol[k] | 0x20) >= 'a' && (symbol[k] | 0x20) <= 'z');
  };
  if (!letter(0)) return 0;
  const auto number = [&](std::size_t letters) {
    return gemmi::Element(std::string(symbol.substr(0, letters))).atomic_number();
  };
  // In capitals HO1 is a hydrogen and CA1 a carbon, but CL1 is chlorine.
  static constexpr std::string_view kTwo[] = {"CL", "BR", "FE", "CU", "SI", "SE", "NA", "NI", "PT", "PD", "PB", "SN"};
  const bool small = letter(1) && symbol[1] >= 'a';
  const bool known = std::find(std::begin(kTwo), std::end(kTwo), symbol.substr(0, 2)) != std::end(kTwo);
  if (letter(1) && (small || known || number(1) == 0))
    if (const int two = number(2)) return two;
  return number(1);
}

struct Site {
  std::string label;
  int element = 0;
  Vec3 fraction{0.0};
  double occupancy = 1.0, b_factor_A2 = 0.0;
  std::string disorder;  ///< assembly and group; empty for an atom without alternatives
  std::string assembly;
  std::size_t line = 0;
};

struct Block {
  std::string name, title;
  std::size_t title_rank = std::size(kNameTags);
  std::array<double, 6> cell{};  // lengths in A, angles in degrees
  std::array<bool, 6> has_cell{};
  std::vector<std::string> symmetry;
  std::vector<Site> sites;
  std::size_t without_place = 0;
};

class SmallCifReader {
 public:
  SmallCifReader(TextSource& text, const ReadOptions& options)
      : text_(text), file_(text.file()), options_(options), words_(text) {}

  Expected<Molecule> run() {
    if (auto problem = readCifDocument(text_, words_, *this)) return *problem;
    if (models_ == 0)
      return Problem{file_, 0, 0, tr("there is no atom with _atom_site_fract_x, _y and _z in it"), tr(kSmallRemedy)};
    if (options_.model < 1 || options_.model > models_) return noSuchModel(file_, options_.model, models_);
    return molecule();
  }

  // The parts of the file, from readCifDocument().
  std::optional<Problem> block(std::string_view name) {
    endBlock();
    block_.name = name;
    return std::nullopt;
  }
  std::optional<Problem> end() {
    endBlock();
    return std::nullopt;
  }

  std::optional<Problem> pair(const std::string& written) {
    if (words_.null()) return std::nullopt;
    const std::string tag = lower(written);
    if (const std::size_t k = indexIn(kCellTags, tag); k < std::size(kCellTags)) {
      if (!parseCifNumber(words_.text(), block_.cell[k]))
        return words_.problemHere(trf("{0} is not a number: {1}", tag, inQuotes(words_.text())));
      block_.has_cell[k] = true;
    } else if (const std::size_t n = indexIn(kNameTags, tag); n < block_.title_rank) {
      block_.title_rank = n;
      block_.title = words_.text();
      for (char& c : block_.title)
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
      block_.title = std::string(trimmed(block_.title));
    } else if (indexIn(kSymmetryTags, tag) < std::size(kSymmetryTags)) {
      return takeSymmetry();
    }
    return std::nullopt;
  }

  void loop(const std::vector<std::string>& tags) {
    columns_.clear();
    of_sites_ = of_symmetry_ = false;
    site_ = {};
    placed_ = true;
    for (const std::string& written : tags) {
      const std::string tag = lower(written);
      std::size_t column = indexIn(kSiteTags, tag);
      of_sites_ = of_sites_ || (column >= kFractX && column <= kFractZ);
      if (indexIn(kSymmetryTags, tag) < std::size(kSymmetryTags)) {
        of_symmetry_ = true;
        column = 0;
      } else if (of_symmetry_) {
        column = 1;
      }
      columns_.push_back(column);
    }
  }

  std::optional<Problem> cell(std::size_t column) {
    if (of_sites_) return siteCell(site_, placed_, columns_[column]);
    return of_symmetry_ && columns_[column] == 0 ? takeSymmetry() : std::nullopt;
  }

  std::optional<Problem> row() {
    if (!of_sites_) return std::nullopt;
    if (block_.sites.size() >= kMaxSites) return words_.problemHere(tr("more than a million atoms"));
    site_.line = words_.line();
    if (site_.element == 0) site_.element = siteElement(site_.label);
    if (placed_)
      block_.sites.push_back(std::move(site_));
    else
      ++block_.without_place;
    site_ = {};
    placed_ = true;
    return std::nullopt;
  }

 private:
  void endBlock() {
    Block block = std::exchange(block_, {});
    if (block.sites.empty()) return;
    if (++models_ == options_.model) kept_ = std::move(block);
  }

  std::optional<Problem> takeSymmetry() {
    if (block_.symmetry.size() >= kMaxSymmetry) return words_.problemHere(tr("more than 1000 symmetry operations"));
    block_.symmetry.emplace_back(words_.text());
    return std::nullopt;
  }

  std::optional<Problem> siteCell(Site& site, bool& placed, std::size_t column) {
    const std::string_view value = words_.text();
    const auto number = [&](double& to) -> std::optional<Problem> {
      if (parseCifNumber(value, to)) return std::nullopt;
      return words_.problemHere(trf("{0} is not a number: {1}", kSiteTags[column], inQuotes(value)));
    };
    switch (column) {
      case kLabel:
        site.label = value;
        break;
      case kSymbol:
        site.element = siteElement(value);
        break;
      case kFractX:
      case kFractY:
      case kFractZ:
        if (words_.null())
          placed = false;
        else
          return number(site.fraction[int(column - kFractX)]);
        break;
      case kSiteOccupancy:
        if (!words_.null()) return number(site.occupancy);
        break;
      case kDisorderGroup:
        if (!words_.null()) site.disorder = value;
        break;
      case kAssembly:
        if (!words_.null()) site.assembly = value;
        break;
      case kUiso:
        if (!words_.null()) {
          if (auto problem = number(site.b_factor_A2)) return problem;
          site.b_factor_A2 *= 8.0 * std::numbers::pi * std::numbers::pi;
        }
        break;
      case kBiso:
        if (!words_.null()) return number(site.b_factor_A2);
        break;
      default:
        break;
    }
    return std::nullopt;
  }

  // Keeps, of the groups of each disorder assembly, the one of highest mean occupancy, the first on a tie.
  std::size_t dropAlternatives() {
    struct Group {
      double sum = 0.0, count = 0.0;
      std::size_t first = 0;
      double mean() const { return sum / count; }
    };
    std::map<std::string, std::map<std::string, Group>> groups;
    for (std::size_t i = 0; i < kept_.sites.size(); ++i) {
      const Site& s = kept_.sites[i];
      if (s.disorder.empty()) continue;
      Group& g = groups[s.assembly].emplace(s.disorder, Group{0.0, 0.0, i}).first->second;
      g.sum += s.occupancy;
      ++g.count;
    }
    std::map<std::string, std::string> best;
    for (const auto& [assembly, of_group] : groups) {
      const auto largest = std::max_element(of_group.begin(), of_group.end(), [](const auto& a, const auto& b) {
        const double x = a.second.mean(), y = b.second.mean();
        return x != y ? x < y : a.second.first > b.second.first;
      });
      best[assembly] = largest->first;
    }
    return std::erase_if(kept_.sites,
                         [&](const Site& s) { return !s.disorder.empty() && s.disorder != best[s.assembly]; });
  }

  Expected<Molecule> molecule() {
    if (std::find(kept_.has_cell.begin(), kept_.has_cell.end(), false) != kept_.has_cell.end())
      return Problem{file_, 0, 0, tr("the unit cell is not whole: three lengths and three angles are needed"),
                     tr(kSmallRemedy)};
    const auto& c = kept_.cell;
    // Three angles form a corner only if each is smaller than the sum of the others, and their sum is less than a full
    // turn.
    bool sound = c[3] + c[4] + c[5] < 359.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = c[3 + k], others = c[3 + (k + 1) % 3] + c[3 + (k + 2) % 3];
      sound = sound && c[k] > 0.01 && c[k] < 1e5 && angle > 1.0 && angle < 179.0 && angle < others - 0.1;
    }
    if (!sound) return Problem{file_, 0, 0, tr("no unit cell has these lengths and angles"), tr(kSmallRemedy)};
    const gemmi::UnitCell cell(c[0], c[1], c[2], c[3], c[4], c[5]);
    ParsedHeader head;
    head.id = kept_.name;
    head.title = kept_.title;
    head.models = models_;
    const std::size_t alternatives = dropAlternatives();
    if (alternatives)
      head.warnings.push_back(trnf("{0} atom of a less occupied disorder group left out.",
                                   "{0} atoms of less occupied disorder groups left out.", alternatives, alternatives));
    if (kept_.without_place)
      head.warnings.push_back(trnf("{0} atom without a place left out.", "{0} atoms without a place left out.",
                                   kept_.without_place, kept_.without_place));
    MoleculeBuilder builder(text_, options_);
    Vec3 middle{0.0};
    for (const Site& s : kept_.sites) {
      const gemmi::Position at = cell.orthogonalize({s.fraction.x, s.fraction.y, s.fraction.z});
      ParsedAtom atom;
      atom.name = s.label;
      atom.residue = kSmallResidue;
      atom.chain = kSmallChain;
      atom.element = s.label;
      atom.atomic_number = s.element;
      atom.position_A = {at.x, at.y, at.z};
      atom.occupancy = s.occupancy;
      atom.b_factor_A2 = s.b_factor_A2;
      atom.line = s.line;
      atom.number = 1;
      atom.hetero = true;
      if (auto problem = builder.add(atom)) return *problem;
      middle += s.fraction / double(kept_.sites.size());
    }
    if (options_.assembly == "cell") {
      if (auto problem = addCell(head, cell, middle)) return *problem;
    } else if (!options_.assembly.empty()) {
      return Problem{file_, 0, 0, trf("there is no biological assembly {0}", inQuotes(options_.assembly)),
                     tr("a crystal of small molecules has the assembly 'cell', its whole unit cell")};
    } else if (kept_.symmetry.size() > 1) {
      head.warnings.push_back(
          tr("These are the atoms of the asymmetric unit; the assembly 'cell' is the whole unit cell."));
    }
    return builder.finish(std::move(head));
  }

  // Each symmetry operation as a rotation and a translation in angstroms that keeps the middle of the atoms within the
  // cell.
  std::optional<Problem> addCell(ParsedHeader& head, const gemmi::UnitCell& cell, const Vec3& middle) const {
    ParsedAssembly::Part part;
    part.chains = {std::string(kSmallChain)};
    const auto matrix = [](const gemmi::Mat33& m) {
      glm::dmat3 out;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) out[j][i] = m[i][j];
      return out;
    };
    const glm::dmat3 to_A = matrix(cell.orth.mat), to_fraction = matrix(cell.frac.mat);
    std::vector<std::string> symmetry = kept_.symmetry;
    if (symmetry.empty()) symmetry.emplace_back("x,y,z");
    for (const std::string& triplet : symmetry) {
      gemmi::Op op;
      try {
        std::string solid = triplet;
        std::erase(solid, ' ');
        op = gemmi::parse_triplet(solid);
      } catch (const std::exception&) {
        return Problem{file_, 0, 0, trf("{0} is no symmetry operation", inQuotes(triplet)),
                       tr("write one like -x,y+1/2,-z")};
      }
      glm::dmat3 turn;
      Vec3 shift;
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) turn[j][i] = double(op.rot[std::size_t(i)][std::size_t(j)]) / gemmi::Op::DEN;
        shift[i] = double(op.tran[std::size_t(i)]) / gemmi::Op::DEN;
      }
      shift -= glm::floor(turn * middle + shift);
      part.operators.push_back({to_A * turn * to_fraction, to_A * shift});
    }
    head.assemblies.push_back({"cell", {std::move(part)}});
    return std::nullopt;
  }

  TextSource& text_;
  const std::string& file_;
  const ReadOptions& options_;
  CifWords words_;
  Block block_, kept_;
  int models_ = 0;
  std::vector<std::size_t> columns_;  // of this loop
  bool of_sites_ = false, of_symmetry_ = false;
  Site site_;  // of this row
  bool placed_ = true;
};

}  // namespace

bool isSmallMoleculeCif(std::string_view text) {
  while (!text.empty()) {
    const std::size_t newline = text.find('\n');
    const std::string line = lower(std::string(trimmed(text.substr(0, std::min<std::size_t>(newline, 40)))));
    if (line.starts_with("_atom_site.") || line.starts_with("_cell.")) return false;
    if (line.starts_with("_atom_site_fract_") || line.starts_with("_cell_length_")) return true;
    text.remove_prefix(newline == std::string_view::npos ? text.size() : newline + 1);
  }
  return false;
}

Expected<Molecule> readSmallCif(TextSource& text, const ReadOptions& options) {
  return SmallCifReader(text, options).run();
}

}  // namespace moltact
