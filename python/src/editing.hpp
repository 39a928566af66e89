#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "session.hpp"
#include "texture.hpp"

namespace lichtraum::python {

/// Numbers by the names of fields: three of a colour or a vector, one of all else.
using Fields = std::map<std::string, std::vector<double>>;
using Textures = std::map<std::string, MadeTexture>;

// Each throws Error{usage} for a name that the scene does not have and for values that make no sense, and then changes
// nothing.

/// A shape, moved after what was done before: `how` is "translate", "rotate" (degrees and an axis) or "scale", with the
/// numbers of eSDF's statement.
void transform(ReadScene& read, std::string const& shape, std::string const& how, std::vector<double> const& numbers);

/// Another one instead, for all shapes that have it: `model` is "phong" or "pbr", with the fields of PhongModel or
/// PbrModel. Of textures it has only these.
void set_material(ReadScene& read, std::string const& name, std::string const& model, Fields const& fields,
                  Textures const& textures);

/// Instead of one of that name, or besides the others; `kind` as in Light::kind.
void set_light(ReadScene& read, std::string const& name, std::string const& kind, Fields const& fields);
void remove_light(ReadScene& read, std::string const& name);

struct Step {
  std::string how;  ///< as of `transform`
  std::vector<double> numbers;
};
/// Instead of one of that name, or besides the others, from the origin by way of these steps. `orthographic`: how much
/// it sees across, if it is such a camera.
void set_camera(ReadScene& read, std::string const& name, double fov_x_degrees, std::optional<double> orthographic,
                std::vector<Step> const& steps, int width, int height);

}  // namespace lichtraum::python
