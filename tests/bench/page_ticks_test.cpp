// The lines that moltact_energy_ticks prints, and what reads them.
#include "engine/bench/energies/page_ticks.h"

#include <doctest/doctest.h>

using namespace moltact;
using namespace moltact::bench;

namespace {

std::vector<EnergyTradeOff> twoPoints() {
  std::vector<EnergyTradeOff> out(2);
  out[0].body = "ligand", out[0].method = {EnergyKind::Float, 10.0};
  out[1].body = "chain", out[1].method = {EnergyKind::Tricubic, 0.375};
  for (EnergyTradeOff& p : out) p.measured = true, p.mean_us = 12.5, p.p999_us = 40;
  out[1].p999_us = 41.25;
  return out;
}

}  // namespace

TEST_CASE("the ticks of a page that are written are read for the same body and method") {
  const std::string lines = pageTickLines(twoPoints());
  CHECK(lines == "body,method,mean_us,p999_us\nligand,float 10 A,12.5,40\nchain,tricubic 0.375 A,12.5,41.25\n");
  std::vector<EnergyTradeOff> points = twoPoints();
  std::swap(points[0], points[1]);
  REQUIRE(!addPageTicks(lines, points));
  CHECK(points[0].page_mean_us == 12.5);
  CHECK(points[0].page_p999_us == 41.25);
  CHECK(points[1].page_p999_us == 40);
}

TEST_CASE("a method of the chart that is not among the points changes nothing") {
  std::vector<EnergyTradeOff> points = twoPoints();
  CHECK(!addPageTicks("body,method,mean_us,p999_us\nligand,float 14 A,1,2\n", points));
  CHECK(points[0].page_mean_us == 0);
  CHECK(points[1].page_mean_us == 0);
}

TEST_CASE("a wrong line of a page's ticks is reported with its number") {
  std::vector<EnergyTradeOff> points = twoPoints();
  for (const auto& [lines, what] : {std::pair{"", "line 1 of the page's ticks: it is not"},
                                    std::pair{"body,method\n", "line 1 of the page's ticks: it is not"},
                                    std::pair{"body,method,mean_us,p999_us\nligand,float 10 A,1\n",
                                              "line 2 of the page's ticks: it has 3 cells, not 4"},
                                    std::pair{"body,method,mean_us,p999_us\nligand,float 10 A,1,-2\n",
                                              "line 2 of the page's ticks: a time is not a positive number"},
                                    std::pair{"body,method,mean_us,p999_us\nligand,float 10 A,1,2 us\n",
                                              "line 2 of the page's ticks: a time is not a positive number"},
                                    std::pair{"body,method,mean_us,p999_us\nligand,float 11 A,1,2\n",
                                              "line 2 of the page's ticks: 'float 11 A' on 'ligand' is not in"},
                                    std::pair{"body,method,mean_us,p999_us\nvirus,float 10 A,1,2\n",
                                              "line 2 of the page's ticks: 'float 10 A' on 'virus' is not in"}}) {
    const std::string text = lines;
    CAPTURE(text);
    const auto problem = addPageTicks(text, points);
    REQUIRE(problem);
    CHECK(problem->text().find(what) != std::string::npos);
  }
}
