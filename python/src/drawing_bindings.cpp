#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "control.hpp"
#include "session.hpp"

namespace nb = nanobind;

namespace lichtraum::python {
namespace {

/// Of a registry of the scene.
template <class Registry>
std::vector<std::string> names_in(ReadScene const& read, Registry Scene::*registry) {
  nb::gil_scoped_release const release;
  std::lock_guard const lock(*read.mutex);
  std::vector<std::string> names;
  for (auto const& item : read.scene.*registry) {
    if constexpr (requires { item->name(); }) {
      names.push_back(item->name());
    } else {
      names.push_back(item.name());
    }
  }
  return names;
}

}  // namespace

void bind_drawing(nb::module_& module) {
  nb::class_<app::RenderOptions>(module, "Options", "What `lichtraum render` is told about a picture.");
  module.def("parse_options", &parse_options, nb::arg("words"));
  module.def("option_names", &option_names);

  nb::class_<ReadScene>(module, "Scene", "A scene that was read from a file.")
      .def_ro("name", &ReadScene::name)
      .def_ro("is_model", &ReadScene::is_model)
      .def_ro("diagnostics", &ReadScene::diagnostics)
      .def_prop_ro(
          "has_brightness",
          [](ReadScene const& read) { return read.scene.tone_map == ToneMap::reinhard; })  // of a lamp, in eSDF
      .def_prop_ro("cameras", [](ReadScene const& read) { return names_in(read, &Scene::cameras); })
      .def_prop_ro("shapes", [](ReadScene const& read) { return names_in(read, &Scene::shapes); })
      .def_prop_ro("materials", [](ReadScene const& read) { return names_in(read, &Scene::materials); })
      .def_prop_ro("lights", [](ReadScene const& read) { return names_in(read, &Scene::lights); });
  module.def("read_scene", &read_scene, nb::arg("path"), nb::arg("options"), nb::call_guard<nb::gil_scoped_release>());

  nb::class_<Control>(module, "Control", "Stops a thread that draws, and tells how far it is.")
      .def(nb::init<>())
      .def("stop", &Control::stop)
      .def_prop_ro("fraction", &Control::fraction);

  nb::class_<Session>(module, "Session", "A device, and what is kept from one picture to the next.")
      .def(nb::init<std::string const&, std::string const&>(), nb::arg("device") = "", nb::arg("traversal") = "",
           nb::call_guard<nb::gil_scoped_release>())
      .def_prop_ro("device", [](Session const& session) { return session.device().name; })
      .def_prop_ro("is_reference",
                   [](Session const& session) { return session.device().kind == DeviceKind::reference; })
      .def_prop_ro("warnings", &Session::warnings)
      .def("draw_file", &Session::draw_file, nb::arg("path"), nb::arg("options"), nb::arg("picture"),
           nb::arg("control"), nb::call_guard<nb::gil_scoped_release>())
      .def("draw_scene", &Session::draw_scene, nb::arg("scene"), nb::arg("options"), nb::arg("picture"),
           nb::arg("control"), nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace lichtraum::python
