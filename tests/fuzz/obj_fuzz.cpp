#include <cstdint>
#include <string>

#include "io/obj/material_from_mtl.hpp"
#include "lichtraum/obj.hpp"
#include "scene/flatten.hpp"

namespace {

lichtraum::obj::MtlTextures all_of(std::shared_ptr<lichtraum::TextureImage const> const& picture) {
  return {picture, picture, picture, picture, picture, picture};
}

auto const picture =
    std::make_shared<lichtraum::TextureImage const>(lichtraum::TextureImage{"a.png", 1, 1, {9, 8, 7, 6}});

}  // namespace

// Any bytes are read as an OBJ file and as an MTL file; tools/fuzz runs this.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string text(reinterpret_cast<char const*>(data), size);
  try {
    lichtraum::Diagnostics diagnostics("fuzz.mtl", 100);
    lichtraum::normalise_line_breaks(text);
    for (auto const& material : lichtraum::obj::read_mtl(text, diagnostics)) {
      lichtraum::obj::PackedPictures packed;
      for (auto const& textures : {lichtraum::obj::MtlTextures(), all_of(picture)}) {
        for (bool const has_colors : {false, true}) {
          lichtraum::obj::material_from_mtl(material, textures, has_colors, packed);
        }
      }
    }
    lichtraum::flatten(lichtraum::import_obj_text(text, "fuzz.obj", "/nonexistent").scene.roots());
  } catch (lichtraum::Error const&) {  // what a faulty model must end in; anything else is a finding
  }
  return 0;
}
