#include "shared/math.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

TEST_CASE("elementary functions have the host's bytes, in one lane and in sixteen", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  constexpr std::size_t function_count = 6;
  std::size_t const count = 16 * scaled_count(1 << 14);
  std::mt19937_64 random(5);
  std::vector<float> xs, ys;
  auto const number = [&](std::size_t i) {
    auto const sign = random() % 2 == 0 ? 1.0f : -1.0f;
    if (i % 2 == 0) return sign * float(double(random() >> 11) * 0x1p-50);
    return sign * std::bit_cast<float>(std::uint32_t(random() % 0x7f800000u));
  };
  for (std::size_t i = 0; i < count; ++i) {
    xs.push_back(number(i));
    ys.push_back(number(i));
  }
  for (int const lanes : {1, 16}) {
    std::string first_difference;
    std::vector<float> results(function_count * count);
    ProbeProgram const program("math_functions.cl", fmt::format("-D LANES={}", lanes));
    program.run("probe_functions", count / std::size_t(lanes), {in(xs), in(ys), out(results)});
    for (std::size_t i = 0; i < count; ++i) {
      float const x = xs[i], y = ys[i];
      float cosine;
      float const sine = device::sin_and_cos_of(x, &cosine);
      std::array<float, function_count> const expected{device::pow_of(std::fabs(x), std::fabs(y)),
                                                       device::exp_of(x),
                                                       device::log_of(std::fabs(x)),
                                                       sine,
                                                       cosine,
                                                       std::fabs(x) < 1 ? device::acos_of(x) : device::atan2_of(x, y)};
      for (std::size_t k = 0; k < function_count; ++k) {
        float const got = results[function_count * i + k];
        bool const is_wild = k == 3 || k == 4;  // sines of numbers beyond what they are for: conversions overflow
        if (is_wild && std::fabs(x) > 32768) continue;
        bool const is_same = std::bit_cast<std::uint32_t>(got) == std::bit_cast<std::uint32_t>(expected[k]);
        if (is_same || !first_difference.empty()) continue;
        first_difference = fmt::format("function {} of {}, {}: {} instead of {}", k, x, y, got, expected[k]);
      }
    }
    CHECK(first_difference == "");
  }
}

TEST_CASE("products and sums are rounded one by one, unless fma is written", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  std::size_t const count = 16 * scaled_count(1 << 10);
  std::mt19937_64 random(6);
  std::vector<float> a, b, c;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::vector<float>* const list : {&a, &b, &c}) list->push_back(1 + float(random() >> 40) * 0x1p-24f);
  }
  for (int const lanes : {1, 16}) {
    std::vector<float> results(3 * count);
    ProbeProgram const program("math_functions.cl", fmt::format("-D LANES={}", lanes));
    program.run("probe_products", count / std::size_t(lanes), {in(a), in(b), in(c), out(results)});
    std::size_t wrong = 0, telling = 0;
    for (std::size_t i = 0; i < count; ++i) {
      // A product of two floats is exact as a double.
      auto const product = [](float x, float y) { return float(double(x) * double(y)); };
      float const sum = float(double(product(a[i], b[i])) + double(c[i]));
      float const difference = float(double(product(a[i], b[i])) - double(product(c[i], a[i])));
      float const fused = std::fma(a[i], b[i], c[i]);
      wrong += !(results[3 * i] == sum && results[3 * i + 1] == difference && results[3 * i + 2] == fused);
      telling += sum != fused;
    }
    CHECK(wrong == 0);
    CHECK(telling > count / 20);
  }
}
