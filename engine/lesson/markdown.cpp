#include "engine/lesson/markdown.h"

#include <md4c.h>

#include <charconv>
#include <functional>
#include <utility>

#include "engine/core/text.h"
#include "engine/core/utf8.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/formula.h"
#include "engine/lesson/letters.h"

namespace moltact {
namespace {

using Kind = MarkdownBlock::Kind;

/// The entities that lesson authors use; all others stay as written.
std::string entityText(std::string_view entity) {
  constexpr std::pair<std::string_view, std::string_view> kKnown[] = {
      {"&amp;", "&"},  {"&lt;", "<"},    {"&gt;", ">"},    {"&quot;", "\""}, {"&apos;", "'"}, {"&nbsp;", "\xC2\xA0"},
      {"&rarr;", "→"}, {"&Aring;", "Å"}, {"&alpha;", "α"}, {"&beta;", "β"},  {"&deg;", "°"},  {"&ndash;", "–"},
  };
  for (const auto& [name, text] : kKnown)
    if (entity == name) return std::string(text);
  if (entity.starts_with("&#") && entity.size() > 3) {
    const bool hex = entity[2] == 'x' || entity[2] == 'X';
    const std::string_view digits = entity.substr(hex ? 3 : 2, entity.size() - (hex ? 4 : 3));
    unsigned code = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, hex ? 16 : 10);
    const bool whole = error == std::errc{} && end == digits.data() + digits.size();
    if (whole && code > 0 && code < 0x110000 && (code < 0xD800 || code >= 0xE000)) {
      return utf8Of(code);
    }
  }
  return std::string(entity);
}

std::string attributeText(const MD_ATTRIBUTE& attribute) {
  std::string out;
  for (int i = 0; attribute.size > 0 && attribute.substr_offsets[i] < attribute.size; ++i) {
    const MD_OFFSET begin = attribute.substr_offsets[i];
    const std::string_view part(attribute.text + begin, attribute.substr_offsets[i + 1] - begin);
    out += attribute.substr_types[i] == MD_TEXT_ENTITY ? entityText(part) : std::string(part);
  }
  return out;
}

class Builder {
 public:
  Builder(const SourceText& source, std::size_t from) : source_(source), offset_(from) { stack_.emplace_back(); }

  Expected<MarkdownBlock> build() {
    MD_PARSER parser{};
    parser.flags = MD_FLAG_TASKLISTS | MD_FLAG_PERMISSIVEURLAUTOLINKS | MD_FLAG_NOINDENTEDCODEBLOCKS | MD_FLAG_TABLES |
                   MD_FLAG_LATEXMATHSPANS;
    parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* self) { return of(self).enter(type, detail); };
    parser.leave_block = [](MD_BLOCKTYPE type, void*, void* self) { return of(self).leave(type); };
    parser.enter_span = [](MD_SPANTYPE type, void* detail, void* self) { return of(self).span(type, detail, 1); };
    parser.leave_span = [](MD_SPANTYPE type, void* detail, void* self) { return of(self).span(type, detail, -1); };
    parser.text = [](MD_TEXTTYPE type, const char* text, MD_SIZE size, void* self) {
      return of(self).text(type, {text, size});
    };
    const std::string_view body = source_.bytes().substr(offset_);
    const int status = md_parse(body.data(), static_cast<MD_SIZE>(body.size()), &parser, this);
    if (status == 0) return std::move(stack_.front());
    const Place place = source_.at(offset_);
    if (status == kTooDeep)
      return Problem{source_.name(), place.line, place.column, tr("lists and quotes are nested too deeply"),
                     tr("use fewer levels")};
    return Problem{source_.name(), place.line, place.column, tr("this text cannot be parsed as Markdown"),
                   tr("look for very long or broken lines here")};
  }

 private:
  static constexpr int kTooDeep = 1;

  static Builder& of(void* self) { return *static_cast<Builder*>(self); }

  /// Tracks md4c's position in the source: most texts that it passes are views of the source.
  Place follow(const char* text) {
    if (inSource(text)) offset_ = static_cast<std::size_t>(text - source_.bytes().data());
    return source_.at(offset_);
  }

  bool inSource(const char* text) const {
    const std::string_view all = source_.bytes();
    const std::less<const char*> before;
    return text && !before(text, all.data()) && before(text, all.data() + all.size());
  }

  void push(Kind kind) {
    stack_.emplace_back();
    stack_.back().kind = kind;
  }

