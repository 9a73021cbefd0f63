#include "engine/lesson/glossary.h"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "engine/core/utf8.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/letters.h"
#include "engine/lesson/reading.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;
using Kind = MarkdownBlock::Kind;
using reading::Reading;

constexpr std::string_view kFileName = "glossary", kLink = "#word:";

/// Splits the text at the first colon that is neither in code nor in a link.
std::pair<RichText, RichText> partedAtColon(const RichText& text) {
  std::pair<RichText, RichText> out;
  bool behind = false;
  for (const TextRun& run : text) {
    const std::size_t colon = behind || run.code ? std::string::npos : run.text.find(':');
    TextRun before = run, after = run;
    if (!behind) before.text = run.text.substr(0, colon);
    if (!behind && colon != std::string::npos)
      after.text = run.text.substr(std::min(run.text.find_first_not_of(" \n", colon + 1), run.text.size()));
    if (!behind && !before.text.empty()) out.first.push_back(std::move(before));
    behind = behind || colon != std::string::npos;
    if (behind && !after.text.empty()) out.second.push_back(std::move(after));
  }
  return out;
}

void readWord(Reading& reading, const MarkdownBlock& item, std::vector<GlossaryWord>& words) {
  RichText text = item.text;
  for (const MarkdownBlock& child : item.children)
    if (text.empty()) text = child.text;
  if (words.size() == kMaxGlossaryWords) {
    reading.error(item.place, trf("a glossary of more than {0} words", kMaxGlossaryWords), tr("take some out"));
    return;
  }
  auto [head, meaning] = partedAtColon(text);
  GlossaryWord out;
  out.place = item.place;
  out.meaning = std::move(meaning);
  std::string names = bareText(head);
  // The bold word may contain commas; commas after it separate its other forms.
  if (!head.empty() && head[0].bold) {
    out.word = std::string(stripped(head[0].text));
    names.erase(0, head[0].text.size());
  }
  for (std::size_t from = 0; from < names.size();) {
    const std::size_t comma = std::min(names.find(',', from), names.size());
    if (const std::string_view name = stripped(std::string_view(names).substr(from, comma - from)); !name.empty())
      out.others.emplace_back(name);
    from = comma + 1;
  }
  if (out.word.empty())
    reading.error(item.place, tr("an entry of the glossary without its word"),
                  tr("begin it with the word in two stars: - **crease**, creases: what it means"));
  else if (plainText(out.meaning).empty())
    reading.error(item.place, trf("'{0}' has no meaning here", out.word),
                  tr("write it behind a colon: - **crease**, creases: what it means"));
  else
    words.push_back(std::move(out));
}

/// Reports words that are given twice; the first one counts.
void checkTwins(Reading& reading, std::vector<GlossaryWord>& words) {
  std::map<std::string, std::size_t> lines;
  for (GlossaryWord& word : words) {
    std::vector<std::string> names = word.others;
    names.push_back(word.word);
    std::set<std::string> own;
    for (const std::string& name : names) {
      if (!own.insert(slug(name)).second) continue;
      if (const auto [twin, is_new] = lines.emplace(slug(name), word.place.line); !is_new)
        reading.error(word.place, trf("'{0}' is explained twice", name),
                      trf("take one of the two out; the other is on line {0}", twin->second));
    }
  }
}

/// Ignores the case of the first letter, as at the start of sentences; U+00C0 to U+00DE are the capitals of Latin-1.
bool sameBeginning(char32_t a, char32_t b) {
  const auto small = [](char32_t c) {
    return (c >= 'A' && c <= 'Z') || (c >= 0xC0 && c <= 0xDE && c != 0xD7) ? c + 0x20 : c;
  };
  return small(a) == small(b);
}

bool matchesAt(std::string_view text, std::size_t at, std::string_view name) {
  const CodePoint a = firstCodePoint(text.substr(at)), b = firstCodePoint(name);
  if (!a.valid || !b.valid || !sameBeginning(a.code, b.code)) return false;
  const std::string_view rest = text.substr(at + a.bytes), wanted = name.substr(b.bytes);
  if (!rest.starts_with(wanted)) return false;
  const std::string_view behind = rest.substr(wanted.size());
  // "pit-shaped" is a different word.
  return !beginsWithLetter(behind) && !(behind.starts_with('-') && beginsWithLetter(behind.substr(1)));
}

