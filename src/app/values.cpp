#include "app/values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

#include "core/srgb.hpp"
#include "farm/plan.hpp"
#include "lichtraum/words.hpp"

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

/// Takes a colour from the front: red, green and blue, or one as "#rrggbb" (sRGB). Nothing where there is none.
std::optional<Rgb> take_color(std::vector<std::string_view>& parts) {
  auto const drop = [&](std::ptrdiff_t count) { parts.erase(parts.begin(), parts.begin() + count); };
  Rgb color(0);
  if (!parts.empty() && parts[0].starts_with('#')) {
    std::string_view const digits = parts[0].substr(1);
    std::uint32_t value = 0;
    auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (digits.size() != 6 || error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    for (int i = 0; i < 3; ++i) color[i] = linear_from_srgb(((value >> (16 - 8 * i)) & 0xff) / 255.0);
    drop(1);
    return color;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    auto const share = i < parts.size() ? number<double>(parts[i]) : std::nullopt;
    if (!share || !std::isfinite(*share) || *share < 0) return std::nullopt;
    color[int(i)] = *share;
  }
  drop(3);
  return color;
}

/// Finite numbers with commas between; false where the text is anything else.
bool read_numbers(std::string_view text, std::span<double> numbers) {
  auto const parts = split(text, ',');
  for (std::size_t i = 0; i < numbers.size() && parts.size() == numbers.size(); ++i) {
    auto const value = number<double>(parts[i]);
    if (!value || !std::isfinite(*value)) return false;
    numbers[i] = *value;
  }
  return parts.size() == numbers.size();
}

template <class Value, std::size_t count>
Value word(std::string_view text, std::array<Word<Value>, count> const& words) {
  std::span<Word<Value> const> const known(words);
  if (Value const* const value = find_value(known, text)) return *value;
  throw std::invalid_argument("expected " + list_of(known));
}

/// `noun`: what is numbered, one and several.
FrameRange parse_range(std::string_view text, std::string_view noun, std::string_view nouns, int largest) {
  std::size_t const dots = text.find("..");
  auto const first = number<int>(text.substr(0, dots));
  auto const last = dots == std::string_view::npos ? first : number<int>(text.substr(dots + 2));
  if (!first || !last || *first < 0)
    throw std::invalid_argument(fmt::format("expected numbers of {}, such as 0..99", nouns));
  if (*first > *last) throw std::invalid_argument(fmt::format("expected the first {} before the last", noun));
  if (*last > largest) throw std::invalid_argument(fmt::format("expected {} up to {}", nouns, largest));
  return {*first, *last};
}

}  // namespace

Resolution parse_size(std::string_view text) {
  auto const parts = split(text, 'x');
  auto const width = number<int>(parts[0]);
  auto const height = parts.size() == 2 ? number<int>(parts[1]) : std::nullopt;
  if (!width || !height) throw std::invalid_argument("expected WIDTHxHEIGHT in pixels, such as 1280x720");
  if (*width < 1 || *height < 1) throw std::invalid_argument("expected at least 1x1 pixels");
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
  using job_limits::grid_side;
  auto const parts = split(text, 'x');
  auto const first = number<int>(parts[0]);
  if (parts.size() == 1 && first && *first >= 1 && *first <= job_limits::samples) {
    return {*first == 1 ? Sampling::Pattern::grid : Sampling::Pattern::seeded, *first};
  }
  if (parts.size() == 2 && parts[0] == parts[1] && first && *first >= 1 && *first <= grid_side) {
    return {Sampling::Pattern::grid, *first * *first};
  }
  throw std::invalid_argument(fmt::format(
      "expected a number of samples per pixel from 1 to {}, or a square grid such as 4x4", job_limits::samples));
}

int parse_depth(std::string_view text) { return number_in_range(text, 0, job_limits::depth); }

std::uint64_t parse_seed(std::string_view text) {
  return number_in_range(text, std::uint64_t(0), std::numeric_limits<std::uint64_t>::max());
}

