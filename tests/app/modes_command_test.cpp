// `moltact modes` as users call it. Oracle: published overlaps of adenylate kinase's modes with its closing, and the
// figures of docs/elastic.md.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/command_place.h"

using namespace moltact::test;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE(
    "the first mode of open adenylate kinase overlaps with its closing by 0.80, the first ten together by 0.97; its "
    "springs of 0.235 kcal/mol/A^2 give its B factors") {
  const CommandPlace place;
  const Run run = place.run("modes 4ake --toward '1ake, superposed on chain A' --json");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  const auto json = nlohmann::json::parse(run.out);
  CHECK(json["nodes"] == 214);
  CHECK(double(json["eigenvalues"][0]) == doctest::Approx(0.0306).epsilon(0.01));
  CHECK(double(json["spring_kcal_mol_A2"]) == doctest::Approx(0.235).epsilon(0.01));
  CHECK(double(json["change_A"]) == doctest::Approx(7.131).epsilon(0.01));
  CHECK(double(json["overlaps"][0]) == doctest::Approx(0.799).epsilon(0.01));
  double together = 0.0;
  for (const double overlap : json["overlaps"]) together += overlap * overlap;
  CHECK(json["overlaps"].size() == 10);
  CHECK(std::sqrt(together) == doctest::Approx(0.966).epsilon(0.005));
  const Run text = place.run("modes 4ake --count 3 --toward 1ake");
  CHECK(has(text.out, "nodes     214\n"));
  CHECK(has(text.out, "mode  eigenvalue  kcal/mol at 1 A  overlap  together\n"));
  CHECK(has(text.out, "0.236 kcal/mol/A^2"));
}

TEST_CASE(
    "a molecule without B factors has stiffnesses for unit springs; too few nodes, a wrong number and another molecule "
    "are refused with a remedy") {
  const CommandPlace place;
  const Run helix = place.run("modes alpha-helix --count 2");
  CHECK(helix.status == 0);
  CHECK(has(helix.out, "the file has no B factors"));
  CHECK(place.run("modes benzene").status != 0);
  CHECK(place.run("modes 1ubq --count 0").status != 0);
  const Run other = place.run("modes 1ubq --toward nothing-of-this-name");
  CHECK(other.status != 0);
  CHECK(has(other.err, "nothing-of-this-name"));
}
