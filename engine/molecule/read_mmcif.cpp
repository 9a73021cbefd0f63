// Reads mmCIF files as a stream: row by row of _atom_site, so that messages name the row and the item of an invalid
// number, and only the molecule needs memory. Of the rest it keeps what names the entry and describes its assemblies.
// gemmi takes 0.79 s and 1 097 MB for a million atoms, this reader 0.28 s and 55 MB (build/release/reading_benchmark).
// Files written by gemmi give the same atoms (tests/molecule/gemmi_agrees_test.cpp). Words, loops and pairs are those of
// every CIF (cif_words.h, cif_document.h).
#include <algorithm>
#include <array>
#include <gemmi/elem.hpp>
#include <optional>
#include <span>
#include <unordered_map>

#include "engine/core/printable.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/cif_document.h"
#include "engine/molecule/mmcif_operators.h"
#include "engine/molecule/parsed_structure.h"

namespace moltact {
namespace {

enum Column {
  kX,
  kY,
  kZ,
  kElement,
  kName,
  kAuthName,
  kComp,
  kAuthComp,
  kChain,
  kAuthChain,
  kSeq,
  kAuthSeq,
  kInsertion,
  kAlternate,
  kOccupancy,
  kBFactor,
  kGroup,
  kModel,
  kFormalCharge
};

constexpr std::string_view kAtomTags[] = {
    "_atom_site.Cartn_x",           "_atom_site.Cartn_y",       "_atom_site.Cartn_z",
    "_atom_site.type_symbol",       "_atom_site.label_atom_id", "_atom_site.auth_atom_id",
    "_atom_site.label_comp_id",     "_atom_site.auth_comp_id",  "_atom_site.label_asym_id",
    "_atom_site.auth_asym_id",      "_atom_site.label_seq_id",  "_atom_site.auth_seq_id",
    "_atom_site.pdbx_PDB_ins_code", "_atom_site.label_alt_id",  "_atom_site.occupancy",
    "_atom_site.B_iso_or_equiv",    "_atom_site.group_PDB",     "_atom_site.pdbx_PDB_model_num",
    "_atom_site.pdbx_formal_charge"};
constexpr std::string_view kGeneratorTags[] = {"_pdbx_struct_assembly_gen.assembly_id",
                                               "_pdbx_struct_assembly_gen.oper_expression",
                                               "_pdbx_struct_assembly_gen.asym_id_list"};
constexpr std::string_view kOperatorTags[] = {
    "_pdbx_struct_oper_list.id",           "_pdbx_struct_oper_list.matrix[1][1]", "_pdbx_struct_oper_list.matrix[1][2]",
    "_pdbx_struct_oper_list.matrix[1][3]", "_pdbx_struct_oper_list.matrix[2][1]", "_pdbx_struct_oper_list.matrix[2][2]",
    "_pdbx_struct_oper_list.matrix[2][3]", "_pdbx_struct_oper_list.matrix[3][1]", "_pdbx_struct_oper_list.matrix[3][2]",
    "_pdbx_struct_oper_list.matrix[3][3]", "_pdbx_struct_oper_list.vector[1]",    "_pdbx_struct_oper_list.vector[2]",
    "_pdbx_struct_oper_list.vector[3]"};
constexpr std::string_view kEntryTags[] = {"_entry.id"};
constexpr std::string_view kTitleTags[] = {"_struct.title"};
// The first and last residue of a helix or a strand: columns of both tables, in one order.
enum EndColumn {
  kFirstChain,
  kFirstAuthChain,
  kFirstSeq,
  kFirstAuthSeq,
  kFirstInsertion,
  kLastSeq,
  kLastAuthSeq,
  kLastInsertion,
  kType,
  kHelixClass
};
constexpr std::string_view kConformationTags[] = {
    "_struct_conf.beg_label_asym_id",   "_struct_conf.beg_auth_asym_id",      "_struct_conf.beg_label_seq_id",
    "_struct_conf.beg_auth_seq_id",     "_struct_conf.pdbx_beg_PDB_ins_code", "_struct_conf.end_label_seq_id",
    "_struct_conf.end_auth_seq_id",     "_struct_conf.pdbx_end_PDB_ins_code", "_struct_conf.conf_type_id",
    "_struct_conf.pdbx_PDB_helix_class"};
constexpr std::string_view kStrandTags[] = {
    "_struct_sheet_range.beg_label_asym_id",     "_struct_sheet_range.beg_auth_asym_id",
    "_struct_sheet_range.beg_label_seq_id",      "_struct_sheet_range.beg_auth_seq_id",
    "_struct_sheet_range.pdbx_beg_PDB_ins_code", "_struct_sheet_range.end_label_seq_id",
    "_struct_sheet_range.end_auth_seq_id",       "_struct_sheet_range.pdbx_end_PDB_ins_code"};

enum class Table { Atoms, Generators, Operators, Entry, Title, Conformations, Strands };
struct TableTags {
  std::string_view category;
  std::span<const std::string_view> tags;
};
constexpr TableTags kTables[] = {{"_atom_site.", kAtomTags},
                                 {"_pdbx_struct_assembly_gen.", kGeneratorTags},
                                 {"_pdbx_struct_oper_list.", kOperatorTags},
                                 {"_entry.", kEntryTags},
                                 {"_struct.", kTitleTags},
                                 {"_struct_conf.", kConformationTags},
                                 {"_struct_sheet_range.", kStrandTags}};

constexpr const char* kTableRemedy = N_("correct the file, or take it again from its source");
constexpr std::size_t kMaxModels = 100'000;
constexpr std::size_t kMaxKept = std::size_t{32} << 20;  // bytes of text that describes assemblies

/// One value of a row, without quotes.
struct Cell {
  std::string text;
  bool there = false, null = false;
  bool says() const { return there && !null; }
  std::string_view said() const { return says() ? std::string_view(text) : std::string_view(); }
};
using Row = std::array<Cell, std::size(kAtomTags)>;

Problem noTable(const std::string& file) {
  return {file, 0, 0, tr("there is no _atom_site table with Cartn_x, Cartn_y and Cartn_z in it"),
          tr("take a coordinate file from the PDB (www.rcsb.org)")};
}

/// An entry's name or title, which may extend over several lines.
std::string written(std::string_view given) { return std::string(trimmed(oneLine(given))); }

class Reader {
 public:
  Reader(TextSource& text, const ReadOptions& options)
      : text_(text), file_(text.file()), options_(options), words_(text), builder_(text, options) {}