  int enter(MD_BLOCKTYPE type, void* detail) {
    if (stack_.size() > kDeepestMarkdown) return kTooDeep;
    tag_script_ = Script::None;
    after_formula_ = false;
    switch (type) {
      case MD_BLOCK_QUOTE:
        push(Kind::Quote);
        break;
      case MD_BLOCK_UL:
        push(Kind::List);
        break;
      case MD_BLOCK_OL:
        push(Kind::List);
        stack_.back().ordered = true;
        stack_.back().start = static_cast<int>(static_cast<MD_BLOCK_OL_DETAIL*>(detail)->start);
        break;
      case MD_BLOCK_LI: {
        push(Kind::Item);
        const auto& item = *static_cast<MD_BLOCK_LI_DETAIL*>(detail);
        stack_.back().is_task = item.is_task != 0;
        stack_.back().ticked = item.is_task && item.task_mark != ' ';
        break;
      }
      case MD_BLOCK_HR:
        push(Kind::Rule);
        break;
      case MD_BLOCK_H:
        push(Kind::Heading);
        stack_.back().level = static_cast<int>(static_cast<MD_BLOCK_H_DETAIL*>(detail)->level);
        break;
      case MD_BLOCK_CODE: {
        push(Kind::Code);
        const auto& code = *static_cast<MD_BLOCK_CODE_DETAIL*>(detail);
        stack_.back().info = attributeText(code.lang);
        if (code.lang.size) stack_.back().place = follow(code.lang.text);
        line_open_ = false;
        break;
      }
      case MD_BLOCK_HTML:
        push(Kind::Html);
        break;
      case MD_BLOCK_P:
        push(Kind::Paragraph);
        break;
      case MD_BLOCK_TABLE:
        push(Kind::Table);
        break;
      case MD_BLOCK_TR:
        push(Kind::Row);
        break;
      case MD_BLOCK_TH:
      case MD_BLOCK_TD: {
        push(Kind::Cell);
        const MD_ALIGN align = static_cast<MD_BLOCK_TD_DETAIL*>(detail)->align;
        stack_.back().side = align == MD_ALIGN_CENTER  ? Table::Side::Middle
                             : align == MD_ALIGN_RIGHT ? Table::Side::Right
                                                       : Table::Side::Left;
        break;
      }
      default:
        break;
    }
    return 0;
  }

  int leave(MD_BLOCKTYPE type) {
    const bool no_block = type == MD_BLOCK_DOC || type == MD_BLOCK_THEAD || type == MD_BLOCK_TBODY;
    if (no_block || stack_.size() < 2) return 0;
    MarkdownBlock done = std::move(stack_.back());
    stack_.pop_back();
    if (done.place.line == 0)
      done.place = !done.children.empty()       ? done.children.front().place
                   : done.kind == Kind::Heading ? emptyHeading()
                                                : source_.at(offset_);
    stack_.back().children.push_back(std::move(done));
    return 0;
  }

  /// md4c gives no place for an empty heading: it is the next line that consists only of its marks.
  Place emptyHeading() const {
    const std::string_view bytes = source_.bytes();
    for (std::size_t at = bytes.find('\n', offset_); at != std::string_view::npos; at = bytes.find('\n', at + 1)) {
      const std::string_view line = stripped(bytes.substr(at + 1, bytes.substr(at + 1).find('\n')));
      if (!line.empty() && line.find_first_not_of('#') == std::string_view::npos) return source_.at(at + 1);
    }
    return source_.at(offset_);
  }

  int span(MD_SPANTYPE type, void* detail, int step) {
    switch (type) {
      case MD_SPAN_EM:
        italic_ += step;
        break;
      case MD_SPAN_STRONG:
        bold_ += step;
        break;
      case MD_SPAN_CODE:
        code_ += step;
        break;
      case MD_SPAN_A:
        links_ += step;
        if (step < 0) placeLink();
        link_ = links_ > 0 ? attributeText(static_cast<MD_SPAN_A_DETAIL*>(detail)->href) : std::string();
        break;
      case MD_SPAN_IMG:
        images_ += step;
        if (step > 0 && images_ == 1) {
          // md4c gives no place for a picture: it is the next one after the text so far.
          const std::size_t at = source_.bytes().find("![", offset_);
          const auto& image = *static_cast<MD_SPAN_IMG_DETAIL*>(detail);
          stack_.back().images.push_back({.path = attributeText(image.src),
                                          .description = {},
                                          .caption = attributeText(image.title),
                                          .place = source_.at(at == std::string_view::npos ? offset_ : at)});
        }
        break;
      case MD_SPAN_LATEXMATH:
      case MD_SPAN_LATEXMATH_DISPLAY:
        if (step > 0)
          formula_.clear();
        else
          addFormula(type == MD_SPAN_LATEXMATH_DISPLAY);
        break;
      default:
        break;
    }
    return 0;
  }

