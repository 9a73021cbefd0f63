#include "engine/molecule/molecule_key.h"

#include <doctest/doctest.h>

#include <set>
#include <unordered_set>

#include "engine/molecule/catalogue.h"
#include "tests/molecule/files.h"
#include "tests/molecule/other_reading.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE("a file read in 4 ways is 4 molecules; the same reading of it is one") {
  const std::filesystem::path file = "2hhb.pdb";
  const std::vector<MoleculeKey> keys{
      {file}, {file, {.model = 2}}, {file, {.waters = true}}, {file, {.assembly = "1"}}, {file, {.waters = true}}};
  CHECK(std::set<MoleculeKey>(keys.begin(), keys.end()).size() == 4);
  CHECK(std::unordered_set<MoleculeKey>(keys.begin(), keys.end()).size() == 4);
  CHECK(keys[2] == keys[4]);
  CHECK(MoleculeKey{"1ubq.pdb"} != MoleculeKey{"2hhb.pdb"});
}

TEST_CASE("a recording's labels give back how its molecule was read; missing and unsound ones give the default") {
  const NamedMolecule named("2hhb", {.model = 3, .waters = true, .assembly = "1"});
  CHECK(labelledMolecule(moleculeLabels(named)) == named);
  CHECK(labelledMolecule(moleculeLabels("1ubq")) == NamedMolecule("1ubq"));
  CHECK(labelledMolecule({{"molecule", "1ubq"}}) == NamedMolecule("1ubq"));
  for (const char* model : {"0", "-4", "first", "99999999999999999999"})
    CHECK(labelledMolecule({{"molecule", "1ubq"}, {"model", model}, {"waters", "perhaps"}}) == NamedMolecule("1ubq"));
  CHECK(readingText(named.reading) == "model 3, with waters, assembly 1");
  CHECK(readingText({}).empty());
}

TEST_CASE(
    "every option alone distinguishes molecules in text, hash and labels; an invalid value changes "
    "nothing") {
  std::set<std::string_view> names;
  for (const ReadingOption& option : readingOptions()) {
    CAPTURE(std::string(option.name));
    CHECK(names.insert(option.name).second);
    ReadOptions reading;
    CHECK(isDefault(reading, option));
    const bool may_be_any = std::holds_alternative<std::string ReadOptions::*>(option.member) && !option.words;
    REQUIRE(readText(reading, option, test::otherThanDefault(option)));
    CHECK_FALSE(isDefault(reading, option));
    for (const ReadingOption& o : readingOptions()) CHECK(isDefault(reading, o) == (&o != &option));
    CHECK(std::hash<MoleculeKey>()({"a", reading}) != std::hash<MoleculeKey>()({"a", {}}));
    CHECK_FALSE(readingText(reading).empty());
    CHECK(labelledMolecule(moleculeLabels({"a", reading})) == NamedMolecule("a", reading));
    const ReadOptions before = reading;
    for (const char* unsound : {"", "0", "-1", "perhaps", "100001", "3 "})
      if (!may_be_any) CHECK_FALSE(readText(reading, option, unsound));
    CHECK(reading == before);
  }
}

TEST_CASE("an option whose text is one of two words takes these and no third, and its default by its own word") {
  ReadingOption option = readingOptions().front();
  option.member = &ReadOptions::assembly;
  option.fallback = "none";
  option.words = [] { return std::vector<OfferedWord>{{"bondi", "Bondi", ""}, {"alvarez", "Alvarez", ""}}; };
  ReadOptions reading;
  CHECK(readText(reading, option, "alvarez"));
  CHECK(textOf(reading, option) == "alvarez");
  for (const char* unsound : {"Alvarez", "7", "", "alvarez "}) CHECK_FALSE(readText(reading, option, unsound));
  CHECK(textOf(reading, option) == "alvarez");
  CHECK(readText(reading, option, "none"));
  CHECK(reading == ReadOptions());
}

TEST_CASE("a molecule of the library lasts by its id, another by its whole path, each with how it was read") {
  const MoleculeFolders folders{libraryFolder(), {}};
  const ReadOptions waters{.waters = true};
  CHECK(lastingName({libraryFolder() / "1ubq.pdb", waters}, folders) == NamedMolecule("1ubq", waters));
  const std::filesystem::path mine = std::filesystem::current_path() / "1ubq.xyzr";
  CHECK(lastingName({"1ubq.xyzr", waters}, folders) == NamedMolecule(mine.string(), waters));
  const Expected<MoleculeKey> found = findMoleculeKey(NamedMolecule("1UBQ", waters), folders);
  REQUIRE(found);
  CHECK(*found == MoleculeKey{libraryFolder() / "1ubq.pdb", waters});
  // Ubiquitin has 602 atoms of its own and 58 of waters in its file.
  CHECK(readMolecule(*found)->atoms.size() == 602 + 58);
}

TEST_CASE(
    "every extension of a reader is recognised by name, found among fetched files, and named in the "
    "message for other files") {
  const Scratch scratch;
  CHECK(moleculeEndings().size() >= 5);
  for (const std::string_view ending : moleculeEndings())
    for (const char* packed : {"", ".gz"}) {
      const std::string id = "9abc", name = id + std::string(ending) + packed;
      CAPTURE(name);
      CHECK(hasMoleculeName(name));
      CHECK(hasMoleculeName("/some.where/X" + std::string(ending == ".pdb" ? ".PDB" : ending)));
      const std::filesystem::path file = scratch.write(name, "");
      const auto found = findMolecule(id, MoleculeFolders{libraryFolder(), scratch.folder});
      REQUIRE(found);
      CHECK(*found == file);
      std::filesystem::remove(file);
      CHECK(problemOf("Dear reader,\n", "letter.txt").find(ending) != std::string::npos);
    }
  for (const char* other : {"letter.txt", "pdb", ".gz", "x.pdbx", "lesson.md"}) CHECK_FALSE(hasMoleculeName(other));
}
