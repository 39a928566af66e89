#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/files_read.hpp"
#include "app/renderer_choice.hpp"
#include "app/stopwatch.hpp"
#include "app/values.hpp"
#include "core/counted.hpp"
#include "core/read_file.hpp"
#include "lichtraum/denoise.hpp"
#include "lichtraum/exr_layers.hpp"
#include "lichtraum/image_io.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* denoise_description =
    "Takes the noise out of the radiance that an OpenEXR file holds, guided by its\n"
    "albedo and normals: FILE is what 'lichtraum render --planes\n"
    "radiance,albedo,normal' writes. All other layers stay as they are.";

constexpr char const* denoise_examples =
    "  lichtraum denoise film.exr\n"
    "  lichtraum denoise film.exr -o picture.png --exposure 1\n"
    "  lichtraum denoise film.exr -o smooth.exr --denoise builtin\n";

constexpr Development usual_development{0, ToneMap::none, Transfer::srgb};

struct DenoiseOptions {
  std::string input;
  std::filesystem::path output;
  Denoising denoising = Denoising::on;
  bool has_noisy_guides = false;
  std::string device;
  Development development = usual_development;
};

Denoising parse_denoiser(std::string_view text) {
  if (text == "on") return Denoising::on;
  if (text == "builtin") return Denoising::builtin;
  throw std::invalid_argument("expected on or builtin");
}

bool parse_denoise(Arguments const& arguments, DenoiseOptions& options, Console& console) {
  auto const parser = make_parser("denoise", denoise_description, denoise_examples);
  add_inputs(*parser, options.input, "FILE");
  auto const path = [](std::string const& text) { return std::filesystem::path(parse_name(text)); };
  add_value(*parser, "-o,--output", options.output, path, "FILE",
            "Write to FILE: an .exr keeps all layers, others\nare pictures (default: <name>-denoised.exr)", "Output");
  auto const tone_map = [](std::string const& text) {
    ToneMap const parsed = parse_tone_map(text);
    return parsed == ToneMap::automatic ? ToneMap::none : parsed;
  };
  add_value(*parser, "--exposure", options.development.exposure_ev, parse_exposure, "EV",
            "Of a picture: stops brighter, or darker\n(default: 0)", "Output");
  add_value(*parser, "--tonemap", options.development.tone_map, tone_map, "NAME",
            "Of a picture: none (default; a film does not tell\nwhat its scene needs), neutral (as 'lichtraum\nrender' "
            "develops models), agx, aces or reinhard",
            "Output");
  add_value(*parser, "--transfer", options.development.transfer, parse_transfer, "NAME",
            "Of a picture: srgb (default) or linear (as\n'lichtraum render' stores scenes)", "Output");
  add_value(*parser, "--denoise", options.denoising, parse_denoiser, "NAME",
            "on (default): by Open Image Denoise where it is\nfound; builtin: by lichtraum's own filter", "Denoising");
  parser
      ->add_flag("--prefilter", options.has_noisy_guides,
                 "Take the noise out of albedo and normals first:\nfor depth of field. With Open Image Denoise")
      ->group("Denoising");
  add_value(*parser, "--device", options.device, parse_name, "NAME",
            "Where the built-in filter runs: index, part of a\nname, cpu, gpu or reference", "Denoising");
  add_verbosity(*parser, console);
  return parse(*parser, arguments);
}

std::vector<Diagnostic> options_without_effect(DenoiseOptions const& options, std::filesystem::path const& output,
                                               ImageFormat const& format) {
  std::vector<Diagnostic> found;
  auto const add = [&](std::string message) {
    found.push_back({Severity::warning, DiagnosticCode::option_without_effect, {}, 1, std::move(message), {}, {}});
  };
  auto const has_no_effect = [&](bool given, char const* option) {
    if (!given || format.encode) return;
    add(fmt::format("{} has no effect on '{}': it stores radiance as it is", option, output.string()));
  };
  Development const& development = options.development;
  has_no_effect(development.exposure_ev != usual_development.exposure_ev, "--exposure");
  has_no_effect(development.tone_map != usual_development.tone_map, "--tonemap");
  has_no_effect(development.transfer != usual_development.transfer, "--transfer");
  if (options.has_noisy_guides && options.denoising == Denoising::builtin) {
    add("--prefilter has no effect with --denoise builtin: it is for Open Image Denoise");
  }
  return found;
}

std::string list_of(std::vector<std::string> const& channels) {
  std::string list;
  for (std::string const& channel : channels) list += fmt::format("{}{}", list.empty() ? "" : ", ", channel);
  return list;
}

constexpr char const* advice = "lichtraum render --planes radiance,albedo,normal -o film.exr stores what is needed";

