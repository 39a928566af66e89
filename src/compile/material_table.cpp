#include "compile/material_table.hpp"

#include <algorithm>
#include <cstring>
#include <unordered_map>

#include "lichtraum/error.hpp"
#include "scene/device_conversion.hpp"
#include "scene/pbr_evaluation.hpp"
#include "scene/texture_lookup.hpp"
#include "scene/used_texcoords.hpp"
#include "shared/scene_arrays.h"

namespace lichtraum {
namespace {

/// Collects textures, each once, and their pictures, each once.
class Textures {
 public:
  explicit Textures(MaterialTable& table) : table_(table) {}

  device::TextureSlot slot(TextureSlot const& source, std::vector<int> const& used_sets) {
    device::TextureSlot result{};
    result.texture = source ? number_of(source.texture) : NO_TEXTURE;
    // An empty slot looks somewhere, too: that of anisotropy says along what it is.
    auto const place = std::find(used_sets.begin(), used_sets.end(), source.texcoord);
    result.texcoord = place == used_sets.end() ? 0 : device::uint(place - used_sets.begin());
    // The columns of the affine map, read off its images of the origin and the axes.
    glm::dvec2 const origin = transform_coordinate(source, {0, 0});
    glm::dvec2 const u = transform_coordinate(source, {1, 0}) - origin;
    glm::dvec2 const v = transform_coordinate(source, {0, 1}) - origin;
    store(Vec3(u.x, v.x, origin.x), result.row_u);
    store(Vec3(u.y, v.y, origin.y), result.row_v);
    return result;
  }

 private:
  device::uint number_of(std::shared_ptr<Texture const> const& texture) {
    auto const [found, is_new] = textures_.emplace(texture.get(), device::uint(table_.textures.size()));
    if (!is_new) return found->second;
    TextureImage const& image = *texture->image;
    device::uint const sampling = device::uint(texture->wrap_s) | device::uint(texture->wrap_t) << 2 |
                                  (texture->filter == TextureFilter::linear ? FILTER_LINEAR : FILTER_NEAREST) << 4;
    table_.textures.push_back({first_texel(image), device::uint(image.width), device::uint(image.height), sampling});
    return found->second;
  }

  device::uint first_texel(TextureImage const& image) {
    auto const [found, is_new] = images_.emplace(&image, table_.texels.size());
    if (is_new) {
      std::size_t const count = image.rgba.size() / 4;
      if (table_.texels.size() + count > 0xFFFFFFFFu) {
        throw Error(ErrorKind::scene, "the textures have more than 2^32 texels; a smaller --max-texture helps");
      }
      table_.texels.resize(table_.texels.size() + count);
      // The host is little endian, as the device is: red is the lowest byte of a word.
      std::memcpy(table_.texels.data() + found->second, image.rgba.data(), 4 * count);
    }
    return device::uint(found->second);
  }

