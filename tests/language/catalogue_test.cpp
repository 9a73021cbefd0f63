#include "engine/language/catalogue.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include "engine/language/mo_file.h"

using namespace moltact;
namespace fs = std::filesystem;

namespace {

const fs::path kFolder = fs::path(MOLTACT_TEST_CATALOGUES) / "little", kBig = fs::path(MOLTACT_TEST_CATALOGUES) / "big";

struct English {
  English() { setLanguage("en", {}); }
  ~English() { setLanguage("en", {}); }
};

std::string bytesOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The environment as it was, afterwards.
struct Variables {
  static constexpr const char* kNames[] = {"LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG"};
  std::vector<std::optional<std::string>> before;
  Variables() {
    for (const char* name : kNames) {
      const char* value = std::getenv(name);
      before.push_back(value ? std::optional<std::string>(value) : std::nullopt);
      ::unsetenv(name);
    }
  }
  ~Variables() {
    for (std::size_t k = 0; k < before.size(); ++k)
      if (before[k])
        ::setenv(kNames[k], before[k]->c_str(), 1);
      else
        ::unsetenv(kNames[k]);
  }
};

}  // namespace

TEST_CASE("in English every sentence is itself") {
  const English english;
  CHECK(std::string(tr("Open")) == "Open");
  CHECK(trf("{0} of {1}", 2, "five") == "2 of five");
  CHECK(trnf("{0} atom in {1}", "{0} atoms in {1}", 1, 1, "x") == "1 atom in x");
  CHECK(trnf("{0} atom in {1}", "{0} atoms in {1}", 0, 0, "x") == "0 atoms in x");
  CHECK(language() == "en");
}

TEST_CASE("a catalogue of either byte order gives its texts, contexts and three plurals") {
  const English english;
  for (const fs::path& folder : {kFolder, kBig}) {
    REQUIRE_FALSE(setLanguage("qq", folder));
    CHECK(language() == "qq");
    CHECK(std::string(tr("Open")) == "Öffnen");
    CHECK(std::string(tr(std::string_view("Open it").substr(0, 4))) == "Öffnen");
    CHECK(std::string(trc("a door", "Open")) == "Offen");
    CHECK(std::string(trc("a window", "Open")) == "Open");
    CHECK(trf("{0} of {1}", 2, "five") == "von five sind es 2");
    CHECK(trnf("{0} atom in {1}", "{0} atoms in {1}", 1, 1, "x") == "1 atom w x");
    CHECK(trnf("{0} atom in {1}", "{0} atoms in {1}", 3, 3, "x") == "3 atomy w x");
    CHECK(trnf("{0} atom in {1}", "{0} atoms in {1}", 12, 12, "x") == "12 atomów w x");
    CHECK(std::string(tr("nobody translated this")) == "nobody translated this");
    CHECK(std::string(tr("left empty")) == "left empty");
    CHECK(std::string(tr("")).empty());
    setLanguage("en", folder);
    CHECK(std::string(tr("Open")) == "Open");
  }
}

TEST_CASE("a translation whose placeholders are wrong is said in English, and wrong English as it stands") {
  const English english;
  REQUIRE_FALSE(setLanguage("qq", kFolder));
  CHECK(trf("a faulty one: {0}", 3) == "a faulty one: 3");
  CHECK(trf("one that asks for more: {0}", 3) == "one that asks for more: 3");
  CHECK(trf("wrong itself: {", 3) == "wrong itself: {");
  CHECK(trf("a piece is not read: {0}", "{1} {x") == "a piece is not read: {1} {x");
}

TEST_CASE("the languages are English and the folder's, named as their catalogues say; a broken one is left out") {
  const fs::path folder = fs::temp_directory_path() / "moltact-test-languages";
  fs::create_directories(folder);
  fs::copy_file(kFolder / "qq.mo", folder / "qq.mo", fs::copy_options::overwrite_existing);
  std::ofstream(folder / "zz.mo") << "no catalogue";
  std::ofstream(folder / "readme.txt") << "no catalogue";
  const std::vector<Language> found = languages(folder);
  REQUIRE(found.size() == 2);
  CHECK(found[0].code == "en");
  CHECK(found[0].name == "English");
  CHECK(found[1].code == "qq");
  CHECK(found[1].name == "Qué");
  CHECK(languages(folder / "nowhere").size() == 1);

  const English english;
  const auto missing = setLanguage("fr", folder), broken = setLanguage("zz", folder),
             odd = setLanguage("../qq", folder);
  REQUIRE((missing && broken && odd));
  CHECK(missing->text() ==
        (folder / "fr.mo").string() + ": there are no texts in the language 'fr'; there are texts in en, qq");
  CHECK(broken->text().find("it is no catalogue of translations") != std::string::npos);
  CHECK(odd->text() == "'../qq' is no language's code; there are texts in en, qq");
  CHECK(language() == "en");
  fs::remove_all(folder);
}

