#include "engine/language/catalogue.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "engine/language/mo_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNameContext = "the language's own name";

struct Catalogue {
  std::string code;
  MoFile texts;
};

// Catalogues are kept until the program ends, because callers hold pointers to their texts.
struct Store {
  std::mutex mutex;
  std::map<fs::path, std::unique_ptr<const Catalogue>> read;
};

Store& store() {
  static Store& it = *new Store;  // never destroyed, because texts are read until the very end
  return it;
}

std::atomic<const Catalogue*> g_in_use{nullptr};  // null: English

// The code becomes part of a file's name.
bool soundCode(std::string_view code) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return code.size() >= 2 && code.size() <= 8 && std::all_of(code.begin(), code.end(), letter);
}

Expected<const Catalogue*> catalogueOf(std::string_view code, const fs::path& folder) {
  const fs::path file = folder / (std::string(code) + ".mo");
  Store& s = store();
  const std::lock_guard lock(s.mutex);
  if (const auto at = s.read.find(file); at != s.read.end()) return at->second.get();
  std::error_code error;
  const auto size = fs::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in) return Problem{file.string(), 0, 0, trf("there are no texts in the language '{0}'", code), {}};
  if (size > kMaxCatalogueBytes)
    return Problem{file.string(), 0, 0, tr("it is larger than a catalogue of translations may be (4 MB)"), {}};
  auto texts = MoFile::parse(std::string(std::istreambuf_iterator<char>(in), {}));
  if (!texts) {
    Problem p = texts.problem();
    p.file = file.string();
    return p;
  }
  auto made = std::make_unique<const Catalogue>(Catalogue{std::string(code), *std::move(texts)});
  return s.read.emplace(file, std::move(made)).first->second.get();
}

std::string codeOfLocale(std::string_view locale) {
  const std::string_view code = locale.substr(0, locale.find_first_of("-_.@"));
  return code == "C" || code == "POSIX" ? "en" : std::string(code);
}

}  // namespace

const char* tr(const char* english) noexcept {
  const Catalogue* c = g_in_use.load(std::memory_order_acquire);
  if (!c || !english || !*english) return english;
  const char* text = c->texts.find({}, english);
  return text ? text : english;
}

std::string_view tr(std::string_view english) noexcept {
  const Catalogue* c = g_in_use.load(std::memory_order_acquire);
  if (!c || english.empty()) return english;
  const char* text = c->texts.find({}, english);
  return text ? std::string_view(text) : english;
}

const char* trc(const char* context, const char* english) noexcept {
  const Catalogue* c = g_in_use.load(std::memory_order_acquire);
  if (!c) return english;
  const char* text = c->texts.find(context, english);
  return text ? text : english;
}

const char* trn(const char* one, const char* many, unsigned long n) noexcept {
  const Catalogue* c = g_in_use.load(std::memory_order_acquire);
  if (c)
    if (const char* text = c->texts.findPlural(one, n)) return text;
  return n == 1 ? one : many;
}

std::string filled(const char* sentence, const char* english, std::span<const FormatArg> pieces) {
  fmt::dynamic_format_arg_store<fmt::format_context> arguments;
  for (const FormatArg& p : pieces) arguments.push_back(std::string_view(p.text()));
  for (const char* text : {sentence, english}) try {
      return fmt::vformat(text, arguments);
    } catch (const fmt::format_error&) {
    }
  return english;
}

std::vector<Language> languages(const fs::path& folder) {
  std::vector<Language> out;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string code = it->path().stem().string();
    if (it->path().extension() != ".mo" || !soundCode(code) || code == "en") continue;
    const auto catalogue = catalogueOf(code, folder);
    if (!catalogue) continue;
    // NC_("the language's own name", "English") marks every catalogue's entry for its name.
    const char* name = (*catalogue)->texts.find(kNameContext, "English");
    out.push_back({code, name ? name : code});
  }
  std::sort(out.begin(), out.end(), [](const Language& a, const Language& b) { return a.code < b.code; });
  out.insert(out.begin(), {"en", NC_("the language's own name", "English")});
  return out;
}

std::optional<Problem> setLanguage(std::string_view code, const fs::path& folder) {
  const Catalogue* next = nullptr;
  if (code != "en") {
    const auto refuse = [&](Problem p) {
      std::string known;
      for (const Language& l : languages(folder)) known += (known.empty() ? "" : ", ") + l.code;
      p.remedy = trf("there are texts in {0}", known);
      return p;
    };
    if (!soundCode(code)) return refuse({{}, 0, 0, trf("'{0}' is no language's code", code), {}});
    const auto catalogue = catalogueOf(code, folder);
    if (!catalogue) return refuse(catalogue.problem());
    next = *catalogue;
  }
  g_in_use.store(next, std::memory_order_release);
  return std::nullopt;
}

std::string language() {
  const Catalogue* c = g_in_use.load(std::memory_order_acquire);
  return c ? c->code : "en";
}

std::vector<std::string> systemLanguages(const std::string& otherwise) {
  std::string locale;
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
    if (const char* value = std::getenv(name); locale.empty() && value) locale = value;
  if (locale.empty()) locale = otherwise;
  std::vector<std::string> out;
  if (locale.empty()) return out;
  const std::string own = codeOfLocale(locale);
  const char* list = std::getenv("LANGUAGE");
  // A "C" locale means the original language.
  if (list && !(locale == "C" || locale == "POSIX" || locale.starts_with("C.")))
    for (std::string_view rest = list; !rest.empty();) {
      const std::size_t end = std::min(rest.find(':'), rest.size());
      if (end) out.push_back(codeOfLocale(rest.substr(0, end)));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  if (std::find(out.begin(), out.end(), own) == out.end()) out.push_back(own);
  return out;
}

std::string systemLanguage(const fs::path& folder, const std::string& otherwise) {
  std::error_code error;
  for (const std::string& code : systemLanguages(otherwise))
    if (code == "en" || (soundCode(code) && fs::exists(folder / (code + ".mo"), error))) return code;
  return "en";
}

}  // namespace moltact