double parse_time(std::string_view text) {
  auto const seconds = number<double>(text);
  if (!seconds || !std::isfinite(*seconds)) throw std::invalid_argument("expected a number of seconds");
  return *seconds;
}

FrameRange parse_frames(std::string_view text) { return parse_range(text, "frame", "frames", 10'000'000); }

FrameRange parse_units(std::string_view text) { return parse_range(text, "unit", "units", int(farm::most_units - 1)); }

double parse_ui_scale(std::string_view text) {
  auto const scale = number<double>(text);
  if (!scale || !(*scale >= 0.5 && *scale <= 8)) throw std::invalid_argument("expected a factor from 0.5 to 8");
  return *scale;
}

double parse_frame_rate(std::string_view text) {
  auto const rate = number<double>(text);
  if (!rate || !(*rate > 0 && *rate <= 1000)) throw std::invalid_argument("expected frames per second, up to 1000");
  return *rate;
}

int parse_count(std::string_view text) { return number_in_range(text, 1, 100'000); }

int parse_texture_size(std::string_view text) { return number_in_range(text, 1, job_limits::texture_side); }

double parse_point_size(std::string_view text) {
  auto const size = number<double>(text);
  if (!size || !(*size >= job_limits::least_point_size && *size <= job_limits::point_size)) {
    throw std::invalid_argument("expected thousandths of the model's diagonal, above 0 and at most 1000, such as 2");
  }
  return *size;
}

int parse_thumbnail_side(std::string_view text) { return number_in_range(text, 1, 2048); }

int parse_bits(std::string_view text) { return word(text, std::to_array<Word<int>>({{"8", 8}, {"16", 16}})); }

int parse_quality(std::string_view text) { return number_in_range(text, 1, job_limits::jpeg_quality); }

PlaneSet parse_planes(std::string_view text) {
  auto const words = plane_words();
  std::span<Word<FilmPlane> const> const known(words);
  PlaneSet planes;
  for (std::string_view const part : split(text, ',')) {
    FilmPlane const* const plane = find_value(known, part);
    if (!plane) throw std::invalid_argument("expected names separated by commas, of: " + list_of(known));
    planes.add(*plane);
  }
  return planes;
}

JobBackground parse_background(std::string_view text) {
  if (text == "none") return {};
  if (text == "environment") return {Background::environment()};
  auto parts = split(text, ',');
  auto const top = take_color(parts);
  auto const bottom = top && !parts.empty() ? take_color(parts) : top;
  if (!bottom || !parts.empty()) {
    throw std::invalid_argument(
        "expected environment, none, a colour as red, green and blue, such as 0.2,0.3,0.5, or as '#336699', or two of "
        "them: for the picture's upper edge and its lower one");
  }
  return {Background(*top, *bottom)};
}

Vec3 parse_point(std::string_view text) {
  std::array<double, 3> point{};
  if (!read_numbers(text, point)) throw std::invalid_argument("expected three numbers, X,Y,Z, such as 0,1.5,5");
  return {point[0], point[1], point[2]};
}

double parse_aperture(std::string_view text) {
  auto const diameter = number<double>(text);
  if (!diameter || !(*diameter >= 0) || !std::isfinite(*diameter)) {
    throw std::invalid_argument("expected a diameter of at least 0, in units of the scene, such as 0.1");
  }
  return *diameter;
}

JobView::Focus parse_focus(std::string_view text) {
  std::array<double, 3> point{};
  if (read_numbers(text, point)) return Vec3(point[0], point[1], point[2]);
  double distance = 0;
  if (!read_numbers(text, std::span(&distance, 1)) || distance <= 0) {
    throw std::invalid_argument("expected a distance above 0, such as 2.5, or a point X,Y,Z");
  }
  return distance;
}

double parse_fov(std::string_view text) {
  auto const degrees = number<double>(text);
  if (!degrees || !(*degrees > 0 && *degrees < 180)) {
    throw std::invalid_argument("expected degrees between 0 and 180, such as 45");
  }
  return *degrees;
}

JobView::Orbit parse_orbit(std::string_view text) {
  std::array<double, 3> numbers{0, 0, 1};
  auto const count = std::size_t(1 + std::count(text.begin(), text.end(), ','));
  bool const is_good = (count == 2 || count == 3) && read_numbers(text, std::span(numbers.data(), count)) &&
                       std::abs(numbers[1]) <= 90 && numbers[2] > 0;
  if (!is_good) {
    throw std::invalid_argument(
        "expected azimuth and elevation (-90 to 90) in degrees, and perhaps a distance above 0 (without one, the "
        "camera sees everything), such as 35,20 or 35,20,5");
  }
  return {numbers[0], numbers[1], count == 3 ? std::optional(numbers[2]) : std::nullopt};
}

double parse_clamp(std::string_view text) {
  auto const radiance = number<double>(text);
  if (!radiance || !(*radiance > 0) || !std::isfinite(*radiance)) {
    throw std::invalid_argument("expected a radiance above 0, such as 10");
  }
  return *radiance;
}

double parse_noise(std::string_view text) {
  auto const noise = number<double>(text);
  if (!noise || !(*noise > 0) || *noise > 1) {
    throw std::invalid_argument("expected a share of the brightness above 0, at most 1, such as 0.05");
  }
  return *noise;
}

double parse_exposure(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  auto const stops = number<double>(text);
  constexpr double most = job_limits::exposure_ev;
  if (!stops || !(std::abs(*stops) <= most)) {
    throw std::invalid_argument(fmt::format("expected stops from {} to {}, such as 1.5", -most, most));
  }
  return *stops;
}

Ground parse_ground(std::string_view text) {
  return text == "true" ? Ground::matt : word(text, ground_words);  // CLI11's name for a flag without a value
}

Integrator parse_integrator(std::string_view text) { return word(text, integrator_words); }
double parse_environment_rotation(std::string_view text) {
  auto const degrees = number<double>(text);
  constexpr double most = job_limits::environment_degrees;
  if (!degrees || !(std::abs(*degrees) <= most)) {
    throw std::invalid_argument(fmt::format("expected degrees from {} to {}, such as 90", -most, most));
  }
  return *degrees;
}

double parse_environment_brightness(std::string_view text) {
  auto const brightness = number<double>(text);
  constexpr double most = job_limits::environment_brightness;
  if (!brightness || !(*brightness >= 0 && *brightness <= most)) {
    throw std::invalid_argument(fmt::format("expected a number from 0 to {}, such as 0.5", most));
  }
  return *brightness;
}

std::optional<Traversal> parse_traversal(std::string_view text) {
  return word(text, std::to_array<Word<std::optional<Traversal>>>({{"auto", std::nullopt},
                                                                   {"scalar", Traversal::scalar},
                                                                   {"wide", Traversal::wide},
                                                                   {"packet", Traversal::packet}}));
}

ToneMap parse_tone_map(std::string_view text) { return word(text, tone_map_words); }

Denoising parse_denoising(std::string_view text) { return word(text, denoising_words); }

Transfer parse_transfer(std::string_view text) { return word(text, transfer_words); }

TransformOrder parse_transform_order(std::string_view text) { return word(text, transform_order_words); }

RotationSense parse_rotation(std::string_view text) { return word(text, rotation_words); }

std::string parse_input_format(std::string_view text) {
  auto formats = model_formats();
  formats.insert(formats.begin(), "sdf");
  if (std::find(formats.begin(), formats.end(), text) != formats.end()) return std::string(text);
  std::string const last(formats.back());
  formats.pop_back();
  throw std::invalid_argument(fmt::format("expected {} or {}", fmt::join(formats, ", "), last));
}

std::vector<MaterialExtra> parse_material_extras(std::string_view text) {
  std::vector<MaterialExtra> extras;
  for (std::string_view const part : split(text, ',')) {
    extras.push_back(word(part, material_extra_words));
  }
  return extras;
}

}  // namespace lichtraum::app