/// Links the first occurrence of each word in the texts of one step.
class Linker {
 public:
  explicit Linker(const std::vector<GlossaryWord>& words) {
    for (const GlossaryWord& word : words) {
      names_.emplace_back(word.word, &word);
      for (const std::string& other : word.others) names_.emplace_back(other, &word);
    }
    // Longest first: "hydrogen bond" before "hydrogen".
    std::stable_sort(names_.begin(), names_.end(),
                     [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
  }

  void blocks(std::vector<Block>& blocks) {
    done_.clear();
    // A word that the author has linked explicitly needs no further link.
    for (Block& b : blocks)
      visit(b, [&](RichText& text) {
        for (const TextRun& run : text)
          if (const auto to = wordLink(run.link))
            for (const auto& [name, word] : names_)
              if (slug(name) == *to) done_.insert(slug(word->word));
      });
    for (Block& b : blocks) visit(b, [&](RichText& text) { link(text); });
  }

 private:
  template <class Visit>
  static void visit(Block& block, const Visit& text) {
    if (auto* p = std::get_if<Paragraph>(&block)) text(p->text);
    if (auto* l = std::get_if<ListBlock>(&block))
      for (ListBlock::Item& item : l->items) text(item.text);
    if (auto* t = std::get_if<Tip>(&block))
      for (RichText& p : t->paragraphs) text(p);
    if (auto* q = std::get_if<Quote>(&block))
      for (RichText& p : q->paragraphs) text(p);
    if (auto* t = std::get_if<Table>(&block))
      for (std::vector<RichText>& row : t->rows)
        for (RichText& cell : row) text(cell);
  }

  void link(RichText& text) {
    for (std::size_t k = 0; k < text.size(); ++k) {
      if (text[k].code || !text[k].link.empty() || text[k].script != Script::None) continue;
      for (std::size_t at = 0; at < text[k].text.size(); ++at) {
        const std::string_view all = text[k].text;
        if (!beginsWithLetter(all.substr(at)) || (at > 0 && (endsInLetter(all.substr(0, at)) || all[at - 1] == '-')) ||
            (at == 0 && k > 0 && endsInLetter(text[k - 1].text)))
          continue;
        const auto name = std::find_if(names_.begin(), names_.end(), [&](const auto& n) {
          return matchesAt(all, at, n.first) && !done_.contains(slug(n.second->word));
        });
        if (name == names_.end()) continue;
        const std::string id = slug(name->second->word);
        done_.insert(id);
        TextRun before = text[k], word = text[k], after = text[k];
        before.text = std::string(all.substr(0, at));
        word.text = std::string(all.substr(at, name->first.size()));
        after.text = std::string(all.substr(at + name->first.size()));
        word.link = std::string(kLink) + id;
        word.link_place = word.place;
        text[k] = std::move(word);
        if (!after.text.empty()) text.insert(text.begin() + std::ptrdiff_t(k) + 1, std::move(after));
        if (!before.text.empty()) text.insert(text.begin() + std::ptrdiff_t(k++), std::move(before));
        break;
      }
    }
  }

  std::vector<std::pair<std::string, const GlossaryWord*>> names_;  // the longest first
  std::set<std::string> done_;
};

}  // namespace

namespace reading {

void readWords(Reading& reading, const MarkdownBlock& block, std::vector<GlossaryWord>& words) {
  if (block.kind == Kind::Code && !block.info.empty())
    reading.error(block.place, trf("a {0} block in the glossary", block.info),
                  tr("start the step that it belongs to with '## …', or move it above the glossary"));
  if (block.kind != Kind::List) return;
  const std::size_t before = words.size();
  for (const MarkdownBlock& item : block.children) readWord(reading, item, words);
  if (words.size() > before) checkTwins(reading, words);
}

}  // namespace reading

bool isGlossaryHeading(std::string_view heading) {
  const std::string id = slug(heading);
  return id == "glossary" || id == "glossar";
}

bool isGlossaryFile(const fs::path& file) { return file.extension() == ".md" && lessonName(file).id == kFileName; }

Glossary readGlossary(const std::string& name, std::string bytes) {
  Glossary out;
  out.file = name;
  const SourceText source(name, std::move(bytes));
  Reading reading{source, {}, {}};
  if (source.bytes().size() > kLargestLesson)
    reading.error({1, 1}, tr("a glossary of more than 1 MiB"), tr("take some words out"));
  else if (const std::size_t bad = firstBadByte(source.bytes()); bad != std::string_view::npos)
    reading.error(source.at(bad), tr("this is not UTF-8 text"), tr("save the file in the encoding UTF-8"));
  else if (const auto tree = parseMarkdown(source, 0); !tree)
    reading.errors.push_back(tree.problem());
  else {
    for (const MarkdownBlock& block : tree->children) reading::readWords(reading, block, out.words);
    for (const Problem& slip : tree->slips) reading.warnings.push_back(slip);
    if (out.words.empty() && reading.errors.empty())
      reading.warning({1, 1}, tr("a glossary without words"),
                      tr("write a line for each: - **crease**, creases: what it means"));
  }
  orderProblems(reading.errors);
  out.errors = std::move(reading.errors);
  out.warnings = std::move(reading.warnings);
  return out;
}

Glossary glossaryBeside(const fs::path& lesson_file, std::string_view language) {
  // If the file's name gives a language, a glossary in another language does not fit.
  const std::string named = lessonName(lesson_file).language;
  std::vector<std::string> endings;
  if (!named.empty() || !language.empty()) endings.push_back("." + (named.empty() ? std::string(language) : named));
  if (named.empty()) endings.emplace_back();
  for (const std::string& ending : endings) {
    const fs::path file = lesson_file.parent_path() / (std::string(kFileName) + ending + ".md");
    std::error_code error;
    if (!fs::is_regular_file(file, error)) continue;
    Expected<std::string> bytes = readLessonFile(file);
    if (bytes) return readGlossary(file.string(), *std::move(bytes));
    Glossary out;
    out.file = file;
    out.errors.push_back(bytes.problem());
    return out;
  }
  return {};
}

std::optional<std::string> wordLink(std::string_view link) {
  if (!link.starts_with(kLink)) return std::nullopt;
  return slug(link.substr(kLink.size()));
}

const GlossaryWord* findWord(const Lesson& lesson, std::string_view id) {
  for (const GlossaryWord& word : lesson.glossary) {
    if (slug(word.word) == id) return &word;
    for (const std::string& other : word.others)
      if (slug(other) == id) return &word;
  }
  return nullptr;
}

void linkWords(Lesson& lesson, const Glossary& shared) {
  for (const GlossaryWord& word : shared.words)
    if (!findWord(lesson, slug(word.word))) lesson.glossary.push_back(word);
  if (lesson.glossary.empty()) return;
  Linker linker(lesson.glossary);
  linker.blocks(lesson.introduction);
  for (Step& step : lesson.steps) linker.blocks(step.blocks);
}

}  // namespace moltact
