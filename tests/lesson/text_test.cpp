// The contents of a lesson's text besides words: scripts, formulas, tables, pictures and glossary words.
#include <doctest/doctest.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>

#include "engine/lesson/check.h"
#include "engine/lesson/formula.h"
#include "engine/lesson/glossary.h"
#include "engine/lesson/lesson_picture.h"
#include "engine/lesson/png_inflation.h"
#include "engine/lesson/reader.h"
#include "tests/lesson/small_molecules.h"
#include "tests/lesson/small_picture.h"

using namespace moltact;

namespace {

namespace fs = std::filesystem;

const std::string kTextHead = "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n";
const std::string kTextStep = "## One step\n```scene\nmolecule: mix\n```\n";  // lines 9 to 12

Lesson textLessonOf(const std::string& text) {
  LessonReading reading = readLessonText("l.md", kTextHead + kTextStep + text);
  for (const Problem& p : reading.errors) FAIL(p.text());
  return *reading.lesson;
}

// "H[2]O" with its scripts as _2_ and ^2^, slanted text as /x/.
std::string shown(const RichText& text) {
  std::string out;
  for (const TextRun& run : text) {
    const std::string around = run.script == Script::Sub     ? "_"
                               : run.script == Script::Super ? "^"
                               : run.italic                  ? "/"
                                                             : "";
    out += around + run.text + around;
  }
  return out;
}
std::string shown(const std::string& text) {
  const Lesson lesson = textLessonOf(text);
  return shown(std::get<Paragraph>(lesson.steps[0].blocks.at(0)).text);
}

std::string formula(std::string_view text, std::vector<Problem>& problems) {
  return shown(formulaText(text, {1, 1}, problems));
}
std::string formula(std::string_view text) {
  std::vector<Problem> problems;
  std::string out = formula(text, problems);
  for (const Problem& p : problems) out += " !" + p.message;
  return out;
}

Expected<std::shared_ptr<const Molecule>> textOnlyMix(const NamedMolecule& named) {
  if (named.name == "mix") return std::make_shared<const Molecule>(mixedMolecule());
  return Problem{{}, 0, 0, "there is no molecule '" + named.name + "'", "choose another"};
}

std::vector<std::string> textReported(const std::vector<Problem>& problems) {
  std::vector<std::string> out;
  for (const Problem& p : problems) out.push_back(p.text());
  return out;
}

struct TextFolder {
  fs::path path = fs::temp_directory_path() / ("moltact-text-" + std::to_string(::getpid()));
  TextFolder() { fs::create_directories(path); }
  ~TextFolder() { fs::remove_all(path); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
  }
  std::string operator/(const std::string& name) const { return (path / name).string(); }
};

std::vector<std::string> linksOf(const Lesson& lesson, std::size_t step) {
  std::vector<std::string> out;
  for (const Block& b : lesson.steps[step].blocks)
    if (const auto* p = std::get_if<Paragraph>(&b))
      for (const TextRun& run : p->text)
        if (!run.link.empty()) out.push_back(run.text + " -> " + run.link);
  return out;
}

}  // namespace

TEST_CASE("H~2~O has a subscript and 10^−9^ a superscript, on pages of the web as in Pandoc; escaped signs stay") {
  CHECK(shown(std::string("Water is H~2~O.")) == "Water is H_2_O.");
  CHECK(shown(std::string("10^−9^ m, PO~4~^3−^ and ^14^C")) == "10^−9^ m, PO_4_^3−^ and ^14^C");
  CHECK(shown(std::string("H<sub>2</sub>O and m<sup>2</sup>")) == "H_2_O and m^2^");
  CHECK(shown(std::string("*K*~d~ of 5")) == "/K/_d_ of 5");
  CHECK(shown(std::string(R"(a\~2\~b and 2\^3\^)")) == "a~2~b and 2^3^");
  CHECK(shown(std::string("`H~2~O`")) == "H~2~O");
  CHECK(shown(std::string("one<br>two")) == "one\ntwo");
}

TEST_CASE("a tilde that means about is no subscript: ~5 Å, ~5–~7 Å, and one with a blank behind it") {
  for (const char* text : {"It is ~5 Å or ~7 Å wide.", "~5–~7 Å", "a ~ b ~ c", "x~a b~"})
    CHECK(shown(std::string(text)) == text);
}

