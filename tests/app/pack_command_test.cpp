// `moltact pack` as teachers call it, and check, play and info with its output.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command_place.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;
using test::CommandPlace;
using test::contents;
using test::Run;

const std::string kLesson =
    "---\ntitle: Haem\nminutes: 1\ngoals: G\nmolecules: mine.xyzr\nauthor: A. Teacher\nlicence: CC-BY-4.0\nask: "
    "code\n---\n## One\n```scene\nmolecule: mine.xyzr\n```\n```touch\nreach: all\nsay: Touch it.\n```\n"
    "### Question: Q?\n- [x] yes → Right.\n- [ ] no → No.\n";

struct Place : CommandPlace {
  Place() {
    write("haem.md", kLesson);
    write("mine.xyzr", "0 0 0 1.5\n3 0 0 1.5\n");
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
  }
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a lesson is packed beside itself or to the path of -o, listed file by file, twice to the same bytes") {
  const Place place;
  const Run run = place.run("pack haem.md");
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  CHECK(has(run.out, "haem.moltact is written (1 kB):\n  haem.md\n  mine.xyzr\n"));
  CHECK(place.run("pack haem.md -o again.moltact").status == 0);
  CHECK(contents(place.folder / "again.moltact") == contents(place.folder / "haem.moltact"));
  CHECK(contents(place.folder / "haem.moltact").starts_with("PK\3\4"));
}

TEST_CASE(
    "with --html the pack stands in base64 in the page that --page names, which opens it; another page is refused") {
  const Place place;
  place.write("edition.html", "<html><!--a lesson comes here--><script>program</script></html>");
  const Run run = place.run("pack haem.md --html --page edition.html");
  CHECK(run.status == 0);
  CHECK(has(run.out, "haem.html is written (1 kB):\n  haem.md\n  mine.xyzr\n"));
  const std::string page = contents(place.folder / "haem.html");
  const std::string head = "<html><script type=\"text/plain\" id=\"pack-bytes\" data-name=\"haem.moltact\">";
  CHECK(page.starts_with(head + "UEsDBBQ"));  // "PK\3\4\24"
  CHECK(page.ends_with("</script><script>program</script></html>"));
  // coreutils' base64 reads the same bytes back.
  REQUIRE(place.run("pack haem.md").status == 0);
  const std::string code = page.substr(head.size(), page.find("</script>") - head.size());
  place.write("code.txt", code);
  const std::string decode = "base64 -d '" + (place.folder / "code.txt").string() + "' > '" +
                             (place.folder / "decoded.moltact").string() + "'";
  REQUIRE(std::system(decode.c_str()) == 0);
  CHECK(contents(place.folder / "decoded.moltact") == contents(place.folder / "haem.moltact"));

  place.write("other.html", "<html></html>");
  const Run other = place.run("pack haem.md --html --page other.html -o other-out.html");
  CHECK(other.status == 1);
  CHECK(has(other.err, "other.html: it is no page of the browser edition"));
  CHECK_FALSE(fs::exists(place.folder / "other-out.html"));
  CHECK(has(place.run("pack haem.md --html --page haem.html").err, "holds a lesson already"));
  CHECK(place.run("pack haem.md --html --page gone.html").status == 1);
}

TEST_CASE(
    "for a learning platform a translation with another task is refused at its line and nothing is written; a .moltact "
    "takes it, and so does the platform once it is mended") {
  const Place place;
  place.write(
      "edition.html",
      "<html><script id=\"platform-script\"></script><!--a lesson comes here--><script>program</script></html>");
  std::string german = kLesson;
  german.replace(german.find("reach: all"), 10, "press: anywhere\nuntil: 0.8 N");
  place.write("haem.de.md", german);
  place.write("other.de.md", german);  // of another lesson
  for (const char* option : {"--scorm", "--cmi5"}) {
    const Run run = place.run(std::string("pack haem.md --page edition.html -o out.zip ") + option);
    CHECK(run.status == 1);
    CHECK(has(run.err, "haem.de.md:14"));
    CHECK(has(run.err, "task 1 of step 1 is 'press', that of haem.md is 'reach'; give the translation the same steps"));
    CHECK_FALSE(fs::exists(place.folder / "out.zip"));
  }
  CHECK(place.run("pack haem.md").status == 0);
  place.write("haem.de.md", kLesson);
  CHECK(place.run("pack haem.md --scorm --page edition.html").status == 0);
}

