#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <utility>

#include "denoise/check_picture.hpp"
#include "denoise/oidn_functions.hpp"
#include "lichtraum/denoise.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {
namespace {

using namespace oidn;

constexpr char const* file_name = "libOpenImageDenoise.so.2";

Error unavailable(std::string const& why) { return {ErrorKind::unavailable, why}; }

/// The program that this code is part of; of a library or the Python module, that beside it (lichtraum/_native.so has
/// lichtraum/bin/lichtraum).
std::filesystem::path program() {
  std::error_code error;
  Dl_info info{};
  if (::dladdr(reinterpret_cast<void const*>(&program), &info) != 0 && info.dli_fname) {
    auto const beside = std::filesystem::path(info.dli_fname).parent_path() / "bin/lichtraum";
    if (auto const found = std::filesystem::canonical(beside, error); !error) return found;
  }
  return std::filesystem::read_symlink("/proc/self/exe", error);
}

/// Where tools/setup and `cmake --install` put it. The library finds its other parts in ../lib of its own folder only.
std::string file_beside_program() {
  return program().parent_path().parent_path() / "lib/lichtraum/oidn/lib" / file_name;
}

std::vector<std::string> places() {
  if (char const* const chosen = std::getenv("LICHTRAUM_OIDN")) {
    std::error_code error;
    std::filesystem::path const path(chosen);
    return {std::filesystem::is_directory(path, error) ? path / file_name : path};
  }
  return {file_name, file_beside_program()};
}

/// It stays loaded until the process ends: its threads may.
void* load() {
  std::string reasons;
  for (std::string const& place : places()) {
    if (void* const loaded = ::dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL)) return loaded;
    reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", ::dlerror());
  }
  throw unavailable(reasons);
}

Functions find_functions(void* loaded) {
  Functions functions;
#define LICHTRAUM_FIND(result, name, parameters)                                   \
  functions.name = reinterpret_cast<result(*) parameters>(::dlsym(loaded, #name)); \
  if (!functions.name) throw unavailable("it lacks the function " #name ", so it is not version 2");
  LICHTRAUM_OIDN_FUNCTIONS(LICHTRAUM_FIND)
#undef LICHTRAUM_FIND
  return functions;
}

/// What is put around a picture for its filter, and cut off again: the picture, mirrored. The library takes what is
/// outside for black, which leaves coloured dots in the corners of an even background.
class Margin {
 public:
  explicit Margin(Resolution const& picture) : picture_(picture) {}

  Resolution size() const { return {picture_.width + 2 * width, picture_.height + 2 * width}; }

  /// A plane of three channels, or none.
  std::vector<float> add_to(std::vector<float> const& plane) const {
    if (plane.empty()) return {};
    auto const [columns, rows] = size();
    std::vector<float> framed(3 * std::size_t(columns) * std::size_t(rows));
    auto out = framed.begin();
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        out = std::copy_n(plane.begin() + offset(mirrored(x, picture_.width), mirrored(y, picture_.height)), 3, out);
      }
    }
    return framed;
  }

  std::vector<float> cut_from(std::vector<float> const& framed) const {
    std::vector<float> plane(3 * std::size_t(picture_.width) * std::size_t(picture_.height));
    for (int y = 0; y < picture_.height; ++y) {
      std::copy_n(framed.begin() + 3 * (std::ptrdiff_t(y + width) * size().width + width), 3 * picture_.width,
                  plane.begin() + offset(0, y));
    }
    return plane;
  }

 private:
  static constexpr int width = 16;

  std::ptrdiff_t offset(int x, int y) const { return 3 * (std::ptrdiff_t(y) * picture_.width + x); }

  /// Of a column or row of the framed picture, where it comes from; also in pictures that are smaller than the margin.
  static int mirrored(int i, int side) {
    int const period = 2 * side;
    int const place = ((i - width) % period + period) % period;
    return place < side ? place : period - 1 - place;
  }

  Resolution picture_;
};

}  // namespace

struct OpenImageDenoise::Library {
  Functions call;
  Device device = nullptr;