TEST_CASE("the text alone writes scripts by Unicode where that has all of them, else as on a line") {
  CHECK(plainText({{.text = "H"}, {.text = "2", .script = Script::Sub}, {.text = "O"}}) == "H₂O");
  CHECK(plainText({{.text = "10"}, {.text = "−9", .script = Script::Super}}) == "10⁻⁹");
  CHECK(plainText({{.text = "K"}, {.text = "d", .script = Script::Sub}}) == "K_d");
  CHECK(plainText({{.text = "e"}, {.text = "kt", .script = Script::Super}}) == "e^kt");
  CHECK(bareText({{.text = "H"}, {.text = "2", .script = Script::Sub}}) == "H2");
}

TEST_CASE("a heading with a subscript has the id that pages of the web give it, and its link leads there") {
  const Lesson lesson = textLessonOf("Text and [H~2~O](#water-h2o).\n\n## Water, H~2~O\n\nText.\n");
  CHECK(lesson.steps[1].id == "water-h2o");
  CHECK(lesson.steps[1].title == "Water, H₂O");
}

TEST_CASE("10^-9 without its second sign is reported at its column, with the mended form") {
  const LessonReading reading = readLessonText("l.md", kTextHead + kTextStep + "A billionth is 10^-9 of it.\n");
  REQUIRE(reading.warnings.size() == 1);
  CHECK(reading.warnings[0].text() == "l.md:13:18: '^' begins no superscript here, for none ends it; close it: ^-9^");
}

TEST_CASE(
    "formulas: letters slant, digits stand, scripts are raised, fractions stand on the line with brackets where "
    "needed") {
  CHECK(formula("F=kd") == "/F/ = /kd/");
  CHECK(formula("F = k \\cdot d^2") == "/F/ = /k/ · /d/^2^");
  CHECK(formula("10^{-9}") == "10^−9^");
  CHECK(formula("10^-9") == "10^−9^");
  CHECK(formula("r_{ij}") == "/r/_ij_");
  CHECK(formula("\\frac{a}{b}") == "/a///b/");
  CHECK(formula("\\frac{a+b}{2}") == "(/a/\u00A0+\u00A0/b/)/2");
  CHECK(formula("\\sqrt{x^2+y^2}") == "√(/x/^2^\u00A0+\u00A0/y/^2^)");
  CHECK(formula("a - b") == "/a/ − /b/");
  CHECK(formula("-b") == "−/b/");
  CHECK(formula("\\Delta G = -RT \\ln K") == "Δ/G/ = −/RT/ ln /K/");
  CHECK(formula("5\\,\\text{mN}") == "5\u00A0mN");
  CHECK(formula("\\alpha \\approx 3") == "/α/ ≈ 3");
}

TEST_CASE("what a formula does not know is reported at its place and shown as written") {
  std::vector<Problem> problems;
  CHECK(formula("a \\matrix b", problems) == "/a/ \\matrix /b/");
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].column == 3);
  CHECK(problems[0].message == "a formula here knows no '\\matrix'");
  for (const char* bad : {"{a", "a}", "x^", "x_{a_b}", "\\frac{a}", "\\sqrt"}) {
    problems.clear();
    formula(bad, problems);
    INFO(bad);
    CHECK(problems.size() >= 1);
  }
}

TEST_CASE("in a text a formula stands between dollar signs; prices stay") {
  CHECK(shown(std::string("It is $F = k d$ there.")) == "It is /F/ = /k/ /d/ there.");
  CHECK(shown(std::string("It costs $5 and then $6.")) == "It costs $5 and then $6.");
  CHECK(shown(std::string("So:\n$$F = k d$$\nand more.")) == "So: \n/F/ = /k/ /d/\nand more.");
}

