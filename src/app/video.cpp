#include "app/video.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <sstream>

#include "core/ascii.hpp"
#include "core/follow_links.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/image_io.hpp"

extern char** environ;

namespace lichtraum::app {
namespace {

namespace fs = std::filesystem;

/// Colours as BT.709 defines them, and said so in the file: players guess otherwise. Without accurate_rnd, chroma is
/// rounded down.
std::vector<std::string> const bt709{"-vf",
                                     "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd",
                                     "-pix_fmt",
                                     "yuv420p",
                                     "-colorspace",
                                     "bt709",
                                     "-color_primaries",
                                     "bt709",
                                     "-color_trc",
                                     "bt709",
                                     "-color_range",
                                     "tv"};

std::vector<std::string> with_bt709(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), bt709.begin(), bt709.end());
  return arguments;
}

/// The last lines of a text.
std::string last_lines(std::string const& text) {
  constexpr std::size_t most_lines = 5;
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) lines.push_back("\n  " + line);
  }
  std::string result;
  for (std::size_t i = lines.size() - std::min(lines.size(), most_lines); i < lines.size(); ++i) result += lines[i];
  return result;
}

std::string find_ffmpeg() {
  char const* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::string file = (folder.empty() ? "." : folder) + "/ffmpeg";
    if (::access(file.c_str(), X_OK) == 0 && fs::is_regular_file(file)) return file;
  }
  return {};
}

[[noreturn]] void cannot_start(int code) {
  throw Error(ErrorKind::io, fmt::format("cannot start ffmpeg: {}", std::strerror(code)));
}

std::vector<std::string> ffmpeg_arguments(FilmFormat const& format, Resolution const& size, double frames_per_second,
                                          fs::path const& file) {
  std::vector<std::string> arguments{find_ffmpeg(),
                                     "-hide_banner",
                                     "-nostdin",
                                     "-loglevel",
                                     "error",
                                     "-y",
                                     "-f",
                                     "rawvideo",
                                     "-pixel_format",
                                     "rgb24",
                                     "-video_size",
                                     fmt::format("{}x{}", size.width, size.height),
                                     "-framerate",
                                     fmt::format("{}", frames_per_second),
                                     "-i",
                                     "pipe:0"};
  arguments.insert(arguments.end(), format.encoder_arguments.begin(), format.encoder_arguments.end());
  // "file:" keeps a name with a colon from being taken for a protocol.
  for (std::string const& word : {std::string("-f"), std::string(format.container), "file:" + file.string()}) {
    arguments.push_back(word);
  }
  return arguments;
}

/// A child that reads `input` and says what it has to say to `messages`. Throws Error{io}.
pid_t spawn(std::vector<std::string> arguments, Descriptor const& input, Descriptor const& messages) {
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input.number(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages.number(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages.number(), STDERR_FILENO);
  // A group of its own: Ctrl-C in the terminal is for lichtraum, which then ends the film in order.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t defaults;
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGPIPE);
  sigaddset(&defaults, SIGXFSZ);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  pid_t child = -1;
  int const code = ::posix_spawn(&child, words[0], &actions, &attributes, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (code != 0) cannot_start(code);
  return child;
}

}  // namespace