  MaterialTable& table_;
  std::unordered_map<Texture const*, device::uint> textures_;
  std::unordered_map<TextureImage const*, std::size_t> images_;
};

static_assert(int(TextureWrap::repeat) == WRAP_REPEAT && int(TextureWrap::mirrored_repeat) == WRAP_MIRRORED_REPEAT &&
              int(TextureWrap::clamp_to_edge) == WRAP_CLAMP_TO_EDGE);
static_assert(int(AlphaMode::opaque) == ALPHA_OPAQUE && int(AlphaMode::mask) == ALPHA_MASK &&
              int(AlphaMode::blend) == ALPHA_BLEND);

device::uint flags_of(PbrModel const& m) {
  return PBR_IS_PRESENT | (varies(m) ? PBR_VARIES : 0u) | (has_cutouts(m) ? PBR_CUTOUT : 0u) |
         (filters(m) ? PBR_FILTERS : 0u) | (varies_more(m) ? PBR_VARIES_MORE : 0u) | (may_be_pane(m) ? PBR_PANE : 0u);
}

/// `slot_of` has the device's slot for a member of the model.
template <class SlotOf>
device::PbrMaterial pbr_material(PbrModel const& m, SlotOf const& slot_of) {
  device::PbrMaterial out{};
  out.flags = flags_of(m);
#define LICHTRAUM_COLOR(name, initial, extension, key) store(m.name, out.name);
#define LICHTRAUM_SHARE(name, initial, extension, key) out.name = float(m.name);
#define LICHTRAUM_NUMBER(name, initial, least, most, extension, key) out.name = float(m.name);
#define LICHTRAUM_TEXTURE(name, extension, key) out.name = slot_of(m.name, &device::PbrMaterial::name);
#define LICHTRAUM_MODE(type, name, initial) out.name = device::uint(m.name);
  PBR_DEVICE_FIELDS(LICHTRAUM_COLOR, LICHTRAUM_SHARE, LICHTRAUM_NUMBER, LICHTRAUM_TEXTURE, LICHTRAUM_MODE)
#undef LICHTRAUM_COLOR
#undef LICHTRAUM_SHARE
#undef LICHTRAUM_NUMBER
#undef LICHTRAUM_TEXTURE
#undef LICHTRAUM_MODE
  return out;
}

/// Of glass that does not refract; as in kernels/materials/pane.clh.
bool is_pane(PhongModel const& m) { return float(m.transmit) > 0 && float(m.ior) == 1 && m.emission == Rgb(0); }

using DeviceSlot = device::TextureSlot device::PbrMaterial::*;

}  // namespace

device::PhongMaterial phong_material(Material const& material) {
  PhongModel const phong = material.phong();
  device::PhongMaterial out{};
#define LICHTRAUM_COLOR(name, initial) store(phong.name, out.name);
#define LICHTRAUM_SHARE(name, initial) out.name = float(phong.name);
#define LICHTRAUM_NUMBER(name, initial, least, most) out.name = float(phong.name);
  PHONG_FIELDS(LICHTRAUM_COLOR, LICHTRAUM_SHARE, LICHTRAUM_NUMBER)
#undef LICHTRAUM_COLOR
#undef LICHTRAUM_SHARE
#undef LICHTRAUM_NUMBER
  return out;
}

device::PbrMaterial pbr_material(PbrModel const& model, device::PbrMaterial const& before) {
  return pbr_material(model, [&](TextureSlot const&, DeviceSlot slot) { return before.*slot; });
}

device::uint features_of(Material const& material) {
  device::uint features = float(material.transmit()) > 0 ? SCENE_TRANSPARENCY : 0;
  PbrModel const* const pbr = material.pbr();
  if (!pbr) return features | (is_pane(material.phong()) ? SCENE_PANES : 0u);
  features |= SCENE_PBR;
  if (has_cutouts(*pbr) || filters(*pbr)) features |= SCENE_CUTOUTS;
  if (filters(*pbr)) features |= SCENE_TRANSPARENCY;
  if (needs_tangents(*pbr)) features |= SCENE_TANGENTS;
  if (may_be_pane(*pbr)) features |= SCENE_PANES;
  return features;
}

MaterialTable make_material_table(std::vector<std::shared_ptr<Material const>> const& materials) {
  MaterialTable table;
  Textures textures(table);
  for (auto const& material : materials) {
    Material const shown = material ? *material : Material();
    table.phong.push_back(phong_material(shown));
    table.features |= features_of(shown);
    if (!shown.pbr()) continue;
    table.pbr.resize(table.phong.size(), {});  // what comes between has none
    std::vector<int> const sets = used_texcoords(*shown.pbr());
    table.pbr.back() =
        pbr_material(*shown.pbr(), [&](TextureSlot const& slot, DeviceSlot) { return textures.slot(slot, sets); });
  }
  if (!table.pbr.empty()) table.pbr.resize(table.phong.size(), {});
  return table;
}

}  // namespace lichtraum