TEST_CASE("the system's languages are read as gettext reads them") {
  const Variables as_before;
  CHECK(systemLanguages().empty());
  CHECK(systemLanguage(kFolder) == "en");
  CHECK(systemLanguages("de-DE") == std::vector<std::string>{"de"});  // of a system whose settings say it
  CHECK(systemLanguage(kFolder, "qq-QQ") == "qq");
  ::setenv("LANG", "qq_QQ.UTF-8", 1);
  CHECK(systemLanguages("de-DE") == std::vector<std::string>{"qq"});
  CHECK(systemLanguages() == std::vector<std::string>{"qq"});
  CHECK(systemLanguage(kFolder) == "qq");
  ::setenv("LANGUAGE", "fr:qq_XX:en", 1);
  CHECK(systemLanguages() == std::vector<std::string>{"fr", "qq", "en"});
  CHECK(systemLanguage(kFolder) == "qq");
  ::setenv("LC_MESSAGES", "de_AT.UTF-8@euro", 1);
  CHECK(systemLanguages() == std::vector<std::string>{"fr", "qq", "en", "de"});
  ::setenv("LC_ALL", "C.UTF-8", 1);
  CHECK(systemLanguages() == std::vector<std::string>{"en"});
}

TEST_CASE("what was returned stays when the language changes, with eight readers meanwhile") {
  const English english;
  REQUIRE_FALSE(setLanguage("qq", kFolder));
  const char* kept = tr("Open");
  std::atomic<bool> stop{false};
  std::vector<std::thread> readers;
  std::atomic<int> wrong{0};
  for (int k = 0; k < 8; ++k)
    readers.emplace_back([&] {
      while (!stop) {
        const std::string text = tr("Open");
        if (text != "Open" && text != "Öffnen") ++wrong;
      }
    });
  for (int k = 0; k < 200; ++k) setLanguage(k % 2 ? "en" : "qq", k % 4 < 2 ? kFolder : kBig);
  stop = true;
  for (std::thread& t : readers) t.join();
  CHECK(wrong == 0);
  CHECK(std::string(kept) == "Öffnen");
}

TEST_CASE("a catalogue cut off anywhere, or with any byte changed, is read or refused; seed 5") {
  const std::string whole = bytesOf(kFolder / "qq.mo");
  REQUIRE(whole.size() > 500);
  REQUIRE(MoFile::parse(whole));
  for (std::size_t size = 0; size < whole.size(); ++size) CHECK_FALSE(MoFile::parse(whole.substr(0, size)));
  std::mt19937 random(5);
  int refused = 0;
  for (int k = 0; k < 20000; ++k) {
    std::string changed = whole;
    changed[random() % changed.size()] = char(random());
    const auto texts = MoFile::parse(changed);
    refused += !texts;
    if (texts) texts->findPlural("{0} atom in {1}", random());
  }
  CHECK(refused > 1000);
}

TEST_CASE("a translation whose first form is empty counts as none, the other forms stand") {
  std::string bytes = bytesOf(kFolder / "qq.mo");
  const std::string forms("{0} atom w {1}\0{0} atomy w {1}", 30);
  const std::size_t at = bytes.find(forms);
  REQUIRE(at != std::string::npos);
  bytes[at] = '\0';  // "{0} atom w {1}" is "" now, and the second form what was left of the first
  const auto texts = MoFile::parse(bytes);
  REQUIRE(texts);
  CHECK(texts->find({}, "{0} atom in {1}") == nullptr);
  CHECK(texts->findPlural("{0} atom in {1}", 1) == nullptr);
  CHECK(std::string(texts->findPlural("{0} atom in {1}", 3)) == "0} atom w {1}");
}
