#pragma once

#include <span>

namespace lichtraum::test {

/// How likely two sets of measurements of one quantity differ by as much as they do, or more: Welch's t-test, two-sided
/// (Welch, "The Generalization of 'Student's' Problem When Several Different Population Variances Are Involved", 1947).
/// The variances may differ; at least two measurements each. Means that differ by less than `tolerance` give 1.
double welch_probability(std::span<double const> a, std::span<double const> b, double tolerance = 0);

/// The level of each of `count` independent tests, of which one or more fail with probability `level` where nothing is
/// wrong: Sidak, "Rectangular Confidence Regions for the Means of Multivariate Normal Distributions", 1967.
double sidak_level(double level, std::size_t count);

}  // namespace lichtraum::test
