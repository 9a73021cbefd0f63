// Oracle: every kind of line is read as it was written; damage is made by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

TEST_CASE("every one of the 20 kinds of event comes back from its line as it was") {
  std::vector<bool> met(std::variant_size_v<AttemptFact>);
  for (const AttemptEvent& event : sampleEvents()) {
    const std::string line = lineOf(event);
    CAPTURE(line);
    CHECK(line.find('\n') == line.size() - 1);
    met[event.what.index()] = true;
    const auto back = readEventLine(line);
    REQUIRE(bool(back));
    REQUIRE(back->has_value());
    CHECK((*back)->what.index() == event.what.index());
    CHECK((*back)->t_s == event.t_s);
    CHECK(lineOf(**back) == line);
  }
  CHECK(met == std::vector<bool>(21, true));
}

TEST_CASE("HIP samples keep places to 0.001 A, forces, features and the atoms that held the probe") {
  const AttemptEvent event = sampleEvents()[7];
  const auto& wanted = std::get<HipChunk>(event.what).samples;
  const auto back = readEventLine(lineOf(event));
  const auto& got = std::get<HipChunk>((**back).what).samples;
  REQUIRE(got.size() == wanted.size());
  for (std::size_t k = 0; k < got.size(); ++k) {
    CAPTURE(k);
    CHECK(got[k].t_s == doctest::Approx(wanted[k].t_s));
    CHECK(glm::distance(got[k].hip.A, wanted[k].hip.A) < 1e-3);
    CHECK(glm::distance(got[k].scp.A, wanted[k].scp.A) < 1e-3);
    CHECK(glm::distance(got[k].displacement_A, wanted[k].displacement_A) < 1e-3);
    CHECK(glm::distance(got[k].force.N, wanted[k].force.N) < 1e-3);
    CHECK(got[k].feature == wanted[k].feature);
    CHECK(got[k].atoms == wanted[k].atoms);
  }
}

namespace {

// Three samples of a body that is turned about z, one of them touching; `apart` from the hand by a rest of its own.
HipChunk heldChunk(bool apart) {
  HipChunk chunk;
  for (int k = 0; k < 3; ++k) {
    HipSample s;
    s.t_s = 3.0 + 0.017 * k;
    s.hip.A = s.scp.A = {1.25 * k, -3.5, 0.125};
    if (k == 1) {
      s.feature = Feature::Sphere;
      s.atoms = {7, -1, -1};
      s.scp.A.z += 0.5;
      s.displacement_A = {0, 0, 0.5};
    }
    const Quat turned = glm::angleAxis(0.3 * k, Vec3(0, 0, 1));
    s.held = {turned, s.bodyAtHand(turned)};
    if (apart) s.held->body = {{s.hip.A + Vec3(0, 0.25, 0)}, glm::angleAxis(0.5 * k, Vec3(1, 0, 0))};
    chunk.samples.push_back(s);
  }
  return chunk;
}

double turned(const Quat& a, const Quat& b) { return glm::length(rotationBetween(a, b)); }

}  // namespace

TEST_CASE(
    "HIP samples of a body keep the hand's orientation to 2e-5 rad and the body's pose to 0.001 A; a line of a probe "
    "has no key of a body") {
  for (const bool apart : {false, true}) {
    CAPTURE(apart);
    const HipChunk wanted = heldChunk(apart);
    const std::string line = lineOf({3.05, wanted});
    CAPTURE(line);
    CHECK((line.find("\"body\":") != std::string::npos) == apart);
    const auto back = readEventLine(line);
    REQUIRE(bool(back));
    const auto& got = std::get<HipChunk>((**back).what).samples;
    REQUIRE(got.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const HipSample& want = wanted.samples[k];
      REQUIRE(got[k].held);
      CHECK(turned(got[k].held->orientation, want.held->orientation) < 2e-5);
      CHECK(turned(got[k].held->body.orientation, want.held->body.orientation) < 2e-5);
      CHECK(glm::distance(got[k].held->body.place.A, want.held->body.place.A) < 1e-3);
    }
    CHECK(lineOf(**back) == line);
  }
  // Byte for byte what former versions wrote.
  CHECK(
      lineOf(sampleEvents()[7]) ==
      "{\"kind\":\"trace\",\"t\":3.085,\"from\":3.0,\"ms\":[0,17,34,51,68,85],\"feature\":\"..SSCP\",\"hip\":[0.0,-3.5,"
      "0.0,1.25,-3.5,0.001,2.5,-3.5,0.002,3.75,-3.5,0.003,5.0,-3.5,0.004,6.25,-3.5,0.005],\"scp\":[2.5,-3.5,0.502,3."
      "75,-3.5,0.503,5.0,-3.5,0.504,6.25,-3.5,0.505],\"force\":[0.1,0.0,0.5,0.1,0.0,0.75,0.1,0.0,1.0,0.1,0.0,1.25],"
      "\"displacement\":[0.0,0.3,0.4,0.0,0.3,0.4,0.0,0.3,0.4,0.0,0.3,0.4],\"atoms\":[[2,7],[4,7,9],[5,7,9,12]]}\n");
}

