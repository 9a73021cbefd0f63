// Statistics of known numbers, and the formats of the results.
#include <doctest/doctest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "engine/bench/accuracy.h"
#include "engine/bench/chart_svg.h"
#include "engine/bench/feel.h"
#include "engine/bench/hand_replay.h"
#include "engine/bench/log_axis.h"
#include "engine/bench/report_table.h"
#include "engine/bench/stability.h"
#include "engine/bench/statistics.h"
#include "engine/bench/stiffness.h"
#include "engine/bench/tables.h"

using namespace moltact;
using namespace moltact::bench;

namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) ++n;
  return n;
}

// Every element that is opened is closed, in order; no bare < or & in between.
bool wellFormed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = 0; at < xml.size(); ++at) {
    if (xml[at] == '&') {
      const std::string entity = xml.substr(at, xml.find(';', at) - at + 1);
      if (entity != "&amp;" && entity != "&lt;" && entity != "&gt;" && entity != "&quot;") return false;
    }
    if (xml[at] == '>') return false;
    if (xml[at] != '<') continue;
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (std::count(tag.begin(), tag.end(), '"') % 2 || tag.find('<') != std::string::npos) return false;
    const std::string name = tag.substr(tag[0] == '/' ? 1 : 0, tag.find_first_of(" /", 1) - (tag[0] == '/' ? 1 : 0));
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
    at = end;
  }
  return open.empty();
}

ReportTable sample() {
  return {"sample",
          "A sample",
          {{"name", "name"}, {"time_ns", "time (ns)"}},
          {{std::string("a, \"b\""), 12345.678}, {std::string("c|d"), Cell{}}},
          "A note."};
}

}  // namespace

