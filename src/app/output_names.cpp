#include "app/output_names.hpp"

#include <fmt/format.h>

#include <cctype>

#include "app/longer_stems.hpp"
#include "app/video.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/job.hpp"
#include "lichtraum/sandboxed_path.hpp"

namespace lichtraum::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_pattern(std::string const& pattern) {
  throw Error(ErrorKind::usage,
              fmt::format("--output: '{}': a % stands for the picture's number and is written %d or %04d, once; "
                          "%% is a percent sign",
                          pattern));
}

bool is_stream(fs::path const& path) {
  std::error_code ignored;
  fs::file_status const status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// Throws Error{usage} for one that names neither a picture nor a film, and lists those that do.
void check_extension(fs::path const& file) {
  try {
    image_format_for(file);
  } catch (Error const& error) {
    std::string films;
    for (FilmFormat const& format : film_formats())
      films += fmt::format("{}{}", films.empty() ? "" : ", ", format.extension);
    throw Error(error.kind(), fmt::format("{}; of films: {}", error.what(), films));
  }
}

}  // namespace

fs::path Output::partial_path() const {
  fs::path partial = path;
  partial.replace_extension(".partial" + path.extension().string());
  return partial;
}

OutputNames::OutputNames(OutputOptions options) : options_(std::move(options)) {
  std::string const& pattern = options_.file;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    std::string& part = number_format_.empty() ? before_number_ : after_number_;
    if (pattern[i] != '%') {
      part += pattern[i];
    } else if (pattern.compare(i, 2, "%%") == 0) {
      part += pattern[++i];
    } else {
      std::size_t const end = pattern.find('d', i);
      std::string const width = end == std::string::npos ? "x" : pattern.substr(i + 1, end - i - 1);
      bool const is_good = width.empty() || (width.size() == 2 && width[0] == '0' &&
                                             std::isdigit(static_cast<unsigned char>(width[1])) != 0);
      if (!is_good || !number_format_.empty()) refuse_pattern(pattern);
      number_format_ = "{:" + width + "}";
      i = end;
    }
  }
  if (options_.file.empty() || options_.file == "-") return;
  std::error_code ignored;
  if (std::filesystem::is_directory(options_.file, ignored)) {
    throw Error(ErrorKind::usage,
                fmt::format("--output {0}: that is a folder; --output-dir {0} writes there", options_.file));
  }
  if (find_film_format(options_.file)) {
    is_film_ = true;
    if (!number_format_.empty()) {
      throw Error(ErrorKind::usage, fmt::format("'{}': a film is one file, without a number in its name", pattern));
    }
    if (options_.format) {
      throw Error(ErrorKind::usage, fmt::format("--format {} contradicts the name '{}': leave one of them out",
                                                options_.format->name, pattern));
    }
    return;
  }
  ImageFormat const* const by_extension = find_image_format(options_.file);
  // A device or pipe has no extension to choose: PNG, as on standard output.
  if (!by_extension && !options_.format && number_format_.empty() && is_stream(path_of(""))) {
    options_.format = &image_format_named("png");
  }
  if (!options_.format) check_extension(options_.file);
  if (options_.format && by_extension && by_extension != options_.format) {
    throw Error(ErrorKind::usage, fmt::format("--format {} contradicts the name '{}': leave one of them out",
                                              options_.format->name, options_.file));
  }
}

bool OutputNames::has_one_name() const {
  return !options_.file.empty() && options_.file != "-" && number_format_.empty() && !is_film_;
}

void OutputNames::set_inputs(std::vector<std::string> const& inputs) { longer_stems_ = longer_stems(inputs); }

std::string OutputNames::stem_of(SceneSource const& source) const {
  auto const longer = longer_stems_.find(source.name());
  return longer != longer_stems_.end() ? longer->second : source.stem();
}

void OutputNames::begin_scene(std::size_t picture_count) {
  if (picture_count > std::size_t(job_limits::pictures - picture_count_)) {
    throw Error(ErrorKind::usage, fmt::format("at most {} pictures", job_limits::pictures));
  }
  picture_count_ += int(picture_count);
  number_ = scene_end_;
  scene_end_ += int(picture_count);
}

Output OutputNames::next(RenderCommand const& command, bool is_one_of_many) {
  ++number_;
  if (!options_.file.empty()) return from_command_line();
  if (!is_one_of_many) return from_scene(command.file, command.location);
  fs::path const name = command.file;
  std::string const numbered = fmt::format("{}_{:04}{}", name.stem().string(), number_, name.extension().string());
  return from_scene((name.parent_path() / numbered).string(), command.location);
}

fs::path OutputNames::path_of(std::string const& number) const {
  fs::path const file = before_number_ + number + after_number_;
  return options_.folder == "." ? file : options_.folder / file;
}

Output OutputNames::from_command_line() {
  Output output;
  if (options_.file == "-") {
    output.format = options_.format ? options_.format : &image_format_named("png");
    output.shown = "standard output";
    return output;
  }
  std::string const number = number_format_.empty() ? "" : fmt::format(fmt::runtime(number_format_), number_);
  output.path = path_of(number);
  if (is_film_) {
    output.is_film = true;
    output.format = &image_format_named("ppm");
    output.shown = output.path.string();
    return output;
  }
  output.format = options_.format ? options_.format : &image_format_for(output.path);
  output.shown = output.path.string();
  return output;
}

Output OutputNames::from_scene(std::string const& name, SourceLocation const& location) const {
  Output output;
  fs::path file = name;
  output.format = find_image_format(file);
  if (!output.format) {
    output.format = options_.format ? options_.format : &image_format_named("png");
    file += fmt::format(".{}", output.format->name);
    if (!options_.format) {
      output.note =
          fmt::format("'{}' names no picture format that can be written: '{}' is written instead", name, file.string());
    }
  } else if (options_.format && options_.format != output.format) {
    output.format = options_.format;
    file.replace_extension(output.format->extensions.front());
  }
  SandboxedPath const place = resolve_sandboxed(options_.folder, file, options_.allowed_paths);
  if (!place) {
    Diagnostic outside;
    outside.code = DiagnosticCode::file_outside;
    outside.location = location;
    outside.message = fmt::format("cannot write '{}': {}", name, place.reason);
    outside.hint =
        "pictures go to the folder of --output-dir, or else the current one, and below it: -o FILE names another "
        "place, --allow-path FOLDER permits one";
    throw SceneError({outside});
  }
  output.path = place.path;
  output.shown = (file.is_absolute() || options_.folder == "." ? file : options_.folder / file).string();
  return output;
}

}  // namespace lichtraum::app