TEST_CASE(
    "with --scorm, --scorm 2004 and --cmi5 a zip holds the manifest and the page at its top, well-formed by xmllint "
    "whatever the title is, twice to the same bytes") {
  const Place place;
  place.write(
      "edition.html",
      "<html><script id=\"platform-script\"></script><!--a lesson comes here--><script>program</script></html>");
  std::string evil = kLesson;
  evil.replace(evil.find("Haem"), 4, "H<a>em & \"]]>\" 'ä'");
  evil.replace(evil.find("goals: G"), 8, "goals:\n  - <G> & more\n  - Say it");
  place.write("evil.md", evil);
  struct Case {
    std::string option, file, manifest, kind, mark;
  };
  for (const Case& c :
       {Case{"--scorm", "evil.scorm12.zip", "imsmanifest.xml", "1.2", "<schemaversion>1.2</schemaversion>"},
        {"--scorm 2004", "evil.scorm2004.zip", "imsmanifest.xml", "2004",
         "<schemaversion>2004 4th Edition</schemaversion>"},
        {"--cmi5", "evil.cmi5.zip", "cmi5.xml", "cmi5", "moveOn=\"Completed\""}}) {
    CAPTURE(c.option);
    const Run run = place.run("pack evil.md " + c.option + " --page edition.html");
    CHECK(run.err.empty());
    REQUIRE(run.status == 0);
    CHECK(has(run.out, c.file + " is written"));
    const std::string zip = (place.folder / c.file).string(), into = (place.folder / ("out-" + c.kind)).string();
    REQUIRE(std::system(("python3 -m zipfile -e '" + zip + "' '" + into + "'").c_str()) == 0);
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(into)) files += entry.is_regular_file() ? 1 : 0;
    CHECK(files == 2);
    const std::string manifest = contents(fs::path(into) / c.manifest), page = contents(fs::path(into) / "index.html");
    CHECK(has(manifest, c.mark));
    CHECK(has(manifest, "H&lt;a&gt;em &amp; &quot;]]&gt;&quot; &#39;ä&#39;"));
    CHECK(has(page, "data-name=\"evil.moltact\" data-platform=\"" + c.kind + "\" data-lesson=\"urn:uuid:"));
    if (std::system("command -v xmllint >/dev/null") == 0)
      CHECK(std::system(("xmllint --noout '" + into + "/" + c.manifest + "'").c_str()) == 0);
    REQUIRE(place.run("pack evil.md " + c.option + " --page edition.html -o again.zip").status == 0);
    CHECK(contents(place.folder / "again.zip") == contents(zip));
  }
  CHECK(has(contents(place.folder / "out-cmi5" / "cmi5.xml"),
            "<langstring lang=\"und\">&lt;G&gt; &amp; more</langstring>"));
  place.write("old.html", "<html><!--a lesson comes here--></html>");
  CHECK(has(place.run("pack evil.md --scorm 1.2 --page old.html").err, "knows no learning platform"));
  CHECK(has(place.run("pack evil.md --scorm 1.3 --page edition.html").err, "no edition of SCORM"));
  CHECK(place.run("pack evil.md --scorm --cmi5 --page edition.html").status != 0);
  CHECK(place.run("pack evil.md --html --cmi5 --page edition.html").status != 0);
}

TEST_CASE("a lesson with a fault is not packed, its notes are reported, and a file that is no lesson is refused") {
  const Place place;
  place.write("bad.md", kLesson + "\n![no](gone.png)\n");
  Run run = place.run("pack bad.md");
  CHECK(run.status == 1);
  CHECK(has(run.err, "bad.md:22:1: the picture 'gone.png' leads to no file"));
  CHECK(has(run.err, "nothing was packed"));
  CHECK_FALSE(fs::exists(place.folder / "bad.moltact"));

  place.write("note.md", kLesson + "\n```scenes\n```\n");
  run = place.run("pack note.md");
  CHECK(run.status == 0);
  CHECK(has(run.err, "note: note.md:22:4: 'scenes' is not a block"));

  CHECK(has(place.run("pack mine.xyzr").err, "is no lesson; name a file that ends in .md"));
  CHECK(place.run("pack gone.md").status == 1);
  CHECK(place.run("pack").status == 2);
  CHECK(place.run("pack haem.md -o no/folder.moltact").status == 1);
}

