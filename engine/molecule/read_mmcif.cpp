// Reads mmCIF files: the syntax through gemmi, the _atom_site table row by row, so that a value that is no
// number is told and not taken as 0, and that only the model asked for is built.
#include <charconv>
#include <gemmi/cif.hpp>
#include <gemmi/elem.hpp>
#include <new>
#include <optional>
#include <unordered_map>

#include "engine/molecule/parsed_structure.h"

namespace moltact {
namespace {

namespace cif = gemmi::cif;

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
  kGroup,
  kModel
};

const std::vector<std::string> kTags = {"Cartn_x",
                                        "Cartn_y",
                                        "Cartn_z",
                                        "?type_symbol",
                                        "?label_atom_id",
                                        "?auth_atom_id",
                                        "?label_comp_id",
                                        "?auth_comp_id",
                                        "?label_asym_id",
                                        "?auth_asym_id",
                                        "?label_seq_id",
                                        "?auth_seq_id",
                                        "?pdbx_PDB_ins_code",
                                        "?label_alt_id",
                                        "?occupancy",
                                        "?group_PDB",
                                        "?pdbx_PDB_model_num"};

constexpr const char* kRemedy = "correct the file, or take it again from its source";

std::string text(const cif::Table::Row& row, Column column) {
  return row.has2(column) ? cif::as_string(row[column]) : std::string();
}

std::string firstOf(const cif::Table::Row& row, Column one, Column other) {
  return row.has2(one) ? text(row, one) : text(row, other);
}

/// A CIF number, which may carry its uncertainty in brackets: "1.234(5)".
bool cifNumber(std::string_view word, double& value) {
  if (!word.empty() && word.back() == ')') word = word.substr(0, word.find('('));
  return parseNumber(word, value);
}

bool parseInteger(std::string_view word, int& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size();
}

Problem noTable(const std::string& file) {
  return {file, 0, 0, "there is no _atom_site table with Cartn_x, Cartn_y and Cartn_z in it",
          "take a coordinate file from the PDB (www.rcsb.org)"};
}

Problem rowProblem(const std::string& file, int row, const std::string& what) {
  return {file, 0, 0, "row " + std::to_string(row + 1) + " of the _atom_site table: " + what, kRemedy};
}

/// The row as an atom; false with `problem` filled where a number cannot be read.
bool atomFrom(const cif::Table::Row& row, int index, const std::string& file, ParsedAtom& atom,
              Problem& problem, std::vector<std::string>& warnings) {
  for (int k = 0; k < 3; ++k) {
    const std::string& word = row[static_cast<std::size_t>(kX + k)];
    if (!cifNumber(word, atom.position_A[k])) {
      problem =
          rowProblem(file, index, std::string("Cartn_") + "xyz"[k] + " is not a number: " + inQuotes(word));
      return false;
    }
  }
  atom.name = firstOf(row, kAuthName, kName);
  atom.residue = firstOf(row, kAuthComp, kComp);
  atom.chain = firstOf(row, kAuthChain, kChain);
  atom.label_chain = text(row, kChain);
  atom.element = text(row, kElement);
  atom.atomic_number = atom.element.size() > 2 ? 0 : gemmi::Element(atom.element).atomic_number();
  std::string number = firstOf(row, kAuthSeq, kSeq);
  const std::string insertion = text(row, kInsertion);
  if (!insertion.empty()) atom.insertion = insertion[0];
  // Old files write the insertion code behind the number: 15A.
  if (number.size() > 1 && number.back() >= 'A') {
    atom.insertion = number.back();
    number.pop_back();
  }
  if (!number.empty() && !parseInteger(number, atom.number)) {
    problem = rowProblem(file, index, "the residue number is not a number: " + inQuotes(number));
    return false;
  }
  const std::string alternate = text(row, kAlternate);
  if (!alternate.empty()) atom.alternate = alternate[0];
  if (row.has2(kOccupancy) && !cifNumber(row[kOccupancy], atom.occupancy)) {
    if (warnings.size() < 20)
      warnings.push_back("Row " + std::to_string(index + 1) + " of the _atom_site table: the occupancy " +
                         inQuotes(row[kOccupancy]) + " is not a number and was taken as 1.");
    atom.occupancy = 1.0;
  }
  atom.hetero = text(row, kGroup) == "HETATM";
  return true;
}

constexpr std::size_t kMostModels = 100'000;

/// The atoms of one model; a problem where a row is broken.
std::optional<Problem> readAtoms(cif::Block& block, const std::string& file, int wanted,
                                 ParsedStructure& out) {
  cif::Table table = block.find("_atom_site.", kTags);
  if (!table.ok() || table.length() == 0) return noTable(file);
  std::unordered_map<std::string, int> place_of;  // models by name, in the order of the file, from 1
  std::string last;
  int current = 0, index = -1;
  for (const auto row : table) {
    ++index;
    std::string model = row.has(kModel) ? text(row, kModel) : "1";
    if (current == 0 || last != model) {
      current = place_of.emplace(model, static_cast<int>(place_of.size()) + 1).first->second;
      if (place_of.size() > kMostModels) return rowProblem(file, index, "more than 100 000 models");
      last = std::move(model);
    }
    if (current != wanted) continue;
    ParsedAtom atom;
    Problem problem;
    if (!atomFrom(row, index, file, atom, problem, out.warnings)) return problem;
    out.atoms.push_back(std::move(atom));
  }
  out.models = static_cast<int>(place_of.size());
  return std::nullopt;
}

constexpr std::size_t kMaxOperators = 100'000;

/// The names in one bracket of an operator expression: "1,3-5,P".
std::vector<std::string> operatorNames(std::string_view list) {
  std::vector<std::string> out;
  while (!list.empty()) {
    const std::size_t comma = list.find(',');
    const std::string_view item = trimmed(list.substr(0, comma));
    list.remove_prefix(comma == std::string_view::npos ? list.size() : comma + 1);
    const std::size_t dash = item.find('-');
    int first = 0, last = 0;
    if (dash != std::string_view::npos && parseInteger(item.substr(0, dash), first) &&
        parseInteger(item.substr(dash + 1), last)) {
      for (long n = first; n <= last && out.size() < kMaxOperators; ++n) out.push_back(std::to_string(n));
    } else if (!item.empty()) {
      out.emplace_back(item);
    }
  }
  return out;
}

using Operators = std::vector<std::pair<std::string, ParsedOperator>>;

/// The operators of an expression such as "1", "1,2", "(1-60)" or "(1-60)(61-88)", where the last bracket
/// acts first.
std::vector<ParsedOperator> operatorsOf(std::string_view expression, const Operators& known) {
  std::vector<ParsedOperator> out;
  bool first = true;
  while (!expression.empty()) {
    std::string_view list = expression;
    if (expression.front() == '(') {
      const std::size_t close = expression.find(')');
      list = expression.substr(1, close == std::string_view::npos ? close : close - 1);
      expression.remove_prefix(close == std::string_view::npos ? expression.size() : close + 1);
    } else {
      list = expression.substr(0, expression.find('('));
      expression.remove_prefix(list.size());
    }
    std::vector<ParsedOperator> bracket;
    for (const std::string& name : operatorNames(list))
      for (const auto& [known_name, op] : known)
        if (known_name == name) {
          bracket.push_back(op);
          break;
        }
    if (first) {
      out = std::move(bracket);
    } else {
      std::vector<ParsedOperator> product;
      for (const ParsedOperator& p : out)
        for (const ParsedOperator& q : bracket) {
          if (product.size() >= kMaxOperators) break;
          product.push_back({p.turn * q.turn, p.turn * q.shift_A + p.shift_A});
        }
      out = std::move(product);
    }
    first = false;
  }
  return out;
}

void readAssemblies(cif::Block& block, ParsedStructure& out) {
  Operators known;
  std::vector<std::string> tags = {"id"};
  for (int i = 1; i <= 3; ++i)
    for (int j = 1; j <= 3; ++j)
      tags.push_back("matrix[" + std::to_string(i) + "][" + std::to_string(j) + "]");
  for (int i = 1; i <= 3; ++i) tags.push_back("vector[" + std::to_string(i) + "]");
  for (const auto row : block.find("_pdbx_struct_oper_list.", tags)) {
    ParsedOperator op;
    bool sound = true;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        sound &= cifNumber(row[static_cast<std::size_t>(1 + 3 * i + j)], op.turn[j][i]);
      sound &= cifNumber(row[static_cast<std::size_t>(10 + i)], op.shift_A[i]);
    }
    if (sound)
      known.emplace_back(cif::as_string(row[0]), op);
    else
      out.warnings.push_back("The assembly operator " + inQuotes(row[0]) +
                             " holds what is not a number and was left out.");
  }
  for (const auto row :
       block.find("_pdbx_struct_assembly_gen.", {"assembly_id", "oper_expression", "asym_id_list"})) {
    const std::string name = cif::as_string(row[0]);
    ParsedAssembly::Part part;
    std::string list = cif::as_string(row[2]);
    for (std::string_view rest = list; !rest.empty();) {
      const std::size_t comma = rest.find(',');
      part.label_chains.emplace_back(trimmed(rest.substr(0, comma)));
      rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
    }
    part.operators = operatorsOf(cif::as_string(row[1]), known);
    if (out.assemblies.empty() || out.assemblies.back().name != name) out.assemblies.push_back({name, {}});
    out.assemblies.back().parts.push_back(std::move(part));
  }
}

