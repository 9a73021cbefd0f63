#!/usr/bin/env python3
"""Works out the statistics of a study with NumPy and SciPy (Debian: python3-numpy, python3-scipy), which share no code with
engine/results/study_statistics.cpp. The test statistics_test.cpp compares with its output:

    /usr/bin/python3 tests/study/oracle.py > tests/study/oracle_values.h
"""
import numpy
import scipy
from scipy import optimize, special, stats

random = numpy.random.default_rng(29)


def brace(values):
    return "{" + ", ".join(repr(float(v)) for v in values) + "}"


def hedges(x, y):
    x, y = numpy.array(x), numpy.array(y)
    n1, n2 = len(x), len(y)
    df = n1 + n2 - 2
    pooled = numpy.sqrt((numpy.sum((x - x.mean()) ** 2) + numpy.sum((y - y.mean()) ** 2)) / df)
    d = (x.mean() - y.mean()) / pooled
    j = special.gamma(df / 2) / (numpy.sqrt(df / 2) * special.gamma((df - 1) / 2))
    root = numpy.sqrt(n1 * n2 / (n1 + n2))
    test = stats.ttest_ind(x, y)
    limit = [optimize.brentq(lambda nc: stats.nct.cdf(test.statistic, df, nc) - p, test.statistic - 9, test.statistic + 9,
                             xtol=1e-13) / root for p in (0.975, 0.025)]
    return [j * d, *limit, test.statistic, test.pvalue]


def items(answers):
    n, k = answers.shape
    totals = answers.sum(axis=1)
    out = []
    for i in range(k):
        rest = totals - answers[:, i]
        r = stats.pointbiserialr(answers[:, i], rest).statistic
        # Students with the same total are exchanged by their mean, so that their order does not matter.
        mean_of = {t: answers[totals == t, i].mean() for t in set(totals)}
        order = numpy.argsort(totals, kind="stable")
        sorted_means = numpy.array([mean_of[totals[s]] for s in order])
        count = int(round(0.27 * n))
        out.append([answers[:, i].mean(), r, sorted_means[-count:].mean() - sorted_means[:count].mean()])
    return out


def alpha(answers):
    covariance = numpy.cov(answers.T)
    k = len(covariance)
    return k / (k - 1) * (1 - numpy.trace(covariance) / covariance.sum())


def kr20(answers):
    p = answers.mean(axis=0)
    k = answers.shape[1]
    return k / (k - 1) * (1 - (p * (1 - p)).sum() / answers.sum(axis=1).var())


print(f"""// Written by `/usr/bin/python3 tests/study/oracle.py > tests/study/oracle_values.h`
// with NumPy {numpy.__version__} and SciPy {scipy.__version__}.
#pragma once

#include <vector>

namespace moltact::oracle {{
// clang-format off

struct Groups {{ std::vector<double> x, y; double g, low, high, t, p; }};
inline const std::vector<Groups> kGroups{{""")
for n1, n2, shift in [(2, 2, 1.0), (7, 6, 1.5), (20, 20, 0.5), (31, 12, -0.8), (60, 55, 0.0), (5, 9, 6.0)]:
    x = random.normal(5 + shift, 1, n1).round(3)
    y = random.normal(5, 1, n2).round(3)
    print("    {" + brace(x) + ",\n     " + brace(y) + ",\n     " + brace(hedges(x, y))[1:] + ",")
print("};\n\nstruct NoncentralT { double t, df, delta, cdf; };\ninline const std::vector<NoncentralT> kNoncentralT{")
for t in (-3.0, -0.5, 0.0, 1.2, 4.0, 15.0):
    for df in (2, 11, 118):
        for delta in (-1.5, 0.0, 0.7, 3.0, 12.0):
            print("    " + brace([t, df, delta, stats.nct.cdf(t, df, delta)]) + ",")
print("};\n\nstruct Quantile { double p, df, t; };\ninline const std::vector<Quantile> kQuantiles{")
for p in (0.025, 0.5, 0.9, 0.975, 0.9995):
    for df in (1, 2, 11, 500):
        print("    " + brace([p, df, stats.t.ppf(p, df)]) + ",")
print("};\n\nstruct Power { int n1, n2; double delta, power; };\ninline const std::vector<Power> kPowers{")
for n1, n2, delta in [(20, 20, 0.5), (64, 64, 0.5), (30, 45, 0.8), (10, 10, 0.0), (12, 12, -1.1)]:
    df, nc = n1 + n2 - 2, delta * numpy.sqrt(n1 * n2 / (n1 + n2))
    critical = stats.t.ppf(0.975, df)
    power = stats.nct.sf(critical, df, nc) + stats.nct.cdf(-critical, df, nc)
    print(f"    {{{n1}, {n2}, {delta}, {float(power)!r}}},")
print("};\n\nstruct Test { std::vector<const char*> answers; std::vector<std::vector<double>> items; double alpha; };")
print("inline const std::vector<Test> kTests{")
for students, questions in [(14, 5), (40, 12), (101, 12)]:
    ability = random.normal(0, 1, students)
    hardness = numpy.linspace(-1.5, 1.5, questions)
    answers = (random.random((students, questions)) < special.expit(1.4 * (ability[:, None] - hardness))).astype(int)
    assert abs(alpha(answers) - kr20(answers)) < 1e-12
    print("    {{" + ", ".join('"' + "".join(map(str, row)) + '"' for row in answers) + "},")
    print("     {" + ",\n      ".join(brace(i) for i in items(answers)) + "},\n     " + repr(float(alpha(answers))) + "},")
mean, sd = 5.0, 2.0
values = random.normal(mean, sd, 17).round(3)
low, high = stats.t.interval(0.95, len(values) - 1, values.mean(), stats.sem(values))
print("};\n\ninline const std::vector<double> kValues" + brace(values) + ";")
print(f"inline constexpr double kHalfWidth = {float((high - low) / 2)!r};")
print("\n// clang-format on\n}  // namespace moltact::oracle")