TEST_CASE("a stage keeps the atoms in the hand; lines of a body that name no rotation or no atom are refused") {
  auto stage = std::get<StageChanged>(sampleEvents()[1].what);
  CHECK(lineOf({0.0, stage}).find("held") == std::string::npos);
  stage.held = {3, 4, 601};
  const std::string line = lineOf({0.0, stage});
  const auto back = readEventLine(line);
  REQUIRE(bool(back));
  CHECK(std::get<StageChanged>((**back).what) == stage);
  const auto with = [&](const std::string& held) {
    std::string other = line;
    const std::size_t at = other.find("[3,4,601]");
    return other.replace(at, 9, held);
  };
  CHECK(readEventLine(with("[0]")));
  for (const char* held : {"[602]", "[-1]", "[0.5]", "[4,3]", "[4,4]", "[\"a\"]", "7"})
    CHECK_FALSE(readEventLine(with(held)));

  const std::string free = R"({"kind":"trace","t":1,"from":0,"ms":[0],"feature":".","hip":[1,2,3])";
  CHECK(readEventLine(free + R"(,"orientation":[1,0,0,0]})"));
  CHECK(readEventLine(free + R"(,"orientation":[1,0,0,0],"body":[1,2,3],"body_orientation":[0,1,0,0]})"));
  for (const char* held : {R"(,"orientation":[0,0,0,0]})", R"(,"orientation":[1,0,0]})", R"(,"orientation":[1,1,0,0]})",
                           R"(,"orientation":[1,0,0,0],"body":[1,2,3]})",
                           R"(,"orientation":[1,0,0,0],"body":[1,2],"body_orientation":[0,1,0,0]})",
                           R"(,"orientation":[1,0,0,0],"body":[1,2,3],"body_orientation":[0,0.5,0,0]})"}) {
    CAPTURE(held);
    CHECK_FALSE(readEventLine(free + held));
  }
}

TEST_CASE(
    "the position of atoms is kept as what moved them, its file, its detail and a number to 0.001; lines of former "
    "versions, which knew two structures only, are read as positions of these") {
  const AtomsMoved frame{"trajectory", "run.xtc", "every 10", 1234.567};
  const std::string line = lineOf(AttemptEvent{4.0, frame});
  CHECK(line == R"({"kind":"moved","t":4.0,"by":"trajectory","file":"run.xtc","detail":"every 10","position":1234.567})"
                "\n");
  const auto read = [](const std::string& text) {
    const auto back = readEventLine(text);
    REQUIRE(bool(back));
    return std::get<AtomsMoved>((**back).what);
  };
  CHECK(read(line) == frame);
  CHECK(read(lineOf(AttemptEvent{4.0, AtomsMoved{"simulation", "", "", -2.5}})) ==
        AtomsMoved{"simulation", "", "", -2.5});
  const AtomsMoved computed{"simulation", "", "", 0.5, "OpenMM 7.7, Reference, steps of 4 fs, seed 1"};
  CHECK(read(lineOf(AttemptEvent{4.0, computed})) == computed);
  // As former versions wrote them.
  CHECK(read(R"({"kind":"state","t":8.5,"file":"1ake.pdb","superposed_on":"chain A","share":0.375})") ==
        AtomsMoved{"states", "1ake.pdb", "chain A", 0.375});
  CHECK(read(R"({"kind":"state","t":8.5,"file":"1ake.pdb","share":1.0})") == AtomsMoved{"states", "1ake.pdb", "", 1.0});
  for (const char* none :
       {R"({"kind":"state","t":1,"file":"a.pdb","share":1.01})", R"({"kind":"state","t":1,"share":0})",
        R"({"kind":"moved","t":1,"file":"a.pdb","position":0})", R"({"kind":"moved","t":1,"by":"states"})",
        R"({"kind":"moved","t":1,"by":"states","position":1e13})"})
    CHECK_FALSE(readEventLine(none));
}