  Expected<Molecule> run() {
    if (auto problem = readCifDocument(text_, words_, *this)) return *problem;
    if (!done_) return noTable(file_);
    if (options_.model < 1 || options_.model > head_.models) return noSuchModel(file_, options_.model, head_.models);
    return builder_.finish(std::move(head_));
  }

  // The parts of the file, from readCifDocument().
  std::optional<Problem> block(std::string_view) { return end(); }

  // A cell of a table with one row, which ends with the block.
  std::optional<Problem> pair(const std::string& tag) {
    const auto table = done_ ? std::nullopt : tableOf(tag);
    if (const auto column = table ? columnOf(*table, tag) : std::nullopt) {
      Cell& cell = single_[static_cast<std::size_t>(*table)][*column];
      if (!cell.there) take(cell);
    }
    return std::nullopt;
  }

  void loop(const std::vector<std::string>& tags) {
    table_ = done_ ? std::nullopt : tableOf(tags.front());
    columns_.clear();
    for (const std::string& tag : tags) columns_.push_back(table_ ? columnOf(*table_, tag) : std::nullopt);
    row_ = {};
  }
  std::optional<Problem> cell(std::size_t column) {
    if (columns_[column]) take(row_[*columns_[column]]);
    return std::nullopt;
  }
  std::optional<Problem> row() { return table_ ? readRow(*table_, row_) : std::nullopt; }