TEST_CASE("check, info and play take a pack as they take a lesson, and leave nothing in the temporary folder") {
  const Place place;
  REQUIRE(place.run("pack haem.md").status == 0);
  fs::remove(place.folder / "haem.md");
  fs::remove(place.folder / "mine.xyzr");
  fs::create_directory(place.folder / "tmp");
  const std::string in_tmp = "export TMPDIR='" + (place.folder / "tmp").string() + "';";

  Run run = place.run("check haem.moltact", in_tmp);
  CHECK(run.status == 0);
  CHECK(run.out.ends_with("1 lesson checked: no errors\n"));

  run = place.run("info haem.moltact", in_tmp);
  CHECK(run.status == 0);
  for (const char* part :
       {"Haem\n", "author     A. Teacher\n", "steps      1 (1 tasks, 1 questions)\n", "molecules  mine.xyzr\n",
        "asks for   a code\n", "file       haem.md, ", "file       mine.xyzr, "})
    CHECK_MESSAGE(has(run.out, part), run.out);
  run = place.run("info haem.moltact --json", in_tmp);
  const auto json = nlohmann::json::parse(run.out);
  CHECK(json["title"] == "Haem");
  CHECK(json["asks_for"] == "code");
  CHECK(json["files"].size() == 2);

  run = place.run("play haem.moltact --demonstrate", in_tmp);
  CHECK_MESSAGE(run.status == 0, run.err);
  CHECK(has(run.out, "lesson finished"));
  run = place.run("play haem.moltact --demonstrate --json", in_tmp);
  CHECK(nlohmann::json::parse(run.out)["lesson"] == "haem.moltact/haem.md");
  CHECK(fs::is_empty(place.folder / "tmp"));
}

TEST_CASE("a folder that a killed program left is removed by the next check, info or play; one in use stays") {
  const Place place;
  REQUIRE(place.run("pack haem.md").status == 0);
  fs::create_directory(place.folder / "tmp");
  const fs::path left = place.folder / "tmp/moltact-pack-left", used = place.folder / "tmp/moltact-pack-used";
  // util-linux's flock holds the other folder as a running program does.
  const std::string before = "export TMPDIR='" + (place.folder / "tmp").string() + "'; flock '" + used.string() + "'";
  for (const char* command : {"check haem.moltact", "info haem.moltact", "play haem.moltact --demonstrate"}) {
    CAPTURE(command);
    for (const fs::path& folder : {left, used}) fs::create_directories(folder / "deep");
    CHECK(place.run(command, before).status == 0);
    CHECK_FALSE(fs::exists(left));
    CHECK(fs::exists(used / "deep"));
    fs::remove_all(used);
    CHECK(fs::is_empty(place.folder / "tmp"));
  }
}

TEST_CASE("a fault in a packed lesson is reported at its place in the pack; a broken pack with its remedy") {
  const Place place;
  REQUIRE(place.run("pack haem.md").status == 0);
  std::string bytes = contents(place.folder / "haem.moltact");
  place.write("cut.moltact", bytes.substr(0, bytes.size() - 30));
  for (const char* command : {"check cut.moltact", "info cut.moltact", "play cut.moltact --demonstrate"}) {
    const Run run = place.run(command);
    CAPTURE(command);
    CHECK(run.status == 1);
    CHECK(has(run.out + run.err, "cut.moltact: "));
    CHECK(has(run.out + run.err, "ask for the file again"));
  }
  CHECK(has(place.run("check gone.moltact").out, "there is no such file"));
  // A library that lacks the molecule: a fault in the pack.
  place.write("lib.md", kLesson);
  std::string text = kLesson;
  for (std::size_t at = text.find("mine.xyzr"); at != std::string::npos; at = text.find("mine.xyzr"))
    text.replace(at, 9, "argon");
  place.write("lib.md", text);
  REQUIRE(place.run("pack lib.md").status == 0);
  fs::create_directories(place.folder / "home/molecules");
  place.write("home/molecules/catalogue.json", "{\"molecules\": []}");
  const Run run = place.run("check lib.moltact", "export MOLTACT_HOME='" + (place.folder / "home").string() + "';");
  CHECK(run.status == 1);
  CHECK(has(run.out, "lib.moltact/lib.md:5:12: error: "));
}

}  // namespace moltact
