// Rejected packs: each gives a message, and nothing is written. Oracle: zips assembled byte by byte.
#include "engine/pack/pack_file.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "engine/pack/pack_name.h"
#include "engine/pack/unpack.h"
#include "engine/platform/read_file.h"
#include "tests/pack/zip_maker.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;
using test::packWith;
using test::ZipEntry;
using test::zipOf;

Expected<PackFile> opened(const std::string& bytes) { return PackFile::ofBytes("p.moltact", bytes); }

// The message for a pack that must be refused, whether on opening it or on unpacking; nothing of it is on the disk.
std::string refusal(const std::string& bytes) {
  const ScratchFolder scratch;
  const fs::path packs = scratch.path / "packs";
  Expected<PackFile> pack = opened(bytes);
  Problem problem;
  if (pack) {
    const Expected<fs::path> lesson = unpack(*pack, packs);
    REQUIRE_FALSE(bool(lesson));
    problem = lesson.problem();
  } else {
    problem = pack.problem();
  }
  CHECK(problem.file == "p.moltact");
  CHECK_FALSE(problem.remedy.empty());
  const bool empty = !fs::exists(packs) || fs::is_empty(packs);
  CHECK(empty);
  CHECK_FALSE(fs::exists(scratch.path / "evil"));
  return problem.message;
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE(
    "a pack with a lesson and a picture in a folder is opened and unpacked byte by byte, with or "
    "without entries for folders") {
  const std::string picture(100'000, 'p');
  const ScratchFolder scratch;
  for (const std::vector<ZipEntry>& more :
       {std::vector<ZipEntry>{{"pictures/ring.png", picture, true, 0100644}},
        std::vector<ZipEntry>{{"pictures/", "", false, 040755}, {"pictures/ring.png", picture}}}) {
    Expected<PackFile> pack = opened(packWith(more));
    REQUIRE_MESSAGE(bool(pack), pack.problem().text());
    CHECK(pack->lesson() == "l.md");
    REQUIRE(pack->entries().size() == 2);
    CHECK(pack->entries()[1].name == "pictures/ring.png");
    CHECK(*pack->read(pack->entries()[1]) == picture);
    const Expected<fs::path> lesson = unpack(*pack, scratch.path / "packs");
    REQUIRE_MESSAGE(bool(lesson), lesson.problem().text());
    CHECK(lesson->parent_path().filename() == "l-" + pack->hash());
    CHECK(bytesOf(*lesson) == test::kSmallLesson);
    CHECK(bytesOf(lesson->parent_path() / "pictures/ring.png") == picture);
    CHECK_FALSE(fs::exists(lesson->parent_path() / "pack.json"));
  }
  // Nothing but the two packs is left in the folder.
  CHECK(std::distance(fs::directory_iterator(scratch.path / "packs"), fs::directory_iterator()) == 2);
}

TEST_CASE("a pack that is unpacked again takes the place of what was changed in its folder") {
  const ScratchFolder scratch;
  const Expected<PackFile> pack = opened(packWith());
  REQUIRE(bool(pack));
  const fs::path lesson = *unpack(*pack, scratch.path);
  writeFile(lesson, "changed");
  writeFile(lesson.parent_path() / "stray", "");
  CHECK(*unpack(*pack, scratch.path) == lesson);
  CHECK(bytesOf(lesson) == test::kSmallLesson);
  CHECK_FALSE(fs::exists(lesson.parent_path() / "stray"));
}

TEST_CASE("names that leave the folder, begin at a disk's top, are hidden, no UTF-8 or none on Windows are refused") {
  for (const char* name : {"../evil",  "a/../../evil",
                           "a/..",     "..",
                           "/evil",    "\\evil",
                           "C:evil",   "a\\..\\..\\evil",
                           "a//b",     "./evil",
                           ".hidden",  "a/.b",
                           "ev\xFFil", "\xC0\xAE\xC0\xAE/evil",
                           "ev\nil",   "ev\x1B[2Jil",
                           "a?b",      "a:b",
                           "aux",      "b/COM1.txt",
                           "nul.md",   "a.",
                           "a ",       "e\xE2\x80\xAEvil"}) {
    CAPTURE(name);
    CHECK_FALSE(packNameFault(name).empty());
    CHECK(has(refusal(packWith({{name, "x"}})), "the name"));
  }
  CHECK(has(refusal(packWith({{std::string(201, 'a'), "x"}})), "longer than 200 bytes"));
  CHECK(has(refusal(packWith({{"a/b/c/d/e/f/g/h/i/j", "x"}})), "more than 8 folders"));
  for (const char* name : {"a.md", "pictures/ring (2).png", "b/c..d", "Häm.md", "分子.pdb", "com10", "aux2"}) {
    CAPTURE(name);
    CHECK(packNameFault(name).empty());
  }
}

TEST_CASE("links, devices, encrypted files and unknown ways of packing are refused") {
  CHECK(has(refusal(packWith({{"a", "/etc/passwd", false, 0120777}})), "is a link"));
  CHECK(has(refusal(packWith({{"a", "", false, 020666}})), "no ordinary file"));
  CHECK(has(refusal(packWith({{"a/", "", false, 0120777}})), "is a link"));
  CHECK(has(refusal(packWith({{.name = "a", .bytes = "0123456789abcdef", .encrypted = true}})), "is encrypted"));
  CHECK(has(refusal(packWith({{.name = "a", .bytes = "x", .method = 12}})),
            "by a method that this program does not read"));
}

TEST_CASE("the same name twice, also in capitals, and a file that is a folder too are refused") {
  CHECK_FALSE(refusal(packWith({{"a.pdb", "1"}, {"a.pdb", "2"}})).empty());  // by libzip or by us
  CHECK(has(refusal(packWith({{"a.pdb", "1"}, {"A.PDB", "2"}})), "twice"));
  CHECK(has(refusal(packWith({{"a", "1"}, {"A/b", "2"}})), "a file and a folder"));
}

TEST_CASE("a file that would grow 1000 times, one GiB in all and 1001 files are refused before anything is unpacked") {
  CHECK(has(refusal(packWith({{"a", std::string(8 << 20, '\0'), true}})), "more than 200 times"));
  CHECK(has(refusal(packWith({{.name = "a", .bytes = "x", .deflated = true, .header_size = 0x7FFFFFFF}})), "1024 MiB"));
  std::vector<ZipEntry> many(1001 - 2);
  for (std::size_t k = 0; k < many.size(); ++k) many[k].name = "f" + std::to_string(k);
  CHECK(has(refusal(packWith(many)), "more than 1000 files"));
  many.pop_back();
  CHECK(bool(opened(packWith(many))));
  // Small files may be as even as they like.
  CHECK(bool(opened(packWith({{"a", std::string(1 << 20, '\0'), true}}))));
}

TEST_CASE("a file whose size or checksum differs from its entry is rejected, and nothing of the pack is left") {
  CHECK(has(refusal(packWith({{.name = "a", .bytes = "right", .wrong_checksum = true}})), "damaged"));
  CHECK(has(refusal(packWith({{.name = "a", .bytes = std::string(3000, 'x'), .deflated = true, .header_size = 7}})),
            "damaged"));
  CHECK(has(refusal(packWith({{.name = "a", .bytes = std::string(3000, 'x'), .deflated = true, .header_size = 4000}})),
            "damaged"));
}

TEST_CASE("a pack cut off at any byte, an empty file, a zip that is no pack and a newer format are refused") {
  const std::string whole = packWith();
  for (std::size_t n = 0; n < whole.size(); n += 7) {
    CAPTURE(n);
    CHECK_FALSE(refusal(whole.substr(0, n)).empty());
  }
  CHECK(has(refusal("no zip at all"), "no pack"));
  CHECK(has(refusal(zipOf({{"l.md", test::kSmallLesson}})), "no 'pack.json'"));
  for (const char* manifest : {"", "[]", "{\"format\": 1}", "{\"format\": \"1\", \"lesson\": \"l.md\"}",
                               "{\"format\": 1, \"lesson\": 3}", "{\"format\": 1, \"lesson\": \"l.md\"", "\xFF"}) {
    CAPTURE(manifest);
    CHECK(has(refusal(zipOf({{"pack.json", manifest}, {"l.md", "x"}})), "does not name"));
  }
  CHECK(has(refusal(zipOf({{"pack.json", "{\"format\": 2, \"lesson\": \"l.md\"}"}, {"l.md", "x"}})), "format 2"));
  CHECK(has(refusal(zipOf({{"pack.json", std::string(5000, ' ')}, {"l.md", "x"}})), "4096 bytes"));
  for (const char* lesson : {"m.md", "a/l.md", "../l.md", "pack.json", ""}) {
    CAPTURE(lesson);
    CHECK(has(refusal(zipOf({{"pack.json", "{\"format\": 1, \"lesson\": \"" + std::string(lesson) + "\"}"},
                             {"l.md", "x"},
                             {"a/l.md", "x"}})),
              "is not in it"));
  }
}

}  // namespace moltact
