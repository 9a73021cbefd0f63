// Small text functions shared by the readers.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/molecule/parsed_structure.h"

namespace moltact {

bool parseNumber(std::string_view text, double& value) {
  text = trimmed(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

std::vector<LineWord> wordsOfLine(std::string_view line) {
  constexpr std::size_t kMaxWords = 12;
  constexpr std::string_view kBlank = " \t\r";
  std::vector<LineWord> out;
  for (std::size_t at = line.find_first_not_of(kBlank); at != std::string_view::npos && out.size() < kMaxWords;
       at = line.find_first_not_of(kBlank, at)) {
    const std::size_t end = std::min(line.find_first_of(kBlank, at), line.size());
    out.push_back({line.substr(at, end - at), at + 1});
    at = end;
  }
  return out;
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t kMaxLength = 24;
  std::string out = "'";
  for (char c : text.substr(0, kMaxLength)) out += (c >= ' ' && c <= '~') ? c : '?';
  if (text.size() > kMaxLength) out += "...";
  return out + "'";
}

Problem noSuchModel(const std::string& file, int asked, int models) {
  return {file, 0, 0,
          trnf("there is no model {0}; the file has {1} model", "there is no model {0}; the file has {1} models",
               static_cast<unsigned long>(models), asked, models),
          models == 1 ? tr("ask for model 1") : trf("ask for a model from 1 to {0}", models)};
}

std::string allChargesZero() { return tr("All charges of the file are 0; it is read as a file without charges."); }

std::string partialChargeFault(std::string_view text, double& charge_e) {
  double read_e = 0.0;
  if (!parseNumber(text, read_e)) return trf("expected a number for {0}, found {1}", tr("the charge"), inQuotes(text));
  if (!(std::abs(read_e) <= kMaxPartialCharge_e))
    return trf("the charge {0} is not from {1} to {2}", inQuotes(text), -kMaxPartialCharge_e, kMaxPartialCharge_e);
  charge_e = read_e;
  return {};
}

Problem noAssembly(const std::string& file) {
  return {file, 0, 0, tr("a file of this format describes no biological assembly"),
          tr("read it without one, or take the PDB or mmCIF file")};
}

}  // namespace moltact