  explicit Library(Functions const& functions) : call(functions), device(call.oidnNewDevice(device_type_cpu)) {
    try {
      check();
      if (!device) throw unavailable("it has no device for processors");
      call.oidnSetDeviceBool(device, "setAffinity", false);  // others work here as well
      call.oidnCommitDevice(device);
      check();
    } catch (...) {
      release();
      throw;
    }
  }
  ~Library() { release(); }
  Library(Library const&) = delete;
  Library& operator=(Library const&) = delete;

  void release() {
    if (device) call.oidnReleaseDevice(std::exchange(device, nullptr));
  }

  void check() const {
    char const* message = nullptr;
    int const code = call.oidnGetDeviceError(device, &message);
    if (code == error_none) return;
    throw unavailable(
        fmt::format("{} (its error {})", message && *message ? message : "it does not say what failed", code));
  }

  /// One run of its filter for ray-traced pictures.
  class Run {
   public:
    Run(Library const& library, Resolution const& size)
        : library_(library), size_(size), filter_(library.call.oidnNewFilter(library.device, "RT")) {
      if (!filter_) library.check();
      if (!filter_) throw unavailable("it has no filter for ray-traced pictures");
    }
    ~Run() { library_.call.oidnReleaseFilter(filter_); }
    Run(Run const&) = delete;
    Run& operator=(Run const&) = delete;

    /// Only what is called "output" is written to.
    void set(char const* name, std::vector<float> const& values) {
      if (values.empty()) return;
      library_.call.oidnSetSharedFilterImage(filter_, name, const_cast<float*>(values.data()), format_float3,
                                             std::size_t(size_.width), std::size_t(size_.height), 0, 0, 0);
    }
    void set(char const* name, bool value) { library_.call.oidnSetFilterBool(filter_, name, value); }
    void execute() {
      library_.call.oidnCommitFilter(filter_);
      library_.call.oidnExecuteFilter(filter_);
      library_.check();
    }

   private:
    Library const& library_;
    Resolution size_;
    Filter filter_;
  };

  /// A plane of guides without its noise.
  std::vector<float> filter_guide(char const* name, std::vector<float> const& values, Resolution const& size) const {
    if (values.empty()) return {};
    std::vector<float> filtered(values.size());
    Run run(*this, size);
    run.set(name, values);
    run.set("output", filtered);
    run.execute();
    return filtered;
  }
};

OpenImageDenoise::OpenImageDenoise() {
  auto library = std::make_unique<Library>(find_functions(load()));
  auto const version = [&](char const* part) { return library->call.oidnGetDeviceInt(library->device, part); };
  int const major = version("versionMajor");
  name_ = fmt::format("Open Image Denoise {}.{}.{}", major, version("versionMinor"), version("versionPatch"));
  if (major != 2) throw unavailable(fmt::format("it is {}, and version 2 is needed", name_));
  library_ = std::move(library);
}

OpenImageDenoise::~OpenImageDenoise() = default;

std::vector<float> OpenImageDenoise::filter_noise(NoisyPicture const& picture) const {
  check_picture(picture);
  Library const& library = *library_;
  Margin const margin(picture.size);
  auto const radiance = margin.add_to(finite_values(picture.radiance));
  auto albedo = margin.add_to(finite_values(picture.albedo));
  auto normal = margin.add_to(finite_values(picture.normal));
  if (albedo.empty()) normal.clear();  // the library takes normals beside albedo only
  if (picture.has_noisy_guides) {
    albedo = library.filter_guide("albedo", albedo, margin.size());
    normal = library.filter_guide("normal", normal, margin.size());
  }
  std::vector<float> filtered(radiance.size());
  Library::Run run(library, margin.size());
  run.set("color", radiance);
  run.set("albedo", albedo);
  run.set("normal", normal);
  run.set("output", filtered);
  run.set("hdr", true);
  run.set("cleanAux", picture.has_noisy_guides && !albedo.empty());
  run.execute();
  return margin.cut_from(filtered);
}

}  // namespace lichtraum