std::span<FilmFormat const> film_formats() {
  // The numbers after -crf: no loss that one sees. A GIF's colours are chosen anew for each picture: choosing them for
  // all would keep all in memory.
  constexpr double any_rate = std::numeric_limits<double>::infinity();
  static std::vector<FilmFormat> const formats{
      {".mp4", "mp4", true, any_rate, with_bt709({"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart"})},
      {".webm", "webm", false, any_rate,
       with_bt709(
           {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1", "-deadline", "good", "-cpu-used", "4"})},
      {".gif",
       "gif",
       false,
       50,  // a picture stays for hundredths of a second, and browsers make ten of one
       {"-filter_complex", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1"}},
  };
  return formats;
}

FilmFormat const* find_film_format(fs::path const& path) {
  std::string const extension = to_lower_ascii(path.extension().string());
  for (FilmFormat const& format : film_formats()) {
    if (format.extension == extension) return &format;
  }
  return nullptr;
}

void check_ffmpeg() {
  if (!find_ffmpeg().empty()) return;
  throw Error(ErrorKind::unavailable,
              "films are made by the program ffmpeg, which is not installed: apt install ffmpeg (or write pictures, "
              "-o picture-%04d.png)");
}

void check_frame_rate(fs::path const& film, double frames_per_second) {
  FilmFormat const& format = *find_film_format(film);
  if (frames_per_second <= format.most_frames_per_second) return;
  throw Error(ErrorKind::usage,
              fmt::format("--fps {}: browsers show {} films with at most {} pictures a second; .mp4 and "
                          ".webm have no such limit",
                          frames_per_second, format.extension, format.most_frames_per_second));
}

void check_film(fs::path const& film, Resolution size) {
  FilmFormat const& format = *find_film_format(film);
  if (format.needs_even_size && (size.width % 2 != 0 || size.height % 2 != 0)) {
    throw Error(ErrorKind::usage, fmt::format("'{}': an {} needs an even width and height, not {}x{}", film.string(),
                                              format.extension, size.width, size.height));
  }
  std::error_code ignored;
  if (!fs::exists(film, ignored) || fs::is_regular_file(film, ignored)) return;
  throw Error(ErrorKind::cannot_create,
              fmt::format("cannot write '{}': films are written to files only, and this is none", film.string()));
}

Video::Video(fs::path path, Resolution size, double frames_per_second) : path_(std::move(path)), size_(size) {
  check_frame_rate(path_, frames_per_second);
  check_ffmpeg();
  FilmFormat const& format = *find_film_format(path_);
  check_film(path_, size);
  check_writable(path_);
  fs::path const place = follow_links(path_).value_or(path_);  // renaming is atomic within one file system only
  unfinished_.emplace(place.parent_path(), format.extension);
  if (!unfinished_->descriptor().is_open()) {
    throw Error(ErrorKind::cannot_create, fmt::format("cannot write '{}': {}", path_.string(), std::strerror(errno)));
  }
  struct stat old {};
  if (::stat(place.c_str(), &old) == 0) ::fchmod(unfinished_->descriptor().number(), old.st_mode & 07777);
  unfinished_->descriptor().close();  // ffmpeg opens it by its name
  messages_ = Descriptor(::memfd_create("ffmpeg-messages", MFD_CLOEXEC));
  int ends[2];
  if (!messages_.is_open() || ::pipe2(ends, O_CLOEXEC) != 0) cannot_start(errno);
  Descriptor const input(ends[0]);
  pixels_ = Descriptor(ends[1]);
  fs::path unfinished = unfinished_->path();  // before ffmpeg runs: what throws after that would leave it running
  process_ = spawn(ffmpeg_arguments(format, size, frames_per_second, unfinished), input, messages_);
  removed_on_signal_.emplace(process_, std::move(unfinished));
}

Video::~Video() {
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  wait_for_ffmpeg();
}

int Video::wait_for_ffmpeg() {
  int status = -1;
  while (process_ > 0 && ::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

void Video::fail() {
  pixels_ = Descriptor();
  wait_for_ffmpeg();
  std::string text;
  char buffer[4096];
  ::lseek(messages_.number(), 0, SEEK_SET);
  for (ssize_t count; (count = ::read(messages_.number(), buffer, sizeof buffer)) > 0 && text.size() < (1u << 20);) {
    text.append(buffer, std::size_t(count));
  }
  std::string const lines = last_lines(text);
  throw Error(ErrorKind::io, fmt::format("ffmpeg could not make '{}'{}{}", path_.string(),
                                         lines.empty() ? ": it ended early" : "; it said:", lines));
}

void Video::add(std::string_view pixels) {
  if (write_all(pixels_, pixels) != 0) fail();
  ++frame_count_;
}

void Video::finish_as(fs::path const& path) {
  pixels_ = Descriptor();
  int const status = wait_for_ffmpeg();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail();
  int code = unfinished_->rename_to(follow_links(path).value_or(path));
  if (code == EXDEV) {  // a part of a film, beside a link to another file system
    std::error_code failure;
    fs::copy_file(unfinished_->path(), path, fs::copy_options::overwrite_existing, failure);
    code = failure.value();
  }
  if (code != 0) {
    throw Error(ErrorKind::io, fmt::format("cannot write '{}': {}", path.string(), std::strerror(code)));
  }
}

}  // namespace lichtraum::app