/// The planes of the file that a film has by the same names.
NoisyPicture picture_of(ExrLayers const& layers, std::string const& name, Console const& console) {
  auto const has = [&](FilmPlane plane) { return layers.has(info_of(plane).channels); };
  auto const values = [&](FilmPlane plane) {
    return has(plane) ? layers.values(info_of(plane).channels) : std::vector<float>();
  };
  if (!has(FilmPlane::radiance)) {
    throw Error(ErrorKind::scene,
                fmt::format("'{}' has no radiance, which is in the channels R, G and B; it has: {}. {}", name,
                            list_of(layers.channels()), advice));
  }
  std::string missing;
  for (FilmPlane const plane : {FilmPlane::albedo, FilmPlane::normal}) {
    if (!has(plane)) missing += fmt::format("{}{}", missing.empty() ? "" : " and no ", info_of(plane).name);
  }
  if (!missing.empty()) {
    console.warning(
        fmt::format("'{}' has no {}: edges and textures are harder to tell from noise. {}", name, missing, advice));
  }
  std::vector<float> radiance = values(FilmPlane::radiance);
  // A filter would spread it over all that is near.
  auto const is_faulty = [](float value) { return !(std::abs(value) <= largest_filtered_light); };
  if (auto const faulty = std::ranges::count_if(radiance, is_faulty); faulty > 0) {
    console.warning(fmt::format("'{}' has radiance that is not finite or beyond {:g} ({}): it is taken for 0", name,
                                largest_filtered_light, counted(std::uint64_t(faulty), "number")));
    std::ranges::replace_if(radiance, is_faulty, 0.0f);
  }
  return {layers.size(), std::move(radiance), values(FilmPlane::albedo), values(FilmPlane::normal),
          values(FilmPlane::depth)};
}

/// Throws Error{usage} where `output` would show what is transparent as black.
void check_transparency(ExrLayers const& layers, std::string const& name, std::filesystem::path const& output,
                        ImageFormat const& format) {
  auto const& alpha = info_of(FilmPlane::alpha).channels;
  if (!format.encode || format.has_alpha || !layers.has(alpha)) return;
  if (std::ranges::all_of(layers.values(alpha), [](float value) { return value >= 1; })) return;
  throw Error(ErrorKind::usage,
              fmt::format("'{}' cannot be transparent, as '{}' is: .png and .exr pictures can", output.string(), name));
}

/// What a picture of another format is made of.
Film film_of(ExrLayers const& layers, std::vector<float> const& radiance) {
  PlaneSet planes{FilmPlane::radiance};
  auto const& alpha = info_of(FilmPlane::alpha).channels;
  if (layers.has(alpha)) planes.add(FilmPlane::alpha);
  Film film(whole_picture(layers.size()), planes);
  std::ranges::copy(radiance, film.floats(FilmPlane::radiance).begin());
  if (layers.has(alpha)) std::ranges::copy(layers.values(alpha), film.floats(FilmPlane::alpha).begin());
  film.set_end(1);
  return film;
}

std::string encode(ExrLayers& layers, std::vector<float> const& radiance, ImageFormat const& format,
                   Development const& development) {
  if (format.name == "exr") {
    layers.set_values(info_of(FilmPlane::radiance).channels, radiance);
    return layers.encode();
  }
  Film film = film_of(layers, radiance);
  if (!format.has_alpha) film.keep({FilmPlane::radiance});
  return format.encode_film ? format.encode_film(film, {}) : format.encode(develop(std::move(film), development), {});
}

}  // namespace

int denoise_command(Arguments const& arguments, Console& console) {
  DenoiseOptions options;
  if (!parse_denoise(arguments, options, console)) return 0;
  std::filesystem::path output = options.output;
  if (output.empty()) {
    output = std::filesystem::path(options.input).replace_extension();
    output += "-denoised.exr";
  }
  ImageFormat const& format = image_format_for(output);
  FilesRead files;
  files.add(options.input);
  files.refuse_to_overwrite(output);
  check_writable(output);
  console.show(options_without_effect(options, output, format));

  ExrLayers layers(read_file(options.input), options.input);
  auto const [width, height] = layers.size();
  if (std::max(width, height) > format.max_side) {
    throw Error(ErrorKind::usage, fmt::format("'{}': a {} has at most {} pixels per side, not {}x{}", output.string(),
                                              format.name, format.max_side, width, height));
  }
  check_transparency(layers, options.input, output, format);
  NoisyPicture picture = picture_of(layers, options.input, console);
  picture.has_noisy_guides = options.has_noisy_guides;
  Denoiser denoiser([&](NoisyPicture const& noisy) {
    return choose_renderer(options.device, std::nullopt, console)->filter_noise(noisy);
  });
  Stopwatch const stopwatch;
  std::vector<float> const radiance = denoiser.denoised(picture, options.denoising);
  double const milliseconds = stopwatch.milliseconds();
  if (auto const note = denoiser.take_note(); !note.empty()) console.warning(note);
  write_file_atomically(output, encode(layers, radiance, format, options.development));
  console.info(fmt::format("{}: {}x{}, denoised in {:.1f} ms by {}", output.string(), width, height, milliseconds,
                           denoiser.name(options.denoising)));
  return 0;
}

}  // namespace lichtraum::app
