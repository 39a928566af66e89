#include <cstdint>
#include <string>

#include "io/obj/material_from_mtl.hpp"
#include "lichtraum/obj.hpp"
#include "scene/flatten.hpp"

namespace {

auto const picture =
    std::make_shared<lichtraum::TextureImage const>(lichtraum::TextureImage{"a.png", 1, 1, {9, 8, 7, 6}});

}  // namespace

// Any bytes are read as an OBJ file and as an MTL file; tools/fuzz runs this.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string text(reinterpret_cast<char const*>(data), size);
  try {
    lichtraum::Diagnostics diagnostics("fuzz.mtl", 100);
    lichtraum::normalise_line_breaks(text);
    for (auto& material : lichtraum::obj::read_mtl(text, diagnostics)) {
      lichtraum::obj::MadePictures made;
      for (bool const has_pictures : {false, true}) {
        for (auto const map : lichtraum::obj::mtl_textures) (material.*map).image = has_pictures ? picture : nullptr;
        for (bool const is : {false, true}) lichtraum::obj::material_from_mtl(material, {is, is}, made);
      }
    }
    lichtraum::flatten(lichtraum::import_obj_text(text, "fuzz.obj", "/nonexistent").scene.roots());
  } catch (lichtraum::Error const&) {  // what a faulty model must end in; anything else is a finding
  }
  return 0;
}
