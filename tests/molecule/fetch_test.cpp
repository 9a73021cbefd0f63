// Fetching from a file:// address, which uses the same code as the archive except for the network.
#include <doctest/doctest.h>

#include "engine/molecule/fetch_entry.h"
#include "engine/molecule/pdb_id.h"
#include "tests/molecule/files.h"

using namespace moltact;
using namespace moltact::test;

namespace {

const std::string kCif =
    "data_X\nloop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\nC 0 "
    "0 0\nN 2 0 0\n";

std::string urlOf(const std::filesystem::path& file) { return "file://" + file.string(); }

std::size_t filesIn(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("5adh and pdb_00005ADH are 5ADH; pdb_1a2b3c4d stays; abcd, 5ad, 5ad-h and ../x are no ids") {
  CHECK(pdbId("5adh") == "5ADH");
  CHECK(pdbId("pdb_00005ADH") == "5ADH");
  CHECK(pdbId("PDB_1a2b3c4d") == "pdb_1a2b3c4d");
  for (const char* no : {"abcd", "5ad", "5ad-h", "../x", "", "5_dh", "pdb_0000abcd", "pdb_00005adh1"})
    CHECK(pdbId(no) == "");
  CHECK(entryUrl("5ADH") == "https://files.rcsb.org/download/5ADH.cif.gz");
}

TEST_CASE("a fetched entry is put into the folder under its id, and is not downloaded a second time") {
  const Scratch scratch;
  const auto source = scratch.write("source.cif.gz", gzipped(kCif));
  const auto folder = scratch.folder / "data" / "molecules";
  auto entry = fetchEntry("5adh", folder, urlOf(source));
  REQUIRE_MESSAGE(entry, entry.problem().text());
  CHECK(entry->file == folder / "5ADH.cif.gz");
  CHECK(entry->atoms == 2);
  CHECK_FALSE(entry->was_there);
  CHECK(filesIn(folder) == 1);
  std::filesystem::remove(source);
  entry = fetchEntry("5ADH", folder, urlOf(source));
  REQUIRE(entry);
  CHECK(entry->was_there);
}

TEST_CASE("an entry that is not there, cannot be read or cannot be reached leaves the folder as it was") {
  const Scratch scratch;
  const auto folder = scratch.folder / "molecules";
  CHECK(fetchEntry("5adh", folder, urlOf(scratch.folder / "none.gz")).problem().message ==
        "the Protein Data Bank has no such entry (tried " + urlOf(scratch.folder / "none.gz") + ")");
  const auto broken = scratch.write("broken.cif.gz", gzipped(kCif).substr(0, 40));
  CHECK(fetchEntry("5adh", folder, urlOf(broken)).problem().text() ==
        "5ADH: what came from " + urlOf(broken) + " cannot be read: the gzip file is cut short; try again later");
  // nothing listens on port 1 of this computer
  const Problem offline = fetchEntry("5adh", folder, "http://127.0.0.1:1/5ADH.cif.gz").problem();
  CHECK(offline.message.find("cannot reach http://127.0.0.1:1/5ADH.cif.gz: ") == 0);
  CHECK(offline.remedy == "are you online? Otherwise download the file on another computer and put it at " +
                              (folder / "5ADH.cif.gz").string());
  CHECK(filesIn(folder) == 0);
}

TEST_CASE("a wrong id is refused before anything is created") {
  const Scratch scratch;
  const auto folder = scratch.folder / "molecules";
  CHECK(fetchEntry("../../x", folder).problem().text() ==
        "../../x: it is not an id of the Protein Data Bank; an id is a digit and three letters or digits "
        "(5ADH), or pdb_ and eight");
  CHECK_FALSE(std::filesystem::exists(folder));
}