std::string oneLine(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return std::string(trimmed(text));
}

}  // namespace

Expected<Molecule> readMmcif(std::string_view content, const std::string& file, const ReadOptions& options) {
  // Asked first, because it refuses a large file of something else without parsing it.
  if (content.find("_atom_site.Cartn_x") == std::string_view::npos) return noTable(file);
  try {
    cif::Document document = cif::read_memory(content.data(), content.size(), "");
    ParsedStructure parsed;
    std::optional<Problem> problem;
    for (cif::Block& block : document.blocks) {
      if (block.find_mmcif_category("_atom_site.").positions.empty()) continue;
      if ((problem = readAtoms(block, file, options.model, parsed))) return *problem;
      if (options.model < 1 || options.model > parsed.models)
        return noSuchModel(file, options.model, parsed.models);
      readAssemblies(block, parsed);
      if (const std::string* id = block.find_value("_entry.id")) parsed.id = oneLine(cif::as_string(*id));
      if (const std::string* title = block.find_value("_struct.title"))
        parsed.title = oneLine(cif::as_string(*title));
      return buildMolecule(std::move(parsed), file, options);
    }
    return noTable(file);
  } catch (const gemmi::cif::pegtl::parse_error& e) {
    const auto& where = e.positions().front();
    return Problem{file, where.line, where.column, "it is not sound mmCIF: " + std::string(e.message()),
                   kRemedy};
  } catch (const std::bad_alloc&) {
    throw;  // no fault of the file
  } catch (const std::exception& e) {
    return Problem{file, 0, 0, std::string("it is not sound mmCIF: ") + e.what(), kRemedy};
  }
}

}  // namespace moltact
