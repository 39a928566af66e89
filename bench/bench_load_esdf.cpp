// How fast eSDF files load: from_file to the finished scene, in MB (10^6 bytes) per second. Loading takes one thread;
// the figures are processor time, the median of several runs, so that other work on the machine does not count. Usage:
// bench_load_esdf [triangles] [runs]

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "lichtraum/esdf.hpp"

namespace {

using namespace lichtraum;

double processor_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A soup of small triangles; `format` writes one coordinate.
std::string triangles(int count, char const* format) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-100, 100);
  std::uniform_real_distribution<double> offset(-1, 1);
  std::string text = "define material red 1 0 0 1 0 0 1 0 0 10\n";
  for (int i = 0; i < count; ++i) {
    double const center[] = {place(random), place(random), place(random)};
    text += fmt::format("define shape triangle t{}", i);
    for (int k = 0; k < 9; ++k) text += fmt::format(fmt::runtime(format), center[k % 3] + offset(random));
    text += " red\n";
  }
  return text + "define camera eye 45\nrender eye image.png 640 480\n";
}

void measure(char const* name, std::string const& text, int runs) {
  auto const path = std::filesystem::temp_directory_path() / "lichtraum_bench_load.sdf";
  std::ofstream(path, std::ios::binary) << text;
  std::vector<double> times;
  std::size_t shapes = 0;
  for (int i = 0; i < runs; ++i) {
    double const begin = processor_milliseconds();
    Scene const scene = load_esdf(path);
    times.push_back(processor_milliseconds() - begin);
    shapes = scene.shapes.size();
  }
  std::filesystem::remove(path);
  std::sort(times.begin(), times.end());
  double const median = times[times.size() / 2];
  double const megabytes = static_cast<double>(text.size()) / 1e6;
  fmt::print("{:<24} {:>9} shapes {:>7.1f} MB {:>8.1f} ms {:>7.1f} MB/s {:>7.0f} ns/shape\n", name, shapes, megabytes,
             median, 1e3 * megabytes / median, 1e6 * median / static_cast<double>(shapes));
}

}  // namespace

int main(int argc, char* argv[]) {
  int const count = argc > 1 ? std::atoi(argv[1]) : 1'000'000;
  int const runs = argc > 2 ? std::atoi(argv[2]) : 5;
  measure("triangles, 2 decimals", triangles(count, " {:.2f}"), runs);
  measure("triangles, 4 decimals", triangles(count, " {:.4f}"), runs);
  measure("triangles, 9 digits", triangles(count, " {:.9g}"), runs);
  measure("triangles, 17 digits", triangles(count, " {:.17g}"), runs);
}
