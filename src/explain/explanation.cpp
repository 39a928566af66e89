#include "lichtraum/explanation.hpp"

#include <array>

#include "explain/tables.hpp"

namespace lichtraum {

std::span<ExplanationGroup const> explanation_groups() {
  static std::array const groups{
      ExplanationGroup{"Options and devices", explain::options()},
      ExplanationGroup{"Files", explain::files()},
      ExplanationGroup{"Statements of eSDF", explain::statements()},
      ExplanationGroup{"Names", explain::names()},
      ExplanationGroup{"Numbers and colours", explain::numbers()},
      ExplanationGroup{"Shapes and transforms", explain::shapes()},
      ExplanationGroup{"Materials, lights and cameras", explain::materials_and_views()},
      ExplanationGroup{"Pictures", explain::pictures()},
      ExplanationGroup{"Models", explain::models()},
      ExplanationGroup{"Models in glTF", explain::gltf()},
      ExplanationGroup{"Models in OBJ, with MTL", explain::obj()},
      ExplanationGroup{"Models in PLY", explain::ply()},
      ExplanationGroup{"Models in STL", explain::stl()},
  };
  return groups;
}

Explanation const* explanation_of(DiagnosticCode code) {
  for (ExplanationGroup const& group : explanation_groups()) {
    for (Explanation const& explanation : group.explanations) {
      if (explanation.code == code) return &explanation;
    }
  }
  return nullptr;
}

}  // namespace lichtraum
