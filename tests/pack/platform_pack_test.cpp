// Zips for learning platforms: identifiers and manifests. `moltact pack --scorm` as a whole is in
// tests/app/pack_command_test.cpp, the lesson in a platform in tests/web/platform_tests.py.
#include "engine/pack/platform_pack.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <regex>
#include <set>

namespace moltact {
namespace {

const std::string kEdition = "<script id=\"platform-script\"></script><!--a lesson comes here-->";

std::string valueOf(const std::string& text, const std::string& begin) {
  const std::size_t at = text.find(begin);
  REQUIRE(at != std::string::npos);
  const std::size_t from = at + begin.size();
  return text.substr(from, text.find('"', from) - from);
}

}  // namespace

TEST_CASE("a lesson's IRI is a UUID of version 8 that follows from name and title only, and differs in 400 lessons") {
  const PlatformCourse one{"first-touch", "First touch", "", "", {}};
  PlatformCourse same = one;
  same.description = "Other words";
  same.language = "de";
  same.goals = {"G"};
  CHECK(lessonIri(one) == lessonIri(same));
  // A fixed value: statements in record stores refer to it.
  CHECK(lessonIri(one) == "urn:uuid:136c676f-9a70-8288-a1af-5187b8b8dc5c");
  std::set<std::string> all;
  for (int name = 0; name < 20; ++name)
    for (int title = 0; title < 20; ++title) {
      const std::string iri = lessonIri({std::to_string(name), std::to_string(title), "", "", {}});
      CHECK(std::regex_match(
          iri, std::regex("urn:uuid:[0-9a-f]{8}-[0-9a-f]{4}-8[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}")));
      all.insert(iri);
    }
  CHECK(all.size() == 400);
}

TEST_CASE("a manifest's identifiers are XML names, for names of any characters and of 300 letters") {
  for (const std::string& name : {std::string("1 lesson"), std::string("für \"alle\" <&>"), std::string(300, 'x')}) {
    CAPTURE(name);
    for (const LearningPlatform platform : {LearningPlatform::Scorm12, LearningPlatform::Scorm2004}) {
      const std::string manifest = platformManifest(platform, {name, "T", "", "", {}});
      const std::string id = valueOf(manifest, "<manifest identifier=\"");
      CHECK(std::regex_match(id, std::regex("[A-Za-z_][A-Za-z0-9._-]{0,99}")));
      // The item refers to the resource, and the default organization is there.
      CHECK(valueOf(manifest, "identifierref=\"") == valueOf(manifest, "<resource identifier=\""));
      CHECK(valueOf(manifest, "<organizations default=\"") == valueOf(manifest, "<organization identifier=\""));
      CHECK(valueOf(manifest, " href=\"") == "index.html");
    }
  }
}

TEST_CASE("cmi5.xml has title and description in the lesson's language, and each goal as an objective that is used") {
  const std::string text =
      platformManifest(LearningPlatform::Cmi5, {"l", "Häm", "Was es <hält>", "de", {"Fühle", "Sage"}});
  CHECK(text.find("<langstring lang=\"de\">Was es &lt;hält&gt;</langstring>") != std::string::npos);
  const std::regex objective("<objective id=\"([^\"]+)\">"), used("<objective idref=\"([^\"]+)\"/>");
  std::set<std::string> defined, referred;
  for (std::sregex_iterator it(text.begin(), text.end(), objective), end; it != end; ++it) defined.insert((*it)[1]);
  for (std::sregex_iterator it(text.begin(), text.end(), used), end; it != end; ++it) referred.insert((*it)[1]);
  CHECK(defined.size() == 2);
  CHECK(defined == referred);
  const std::string bare = platformManifest(LearningPlatform::Cmi5, {"l", "Haem", "", "", {}});
  CHECK(bare.find("objective") == std::string::npos);
  CHECK(bare.find("<description>\n      <langstring lang=\"und\">Haem</langstring>") != std::string::npos);
  // As the schema orders them: course, objectives, unit; in a unit title, description, objectives, address.
  std::size_t at = 0;
  for (const char* element :
       {"<course ", "<objectives>", "<au ", "<title>", "<description>", "<objectives>", "<url>"}) {
    CAPTURE(element);
    at = text.find(element, at);
    REQUIRE(at != std::string::npos);
  }
}

TEST_CASE("U+FFFE and U+FFFF, which XML forbids, become U+FFFD in every manifest; their neighbours stay") {
  const PlatformCourse course{"n", "a\uFFFEb\uFFFF\uFFFEc\uFFFC", "", "de", {"\uFFFFgoal"}};
  for (const LearningPlatform platform :
       {LearningPlatform::Scorm12, LearningPlatform::Scorm2004, LearningPlatform::Cmi5}) {
    const std::string manifest = platformManifest(platform, course);
    CHECK(manifest.find("a\uFFFDb\uFFFD\uFFFDc\uFFFC") != std::string::npos);
    CHECK(manifest.find("\uFFFE") == std::string::npos);
    CHECK(manifest.find("\uFFFF") == std::string::npos);
  }
}

TEST_CASE("a page that is no browser edition, holds a lesson or is of an earlier version gives a message, no zip") {
  const PlatformCourse course{"l", "L", "", "", {}};
  const auto zip = [&](const std::string& page) {
    return platformZip(LearningPlatform::Scorm12, course, page, "edition.html", "bytes");
  };
  CHECK(zip(kEdition));
  CHECK(zip("<html></html>").problem().text().find("it is no page of the browser edition") != std::string::npos);
  CHECK(zip("<script id=\"platform-script\"></script>").problem().text().find("holds a lesson already") !=
        std::string::npos);
  CHECK(zip("<!--a lesson comes here-->").problem().text() ==
        "edition.html: this browser edition is of an earlier version, which knows no learning platform; make it anew "
        "with './run.sh web'");
}

}  // namespace moltact
