#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "lichtraum.hpp"

/// Noisy by path, with a lamp that has a size.
inline constexpr char const* lamp_scene =
    "define material red 0.1 0 0 0.7 0.2 0.2 0 0 0 1\n"
    "define shape sphere ball 0 0 -3 1 red\n"
    "define shape box floor -4 -2 -8 4 -1 0 red\n"
    "define light diffuse sun 3 4 0 30 30 30 radius=0.5\n"
    "define camera eye 60\n"
    "render eye lamp.png 50 37\n";

/// Commands under `lichtraum job`, on the reference tracer.
struct Farm : Lichtraum {
  Farm() {
    folder.write("ball.sdf", ball_scene);
    folder.write("lamp.sdf", lamp_scene);
  }
  ProcessResult plan(std::string const& words) const {
    return (*this)("job plan --device reference -o shared -q " + words);
  }
  ProcessResult work(std::string const& words = "") const {
    return (*this)("job work shared " + words);  // by the plan's device
  }
  ProcessResult merge(std::string const& words) const { return (*this)("job merge shared " + words); }
  nlohmann::json status() const { return nlohmann::json::parse((*this)("job status shared --json").out); }

  std::vector<std::filesystem::path> files(std::string const& extension) const {
    std::vector<std::filesystem::path> found;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(folder / "shared")) {
      if (entry.is_regular_file() && entry.path().extension() == extension) found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
  }
  std::filesystem::path unit(int number) const {
    for (std::filesystem::path const& path : files(".unit")) {
      if (path.stem() == std::to_string(number)) return path;
    }
    throw std::runtime_error("there is no unit " + std::to_string(number));
  }
};

inline std::string bytes_of(std::filesystem::path const& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
inline void put(std::filesystem::path const& path, std::string const& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}