TEST_CASE("a table has its headings, its columns' sides and a text in each cell; a row with too few cells is filled") {
  const Lesson lesson =
      textLessonOf("| atom | radius |\n|:---|---:|\n| H~2~ | **1.2 Å** |\n| [C](#one-step) | 1.7 Å |\n| N |\n");
  const auto& table = std::get<Table>(lesson.steps[0].blocks.at(0));
  CHECK(table.sides == std::vector{Table::Side::Left, Table::Side::Right});
  REQUIRE(table.rows.size() == 4);
  CHECK(plainText(table.rows[0][1]) == "radius");
  CHECK(shown(table.rows[1][0]) == "H_2_");
  CHECK(table.rows[1][1][0].bold);
  CHECK(table.rows[2][0][0].link == "#one-step");
  CHECK(table.rows[3].size() == 2);
  CHECK(plainText(table.rows[3][1]).empty());
}

TEST_CASE("a link in a table that leads nowhere is reported at its line") {
  const LessonReading reading =
      readLessonText("l.md", kTextHead + kTextStep + "Text.\n\n| a |\n|---|\n| [b](#nowhere) |\n");
  REQUIRE(reading.errors.size() == 1);
  CHECK(reading.errors[0].line == 17);
}

TEST_CASE("a picture keeps its path, its words and the caption below it") {
  const Lesson lesson = textLessonOf("Text.\n\n![A ring](ring.png \"Figure 1\")\n");
  const auto& image = std::get<Image>(lesson.steps[0].blocks.at(1));
  CHECK(image.path == "ring.png");
  CHECK(image.description == "A ring");
  CHECK(image.caption == "Figure 1");
}

TEST_CASE(
    "a PNG is read to its pixels; what is damaged, larger than allowed or no picture is a problem with a remedy") {
  const auto red = readLessonPicture(std::string_view(kRedPng));
  REQUIRE(red);
  CHECK(red->width_px == 1);
  CHECK(red->rgb == std::vector<std::uint8_t>{255, 0, 0});
  std::string wide = kRedPng;
  wide[18] = '\x20';  // 8193 pixels wide, as its head has it
  const std::string_view bad[] = {"", "GIF89a", "<svg/>", std::string_view(kRedPng).substr(0, 40), wide};
  for (const std::string_view bytes : bad) {
    const auto picture = readLessonPicture(bytes);
    REQUIRE(!picture);
    CHECK(!picture.problem().remedy.empty());
  }
  CHECK(readLessonPicture(std::string_view(wide)).problem().message ==
        "a picture of 8193 x 1 pixels; 4096 a side are the most");
  const std::string large = kRedPng + std::string(kLargestPictureFile, 'x');
  CHECK(readLessonPicture(std::string_view(large)).problem().message == "a picture of more than 8 MiB");
}

TEST_CASE(
    "a PNG of 10 x 10 pixels whose 100 kB inflate to 100 MB is refused unread; one with 60 bytes too many is shown") {
  // Chunks and their checks are written by hand here, the rows packed by zlib.
  const auto png = [](int side, std::size_t row_bytes) {
    const auto four = [](std::uint32_t v) { return std::string{char(v >> 24), char(v >> 16), char(v >> 8), char(v)}; };
    const auto chunk = [&](const std::string& kind, const std::string& data) {
      const std::string all = kind + data;
      const auto sum = crc32(0, reinterpret_cast<const Bytef*>(all.data()), uInt(all.size()));
      return four(std::uint32_t(data.size())) + all + four(std::uint32_t(sum));
    };
    const std::string rows(row_bytes, '\0');
    std::string packed(compressBound(uLong(rows.size())), '\0');
    uLongf size = packed.size();
    REQUIRE(compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
                     uLong(rows.size())) == Z_OK);
    packed.resize(size);
    return "\x89PNG\r\n\x1A\n" +
           chunk("IHDR", four(std::uint32_t(side)) + four(std::uint32_t(side)) + std::string("\x08\x02\0\0\0", 5)) +
           chunk("IDAT", packed.substr(0, size / 2)) + chunk("IDAT", packed.substr(size / 2)) + chunk("IEND", "");
  };
  const std::size_t need = 10 * (1 + 3 * 10);
  CHECK(readLessonPicture(std::string_view(png(10, need))));
  CHECK(readLessonPicture(std::string_view(png(10, need + 60))));
  CHECK(inflatedRows(png(10, need - 1)) == PngRows::Fit);  // too few: the reader of pictures finds that
  const std::string bomb = png(10, 100'000'000);
  CHECK(bomb.size() < 150'000);
  CHECK(inflatedRows(bomb) == PngRows::TooMany);
  CHECK(readLessonPicture(std::string_view(bomb)).problem().message ==
        "the file holds more data than a picture of 10 x 10 pixels has");
  std::string broken = png(10, need);
  broken[60] ^= 0x55;
  CHECK_FALSE(readLessonPicture(std::string_view(broken)));
  // Every cut and every changed byte ends.
  const std::string whole = png(10, need);
  for (std::size_t k = 8; k < whole.size(); ++k) {
    (void)inflatedRows(std::string_view(whole).substr(0, k));
    std::string changed = whole;
    changed[k] = char(0xFF);
    (void)inflatedRows(changed);
  }
}

