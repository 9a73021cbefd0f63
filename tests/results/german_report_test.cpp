// The report on a class in German, with the small catalogue of tests/language.
#include <doctest/doctest.h>

#include "engine/results/class_csv.h"
#include "engine/results/class_page.h"
#include "tests/language/in_german.h"
#include "tests/results/sample_attempt.h"

using namespace moltact;

namespace {

ClassSummary sample() {
  Attempt a;
  a.header = sampleHeader();
  a.events = sampleEvents();
  return summarise({a});
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The first text between `before` and `after`.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t from = text.find(before);
  REQUIRE(from != std::string::npos);
  return text.substr(from + before.size(), text.find(after, from + before.size()) - from - before.size());
}

}  // namespace

TEST_CASE("the page says in German what it is, its headings and counts, and writes 0.43 as 0,43") {
  const std::string english = classPage(sample(), {}, "now");
  const std::string force = between(english, "<b>Peak force</b>, N</div><span>median ", ", n = 1");
  REQUIRE(holds(force, "."));
  const InGerman german;
  const std::string page = classPage(sample(), {}, "heute");
  CHECK(holds(page, "<html lang=\"de\">"));
  CHECK(holds(page, "<h1>Bericht über die Klasse</h1>"));
  CHECK(holds(page, "1 Person, 1 Lektion, 1 Versuch. Erstellt heute mit Moltact."));
  CHECK(holds(page, "<h3>Lernende</h3>"));
  std::string comma = force;
  comma.replace(comma.find('.'), 1, ",");
  CHECK(between(page, "<b>Größte Kraft</b>, N</div><span>Median ", ", n = 1") == comma);
  // What a browser computes with stays as it must be written there.
  CHECK(holds(page, "viewBox=\"0 0 320 152\""));
  CHECK_FALSE(holds(between(page, "<path class=\"median\" d=\"", "\""), ","));
}

TEST_CASE("the table has German headings; its numbers keep the point, for the comma parts its cells") {
  const std::string english = classCsv(sample());
  const InGerman german;
  const std::string table = classCsv(sample());
  CHECK(table.starts_with("\xEF\xBB\xBFlernende,"));
  CHECK(english.starts_with("\xEF\xBB\xBFstudent,"));
  // Row for row as many cells as in English: no number has got another comma.
  const auto commas = [](const std::string& text) { return std::count(text.begin(), text.end(), ','); };
  CHECK(commas(table) == commas(english));
  CHECK(holds(table, ",ja,"));
}