  // The first block with atoms is the molecule; blocks without atoms are ignored.
  std::optional<Problem> end() {
    if (done_) return std::nullopt;
    for (std::size_t t = 0; t < std::size(kTables); ++t) {
      const Row row = std::exchange(single_[t], {});
      if (std::any_of(row.begin(), row.end(), [](const Cell& c) { return c.there; }))
        if (auto problem = readRow(static_cast<Table>(t), row)) return problem;
    }
    if (place_of_.empty()) {
      head_ = {};
      operators_.clear();
      generators_.clear();
      return std::nullopt;
    }
    done_ = true;
    return assemblies();
  }

 private:
  static std::optional<Table> tableOf(std::string_view tag) {
    for (std::size_t t = 0; t < std::size(kTables); ++t)
      if (tag.starts_with(kTables[t].category)) return static_cast<Table>(t);
    return std::nullopt;
  }
  static std::optional<std::size_t> columnOf(Table table, std::string_view tag) {
    const auto tags = kTables[static_cast<std::size_t>(table)].tags;
    const auto found = std::find(tags.begin(), tags.end(), tag);
    if (found == tags.end()) return std::nullopt;
    return static_cast<std::size_t>(found - tags.begin());
  }
  void take(Cell& cell) {
    cell.text = words_.text();
    cell.there = true;
    cell.null = words_.null();
  }

  std::optional<Problem> readRow(Table table, const Row& row) {
    switch (table) {
      case Table::Atoms:
        return atom(row);
      case Table::Generators:
        return options_.assembly.empty() ? std::nullopt : generator(row);
      case Table::Operators:
        return options_.assembly.empty() ? std::nullopt : oper(row);
      case Table::Entry:
        if (head_.id.empty()) head_.id = written(row[0].said());
        return std::nullopt;
      case Table::Title:
        if (head_.title.empty()) head_.title = written(row[0].said());
        return std::nullopt;
      case Table::Conformations:
        return conformation(row);
      case Table::Strands:
        return element(row, {SecondaryStructure::Strand});
    }
    return std::nullopt;
  }

  Problem rowProblem(const std::string& what) const {
    return {file_, 0, 0, trf("row {0} of the _atom_site table: {1}", rows_, what), tr(kTableRemedy)};
  }

  static std::string_view firstOf(const Cell& one, const Cell& other) { return one.says() ? one.said() : other.said(); }

