#include "contest.hpp"

#include <fmt/format.h>

#include <limits>

namespace lichtraum::bench {

void Contest::run(int repetitions, Clock const& clock) {
  for (Contestant& contestant : contestants_) {
    contestant.run();  // also compiles
    contestant.disagree = contestant.disagreement();
  }
  for (int i = 0; i < repetitions; ++i) {
    for (Contestant& contestant : contestants_) contestant.ms.push_back(clock(contestant.run));
  }
}

double Contest::ratio_to_fastest_peer(Contestant const& contestant) const {
  double fastest = std::numeric_limits<double>::quiet_NaN();  // unless there is a peer
  for (Contestant const& other : contestants_) {
    if (other.is_peer && other.rays == contestant.rays) fastest = std::fmin(fastest, median(other.ms));
  }
  return fastest / median(contestant.ms);
}

void Contest::print() const {
  for (Contestant const& c : contestants_) {
    double const ms = median(c.ms);
    fmt::print("{:8} {:16} {:8.2f} ms {:8.2f} Mrays/s {:6.2f} x  disagree {:.6f} %\n", c.rays, c.name, ms,
               double(c.count) / ms / 1e3, ratio_to_fastest_peer(c), 100 * c.disagree);
  }
}

std::string Contest::json() const {
  std::string text;
  for (Contestant const& c : contestants_) {
    double const ms = median(c.ms);
    text += fmt::format(
        "{}\n    {{\"rays\": \"{}\", \"tracer\": \"{}\", \"ms\": {:.4f}, \"mrays_per_s\": {:.3f}, \"ratio\": {:.4f}, "
        "\"disagree\": {:.9f}}}",
        text.empty() ? "" : ",", c.rays, c.name, ms, double(c.count) / ms / 1e3, ratio_to_fastest_peer(c), c.disagree);
  }
  return text;
}

}  // namespace lichtraum::bench