TEST_CASE("of 1 to 10 000 the mean is 5000.5, p50 5000, p99 9900, p99.99 9999 and the greatest 10 000") {
  std::vector<double> values(10'000);
  std::iota(values.begin(), values.end(), 1.0);
  std::reverse(values.begin(), values.end());
  const Statistics s = statisticsOf(values);
  CHECK(s.count == 10'000);
  CHECK(s.mean == doctest::Approx(5000.5));
  CHECK(s.p50 == 5000);
  CHECK(s.p99 == 9900);
  CHECK(s.p9999 == 9999);
  CHECK(s.max == 10'000);
  CHECK(statisticsOf({3, 4}).rms == doctest::Approx(std::sqrt(12.5)));
  CHECK(statisticsOf({}).max == 0);
}

TEST_CASE(
    "the mean of 1, 2, 3, 4 is 2.5 and its 95 % interval by Student's t with 3 degrees of freedom 2.054 to either "
    "side; of 30 values t is 2.045") {
  const MeanOf four = meanOf({1, 2, 3, 4});
  CHECK(four.mean == 2.5);
  CHECK(four.half_width == doctest::Approx(3.182 * std::sqrt(5.0 / 3.0 / 4.0)));
  std::vector<double> thirty(30, 0.0);
  for (std::size_t k = 0; k < 30; ++k) thirty[k] = k % 2 ? 1.0 : -1.0;
  CHECK(meanOf(thirty).half_width == doctest::Approx(2.0452 * std::sqrt(30.0 / 29.0 / 30.0)).epsilon(1e-3));
  CHECK(meanOf({7}).half_width == 0);
  CHECK(meanOf({}).mean == 0);
}

TEST_CASE("the front of (1,9) (2,5) (2,6) (3,5) (4,1) is the first, second and last point") {
  CHECK(paretoFront({1, 2, 2, 3, 4}, {9, 5, 6, 5, 1}) == std::vector<std::size_t>{0, 1, 4});
}

TEST_CASE("angles of a billionth of a degree and of 180 degrees are reported exactly") {
  const double tiny = 1e-9 * 3.141592653589793 / 180;
  CHECK(angle_deg({1, 0, 0}, {1, tiny, 0}) == doctest::Approx(1e-9).epsilon(1e-9));
  CHECK(angle_deg({1, 0, 0}, {-2, 0, 0}) == doctest::Approx(180));
  CHECK(angle_deg({1, 0, 0}, {0, 0, 3}) == doctest::Approx(90));
}

TEST_CASE("numbers read with three digits: 0.0123, 99.97 as 100, 12 346, 1.2e-13, 42") {
  CHECK(readable(0.012345) == "0.0123");
  CHECK(readable(99.97) == "100");
  CHECK(readable(12345.678) == "12 346");
  CHECK(readable(1234567) == "1 234 567");
  CHECK(readable(1.23e-13) == "1.2e-13");
  CHECK(readable(42) == "42");
  CHECK(readable(-1234.5) == "-1 234");
  CHECK(readable(0) == "0");
}

TEST_CASE("a table is written as CSV with quoted fields, as Markdown and as JSON without nulls") {
  CHECK(toCsv(sample()) == "name,time_ns\n\"a, \"\"b\"\"\",12345.678\nc|d,\n");
  CHECK(toMarkdown(sample()) ==
        "| name | time (ns) |\n| --- | ---: |\n| a, \"b\" | 12 346 |\n| c\\|d | - |\n\nA note.\n");
  const auto json = nlohmann::json::parse(toJson({sample()}, "a command"));
  CHECK(json["command"] == "a command");
  CHECK(json["tables"]["sample"]["rows"][0]["time_ns"] == 12345.678);
  CHECK_FALSE(json["tables"]["sample"]["rows"][1].contains("time_ns"));
}

TEST_CASE("of two rows the one named c|d is picked out, and none from a column that is not there") {
  const ReportTable picked = rowsWhere(sample(), "name", "c|d", "picked", "Picked");
  CHECK(picked.rows.size() == 1);
  CHECK(picked.name == "picked");
  CHECK(rowsWhere(sample(), "nothing", "c|d", "picked", "Picked").rows.empty());
}

TEST_CASE("the CSV of tick times keeps its header") {
  const std::string csv = toCsv(tickTable({}));
  CHECK(
      csv ==
      "scene,spheres,motion,method,mean_ns,p50_ns,single_error_ns,p99_ns,p99.99_ns,max_ns,times_exact,touching_percent,"
      "ticks,dropped\n");
  CHECK(toCsv(readyTable({})) ==
        "scene,spheres,method,scene_ms,tracker_ms,first_touch_ms,ready_ms,bytes,bytes_times_exact,atoms_"
        "modelled,modelled_percent\n");
}

TEST_CASE("what stands between markers is replaced, and nothing else") {
  const std::string page = "one\n<!-- sample:begin (made) -->\nold\n<!-- sample:end -->\ntwo\n";
  CHECK(replacedBetweenMarkers(page, "sample", "new\n") ==
        "one\n<!-- sample:begin (made) -->\nnew\n<!-- sample:end -->\ntwo\n");
  CHECK(replacedBetweenMarkers(page, "other", "new\n") == page);
}

TEST_CASE("every marker on the pages names a table or sentences that a run writes, stands once, and has its end") {
  std::set<std::string> written{"stability_sentences", "stiffness_sentences", "felt_sentences", "hands_sentences"};
  for (const ReportTable& t :
       {fidelityMatrix({}), stabilityMatrix({}), stabilitySummary({}), deviceTable(), stiffnessTable({}),
        stiffnessSetupsTable(), feelTable({}), feltTable("felt", "", {}), handsTable({}), handsFeltTable({})})
    written.insert(t.name);
  // The scenes in which the surface moves or has friction have tables of their own.
  written.insert("changing_stability_sentences");
  for (const ReportTable& t : {fidelityMatrix({}), stabilityMatrix({}), stabilitySummary({})})
    written.insert("changing_" + t.name);
  std::map<std::string, int> found;
  for (const char* page : {"stability.md", "hands.md"}) {
    std::ifstream in(std::string(MOLTACT_SOURCE_DIR "/docs/") + page);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    for (std::size_t at = 0; (at = text.find("<!-- ", at)) != std::string::npos; ++at) {
      const std::size_t colon = text.find(":begin", at), end = text.find("-->", at);
      if (colon > end) continue;
      const std::string name = text.substr(at + 5, colon - at - 5);
      ++found[name];
      CHECK_MESSAGE(written.contains(name), name);
      CHECK(replacedBetweenMarkers(text, name, "moltact\n").find("moltact\n<!-- " + name + ":end") !=
            std::string::npos);
    }
  }
  for (const std::string& name : written) CHECK_MESSAGE(found[name] == 1, name);
}

TEST_CASE("the page on stability names the limits that are used: 0.05 A, 0.05 N, 10 uJ and 0.055 mm") {
  const StabilityLimits limits;
  std::ifstream in(MOLTACT_SOURCE_DIR "/docs/stability.md");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto says = [&](const std::string& what) { CHECK_MESSAGE(text.find(what) != std::string::npos, what); };
  const auto n = [](double value) {
    char digits[20];
    std::snprintf(digits, sizeof digits, "%g", value);
    return std::string(digits);
  };
  says("more than " + n(limits.place_A) + " A from the reference");
  says("by " + n(limits.step_over_N) + " N more than");
  says("over a closed path the method returns over " + n(1e6 * limits.energy_J) + " uJ more");
  says("one step of its sensor, " + n(limits.jitter_mm) + " mm");
  // A spring pressed 1 A deep holds 2400 uJ.
  const LoopSettings loop;
  const double deep_mm = 1 / loop.workspace.A_per_mm;
  CHECK(0.5 * loop.stiffness_N_per_mm * deep_mm * deep_mm * 1e3 == doctest::Approx(2400));
}

TEST_CASE("names are listed as a, b and c") {
  CHECK(listed({}) == "none");
  CHECK(listed({"a"}) == "a");
  CHECK(listed({"a", "b"}) == "a and b");
  CHECK(listed({"a", "b", "c"}) == "a, b and c");
}

TEST_CASE("the first 6 series of a chart have 6 different marks, and the seventh has the first one's again") {
  std::set<Mark> marks;
  for (std::size_t k = 0; k < kMarkCount; ++k) marks.insert(markAt(k));
  CHECK(marks.size() == 6);
  for (std::size_t k = 0; k < 20; ++k) CHECK(markAt(k) == markAt(k % 6));
}

TEST_CASE("a chart is well-formed and holds each of its 3 marks and labels, not those at or below zero") {
  const std::string svg =
      chartSvg("A & B",
               {{"panel",
                 "x < 1",
                 "y",
                 {{"one", Mark::Disc, false, false, true, {{1, 1, "first"}, {10, 5, "a<b"}}},
                  {"two", Mark::Square, true, true, true, {{100, 1e-9, "far"}, {5, 0, "zero"}, {-1, 2, "minus"}}}}}},
               "note");
  CHECK(wellFormed(svg));
  // A mark in the legend for each of the two series.
  CHECK(count(svg, "class=\"mark\"") == 3 + 2);
  for (const char* label : {">first<", ">a&lt;b<", ">far<", ">A &amp; B<", ">note<"})
    CHECK(svg.find(label) != std::string::npos);
  CHECK(svg.find("zero") == std::string::npos);
  CHECK(svg.find("minus") == std::string::npos);
}

TEST_CASE("an axis from 1e-14 to 1 cuts the empty decades short and keeps the order of values") {
  const LogAxis axis({1e-14, 1e-3, 1e-2, 0.5}, 0, 100, true);
  CHECK(axis.cut());
  CHECK(axis.at(1e-14) > 0);
  CHECK(axis.at(1e-14) < axis.at(1e-3));
  CHECK(axis.at(1e-3) < axis.at(1e-2));
  CHECK(axis.at(0.5) < 100);
  CHECK((axis.at(1e-2) - axis.at(1e-3)) > 12);  // without the cut a decade would have 7
  const LogAxis whole({1, 1000}, 0, 100, false);
  CHECK_FALSE(whole.cut());
}