TEST_CASE("halving keeps the mean: a board of black and white fields of a pixel is grey at half its size") {
  LessonPicture board{8, 4, {}};
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x)
      for (int c = 0; c < 3; ++c) board.rgb.push_back((x + y) % 2 ? 254 : 0);
  const LessonPicture half = halvedTo(board, 4);
  CHECK(half.width_px == 4);
  CHECK(half.height_px == 2);
  CHECK(half.rgb == std::vector<std::uint8_t>(24, 127));
  CHECK(halvedTo(board, 8).rgb == board.rgb);
}

TEST_CASE("check reports an invalid picture at its place") {
  const TextFolder folder;
  folder.write("ring.png", "no picture");
  folder.write("good.png", kRedPng);
  const LessonCheck check = checkLesson(
      folder / "l.md", kTextHead + kTextStep + "Text.\n\n![A ring](ring.png)\n\n![Red](good.png)\n", textOnlyMix);
  REQUIRE(check.errors.size() == 1);
  CHECK(check.errors[0].line == 15);
  CHECK(check.errors[0].message == "'ring.png' cannot be shown: this is no picture that a lesson can show");
}

TEST_CASE(
    "a glossary: bold word, other ways to write it, a meaning behind the colon; headings and prose are passed over") {
  const Glossary words = readGlossary(
      "glossary.md",
      "# Words\n\nFor all.\n\n- **active site**, active sites: A *pocket*: see H~2~O.\n- **pit**: Three.\n");
  CHECK(textReported(words.errors).empty());
  REQUIRE(words.words.size() == 2);
  CHECK(words.words[0].word == "active site");
  CHECK(words.words[0].others == std::vector<std::string>{"active sites"});
  CHECK(shown(words.words[0].meaning) == "A /pocket/: see H_2_O.");
  CHECK(words.words[1].others.empty());
}

TEST_CASE("an entry without word or meaning, and a word that stands twice, are reported at their lines") {
  const Glossary words =
      readGlossary("glossary.md", "- crease: A line.\n- **pit**\n- **ring**: One.\n- **loop**, ring: Two.\n");
  CHECK(textReported(words.errors) ==
        std::vector<std::string>{
            "glossary.md:1:3: an entry of the glossary without its word; begin it with the word in two stars: - "
            "**crease**, creases: what it means",
            "glossary.md:2:5: 'pit' has no meaning here; write it behind a colon: - **crease**, creases: what it means",
            "glossary.md:4:5: 'ring' is explained twice; take one of the two out; the other is on line 3"});
  CHECK(!readGlossary("glossary.md", "\xFF").errors.empty());
  CHECK(readGlossary("glossary.md", "Nothing.\n").warnings.size() == 1);
}

TEST_CASE(
    "the first of each word in every step leads to its meaning, the longest first, whole words only, in capitals too") {
  Lesson lesson = textLessonOf(
      "Hydrogen bonds hold it; hydrogen does not. Pits and a pit, pit-shaped, pitfall.\n\n"
      "`crease` and [crease](#one-step)s, creases.\n\n## Two\n\nA pit.\n\n"
      "## Glossary\n\n- **pit**, pits: Three.\n- **hydrogen**: H.\n- **hydrogen bond**, hydrogen bonds: Weak.\n- "
      "**crease**, creases: Two.\n");
  CHECK(lesson.steps.size() == 2);
  linkWords(lesson, {});
  CHECK(linksOf(lesson, 0) == std::vector<std::string>{"Hydrogen bonds -> #word:hydrogen-bond",
                                                       "hydrogen -> #word:hydrogen", "Pits -> #word:pit",
                                                       "crease -> #one-step", "creases -> #word:crease"});
  CHECK(linksOf(lesson, 1) == std::vector<std::string>{"pit -> #word:pit"});
}

