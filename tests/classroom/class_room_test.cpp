// A class without sockets and files: names, lines that come twice or in part, limits, and what a restart makes of the records.
#include "engine/classroom/class_room.h"

#include <doctest/doctest.h>

#include <set>
#include <sstream>

#include "engine/classroom/class_names.h"
#include "engine/classroom/class_view.h"
#include "engine/classroom/rate_limit.h"
#include "engine/classroom/secrets.h"
#include "engine/core/utf8.h"
#include "tests/classroom/small_class.h"

namespace moltact {
namespace {

using namespace test;
using Refused = ClassRoom::Refused;

TEST_CASE("400 students who type no name get 400 different animals, in an order that only the seed decides") {
  std::vector<std::string> first;
  for (int round = 0; round < 2; ++round) {
    NameBook book(7);
    std::set<std::string> met;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < kMaxStudents; ++k) names.push_back(book.take(k % 2 ? "" : " \t "));
    met.insert(names.begin(), names.end());
    CHECK(met.size() == kMaxStudents);
    CHECK(*met.begin() != "");
    if (round == 0)
      first = names;
    else
      CHECK(names == first);
  }
  NameBook other(8);
  CHECK(other.take("") != first[0]);
}

TEST_CASE("a name is one line of at most 40 characters, and a second Anna is Anna 2 whatever her capitals") {
  CHECK(cleanName("  Ada \n  Lovelace\t") == "Ada Lovelace");
  CHECK(cleanName("\x1b[31mred") == "\xEF\xBF\xBD[31mred");
  CHECK(characterCount(cleanName(std::string(300, 'x'))) == kMaxNameCharacters);
  std::string umlauts;
  for (int k = 0; k < 60; ++k) umlauts += "ü";
  CHECK(characterCount(cleanName(umlauts)) == kMaxNameCharacters);
  CHECK(cleanName("\xff\xfe").find('\xff') == std::string::npos);
  NameBook book(1);
  CHECK(book.take("Anna") == "Anna");
  CHECK(book.take("anna") == "anna 2");
  CHECK(book.take("ANNA") == "ANNA 3");
  book.mark("Bo");
  CHECK(book.take("bo") == "bo 2");
}

TEST_CASE("an animal that a student has typed as a name is not given to another") {
  NameBook plain(3), other(3);
  const std::string animal = plain.take("");
  CHECK(other.take(animal) == animal);
  CHECK(other.take("") != animal);
}

TEST_CASE(
    "lines that come again are taken once, a gap is refused with the number that is there, half a batch never counts") {
  ClassRoom room(smallLessons(), 1);
  const std::size_t s = room.join("Ada", "t", 0.0)->student;
  const std::vector<std::string> lines{headerLine(), eventLine(0.0, StepEntered{"one"}),
                                       eventLine(2.0, HintOpened{"one"})};
  CHECK(room.take(s, "a", 0, lines, 1.0).have == 3);
  const std::uint64_t version = room.version();
  for (const std::size_t from : {0, 1, 2, 3}) {
    const ClassRoom::Taken again = room.take(s, "a", from, {lines.begin() + std::ptrdiff_t(from), lines.end()}, 2.0);
    CHECK(again.refused == Refused::No);
    CHECK(again.have == 3);
    CHECK(again.records.empty());
  }
  CHECK(room.version() == version);
  CHECK(room.students()[s].attempts[0].hints() == 1);
  CHECK(room.take(s, "a", 5, {eventLine(9.0, HintOpened{"one"})}, 3.0).refused == Refused::Gap);
  CHECK(room.take(s, "a", 5, {}, 3.0).have == 3);
  // The second of three lines is no object: none is taken.
  const std::vector<std::string> broken{eventLine(3.0, HintOpened{"one"}), "what?", eventLine(4.0, HintOpened{"one"})};
  const ClassRoom::Taken taken = room.take(s, "a", 3, broken, 4.0);
  CHECK(taken.refused == Refused::Broken);
  CHECK(taken.have == 3);
  CHECK(room.students()[s].attempts[0].hints() == 1);
  // A batch that begins with lines that are there: the page must first see whose they are.
  const ClassRoom::Taken partly = room.take(s, "a", 2, {lines[2], eventLine(5.0, HintOpened{"one"})}, 5.0);
  CHECK(partly.refused == Refused::Gap);
  CHECK(partly.have == 3);
  CHECK(room.take(s, "a", 3, {eventLine(5.0, HintOpened{"one"})}, 5.0).have == 4);
  CHECK(room.students()[s].attempts[0].hints() == 2);
}

TEST_CASE(
    "a line that is no object, holds a line end, or is too long is refused, and so is an attempt without a header") {
  ClassRoom room(smallLessons(), 1);
  const std::size_t s = room.join("Ada", "t", 0.0)->student;
  CHECK(room.take(s, "a", 0, {eventLine(0.0, StepEntered{"one"})}, 0.0).refused == Refused::Broken);
  CHECK(room.take(s, "a", 0, {"{}"}, 0.0).refused == Refused::Broken);
  CHECK(room.students()[s].attempts.empty());
  CHECK(room.take(s, "a", 0, {headerLine()}, 0.0).have == 1);
  for (const std::string& line :
       {std::string(), std::string("[]"), std::string("{\"a\":1}\n{\"b\":2}"), std::string("{\"a\":1}}"),
        std::string("{\"a\":}"), "{\"kind\":\"x\",\"t\":1,\"y\":\"" + std::string(kMaxClassLine, 'y') + "\"}"})
    CHECK(room.take(s, "a", 1, {line}, 0.0).refused == Refused::Broken);
  for (const std::string& key : {std::string(), std::string("../../etc/passwd"), std::string("a/b"), std::string("a.b"),
                                 std::string("a\0b", 3), std::string(kMaxAttemptKey + 1, 'a'), std::string("ä")})
    CHECK(room.take(s, key, 0, {headerLine()}, 0.0).refused == Refused::Broken);
  CHECK(room.students()[s].attempts.size() == 1);
}

TEST_CASE("a student has at most 40 attempts, a class at most 400 students, and nobody joins a class that has ended") {
  ClassRoom room(smallLessons(), 1);
  const std::size_t s = room.join("Ada", "t", 0.0)->student;
  for (std::size_t k = 0; k < kMaxAttemptsOfStudent; ++k)
    CHECK(room.take(s, "a" + std::to_string(k), 0, {headerLine()}, 0.0).refused == Refused::No);
  CHECK(room.take(s, "more", 0, {headerLine()}, 0.0).refused == Refused::Full);
  for (std::size_t k = 1; k < kMaxStudents; ++k) CHECK(room.join("", "t" + std::to_string(k), 0.0));
  CHECK_FALSE(room.join("late", "x", 0.0));
  CHECK(room.students().size() == kMaxStudents);
  ClassRoom over(smallLessons(), 1);
  CHECK_FALSE(over.end().empty());
  CHECK_FALSE(over.join("late", "x", 0.0));
}

TEST_CASE("a student's lines stop at 64 MiB, and what was taken stays") {
  ClassRoom room(smallLessons(), 1);
  const std::size_t s = room.join("Ada", "t", 0.0)->student;
  room.take(s, "a", 0, {headerLine()}, 0.0);
  const std::string line = "{\"kind\":\"trace\",\"t\":1.0,\"x\":\"" + std::string(kMaxClassLine - 100, 'y') + "\"}";
  std::size_t have = 1;
  Refused refused = Refused::No;
  while (refused == Refused::No && have < 1000) {
    const ClassRoom::Taken taken = room.take(s, "a", have, {line}, 0.0);
    refused = taken.refused;
    have = taken.have;
  }
  CHECK(refused == Refused::Full);
  CHECK(room.students()[s].bytes <= kMaxBytesOfStudent);
  CHECK(room.students()[s].bytes + line.size() > kMaxBytesOfStudent);
}

TEST_CASE("the header on the teacher's computer has the name of the class, whatever name the page sends") {
  ClassRoom room(smallLessons(), 1);
  const std::size_t s = room.join("Ada", "t", 0.0)->student;
  const ClassRoom::Taken taken = room.take(s, "a", 0, {headerLine("Somebody else")}, 0.0);
  std::istringstream records(taken.records);
  std::string record;
  std::getline(records, record);
  CHECK_FALSE(lineRecord(record));
  std::getline(records, record);
  const auto line = lineRecord(record);
  REQUIRE(line);
  CHECK(readHeaderLine(line->line)->student == "Ada");
  CHECK(taken.records.find("Somebody else") == std::string::npos);
}

TEST_CASE("a token of a student opens for that student alone, and a wrong one of any length for nobody") {
  ClassRoom room(smallLessons(), 1);
  room.join("Ada", "abcdef", 0.0);
  room.join("Bo", "abcdeg", 0.0);
  CHECK(room.studentOf("abcdef") == 0);
  CHECK(room.studentOf("abcdeg") == 1);
  for (const char* wrong : {"", "abcde", "abcdefg", "abcdefabcdef", "ABCDEF"}) CHECK_FALSE(room.studentOf(wrong));
  CHECK(sameSecret("same", "same"));
  CHECK_FALSE(sameSecret("same", "samesame"));
  CHECK_FALSE(sameSecret("", "x"));
}

TEST_CASE("secrets are drawn evenly: of 310 000 signs each of the 31 comes 10 000 times, within five deviations") {
  std::uint64_t seed = 5;
  const auto bytes = [&](std::size_t n) {
    std::string out;
    for (std::size_t k = 0; k < n; ++k) out += char(nextRandom(seed) >> 40);
    return out;
  };
  const std::string text = secretText(310000, bytes);
  std::map<char, int> counts;
  for (const char c : text) ++counts[c];
  CHECK(counts.size() == 31);
  for (const auto& [c, n] : counts) CHECK(std::abs(n - 10000) < 5 * 99);
}

TEST_CASE("from the records of a class the same class is built again, line by line") {
  ClassRoom room(smallLessons(), 1);
  std::string journal;
  std::vector<std::size_t> sent(3);
  for (int k = 0; k < 3; ++k) journal += room.join(k ? "" : "Ada \"<script>\"", "t" + std::to_string(k), 0.0)->record;
  const auto send = [&](std::size_t s, const std::string& line) {
    const ClassRoom::Taken taken = room.take(s, "key-1", sent[s], {line}, 0.0);
    REQUIRE(taken.refused == Refused::No);
    sent[s] = taken.have;
    journal += taken.records;
  };
  for (std::size_t s = 0; s < 3; ++s) {
    send(s, headerLine());
    send(s, eventLine(0.0, StepEntered{"one"}));
    send(s, eventLine(1.0 + double(s), Answered{"one", "expect", 1, {s % 2}, "", true, InputKind::Mouse}));
    send(s, eventLine(2.0, CurveKept{"one", 0, false, "depth", 0.8, 3.3, {0.0, 1.0}}));
    send(s, eventLine(3.0, TaskDone{"one", 0, 1.0, InputKind::Mouse, {}, true}));
    send(s, eventLine(40.0, StepEntered{"two"}));
    send(s, eventLine(41.0, Answered{"two", "which", 1, {0}, "", false, InputKind::Mouse}));
    send(s, eventLine(42.0, ProgressMade{"two", 2, 4}));
  }
  journal += room.hold("bumps", 1);
  journal += room.end();

  ClassRoom again(smallLessons(), 1);
  std::istringstream records(journal);
  std::size_t count = 0;
  for (std::string record; std::getline(records, record); ++count) CHECK_MESSAGE(again.restore(record), record);
  CHECK(count == 3 + 3 * 9 + 2);
  REQUIRE(again.students().size() == 3);
  CHECK(again.ended());
  CHECK(again.held() == room.held());
  for (std::size_t s = 0; s < 3; ++s) {
    const LiveStudent &a = room.students()[s], &b = again.students()[s];
    CHECK(a.name == b.name);
    CHECK(a.token == b.token);
    REQUIRE(b.attempts.size() == 1);
    CHECK(a.attempts[0].lines == b.attempts[0].lines);
    CHECK(a.attempts[0].key == b.attempts[0].key);
    CHECK(a.attempts[0].spent_s(0) == b.attempts[0].spent_s(0));
    CHECK(a.attempts[0].answers.size() == b.attempts[0].answers.size());
    CHECK(b.attempts[0].curves.size() == 1);
    CHECK(b.attempts[0].done == 2);
    CHECK(again.take(s, "key-1", sent[s], {eventLine(50.0, HintOpened{"two"})}, 1.0).have == sent[s] + 1);
  }
  // A name that is gone from the list of a restarted class is not given out again.
  CHECK(again.students()[1].name != again.students()[2].name);
  for (const char* broken :
       {"", "{}", "{\"kind\":\"joined\",\"student\":9}", "{\"kind\":\"line\",\"student\":99,\"attempt\":0,\"line\":{}}",
        "{\"kind\":\"line\",\"student\":0,\"attempt\":7,\"line\":{}}",
        "{\"kind\":\"held\",\"lesson\":\"none\",\"step\":0}"})
    CHECK_FALSE(again.restore(broken));
}

TEST_CASE("a bucket of 3 with one more each second lets 3 pass at once, and then one each second") {
  RateBucket bucket;
  const RateLimit limit{3.0, 1.0};
  int passed = 0;
  for (int k = 0; k < 10; ++k) passed += bucket.take(limit, 5.0);
  CHECK(passed == 3);
  CHECK_FALSE(bucket.take(limit, 5.9));
  CHECK(bucket.take(limit, 6.05));
  CHECK_FALSE(bucket.take(limit, 6.1));
  passed = 0;
  for (int k = 0; k < 10; ++k) passed += bucket.take(limit, 1000.0);
  CHECK(passed == 3);
  RateByAddress by({1.0, 0.0});
  for (int k = 0; k < 5000; ++k) CHECK(by.take("10.0." + std::to_string(k), double(k)));
  CHECK_FALSE(by.take("10.0.4999", 5000.0));
  CHECK(by.take("10.0.0", 5001.0));  // dropped long ago
}

}  // namespace
}  // namespace moltact
