#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "lichtraum/image_io.hpp"
#include "picture.hpp"

namespace nb = nanobind;

namespace lichtraum::python {
namespace {

using Floats = nb::ndarray<nb::numpy, float const, nb::c_contig, nb::device::cpu>;
using Numbers = nb::ndarray<nb::numpy, std::uint32_t const, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

/// Of a picture's own memory, which stays as long as the array: height x width (x channels).
Floats view(std::vector<float> const& values, Picture const& picture, std::size_t channels, nb::handle owner) {
  std::size_t const shape[] = {std::size_t(picture.request.region.height), std::size_t(picture.request.region.width),
                               channels};
  return {values.data(), channels == 1 ? std::size_t(2) : std::size_t(3), shape, owner};
}

FilmPlane plane_named(Picture const& picture, std::string_view name) {
  for (FilmPlane const plane : picture.film.planes().list()) {
    if (info_of(plane).name == name) return plane;
  }
  throw nb::key_error(std::string(name).c_str());
}

nb::object plane(nb::handle self, std::string_view name) {
  auto const& picture = nb::cast<Picture const&>(self);
  FilmPlane const plane = plane_named(picture, name);
  PlaneInfo const& info = info_of(plane);
  if (!info.is_number) return nb::cast(view(picture.planes.at(plane), picture, info.channels.size(), self));
  std::size_t const shape[] = {std::size_t(picture.request.region.height), std::size_t(picture.request.region.width)};
  return nb::cast(Numbers(picture.film.numbers(plane).data(), 2, shape, self));
}

Floats radiance(nb::handle self) {
  auto const& picture = nb::cast<Picture const&>(self);
  if (picture.radiance.empty()) {
    throw Error(ErrorKind::usage, "the picture has no radiance: planes= asked only for others");
  }
  return view(picture.radiance, picture, 3, self);
}

nb::bytes encoded(Picture const& picture, std::string const& format, int bits, int quality, bool ppm_ascii) {
  std::string bytes;
  {
    nb::gil_scoped_release const release;
    ImageFormat const& chosen = image_format_named(format);
    ValueEncoding const encoding{bits, ppm_ascii, quality};
    picture.check_format(chosen, encoding, format);
    bytes = picture.encoded(chosen, encoding);
  }
  return nb::bytes(bytes.data(), bytes.size());
}

/// To look at: one plane, whatever else there is.
nb::bytes shown(Picture const& picture) {
  std::string bytes;
  {
    nb::gil_scoped_release const release;
    bytes = picture.encoded(image_format_named("png"), {});
  }
  return nb::bytes(bytes.data(), bytes.size());
}

void save(Picture const& picture, std::string const& path, std::string const& format, int bits, int quality,
          bool ppm_ascii) {
  nb::gil_scoped_release const release;
  ImageFormat const& chosen = format.empty() ? image_format_for(path) : image_format_named(format);
  ValueEncoding const encoding{bits, ppm_ascii, quality};
  picture.check_format(chosen, encoding, path);
  picture.files.refuse_to_overwrite(path);
  write_file_atomically(path, picture.encoded(chosen, encoding));
}

}  // namespace

void bind_picture(nb::module_& module) {
  nb::class_<Picture>(module, "Picture", "A picture that was drawn: see lichtraum.Image.")
      .def_prop_ro("width", [](Picture const& p) { return p.request.region.width; })
      .def_prop_ro("height", [](Picture const& p) { return p.request.region.height; })
      .def_prop_ro("radiance", &radiance,
                   nb::for_getter(nb::sig("def radiance(self) -> numpy.typing.NDArray[numpy.float32]")))
      .def_prop_ro(
          "developed",
          [](nb::handle self) {
            auto const& p = nb::cast<Picture const&>(self);
            return view(p.developed.data(), p, 3, self);
          },
          nb::for_getter(nb::sig("def developed(self) -> numpy.typing.NDArray[numpy.float32]")))
      .def_prop_ro("plane_names",
                   [](Picture const& p) {
                     std::vector<std::string_view> names;
                     for (FilmPlane const each : p.film.planes().list()) names.push_back(info_of(each).name);
                     return names;
                   })
      .def("plane", &plane, nb::arg("name"),
           nb::sig("def plane(self, name: str) -> numpy.typing.NDArray[numpy.float32] | "
                   "numpy.typing.NDArray[numpy.uint32]"))
      .def_ro("diagnostics", &Picture::diagnostics)
      .def_ro("denoiser", &Picture::denoiser)
      .def_prop_ro("job", [](Picture const& p) { return to_json(p.job); })
      .def_prop_ro("samples", [](Picture const& p) { return p.film.samples().count(); })
      .def_prop_ro("rays", [](Picture const& p) { return p.statistics.rays.total(); })
      .def_prop_ro("seconds", [](Picture const& p) { return p.statistics.trace_ms / 1000; })
      .def_prop_ro("device", [](Picture const& p) { return p.device.name; })
      .def("encoded", &encoded, nb::arg("format"), nb::arg("bits") = 8, nb::arg("quality") = 92,
           nb::arg("ppm_ascii") = false)
      .def("shown", &shown)
      .def("save", &save, nb::arg("path"), nb::arg("format") = "", nb::arg("bits") = 8, nb::arg("quality") = 92,
           nb::arg("ppm_ascii") = false);
}

}  // namespace lichtraum::python