TEST_CASE("a word that the author has linked gets no other link in its step; the text itself stays as it was") {
  const std::string text = "A pit and [these](#word:pits).\n\n## Glossary\n\n- **pit**, pits: Three.\n";
  Lesson lesson = textLessonOf(text);
  const std::string before = plainText(std::get<Paragraph>(lesson.steps[0].blocks[0]).text);
  linkWords(lesson, {});
  CHECK(linksOf(lesson, 0) == std::vector<std::string>{"these -> #word:pits"});
  CHECK(plainText(std::get<Paragraph>(lesson.steps[0].blocks[0]).text) == before);
  REQUIRE(findWord(lesson, "pits"));
  CHECK(findWord(lesson, "pits")->word == "pit");
  CHECK(findWord(lesson, "loop") == nullptr);
}

TEST_CASE("what is asked in a question has no link to its answer") {
  Lesson lesson = textLessonOf(
      "Text.\n\n### Question: What is a pit?\n\nOf a pit.\n\n- [x] three → A pit.\n- [ ] two → No.\n\n## Glossary\n\n- "
      "**pit**: Three.\n");
  linkWords(lesson, {});
  const Question& asked = lesson.steps[0].questions[0];
  for (const RichText* text : {&asked.title, &asked.prompt[0], &asked.choices[0].text, &asked.choices[0].feedback})
    for (const TextRun& run : *text) CHECK(run.link.empty());
}

TEST_CASE("the words beside a lesson are those of its language; its own come before them") {
  const TextFolder folder;
  folder.write("glossary.md", "- **pit**: Shared.\n- **ring**: Round.\n");
  folder.write("glossary.de.md", "- **Grube**: Drei.\n");
  const auto first = [&](const char* file, const char* language) {
    const Glossary words = glossaryBeside(folder / file, language);
    return words.words.empty() ? std::string() : words.words[0].word;
  };
  CHECK(first("l.md", "") == "pit");
  CHECK(first("l.de.md", "de") == "Grube");
  CHECK(first("l.md", "de") == "Grube");
  CHECK(first("l.md", "fr") == "pit");
  CHECK(first("l.fr.md", "fr").empty());  // none is better than one in another language
  Lesson lesson = textLessonOf("A pit, a ring.\n\n## Glossary\n\n- **pit**: Own.\n");
  linkWords(lesson, glossaryBeside(folder / "l.md", ""));
  CHECK(plainText(findWord(lesson, "pit")->meaning) == "Own.");
  CHECK(plainText(findWord(lesson, "ring")->meaning) == "Round.");
  CHECK(linksOf(lesson, 0).size() == 2);
}

TEST_CASE("check reports a link to a word that is not explained, and a link with a blank in its target") {
  const TextFolder folder;
  folder.write("glossary.md", "- **pit**: Shared.\n");
  const auto errors = [&](const std::string& text) {
    return textReported(checkLesson(folder / "l.md", kTextHead + kTextStep + text, textOnlyMix).errors);
  };
  CHECK(errors("A [hole](#word:pit).\n").empty());
  CHECK(errors("A [hole](#word:pitt).\n") ==
        std::vector<std::string>{(folder / "l.md") + ":13:10: the glossary has no word 'pitt'; did you mean 'pit'?"});
  CHECK(errors("A [hole](#word:active site).\n").size() == 1);
}

TEST_CASE("a block of a step below the heading of the glossary is reported") {
  const LessonReading reading = readLessonText(
      "l.md", kTextHead + kTextStep + "Text.\n\n## Glossary\n\n- **pit**: Three.\n\n```scene\nmolecule: mix\n```\n");
  REQUIRE(reading.errors.size() == 1);
  CHECK(reading.errors[0].message == "a scene block in the glossary");
}