  /// A formula on a line of its own is separated from the surrounding text.
  void addFormula(bool own_line) {
    MarkdownBlock& block = stack_.back();
    // "$5 and then $6" are prices: a formula has no blank at either end.
    if (!own_line && (formula_.empty() || formula_.front() == ' ' || formula_.back() == ' ')) {
      if (images_ == 0)
        addRun(block.text, {.text = "$" + formula_ + "$",
                            .bold = bold_ > 0,
                            .italic = italic_ > 0,
                            .link = link_,
                            .place = formula_place_});
      return;
    }
    std::vector<Problem> faults;
    RichText runs = formulaText(formula_, formula_place_, faults);
    for (Problem& fault : faults) {
      fault.file = source_.name();
      // For a formula over several lines, the place is its first character.
      if (formula_wraps_) fault.column = formula_place_.column;
      stack_.front().slips.push_back(std::move(fault));
    }
    if (images_ > 0) {
      if (!block.images.empty()) block.images.back().description += plainText(runs);
      return;
    }
    if (own_line && !block.text.empty()) addRun(block.text, {.text = "\n", .place = formula_place_});
    for (TextRun& run : runs) {
      run.bold = bold_ > 0;
      run.link = link_;
      addRun(block.text, std::move(run));
    }
    after_formula_ = own_line;
  }

  /// At the end of a link: sets the place of the target, "](target", in its runs, or their own place if the target is
  /// not written.
  void placeLink() {
    const std::string_view line = source_.bytes().substr(offset_, source_.bytes().substr(offset_).find('\n'));
    const std::size_t bracket = line.find("](");
    const bool written = bracket != std::string_view::npos && stripped(line.substr(bracket + 2)).starts_with(link_);
    // The link's runs are the last ones.
    for (auto run = stack_.back().text.rbegin();
         run != stack_.back().text.rend() && run->link == link_ && run->link_place.line == 0; ++run)
      run->link_place = written ? source_.at(offset_ + bracket + 2) : run->place;
  }

  int text(MD_TEXTTYPE type, std::string_view piece) {
    const Place place = follow(piece.data());
    MarkdownBlock& block = stack_.back();
    if (block.place.line == 0) block.place = place;
    if (block.kind == Kind::Code) {
      codeText(piece, place);
    } else if (type == MD_TEXT_LATEXMATH) {
      if (formula_.empty()) formula_place_ = place, formula_wraps_ = false;
      formula_wraps_ = formula_wraps_ || place.line != formula_place_.line;
      formula_ += piece;
    } else {
      std::string words;
      bool plain = false;
      switch (type) {
        case MD_TEXT_BR:
          words = "\n";
          break;
        case MD_TEXT_SOFTBR:
          words = " ";
          break;
        case MD_TEXT_ENTITY:
          words = entityText(piece);
          break;
        case MD_TEXT_NULLCHAR:
          words = "\xEF\xBF\xBD";
          break;
        case MD_TEXT_HTML:
          if (block.kind != Kind::Html) {
            if (!takeTag(piece)) {
              stack_.front().lines.push_back({std::string(piece), place});
              return 0;
            }
            if (tag_break_) words = "\n";
            break;
          }
          [[fallthrough]];
        default:
          words = std::string(piece);
          plain = type == MD_TEXT_NORMAL;
      }
      if (std::exchange(after_formula_, false) && !words.empty()) words = words == " " ? "\n" : "\n" + words;
      if (images_ > 0) {
        if (!block.images.empty()) block.images.back().description += words;
        return 0;
      }
      const TextRun run{.text = {},
                        .bold = bold_ > 0,
                        .italic = italic_ > 0,
                        .code = code_ > 0,
                        .script = tag_script_,
                        .link = link_,
                        .place = place};
      if (plain && code_ == 0 && tag_script_ == Script::None)
        addWithScripts(block.text, run, words, escaped(piece));
      else if (!words.empty())
        addRun(block.text, withText(run, std::move(words)));
    }
    // Skip the bytes just passed.
    if (inSource(piece.data())) offset_ += piece.size();
    return 0;
  }

  /// Handles <sub>, <sup> and <br>, as in HTML pages; returns false for other tags.
  bool takeTag(std::string_view tag) {
    const std::string name = lower(std::string(tag));
    tag_break_ = name == "<br>" || name == "<br/>" || name == "<br />";
    if (name == "<sub>")
      tag_script_ = Script::Sub;
    else if (name == "<sup>")
      tag_script_ = Script::Super;
    else if (name == "</sub>" || name == "</sup>")
      tag_script_ = Script::None;
    else
      return tag_break_;
    return true;
  }

  /// Whether the piece begins with an escaped character: "\~".
  bool escaped(std::string_view piece) const {
    const std::string_view all = source_.bytes();
    if (!inSource(piece.data())) return false;
    const auto at = static_cast<std::size_t>(piece.data() - all.data());
    return at > 0 && all[at - 1] == '\\';
  }

