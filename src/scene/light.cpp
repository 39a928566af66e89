#include "lichtraum/light.hpp"

#include <ostream>

#include "core/format_numbers.hpp"

namespace lichtraum {

Light Light::ambient(std::string name, Rgb const& la) {
  Light light;
  light.name_ = std::move(name);
  light.kind_ = LightKind::ambient;
  light.la_ = la;
  light.ld_ = Rgb(0);
  return light;
}

Light Light::point(std::string name, Vec3 const& position, Rgb const& ld, Rgb const& la) {
  Light light;
  light.name_ = std::move(name);
  light.kind_ = LightKind::point;
  light.position_ = position;
  light.la_ = la;
  light.ld_ = ld;
  return light;
}

std::ostream& operator<<(std::ostream& out, Light const& light) {
  if (light.kind() == LightKind::ambient) {
    return out << fmt::format("ambient light '{}': la {}", light.name(), format_numbers(light.la()));
  }
  return out << fmt::format("point light '{}': position {}, la {}, ld {}", light.name(),
                            format_numbers(light.position()), format_numbers(light.la()), format_numbers(light.ld()));
}

}  // namespace lichtraum
