// No sentence of the pages and of the headers' comments has more than 30 words, and no cell of a table more than two
// sentences.
#include "tests/core/sentences.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/core/source_tree.h"

namespace {

namespace fs = std::filesystem;
using namespace moltact::test;

std::string words(std::size_t count) {
  std::string out = "Word";
  for (std::size_t k = 1; k < count; ++k) out += " word";
  return out;
}

std::vector<std::string> textsOf(const std::vector<Passage>& passages) {
  std::vector<std::string> out;
  for (const Passage& one : passages) out.push_back(std::to_string(one.line) + " " + one.text);
  return out;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("where a sentence ends, and what counts as a word") {
  CHECK(sentencesOf("One. Two! Three? Four: five; six") == Texts{"One.", "Two!", "Three?", "Four:", "five;", "six"});
  CHECK(sentencesOf("He says \"one.\" (Two.) Three") == Texts{"He says \"one.\"", "(Two.)", "Three"});
  CHECK(sentencesOf("Of 0.5 A, in units.h, by std::array, see e.g. the paper.") ==
        Texts{"Of 0.5 A, in units.h, by std::array, see e.g. the paper."});
  CHECK(sentencesOf("See `a. b. c` and [a page. Two](docs/page.md). End.") ==
        Texts{"See X and a page.", "Two.", "End."});
  CHECK(wordsIn("a force of 0.5 N/mm - and |x - h| <= 2 Å") == 10);
  CHECK(wordsIn(sentencesOf("`moltact bench chart` and [one link of six words here](docs/page.md)").front()) == 8);
}

TEST_CASE("the passages of a page and of a source") {
  CHECK(textsOf(passagesOfPage("# A heading\n\nOne\ntwo\n* three\n  four\n2. five\n\n    code\n\n```\ncode\n```\n"
                               "<!-- a remark -->\n| a | `b|c` |\n| --- | ---: |\n| d \\| e | |\nsix\n")) ==
        Texts{"3 One two", "5 three four", "7 five", "15 a", "15 `b|c`", "17 d \\| e", "18 six"});
  CHECK(
      textsOf(passagesOfSource("// One\n// two\n//\n// three\nint a;  ///< four\n        ///< five\n/// six\nint b;\n"
                               "const char* c = \"// none\";  // seven\n/// * eight\n///   nine\n/// * ten\n"
                               "// key VALUE   its meaning\n//   indented\nint d;  // eleven\nint e;  // twelve\n")) ==
      Texts{"1 One two", "4 three", "5 four five", "7 six", "9 seven", "10 eight nine", "12 ten", "13 key VALUE",
            "13 its meaning", "14 indented", "15 eleven", "16 twelve"});
}

TEST_CASE(
    "a planted sentence of 31 words and a cell of three sentences are found, and those of 30 words and two are not") {
  CHECK(tooLongIn(passagesOfPage(words(30) + ".\n")).empty());
  CHECK(tooLongIn(passagesOfPage("Short.\n" + words(20) + "\n" + words(11) + ".\n")).size() == 1);
  CHECK(tooLongIn(passagesOfPage("Short.\n\n" + words(20) + "\n* " + words(11) + "\n")).empty());
  CHECK(tooLongIn(passagesOfPage("| " + words(31) + " | b |\n")).size() == 1);
  CHECK(tooLongIn(passagesOfPage("| " + words(30) + " | " + words(30) + " |\n")).empty());
  CHECK(tooLongIn(passagesOfPage("| One. Two. Three. |\n")).size() == 1);
  CHECK(tooLongIn(passagesOfPage("| One. Two: three; four |\n")).empty());
  CHECK(tooLongIn(passagesOfSource("int a;\n// " + words(16) + "\n// " + words(15) + "\nint b;\n")) ==
        Texts{"2: 31 words: " + words(16) + " " + words(15)});
  CHECK(tooLongIn(passagesOfSource("/// " + words(16) + ".\n/// " + words(15) + "\n")).empty());
  CHECK(tooLongIn(passagesOfSource("int a;  // " + words(31) + "\n")).size() == 1);
  CHECK(tooLongIn(passagesOfSource("auto a = \"// " + words(31) + "\";\n")).empty());
}

TEST_CASE("no sentence in the literals of the commands, such as the texts of --help, has more than 30 words") {
  CHECK(textsOf(passagesOfLiterals("f(\"One \"\n  \"two\", \"a\\nb\");  // \"none\"\n")) ==
        Texts{"1 One two", "2 a", "2 b"});
  CHECK(tooLongIn(passagesOfLiterals("f(\"" + words(20) + " \"\n  \"" + words(11) + "\");")).size() == 1);
  for (const auto& entry : fs::directory_iterator(kSource / "app/commands"))
    if (entry.path().extension() == ".cpp")
      for (const std::string& found : tooLongIn(passagesOfLiterals(textOf(entry.path()))))
        FAIL_CHECK("app/commands/" << entry.path().filename().string() << ":" << found);
}

TEST_CASE(
    "no sentence of README, CONTRIBUTING, CHANGELOG and docs has more than 30 words, no cell more than two sentences") {
  std::vector<fs::path> pages{"README.md", "CONTRIBUTING.md", "CHANGELOG.md"};
  for (const auto& entry : fs::recursive_directory_iterator(kSource / "docs"))
    if (entry.path().extension() == ".md") pages.push_back(fs::relative(entry.path(), kSource));
  CHECK(pages.size() > 25);
  for (const fs::path& page : pages)
    for (const std::string& found : tooLongIn(passagesOfPage(textOf(kSource / page))))
      FAIL_CHECK(page.generic_string() << ":" << found);
}

TEST_CASE("no sentence in the comments of the headers of engine and app has more than 30 words") {
  std::size_t headers = 0;
  for (const char* top : {"engine", "app"})
    for (const auto& entry : fs::recursive_directory_iterator(kSource / top))
      if (entry.path().extension() == ".h") {
        ++headers;
        for (const std::string& found : tooLongIn(passagesOfSource(textOf(entry.path()))))
          FAIL_CHECK(fs::relative(entry.path(), kSource).generic_string() << ":" << found);
      }
  CHECK(headers > 400);
}
