// The kinds of file that the window opens, and that the file browser lists.
#include "app/ui/files/file_kinds.h"

#include <doctest/doctest.h>

#include "app/ui/files/file_browser.h"
#include "engine/molecule/reader.h"
#include "tests/app/scripted_user_fixture.h"

using namespace moltact;

TEST_CASE("a file's kind follows from its ending, in capitals or small letters; other files have none") {
  CHECK(fileKind("a/first-touch.md") == FileKind::Lesson);
  CHECK(fileKind("FIRST.MD") == FileKind::Lesson);
  CHECK(fileKind("Haem.moltact") == FileKind::Pack);
  CHECK(fileKind("anna.jsonl") == FileKind::Attempt);
  CHECK(fileKind("1ubq.recording") == FileKind::Recording);
  CHECK(fileKind("1UBQ.PDB.gz") == FileKind::Molecule);
  for (const char* other : {"letter.txt", "1ubq", "md", "picture.png", "x.recording.txt"}) CHECK_FALSE(fileKind(other));
}

TEST_CASE("the file browser lists whatever a reader of molecules, a lesson, an attempt or a recording is named like") {
  const Scratch scratch;
  std::size_t files = 0;
  for (const std::string_view ending : moleculeEndings()) {
    scratch.file("m" + std::string(ending), "");
    scratch.file("m" + std::string(ending) + ".gz", "");
    files += 2;
  }
  for (const char* name : {"l.md", "p.moltact", "a.jsonl", "h.recording"}) scratch.file(name, ""), ++files;
  for (const char* name : {"letter.txt", "picture.png", "m.pdb.bak"}) scratch.file(name, "");
  std::filesystem::create_directory(scratch.folder / "folder");
  FileBrowser browser;
  browser.look(scratch.folder);
  CHECK(browser.entries().size() == files + 1);
  CHECK(browser.entries().front().folder);
}
