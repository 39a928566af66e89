#include "io/gltf/draco.hpp"

#include <draco/compression/decode.h>
#include <fmt/format.h>

namespace lichtraum::gltf {
namespace {

std::optional<FloatElements> convert(draco::Mesh const& mesh, draco::PointAttribute const& attribute) {
  auto const components = std::size_t(attribute.num_components());
  if (components < 1 || components > 4) return std::nullopt;
  FloatElements result{components, std::vector<float>(components * mesh.num_points())};
  float* out = result.values.data();
  for (draco::PointIndex point(0); point < mesh.num_points(); ++point, out += components) {
    auto const index = attribute.mapped_index(point);
    if (index.value() >= attribute.size()) return std::nullopt;
    if (!attribute.ConvertValue<float>(index, static_cast<int8_t>(components), out)) return std::nullopt;
  }
  return result;
}

}  // namespace

std::optional<DracoPrimitive> decode_draco(std::string_view compressed,
                                           std::map<std::string, DracoAttribute> const& attributes,
                                           std::string& reason) {
  draco::DecoderBuffer buffer;
  buffer.Init(compressed.data(), compressed.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) {
    reason = fmt::format("Draco: {}", decoded.status().error_msg_string());
    return std::nullopt;
  }
  draco::Mesh& mesh = *decoded.value();
  DracoPrimitive primitive;
  primitive.indices.reserve(std::size_t(mesh.num_faces()) * 3);
  for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face) {
    for (draco::PointIndex const& corner : mesh.face(face)) primitive.indices.push_back(corner.value());
  }
  for (auto const& [name, wanted] : attributes) {
    int const number = wanted.id < 0 ? -1 : mesh.GetAttributeIdByUniqueId(std::uint32_t(wanted.id));
    auto* const attribute = number < 0 ? nullptr : mesh.attribute(number);
    if (attribute && wanted.is_normalized) attribute->set_normalized(*wanted.is_normalized);
    auto elements = attribute ? convert(mesh, *attribute) : std::nullopt;
    if (!elements) {
      reason = fmt::format("Draco: attribute {} (id {}) cannot be read", name, wanted.id);
      return std::nullopt;
    }
    primitive.attributes.emplace(name, std::move(*elements));
  }
  return primitive;
}

}  // namespace lichtraum::gltf