  std::optional<Problem> atom(const Row& row) {
    if (!row[kX].there || !row[kY].there || !row[kZ].there) return std::nullopt;  // an incomplete table
    ++rows_;
    const std::string_view model = row[kModel].there ? row[kModel].said() : "1";
    if (current_ == 0 || last_model_ != model) {
      current_ = place_of_.emplace(model, static_cast<int>(place_of_.size()) + 1).first->second;
      if (place_of_.size() > kMaxModels) return rowProblem(tr("more than 100 000 models"));
      last_model_ = model;
      head_.models = static_cast<int>(place_of_.size());
    }
    if (current_ != options_.model) return std::nullopt;
    ParsedAtom out;
    for (int k = 0; k < 3; ++k)
      if (const Cell& cell = row[static_cast<std::size_t>(kX + k)];
          cell.null || !parseCifNumber(cell.text, out.position_A[k]))
        return rowProblem(trf("{0} is not a number: {1}", std::string("Cartn_") + "xyz"[k], inQuotes(cell.text)));
    out.name = firstOf(row[kAuthName], row[kName]);
    out.residue = firstOf(row[kAuthComp], row[kComp]);
    out.chain = firstOf(row[kAuthChain], row[kChain]);
    out.label_chain = row[kChain].said();
    out.element = row[kElement].said();
    out.atomic_number = out.element.size() > 2 ? 0 : gemmi::Element(std::string(out.element)).atomic_number();
    std::string_view number = firstOf(row[kAuthSeq], row[kSeq]);
    if (const std::string_view insertion = row[kInsertion].said(); !insertion.empty()) out.insertion = insertion[0];
    // Old files append the insertion code to the number: 15A.
    if (number.size() > 1 && number.back() >= 'A') {
      out.insertion = number.back();
      number.remove_suffix(1);
    }
    if (!number.empty() && !parseInteger(number, out.number))
      return rowProblem(trf("the residue number is not a number: {0}", inQuotes(number)));
    if (const std::string_view alternate = row[kAlternate].said(); !alternate.empty()) out.alternate = alternate[0];
    if (row[kOccupancy].says() && !parseCifNumber(row[kOccupancy].text, out.occupancy)) {
      if (head_.warnings.size() < 20)
        head_.warnings.push_back(
            trf("Row {0} of the _atom_site table: the occupancy {1} is not a number and was taken as 1.", rows_,
                inQuotes(row[kOccupancy].text)));
      out.occupancy = 1.0;
    }
    if (row[kBFactor].says() && !parseCifNumber(row[kBFactor].text, out.b_factor_A2)) {
      if (head_.warnings.size() < 20)
        head_.warnings.push_back(
            trf("Row {0} of the _atom_site table: the B factor {1} is not a number and was taken as 0.", rows_,
                inQuotes(row[kBFactor].text)));
      out.b_factor_A2 = 0.0;
    }
    if (std::string_view charge = row[kFormalCharge].said(); !charge.empty()) {
      if (charge.front() == '+') charge.remove_prefix(1);
      if (!parseInteger(charge, out.formal_e) || !isFormalCharge(out.formal_e)) {
        out.formal_e = 0;
        if (head_.warnings.size() < 20)
          head_.warnings.push_back(
              trf("Row {0} of the _atom_site table: the formal charge {1} is no whole number from -15 to 15 and was "
                  "taken as 0.",
                  rows_, inQuotes(row[kFormalCharge].text)));
      }
    }
    out.hetero = row[kGroup].said() == "HETATM";
    return builder_.add(out);
  }

  // A row of the table of helices, turns and, in files by DSSP, strands.
  std::optional<Problem> conformation(const Row& row) {
    const std::string_view type = row[kType].said();
    if (type == "STRN") return element(row, {SecondaryStructure::Strand});
    if (!type.starts_with("HELX")) return std::nullopt;
    const std::string_view number = row[kHelixClass].said();
    HelixKind kind = HelixKind::Alpha;
    if (type == "HELX_RH_3T_P" || (type == "HELX_P" && number == "5"))
      kind = HelixKind::ThreeTen;
    else if (type == "HELX_RH_PI_P" || (type == "HELX_P" && number == "3"))
      kind = HelixKind::Pi;
    else if (type != "HELX_RH_AL_P" && !(type == "HELX_P" && (number.empty() || number == "0" || number == "1")))
      kind = HelixKind::Other;
    return element(row, {SecondaryStructure::Helix, kind});
  }

  std::optional<Problem> element(const Row& row, RecordedStructure structure) {
    if (!row[kFirstChain].there && !row[kFirstAuthChain].there) return std::nullopt;  // an incomplete table
    ParsedSecondaryStructure out{structure, std::string(firstOf(row[kFirstAuthChain], row[kFirstChain])), {}, {}};
    const auto end = [&](ParsedSecondaryStructure::End& at, EndColumn author, EndColumn label, EndColumn insertion) {
      if (const std::string_view code = row[insertion].said(); !code.empty()) at.insertion = code[0];
      return parseInteger(firstOf(row[author], row[label]), at.number);
    };
    if (!end(out.first, kFirstAuthSeq, kFirstSeq, kFirstInsertion) ||
        !end(out.last, kLastAuthSeq, kLastSeq, kLastInsertion)) {
      if (head_.warnings.size() < 40)
        head_.warnings.push_back(
            trf("A helix or strand of chain {0} names no residues and was left out.", inQuotes(out.chain)));
      return std::nullopt;
    }
    kept_ += sizeof out + out.chain.size();
    if (kept_ > kMaxKept) return Problem{file_, 0, 0, tr("more than 32 MiB of helices and strands"), tr(kTableRemedy)};
    head_.elements.push_back(std::move(out));
    return std::nullopt;
  }

