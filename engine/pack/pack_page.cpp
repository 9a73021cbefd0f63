#include "engine/pack/pack_page.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "engine/language/catalogue.h"
#include "engine/pack/pack_file.h"

namespace moltact {
namespace {

// The placeholder in app/web/page.html, before the program, so that the lesson is present when the program starts.
constexpr std::string_view kPlace = "<!--a lesson comes here-->";

// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
  static constexpr std::string_view kSigns = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::array<std::uint32_t, 3> part{};
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    for (std::size_t k = 0; k < count; ++k) part[k] = static_cast<unsigned char>(bytes[at + k]);
    const std::uint32_t all = part[0] << 16 | part[1] << 8 | part[2];
    for (std::size_t k = 0; k < 4; ++k) out += k <= count ? kSigns[all >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

// Escapes text for an attribute between double quotes.
std::string attribute(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '<':
        out += "&lt;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace

PageElement packElement(const std::string& id, const std::string& name, std::string_view pack) {
  return {id, "text/plain", base64(pack), {{"data-name", name + kPackEnding}}};
}

Expected<std::string> pageWithElements(std::string page, const std::string& page_file,
                                       const std::vector<PageElement>& elements) {
  const std::size_t place = page.find(kPlace);
  if (place == std::string::npos)
    return Problem{page_file, 0, 0, tr("it is no page of the browser edition, or holds a lesson already"),
                   tr("name the moltact.html that './run.sh web' made or that came with the program")};
  std::string all;
  for (const PageElement& e : elements) {
    all += "<script type=\"" + e.type + "\" id=\"" + attribute(e.id) + '"';
    for (const auto& [key, value] : e.attributes) all += ' ' + key + "=\"" + attribute(value) + '"';
    all += '>' + e.text + "</script>";
  }
  page.replace(place, kPlace.size(), all);
  return page;
}

Expected<std::string> pageWithPack(std::string page, const std::string& page_file, const std::string& name,
                                   std::string_view pack,
                                   const std::vector<std::pair<std::string, std::string>>& attributes) {
  PageElement element = packElement("pack-bytes", name, pack);
  element.attributes.insert(element.attributes.end(), attributes.begin(), attributes.end());
  return pageWithElements(std::move(page), page_file, {element});
}

}  // namespace moltact
