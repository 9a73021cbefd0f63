#include "engine/language/mo_file.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "engine/core/file_bytes.h"
#include "engine/core/text.h"
#include "engine/core/utf8.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::uint32_t kMagic = 0x950412de, kMagicSwapped = 0xde120495;
constexpr std::size_t kHeader = 28;
constexpr char kContextEnd = '\4';

std::uint32_t swapped(std::uint32_t v) { return v >> 24 | (v >> 8 & 0xff00u) | (v << 8 & 0xff0000u) | v << 24; }

struct Words {
  std::string_view bytes;
  bool swap = false;
  // The caller ensures that the four bytes exist.
  std::size_t at(std::size_t offset) const {
    const auto v = numberAt<std::uint32_t>(bytes.data() + offset);
    return swap ? swapped(v) : v;
  }
};

// The value of a line "Name: value" of the catalogue's header.
std::string_view headerLine(std::string_view header, std::string_view name) {
  for (std::size_t from = 0; from < header.size();) {
    const std::size_t end = std::min(header.find('\n', from), header.size());
    const std::string_view line = header.substr(from, end - from);
    if (line.starts_with(name) && line.substr(name.size()).starts_with(':'))
      return trimmed(line.substr(name.size() + 1));
    from = end + 1;
  }
  return {};
}

Problem broken(std::string message) { return {{}, 0, 0, std::move(message), tr("compile it again with msgfmt")}; }

}  // namespace

Expected<MoFile> MoFile::parse(std::string given) {
  MoFile out;
  out.bytes_ = std::move(given);
  const std::string_view bytes = out.bytes_;
  if (bytes.size() > kMaxCatalogueBytes)
    return broken(tr("it is larger than a catalogue of translations may be (4 MB)"));
  if (bytes.size() < kHeader) return broken(tr("it is no catalogue of translations"));
  const auto magic = numberAt<std::uint32_t>(bytes.data());
  if (magic != kMagic && magic != kMagicSwapped) return broken(tr("it is no catalogue of translations"));
  const Words words{bytes, magic == kMagicSwapped};
  if (words.at(4) >> 16 > 1) return broken(tr("it is a catalogue of a kind that came after this program"));
  const std::size_t count = words.at(8), originals = words.at(12), translations = words.at(16);
  for (const std::size_t table : {originals, translations})
    if (table > bytes.size() || count > (bytes.size() - table) / 8) return broken(tr("its tables leave the file"));
  const auto text = [&](std::size_t table, std::size_t k) -> std::optional<Text> {
    const Text t{words.at(table + 8 * k + 4), words.at(table + 8 * k)};
    if (t.at >= bytes.size() || t.size >= bytes.size() - t.at || bytes[t.at + t.size] != '\0') return std::nullopt;
    return t;
  };
  out.entries_.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto original = text(originals, k), translation = text(translations, k);
    if (!original || !translation) return broken(tr("a text leaves the file"));
    for (const Text& piece : {*original, *translation})
      if (firstNotUtf8(out.view(piece)) != std::string_view::npos) return broken(tr("a text is not UTF-8"));
    if (original->size == 0) {
      const std::string_view rule = headerLine(out.view(*translation), "Plural-Forms");
      if (rule.empty()) continue;
      const auto plural = PluralRule::parse(rule);
      if (!plural) return broken(trf("'{0}' is no rule for plurals", rule.substr(0, 80)));
      out.plural_ = *plural;
      continue;
    }
    Entry e{{}, *original, *translation};
    std::string_view english = out.view(e.english);
    if (const std::size_t end = english.find(kContextEnd); end != std::string_view::npos) {
      e.context = {e.english.at, end};
      e.english = {e.english.at + end + 1, e.english.size - end - 1};
      english = out.view(e.english);
    }
    e.english.size = std::min(english.find('\0'), english.size());
    out.entries_.push_back(e);
  }
  std::sort(out.entries_.begin(), out.entries_.end(), [&](const Entry& a, const Entry& b) {
    return std::pair(out.view(a.english), out.view(a.context)) < std::pair(out.view(b.english), out.view(b.context));
  });
  return out;
}

const MoFile::Entry* MoFile::entry(std::string_view context, std::string_view english) const noexcept {
  const std::pair wanted(english, context);
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), wanted, [&](const Entry& e, const auto& w) {
    return std::pair(view(e.english), view(e.context)) < w;
  });
  return at != entries_.end() && view(at->english) == english && view(at->context) == context ? &*at : nullptr;
}

const char* MoFile::find(std::string_view context, std::string_view english) const noexcept {
  const Entry* e = entry(context, english);
  return e && bytes_[e->translation.at] != '\0' ? bytes_.data() + e->translation.at : nullptr;  // NUL-terminated
}

const char* MoFile::findPlural(std::string_view one, unsigned long n) const noexcept {
  const Entry* e = entry({}, one);
  if (!e) return nullptr;
  std::string_view forms = view(e->translation);
  for (unsigned long skip = plural_.form(n); skip > 0; --skip) {
    const std::size_t end = forms.find('\0');
    if (end == std::string_view::npos) return nullptr;
    forms.remove_prefix(end + 1);
  }
  return forms.empty() || forms.front() == '\0' ? nullptr : forms.data();
}

}  // namespace moltact
