#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench_rays.hpp"

namespace lichtraum::bench {

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// Milliseconds that some work takes.
using Clock = std::function<double(std::function<void()> const&)>;

/// Ways to trace sets of rays, which take turns.
class Contest {
 public:
  /// `count` of the `size` results are of rays that exist. `trace(results)` fills all of them. What others find is
  /// compared with what the first for these rays does.
  template <class Result>
  void add(std::string rays, std::string name, bool is_peer, std::size_t count, std::size_t size,
           std::function<void(std::vector<Result>&)> trace) {
    auto const results = std::make_shared<std::vector<Result>>(size);
    auto const expected = first_results<Result>(rays, results);
    contestants_.push_back({std::move(rays), std::move(name), is_peer, count, [=] { trace(*results); },
                            [=] { return share_different(*results, *expected); }, results});
  }

  /// Once each to warm up and compare, then `repetitions` rounds.
  void run(int repetitions, Clock const& clock);

  /// A line each: its median, and how many times as fast it is as the fastest peer with the same rays.
  void print() const;
  /// The same as elements of a JSON array.
  std::string json() const;

 private:
  struct Contestant {
    std::string rays, name;
    bool is_peer;
    std::size_t count;
    std::function<void()> run;
    std::function<double()> disagreement;
    std::shared_ptr<void> results;
    std::vector<double> ms = {};
    double disagree = 0;
  };
  std::vector<Contestant> contestants_;

  template <class Result>
  std::shared_ptr<std::vector<Result>> first_results(std::string const& rays,
                                                     std::shared_ptr<std::vector<Result>> const& own) const {
    for (Contestant const& other : contestants_) {
      if (other.rays == rays) return std::static_pointer_cast<std::vector<Result>>(other.results);
    }
    return own;
  }

  static bool is_same(RayHit const& a, RayHit const& b) {
    return a.t == b.t || std::abs(a.t - b.t) <= 1e-4f * std::abs(b.t);
  }
  static bool is_same(std::uint8_t a, std::uint8_t b) { return a == b; }
  template <class Result>
  static double share_different(std::vector<Result> const& a, std::vector<Result> const& b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i) different += is_same(a[i], b[i]) ? 0 : 1;
    return double(different) / double(a.size());
  }

  double ratio_to_fastest_peer(Contestant const& contestant) const;
};

}  // namespace lichtraum::bench
