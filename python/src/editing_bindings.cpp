#include <nanobind/ndarray.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "editing.hpp"
#include "lichtraum/image_io.hpp"
#include "saving.hpp"

namespace nb = nanobind;

namespace lichtraum::python {
namespace {

/// As EsdfStatement::Kind calls it.
char const* kind_name(EsdfStatement const& statement) {
  using Kind = EsdfStatement::Kind;
  switch (statement.kind) {
    case Kind::material:
      return "material";
    case Kind::light:
      return "light";
    case Kind::environment:
      return "environment";
    case Kind::camera:
      return "camera";
    case Kind::camera_transform:
      return "camera_transform";
    case Kind::render:
      return "render";
  }
  return "";
}

using Texels = nb::ndarray<std::uint8_t const, nb::shape<-1, -1, 4>, nb::c_contig, nb::device::cpu>;

/// What pickle stores of a texture: its picture (name, width, height, numbers), how it goes on beyond its edges and
/// between its texels, whether it has alpha, and the files that it was read from.
using TextureState = std::tuple<std::string, int, int, nb::bytes, int, int, bool, std::vector<nb::bytes>>;

TextureState state_of(MadeTexture const& made) {
  Texture const& texture = *made.texture;
  TextureImage const& image = *texture.image;
  std::vector<nb::bytes> files;
  for (auto const& name : made.files.names()) files.emplace_back(name.c_str(), name.native().size());
  return {image.name,          image.width,         image.height,   nb::bytes(image.rgba.data(), image.rgba.size()),
          int(texture.wrap_s), int(texture.filter), made.has_alpha, files};
}

void set_state(MadeTexture& made, TextureState const& state) {
  auto const& [name, width, height, texels, wrap, filter, has_alpha, files] = state;
  auto const* const rgba = static_cast<std::uint8_t const*>(texels.data());
  auto image = std::make_shared<TextureImage const>(TextureImage{name, width, height, {rgba, rgba + texels.size()}});
  Texture const texture{std::move(image), TextureWrap(wrap), TextureWrap(wrap), TextureFilter(filter)};
  new (&made) MadeTexture{std::make_shared<Texture const>(texture), has_alpha, {}};
  for (nb::bytes const& file : files) made.files.add(std::string(file.c_str(), file.size()));
}

}  // namespace

void bind_editing(nb::module_& module) {
  nb::class_<Step>(module, "Step", "One transform.")
      .def(
          "__init__",
          [](Step* step, std::string how, std::vector<double> numbers) {
            new (step) Step{std::move(how), std::move(numbers)};
          },
          nb::arg("how"), nb::arg("numbers"));
  using Release = nb::call_guard<nb::gil_scoped_release>;  // whoever draws the scene may take long
  module.def("transform", &transform, nb::arg("scene"), nb::arg("shape"), nb::arg("how"), nb::arg("numbers"),
             Release());
  nb::class_<MadeTexture>(module, "Texture", "A picture for materials.")
      .def_ro("has_alpha", &MadeTexture::has_alpha)
      .def("__getstate__", &state_of)
      .def("__setstate__", &set_state);
  module.def(
      "make_texture",
      [](Texels const& texels, std::string const& wrap, std::string const& filter) {
        return make_texture(texels.data(), int(texels.shape(1)), int(texels.shape(0)), wrap, filter);
      },
      nb::sig("def make_texture(texels: numpy.typing.NDArray[numpy.uint8], wrap: str, filter: str) -> Texture"),
      nb::arg("texels"), nb::arg("wrap"), nb::arg("filter"));
  module.def("read_texture", &read_texture, nb::arg("path"), nb::arg("wrap"), nb::arg("filter"), Release());
  module.def("set_material", &set_material, nb::arg("scene"), nb::arg("name"), nb::arg("model"), nb::arg("fields"),
             nb::arg("textures"), Release());
  module.def("set_light", &set_light, nb::arg("scene"), nb::arg("name"), nb::arg("kind"), nb::arg("fields"), Release());
  module.def("remove_light", &remove_light, nb::arg("scene"), nb::arg("name"), Release());
  module.def("set_camera", &set_camera, nb::arg("scene"), nb::arg("name"), nb::arg("fov_x_degrees"),
             nb::arg("orthographic").none(), nb::arg("steps"), nb::arg("width"), nb::arg("height"), Release());

  nb::class_<EsdfStatement>(module, "Statement", "A line of eSDF, from 1, and whose name it has.")
      .def_ro("line", &EsdfStatement::line)
      .def_prop_ro("kind", [](EsdfStatement const& statement) { return kind_name(statement); })
      .def_ro("name", &EsdfStatement::name);
  module.def(
      "statements_of",
      [](nb::bytes const& text, std::string const& path, app::RenderOptions const& options) {
        std::string copy(text.c_str(), text.size());
        nb::gil_scoped_release const released;
        return statements_of(std::move(copy), path, options);
      },
      nb::arg("text"), nb::arg("path"), nb::arg("options"));
  module.def(
      "write_file",
      [](nb::bytes const& path, nb::bytes const& content) {
        std::filesystem::path const name(std::string(path.c_str(), path.size()));
        std::string_view const bytes(content.c_str(), content.size());
        nb::gil_scoped_release const released;
        write_file_atomically(name, bytes);
      },
      nb::arg("path"), nb::arg("content"));
  module.def(
      "names_picture",
      [](nb::bytes const& path) { return find_image_format(std::string(path.c_str(), path.size())) != nullptr; },
      nb::arg("path"));
  module.def("identity_of", &identity_of, nb::arg("scene"), Release());
}

}  // namespace lichtraum::python
