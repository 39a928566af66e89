#include "app/values.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

namespace lichtraum::app {
namespace {

/// The whole text as a number, in decimal digits only.
template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

template <class Number>
Number number_in_range(std::string_view text, Number low, Number high) {
  auto const value = number<Number>(text);
  if (!value || *value < low || *value > high) {
    throw std::invalid_argument(fmt::format("expected a whole number from {} to {}", low, high));
  }
  return *value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    std::size_t const end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

template <class Value>
struct Word {
  std::string_view word;
  Value value;
};

template <class Value, std::size_t count>
Value word(std::string_view text, Word<Value> const (&words)[count]) {
  std::string expected;
  for (Word<Value> const& entry : words) {
    if (entry.word == text) return entry.value;
    expected += fmt::format("{}{}", expected.empty() ? "" : &entry == &words[count - 1] ? " or " : ", ", entry.word);
  }
  throw std::invalid_argument("expected " + expected);
}

}  // namespace

Resolution parse_size(std::string_view text) {
  auto const parts = split(text, 'x');
  auto const width = number<int>(parts[0]);
  auto const height = parts.size() == 2 ? number<int>(parts[1]) : std::nullopt;
  if (!width || !height) throw std::invalid_argument("expected WIDTHxHEIGHT in pixels, such as 1280x720");
  if (*width < 1 || *height < 1) throw std::invalid_argument("a picture has at least 1x1 pixels");
  return {*width, *height};
}

Region parse_region(std::string_view text) {
  auto const parts = split(text, ',');
  std::array<int, 4> numbers{};
  bool good = parts.size() == numbers.size();
  for (std::size_t i = 0; good && i < numbers.size(); ++i) {
    auto const value = number<int>(parts[i]);
    good = value.has_value() && *value >= 0;
    if (good) numbers[i] = *value;
  }
  if (!good)
    throw std::invalid_argument("expected X,Y,WIDTH,HEIGHT in pixels from the top left corner, such as 0,0,320,240");
  if (numbers[2] < 1 || numbers[3] < 1) throw std::invalid_argument("a region has at least 1x1 pixels");
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

Sampling parse_samples(std::string_view text) {
  constexpr int max_side = 1024;
  auto const parts = split(text, 'x');
  auto const first = number<int>(parts[0]);
  if (parts.size() == 1 && first && *first >= 1 && *first <= max_side * max_side) {
    return {*first == 1 ? Sampling::Pattern::grid : Sampling::Pattern::seeded, *first};
  }
  if (parts.size() == 2 && parts[0] == parts[1] && first && *first >= 1 && *first <= max_side) {
    return {Sampling::Pattern::grid, *first * *first};
  }
  throw std::invalid_argument(fmt::format(
      "expected a number of samples per pixel from 1 to {}, or a square grid such as 4x4", max_side * max_side));
}

int parse_depth(std::string_view text) { return number_in_range(text, 0, 1000); }

std::uint64_t parse_seed(std::string_view text) {
  return number_in_range(text, std::uint64_t(0), std::numeric_limits<std::uint64_t>::max());
}

double parse_time(std::string_view text) {
  auto const seconds = number<double>(text);
  if (!seconds || !std::isfinite(*seconds)) throw std::invalid_argument("expected a number of seconds");
  return *seconds;
}

FrameRange parse_frames(std::string_view text) {
  std::size_t const dots = text.find("..");
  auto const first = number<int>(text.substr(0, dots));
  auto const last = dots == std::string_view::npos ? first : number<int>(text.substr(dots + 2));
  if (!first || !last || *first < 0) throw std::invalid_argument("expected numbers of frames, such as 0..99");
  if (*first > *last) throw std::invalid_argument("expected the first frame before the last");
  if (*last > 10'000'000) throw std::invalid_argument("expected frames up to 10000000");
  return {*first, *last};
}

double parse_frame_rate(std::string_view text) {
  auto const rate = number<double>(text);
  if (!rate || !(*rate > 0 && *rate <= 1000)) throw std::invalid_argument("expected frames per second, up to 1000");
  return *rate;
}

int parse_turntable(std::string_view text) { return number_in_range(text, 1, 100'000); }

int parse_texture_size(std::string_view text) { return number_in_range(text, 1, 65536); }

int parse_bits(std::string_view text) { return word<int>(text, {{"8", 8}, {"16", 16}}); }

int parse_quality(std::string_view text) { return number_in_range(text, 1, 100); }

PlaneSet parse_planes(std::string_view text) {
  PlaneSet planes;
  for (std::string_view const part : split(text, ',')) {
    std::string expected = "expected names with commas between, of:";
    bool is_known = false;
    for (std::size_t i = 0; i < plane_count; ++i) {
      auto const plane = FilmPlane(i);
      std::string_view const name = info_of(plane).name;
      expected += fmt::format("{} {}", i == 0 ? "" : ",", name);
      if (part != name) continue;
      planes.add(plane);
      is_known = true;
    }
    if (!is_known) throw std::invalid_argument(expected);
  }
  return planes;
}

std::optional<Rgb> parse_background(std::string_view text) {
  if (text == "none") return std::nullopt;
  auto const parts = split(text, ',');
  Rgb color(0);
  bool is_good = parts.size() == 3;
  for (int i = 0; is_good && i < 3; ++i) {
    auto const value = number<double>(parts[std::size_t(i)]);
    is_good = value && std::isfinite(*value) && *value >= 0;
    if (is_good) color[i] = *value;
  }
  if (!is_good) throw std::invalid_argument("expected none, or red, green and blue, such as 0.2,0.3,0.5");
  return color;
}

double parse_exposure(std::string_view text) {
  auto const stops = number<double>(text);
  if (!stops || !(std::abs(*stops) <= 100)) throw std::invalid_argument("expected stops from -100 to 100, such as 1.5");
  return *stops;
}

std::optional<Traversal> parse_traversal(std::string_view text) {
  return word<std::optional<Traversal>>(text, {{"auto", std::nullopt},
                                               {"scalar", Traversal::scalar},
                                               {"wide", Traversal::wide},
                                               {"packet", Traversal::packet}});
}

ToneMap parse_tone_map(std::string_view text) {
  return word<ToneMap>(text, {{"auto", ToneMap::automatic}, {"none", ToneMap::none}, {"reinhard", ToneMap::reinhard}});
}

Transfer parse_transfer(std::string_view text) {
  return word<Transfer>(text, {{"linear", Transfer::linear}, {"srgb", Transfer::srgb}});
}

TransformOrder parse_transform_order(std::string_view text) {
  return word<TransformOrder>(text, {{"parent", TransformOrder::parent}, {"local", TransformOrder::local}});
}

RotationSense parse_rotation(std::string_view text) {
  return word<RotationSense>(text, {{"right", RotationSense::right}, {"left", RotationSense::left}});
}

std::vector<MaterialExtra> parse_material_extras(std::string_view text) {
  std::vector<MaterialExtra> extras;
  for (std::string_view const part : split(text, ',')) {
    extras.push_back(word<MaterialExtra>(part, {{"reflectance", MaterialExtra::reflectance},
                                                {"transmittance", MaterialExtra::transmittance},
                                                {"opacity", MaterialExtra::opacity},
                                                {"ior", MaterialExtra::ior},
                                                {"ignore", MaterialExtra::ignore}}));
  }
  return extras;
}

}  // namespace lichtraum::app