TEST_CASE("a felt curve keeps its forces to 0.001 N and the places where nothing was felt") {
  const CurveKept felt{"one", 2, true, "depth", 0.8, 3.3, {0.0, std::nan(""), 1.23456}};
  const std::string line = lineOf(AttemptEvent{4.0, felt});
  CHECK(
      line ==
      R"({"kind":"curve","t":4.0,"step":"one","task":2,"of":"felt","axis":"depth","to_A":0.8,"most_N":3.3,"force_N":[0.0,null,1.235]})"
      "\n");
  const auto back = readEventLine(line);
  const auto& got = std::get<CurveKept>((**back).what);
  CHECK(got.felt);
  REQUIRE(got.force_N.size() == 3);
  CHECK(std::isnan(got.force_N[1]));
  CHECK(got.force_N[2] == 1.235);
}

TEST_CASE("a stage says how its file was read where that is not the default, and no more than that") {
  auto stage = std::get<StageChanged>(sampleEvents()[1].what);
  CHECK(lineOf({0.0, stage}).find("waters") == std::string::npos);
  for (const ReadOptions& reading :
       {ReadOptions{}, ReadOptions{.waters = true}, ReadOptions{.model = 3, .assembly = "1"}}) {
    stage.reading = reading;
    const auto back = readEventLine(lineOf({0.0, stage}));
    REQUIRE(bool(back));
    CHECK(std::get<StageChanged>((**back).what) == stage);
  }
  std::string line = lineOf({0.0, stage});
  line.replace(line.find("\"model\":3"), 9, "\"model\":0");
  CHECK_FALSE(readEventLine(line));
}

TEST_CASE("a stage keeps every property of what it is felt with; attempts without the newer ones have the defaults") {
  auto stage = std::get<StageChanged>(sampleEvents()[1].what);
  CHECK(
      lineOf({0.0, stage}).find("\"probe_A\":1.4,\"stiffness_N_per_mm\":0.5,\"method\":\"exact\",\"force_on\":true}") !=
      std::string::npos);
  for (const TouchProperty& p : touchProperties()) {
    CAPTURE(std::string(p.field));
    stage.touch = {};
    const TouchValue usual = touchValue(stage.touch, p);
    if (std::holds_alternative<double>(usual))
      setTouchValue(stage.touch, p, 0.25 * p.in_files.min + 0.75 * p.in_files.max);
    else if (const auto* on = std::get_if<bool>(&usual))
      setTouchValue(stage.touch, p, !*on);
    else
      setTouchValue(stage.touch, p, std::string("another"));
    const std::string line = lineOf({0.0, stage});
    const auto back = readEventLine(line);
    REQUIRE(bool(back));
    CHECK(std::get<StageChanged>((**back).what) == stage);
    // Without the key.
    const std::size_t at = line.find("\"" + std::string(p.field) + "\":");
    REQUIRE(at != std::string::npos);
    const std::size_t end = line.find_first_of(",}", at);
    const auto without = readEventLine(line.substr(0, at - 1) + line.substr(end));
    CHECK(bool(without) == !p.in_old_files);
    if (without) CHECK(std::get<StageChanged>((**without).what).touch == TouchSetup());
  }
  // A number that no Moltact writes.
  std::string line = lineOf({0.0, stage});
  line.replace(line.find("\"probe_A\":1.4"), 13, "\"probe_A\":21.");
  CHECK_FALSE(readEventLine(line));
}

TEST_CASE("the header comes back with its outline of 2 steps, and any name of a student") {
  const auto back = readHeaderLine(lineOf(sampleHeader()));
  REQUIRE(bool(back));
  CHECK(back->student == "A. \"Quote\", Ünlü\n=1+1");
  REQUIRE(back->lesson.steps.size() == 2);
  CHECK(back->lesson.steps[0].questions[0].choices[2] == "both");
  CHECK(back->lesson.steps[0].questions[0].right == std::vector<std::size_t>{1});
  CHECK(back->lesson.parts() == 3);
  CHECK(lineOf(*back) == lineOf(sampleHeader()));
}

