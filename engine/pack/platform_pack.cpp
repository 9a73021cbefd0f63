#include "engine/pack/platform_pack.h"

#include <algorithm>
#include <utility>

#include "engine/core/content_hash.h"
#include "engine/core/markup.h"
#include "engine/language/catalogue.h"
#include "engine/pack/pack_page.h"
#include "engine/pack/write_pack.h"

namespace moltact {
namespace {

constexpr const char* kStartPage = "index.html";

std::string languageOf(const PlatformCourse& course) { return course.language.empty() ? "und" : course.language; }

// XML has no U+FFFE and U+FFFF, though UTF-8 encodes them: they become U+FFFD.
std::string xmlText(std::string_view text) {
  std::string out = escaped(text);
  for (std::size_t at = 0; (at = out.find("\xEF\xBF", at)) != std::string::npos; at += 2)
    if (at + 2 < out.size() && (out[at + 2] == '\xBE' || out[at + 2] == '\xBF')) out[at + 2] = '\xBD';
  return out;
}

// An XML name (NCName): letters of ASCII, digits and -.
std::string identifierOf(const PlatformCourse& course) {
  std::string out = "moltact-";
  for (const char c : course.name)
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-') out += c;
  out.resize(std::min<std::size_t>(out.size(), 60));
  return out + '-' + contentHash(course.name + '\n' + course.title);
}

std::string scorm12(const PlatformCourse& course) {
  const std::string title = xmlText(course.title);
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier=")" +
         identifierOf(course) +
         R"(" version="1.0" xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2" xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>1.2</schemaversion>
  </metadata>
  <organizations default="lesson-organization">
    <organization identifier="lesson-organization">
      <title>)" +
         title + R"(</title>
      <item identifier="lesson-item" identifierref="lesson-page">
        <title>)" +
         title + R"(</title>
      </item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="lesson-page" type="webcontent" adlcp:scormtype="sco" href=")" +
         kStartPage + R"(">
      <file href=")" +
         kStartPage + R"("/>
    </resource>
  </resources>
</manifest>
)";
}

std::string scorm2004(const PlatformCourse& course) {
  const std::string title = xmlText(course.title);
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier=")" +
         identifierOf(course) +
         R"(" version="1.0" xmlns="http://www.imsglobal.org/xsd/imscp_v1p1" xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_v1p3" xmlns:imsss="http://www.imsglobal.org/xsd/imsss">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>2004 4th Edition</schemaversion>
  </metadata>
  <organizations default="lesson-organization">
    <organization identifier="lesson-organization">
      <title>)" +
         title + R"(</title>
      <item identifier="lesson-item" identifierref="lesson-page">
        <title>)" +
         title + R"(</title>
        <imsss:sequencing>
          <imsss:deliveryControls completionSetByContent="true" objectiveSetByContent="true"/>
        </imsss:sequencing>
      </item>
      <imsss:sequencing>
        <imsss:controlMode choice="true" flow="true"/>
      </imsss:sequencing>
    </organization>
  </organizations>
  <resources>
    <resource identifier="lesson-page" type="webcontent" adlcp:scormType="sco" href=")" +
         kStartPage + R"(">
      <file href=")" +
         kStartPage + R"("/>
    </resource>
  </resources>
</manifest>
)";
}

std::string cmi5(const PlatformCourse& course) {
  const std::string iri = lessonIri(course), language = xmlText(languageOf(course));
  const auto text = [&](const char* element, const std::string& words, const std::string& indent) {
    return indent + '<' + element + ">\n" + indent + "  <langstring lang=\"" + language + "\">" + xmlText(words) +
           "</langstring>\n" + indent + "</" + element + ">\n";
  };
  const std::string about = course.description.empty() ? course.title : course.description;
  const auto named = [&](const std::string& title, const std::string& description, const std::string& indent) {
    return text("title", title, indent) + text("description", description, indent);
  };
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<courseStructure xmlns=\"https://w3id.org/xapi/profiles/cmi5/v1/CourseStructure.xsd\">\n"
      "  <course id=\"" +
      iri + "#course\">\n" + named(course.title, about, "    ") + "  </course>\n";
  std::string uses;
  if (!course.goals.empty()) {
    out += "  <objectives>\n";
    for (std::size_t k = 0; k < course.goals.size(); ++k) {
      const std::string goal = iri + "#goal_" + std::to_string(k + 1);
      out += "    <objective id=\"" + goal + "\">\n" + named(course.goals[k], course.goals[k], "      ") +
             "    </objective>\n";
      uses += "      <objective idref=\"" + goal + "\"/>\n";
    }
    out += "  </objectives>\n";
    uses = "    <objectives>\n" + uses + "    </objectives>\n";
  }
  return out + "  <au id=\"" + iri + "\" moveOn=\"Completed\" launchMethod=\"AnyWindow\">\n" +
         named(course.title, about, "    ") + uses + "    <url>" + kStartPage + "</url>\n  </au>\n</courseStructure>\n";
}

}  // namespace

std::string_view nameOf(LearningPlatform platform) {
  switch (platform) {
    case LearningPlatform::Scorm12:
      return "1.2";
    case LearningPlatform::Scorm2004:
      return "2004";
    case LearningPlatform::Cmi5:
      return "cmi5";
  }
  return "1.2";
}

std::string_view manifestName(LearningPlatform platform) {
  return platform == LearningPlatform::Cmi5 ? "cmi5.xml" : "imsmanifest.xml";
}

std::string lessonIri(const PlatformCourse& course) {
  std::string hex = contentHash(course.name + '\n' + course.title) + contentHash(course.title + '\n' + course.name);
  hex[12] = '8';
  hex[16] = "89ab"[static_cast<unsigned char>(hex[16]) & 3u];
  return "urn:uuid:" + hex.substr(0, 8) + '-' + hex.substr(8, 4) + '-' + hex.substr(12, 4) + '-' + hex.substr(16, 4) +
         '-' + hex.substr(20);
}

std::string platformManifest(LearningPlatform platform, const PlatformCourse& course) {
  switch (platform) {
    case LearningPlatform::Scorm12:
      return scorm12(course);
    case LearningPlatform::Scorm2004:
      return scorm2004(course);
    case LearningPlatform::Cmi5:
      return cmi5(course);
  }
  return {};
}

Expected<std::string> platformZip(LearningPlatform platform, const PlatformCourse& course, std::string page,
                                  const std::string& page_file, std::string_view pack) {
  if (page.find("id=\"platform-script\"") == std::string::npos &&
      page.find("<!--a lesson comes here-->") != std::string::npos)
    return Problem{page_file, 0, 0,
                   tr("this browser edition is of an earlier version, which knows no learning platform"),
                   tr("make it anew with './run.sh web'")};
  Expected<std::string> whole =
      pageWithPack(std::move(page), page_file, course.name, pack,
                   {{"data-platform", std::string(nameOf(platform))}, {"data-lesson", lessonIri(course)}});
  if (!whole) return whole.problem();
  return writeZip(
      {{std::string(manifestName(platform)), platformManifest(platform, course)}, {kStartPage, *std::move(whole)}});
}

}  // namespace moltact
