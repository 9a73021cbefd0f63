// Statistics on known numbers, and the forms in which results are written.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "engine/bench/accuracy.h"
#include "engine/bench/chart_svg.h"
#include "engine/bench/log_axis.h"
#include "engine/bench/report_table.h"
#include "engine/bench/statistics.h"
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
    const std::string name =
        tag.substr(tag[0] == '/' ? 1 : 0, tag.find_first_of(" /", 1) - (tag[0] == '/' ? 1 : 0));
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
  const Spread s = spreadOf(values);
  CHECK(s.count == 10'000);
  CHECK(s.mean == doctest::Approx(5000.5));
  CHECK(s.p50 == 5000);
  CHECK(s.p99 == 9900);
  CHECK(s.p9999 == 9999);
  CHECK(s.max == 10'000);
  CHECK(spreadOf({3, 4}).rms == doctest::Approx(std::sqrt(12.5)));
  CHECK(spreadOf({}).max == 0);
}

TEST_CASE("the front of (1,9) (2,5) (2,6) (3,5) (4,1) is the first, second and last point") {
  CHECK(paretoFront({1, 2, 2, 3, 4}, {9, 5, 6, 5, 1}) == std::vector<std::size_t>{0, 1, 4});
}

TEST_CASE("angles of a billionth of a degree and of 180 degrees are told exactly") {
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
  CHECK(csv ==
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

TEST_CASE("a chart is well-formed and holds each of its 3 marks and labels, not those at or below zero") {
  const std::string svg = chartSvg(
      "A & B",
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