TEST_CASE("a file of format 7 with kinds and keys that are not known is read as far as it is known") {
  auto header = sampleHeader();
  header.format = 7;
  std::string line = lineOf(header);
  line.insert(1, R"("mood":{"x":[1,2]},)");
  const auto back = readHeaderLine(line);
  REQUIRE(bool(back));
  CHECK(back->format == 7);
  const auto unknown = readEventLine(R"({"kind":"smell","t":4,"of":"roses"})");
  REQUIRE(bool(unknown));
  CHECK_FALSE(unknown->has_value());
  const auto more = readEventLine(R"({"t":4,"later":null,"step":"one","kind":"hint"})");
  REQUIRE((bool(more) && more->has_value()));
  CHECK(std::get<HintOpened>((*more)->what).step == "one");
}

TEST_CASE("wrong types, missing keys and numbers that do not fit are reported and never thrown") {
  for (const char* line :
       {"",
        "{",
        "[]",
        "42",
        "null",
        "{}",
        R"({"kind":"hint"})",
        R"({"kind":7,"t":1})",
        R"({"kind":"hint","t":"x","step":"a"})",
        R"({"kind":"hint","t":1,"step":3})",
        R"({"kind":"task","t":1,"step":"a","task":-1})",
        R"({"kind":"task","t":1,"step":"a","task":1e300})",
        R"({"kind":"task","t":1,"step":"a","task":0.5})",
        R"({"kind":"answer","t":1,"step":"a","question":"b","attempt":1,"right":"yes","by":"mouse"})",
        R"({"kind":"answer","t":1,"step":"a","question":"b","attempt":1,"right":true,"by":"foot"})",
        R"({"kind":"touch","t":1,"atoms":[1,99999999999]})",
        R"({"kind":"trace","t":1,"from":0,"ms":[0,1],"feature":"S","hip":[]})",
        R"({"kind":"trace","t":1,"from":0,"ms":[0],"feature":"S","hip":[1,2,3]})",
        R"({"kind":"trace","t":1,"from":0,"ms":[0],"feature":"Q","hip":[1,2,3],"scp":[1,2,3],"force":[0,0,0]})",
        R"({"kind":"view","t":1,"orientation":[1,0,0],"target_A":[0,0,0],"distance_A":5})",
        R"({"kind":"lesson","t":1,"lesson":[]})"}) {
    CAPTURE(line);
    const auto event = readEventLine(line);
    CHECK_FALSE(bool(event));
    CHECK_FALSE(event.problem().message.empty());
    CHECK_FALSE(bool(readHeaderLine(line)));
  }
  const std::string deep(300'000, '[');
  CHECK_FALSE(bool(readEventLine(deep)));
  CHECK_FALSE(bool(readEventLine(std::string(kLongestLine + 1, ' '))));
}

TEST_CASE("numbers that are not finite and bytes that are no UTF-8 still give a line that reads") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto touch = readEventLine(lineOf({nan, TouchEnded{inf, {1}, 0, nan, -inf, nan, InputKind::Mouse}}));
  REQUIRE(bool(touch));
  CHECK(std::get<TouchEnded>((**touch).what).peak_N == 0.0);
  const auto answer = readEventLine(lineOf({1.0, Answered{"a", "b", 1, {}, "\xff\xc3(", true, InputKind::Mouse}}));
  REQUIRE(bool(answer));
  CHECK(std::get<Answered>((**answer).what).written == "\xef\xbf\xbd\xef\xbf\xbd(");
}

TEST_CASE("2000 random changes of bytes in lines neither crash nor hang") {
  const unsigned seed = std::random_device{}();
  MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  const std::vector<AttemptEvent> events = sampleEvents();
  for (int round = 0; round < 2000; ++round) {
    std::string line = round % 10 ? lineOf(events[random() % events.size()]) : lineOf(sampleHeader());
    for (unsigned changes = 1 + random() % 4; changes > 0; --changes) {
      const std::size_t at = random() % line.size();
      if (random() % 3 == 0)
        line.erase(at, 1 + random() % 5);
      else
        line[at] = "{}[]\",:0-9e.ntf\\\x80\xff"[random() % 18];
      if (line.empty()) break;
    }
    (void)bool(readEventLine(line));
    (void)bool(readHeaderLine(line));
  }
}

}  // namespace
}  // namespace moltact