  std::optional<Problem> oper(const Row& row) {
    ParsedOperator op;
    bool sound = true;
    for (std::size_t k = 0; k < std::size(kOperatorTags); ++k)
      if (!row[k].there) return std::nullopt;  // an incomplete table
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        sound &= parseCifNumber(row[static_cast<std::size_t>(1 + 3 * i + j)].text, op.rotation[j][i]);
      sound &= parseCifNumber(row[static_cast<std::size_t>(10 + i)].text, op.shift_A[i]);
    }
    if (sound) {
      operators_.emplace(row[0].said(), op);
      kept_ += row[0].text.size();
    } else if (head_.warnings.size() < 40) {
      head_.warnings.push_back(
          trf("The assembly operator {0} holds what is not a number and was left out.", inQuotes(row[0].text)));
    }
    if (operators_.size() > kMaxOperators || kept_ > kMaxKept)
      return Problem{file_, 0, 0, tr("more than 100 000 operators of assemblies"), tr("read it without an assembly")};
    return std::nullopt;
  }

  std::optional<Problem> generator(const Row& row) {
    for (std::size_t k = 0; k < std::size(kGeneratorTags); ++k)
      if (!row[k].there) return std::nullopt;
    Generator& g = generators_.emplace_back();
    for (std::size_t k = 0; k < g.size(); ++k) g[k] = row[k].said(), kept_ += g[k].size() + sizeof(std::string);
    if (kept_ > kMaxKept)
      return Problem{file_, 0, 0, tr("more than 32 MiB of descriptions of assemblies"),
                     tr("read it without an assembly")};
    return std::nullopt;
  }

  // The operators may follow the table that refers to them.
  std::optional<Problem> assemblies() {
    std::size_t copies = 0;
    for (const Generator& g : generators_) {
      ParsedAssembly::Part part;
      // Of other assemblies only the names are kept, for messages.
      if (g[0] == options_.assembly) {
        for (std::string_view rest = g[2]; !rest.empty();) {
          const std::size_t comma = rest.find(',');
          part.label_chains.emplace_back(trimmed(rest.substr(0, comma)));
          rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
        }
        part.operators = operatorsOf(g[1], operators_);
        copies += part.operators.size();
        if (copies > kMaxCopies)
          return Problem{file_, 0, 0, trf("the assembly {0} has more than a million copies", inQuotes(g[0])),
                         tr("read it without one")};
      }
      if (head_.assemblies.empty() || head_.assemblies.back().name != g[0]) head_.assemblies.push_back({g[0], {}});
      head_.assemblies.back().parts.push_back(std::move(part));
    }
    return std::nullopt;
  }

  using Generator = std::array<std::string, std::size(kGeneratorTags)>;
  TextSource& text_;
  const std::string& file_;
  const ReadOptions& options_;
  CifWords words_;
  MoleculeBuilder builder_;
  ParsedHeader head_;
  std::array<Row, std::size(kTables)> single_;  // pairs of this block
  MmcifOperators operators_;
  std::vector<Generator> generators_;
  std::size_t kept_ = 0, rows_ = 0;
  std::unordered_map<std::string, int> place_of_;  // models by name; numbers in file order, from 1
  std::string last_model_;
  int current_ = 0;
  std::optional<Table> table_;                       // of this loop
  std::vector<std::optional<std::size_t>> columns_;  // of this loop, in the table
  Row row_;
  bool done_ = false;  // the block with the atoms has been read
};

}  // namespace

Expected<Molecule> readMmcif(TextSource& text, const ReadOptions& options) {
  if (isSmallMoleculeCif(text.ahead())) return readSmallCif(text, options);
  return Reader(text, options).run();
}

}  // namespace moltact