  static TextRun withText(TextRun run, std::string words) {
    run.text = std::move(words);
    return run;
  }

  /// Splits "H~2~O" and "10^-9^": a script is enclosed in two marks and contains no blank. A mark after a blank ("~5
  /// Å") does not begin a subscript, which follows a letter or number.
  void addWithScripts(RichText& text, const TextRun& run, std::string_view words, bool first_escaped) {
    std::size_t done = 0;
    const auto take = [&](std::size_t from, std::size_t to, Script script) {
      if (from >= to) return;
      TextRun part = withText(run, std::string(words.substr(from, to - from)));
      part.script = script;
      part.place.column += characterCount(words.substr(0, from));
      addRun(text, std::move(part));
    };
    const auto hangs = [&](std::size_t at) {
      const std::string_view before = at > 0         ? words.substr(0, at)
                                      : text.empty() ? std::string_view()
                                                     : text.back().text;
      return !before.empty() && (endsInLetter(before) || before.back() == ')' || before.back() == ']');
    };
    for (std::size_t at = first_escaped ? 1 : 0; at < words.size(); ++at) {
      const char sign = words[at];
      if (sign != '~' && sign != '^') continue;
      const std::size_t end = words.find_first_of("~^ \n", at + 1);
      const bool closed = end != std::string_view::npos && words[end] == sign && end > at + 1;
      if (closed && (sign == '^' || hangs(at))) {
        take(done, at, Script::None);
        take(at + 1, end, sign == '~' ? Script::Sub : Script::Super);
        done = end + 1;
        at = end;
      } else if (!closed && hangs(at) && at + 1 < words.size() && isScriptStart(words.substr(at + 1), sign)) {
        const std::size_t word_end = std::min(words.find_first_of(" \n,.;:)", at + 1), words.size());
        stack_.front().slips.push_back({source_.name(), run.place.line,
                                        run.place.column + characterCount(words.substr(0, at)),
                                        sign == '^' ? tr("'^' begins no superscript here, for none ends it")
                                                    : tr("'~' begins no subscript here, for none ends it"),
                                        trf("close it: {0}", std::string(words.substr(at, word_end - at)) + sign)});
      }
    }
    take(done, words.size(), Script::None);
  }

  /// Whether a mark without its partner was probably meant as a script: an exponent with or without a sign, or an
  /// index.
  static bool isScriptStart(std::string_view text, char sign) {
    if (sign == '^' && (text.starts_with("-") || text.starts_with("+") || text.starts_with("−"))) return true;
    return text[0] >= '0' && text[0] <= '9';
  }

  static void addRun(RichText& text, TextRun run) {
    if (!text.empty()) {
      TextRun& last = text.back();
      if (last.bold == run.bold && last.italic == run.italic && last.code == run.code && last.script == run.script &&
          last.link == run.link) {
        last.text += run.text;
        return;
      }
    }
    text.push_back(std::move(run));
  }

  void codeText(std::string_view piece, Place place) {
    std::vector<BlockLine>& lines = stack_.back().lines;
    while (!piece.empty()) {
      const std::size_t end = piece.find('\n');
      if (!line_open_) {
        lines.push_back({{}, place});
        line_placed_ = false;
      }
      // md4c passes a line's indentation as separate spaces; only the text after it gives the line's place.
      if (!line_placed_ && inSource(piece.data())) {
        std::string& indentation = lines.back().text;
        // A tab is passed as up to four spaces, but is one character of the file.
        if (place.column <= indentation.size()) indentation.assign(place.column - 1, '\t');
        lines.back().place = {place.line, place.column - indentation.size()};
        line_placed_ = true;
      }
      lines.back().text += piece.substr(0, end);
      line_open_ = end == std::string_view::npos;
      piece.remove_prefix(line_open_ ? piece.size() : end + 1);
    }
  }

  const SourceText& source_;
  std::size_t offset_;
  std::vector<MarkdownBlock> stack_;
  int bold_ = 0, italic_ = 0, code_ = 0, links_ = 0, images_ = 0;
  std::string link_, formula_;
  Place formula_place_;
  bool formula_wraps_ = false;        // it covers several lines
  Script tag_script_ = Script::None;  // of the open HTML tag
  bool tag_break_ = false;            // the last tag was a line break
  bool after_formula_ = false;        // after a formula on a line of its own: further text begins another line
  bool line_open_ = false, line_placed_ = false;
};

}  // namespace

Expected<MarkdownBlock> parseMarkdown(const SourceText& source, std::size_t from) {
  return Builder(source, from).build();
}

}  // namespace moltact
