#include "engine/core/quantile.h"

#include <doctest/doctest.h>

using namespace moltact;

TEST_CASE("quantiles of 1, 2, 3, 4 by linear interpolation") {
  CHECK(quantile({1, 2, 3, 4}, 0.5) == 2.5);
  CHECK(quantile({1, 2, 3, 4}, 0.25) == 1.75);
  CHECK(quantile({1, 2, 3, 4}, 1.0) == 4.0);
  CHECK(quantile({7}, 0.3) == 7.0);
  CHECK(quantile({}, 0.5) == 0.0);
}

TEST_CASE("percentiles of 1 to 100 by nearest rank are values of the list: 50, 99 and 100") {
  std::vector<double> values;
  for (int k = 1; k <= 100; ++k) values.push_back(k);
  CHECK(percentile(values, 0.5) == 50.0);
  CHECK(percentile(values, 0.99) == 99.0);
  CHECK(percentile(values, 0.999) == 100.0);
  CHECK(percentile(values, 0.0) == 1.0);
  CHECK(percentile({}, 0.5) == 0.0);
}
