#pragma once

#include <cstddef>
#include <string_view>

#include "lichtraum/api.hpp"

namespace LICHTRAUM_API lichtraum {

/// The kinds of errors and warnings: CODE(letter, number, name, title). E is an error, W a warning; with strict reading
/// a warning may be an error, and with keep_going an error a warning, of the same code. Codes are stable: texts may be
/// worded better, but a number keeps its meaning, and one that is no longer used is never given to another kind.
///
///   01xx  options and devices   06xx  shapes and transforms              10xx  glTF
///   02xx  files                 07xx  materials, lights and cameras      11xx  OBJ and MTL
///   03xx  statements of eSDF    08xx  pictures                           12xx  PLY
///   04xx  names                 09xx  models                             13xx  STL
///   05xx  numbers and colours
// clang-format off
#define LICHTRAUM_DIAGNOSTIC_CODES(CODE)                                                                \
  CODE(W, 0101, option_without_effect, "an option without effect")                                      \
  CODE(E, 0102, unusable_device, "a device that cannot be used")                                        \
  CODE(E, 0201, not_a_scene, "a file that is not a scene")                                              \
  CODE(E, 0202, file_outside, "a file outside of the folders that a scene may use")                     \
  CODE(E, 0203, unreadable_file, "a file that cannot be read")                                          \
  CODE(E, 0204, unread_format, "a model in a format that is not read")                                  \
  CODE(W, 0205, too_many_findings, "more findings than are shown")                                      \
  CODE(E, 0206, missing_input, "an input that cannot be opened")                                        \
  CODE(E, 0207, unwritable_output, "an output that cannot be written")                                  \
  CODE(E, 0208, failed_transfer, "reading or writing that failed half-way")                             \
  CODE(E, 0209, try_again, "something that may be there later")                                         \
  CODE(E, 0301, unknown_statement, "an unknown statement")                                              \
  CODE(E, 0302, unknown_definition, "'define' with an unknown kind of thing")                           \
  CODE(E, 0303, wrong_count, "too few or too many arguments")                                           \
  CODE(E, 0304, unknown_key, "an unknown key")                                                          \
  CODE(E, 0305, expected_key, "a word where key=value is expected")                                     \
  CODE(E, 0306, key_without_value, "a key without a value")                                             \
  CODE(E, 0307, given_twice, "something that is given twice")                                           \
  CODE(E, 0308, spaces_around_equals, "spaces around '='")                                              \
  CODE(E, 0309, color_with_equals, "'=' after the name of a colour")                                    \
  CODE(E, 0310, semicolon, "a semicolon at the end of a line")                                          \
  CODE(E, 0311, conflict_marker, "a git conflict marker")                                               \
  CODE(E, 0312, placeholder, "a placeholder that was not filled in")                                    \
  CODE(E, 0313, control_character, "a character that cannot be seen")                                   \
  CODE(W, 0314, not_utf8, "text that is not UTF-8")                                                     \
  CODE(E, 0315, not_standard, "a form that is not part of the standard")                                \
  CODE(E, 0401, already_defined, "a name that is already defined")                                      \
  CODE(E, 0402, second_environment, "a second environment")                                             \
  CODE(W, 0403, shape_and_camera, "a shape and a camera of the same name")                              \
  CODE(E, 0404, contains_itself, "a composite that contains itself")                                    \
  CODE(E, 0411, undefined_shape, "a shape that is not defined")                                         \
  CODE(E, 0412, undefined_material, "a material that is not defined")                                   \
  CODE(E, 0413, undefined_camera, "a camera that is not defined")                                       \
  CODE(E, 0414, undefined_object, "a shape or camera that is not defined")                              \
  CODE(E, 0501, not_a_number, "a word where a number is expected")                                      \
  CODE(E, 0502, number_too_large, "a number that is too large")                                         \
  CODE(E, 0503, out_of_range, "a number outside of its range")                                          \
  CODE(E, 0504, not_a_whole_number, "a number that must be whole")                                      \
  CODE(W, 0505, number_with_f, "an f after a number")                                                   \
  CODE(W, 0506, color_out_of_range, "a colour that is not between 0 and 1")                             \
  CODE(E, 0507, zero_direction, "a direction of length 0")                                              \
  CODE(E, 0601, unknown_shape, "an unknown kind of shape")                                              \
  CODE(E, 0602, material_first, "a material before the numbers")                                        \
  CODE(E, 0603, zero_size, "a shape of size 0")                                                         \
  CODE(W, 0604, negative_radius, "a negative radius")                                                   \
  CODE(W, 0605, invisible_shape, "a shape too thin to be seen")                                         \
  CODE(E, 0606, unknown_transform, "an unknown operation of 'transform'")                               \
  CODE(E, 0607, unknown_axis, "an unknown axis")                                                        \
  CODE(E, 0608, zero_scale, "a scale of 0")                                                             \
  CODE(E, 0609, transforms_too_large, "transforms that exceed the range of numbers")                    \
  CODE(E, 0610, transformed_light, "a light that is to be transformed")                                 \
  CODE(W, 0611, axis_before_angle, "a rotation whose axis seems to come first")                         \
  CODE(E, 0701, more_than_all_light, "a material that gives more light than it gets")                   \
  CODE(W, 0702, more_than_all_light_in_extras, "numbers after m that give more light than arrives")     \
  CODE(W, 0703, extra_material_numbers, "numbers after m that mean nothing")                            \
  CODE(E, 0704, unknown_light, "an unknown kind of light")                                              \
  CODE(W, 0705, ambient_light_form, "an ambient light without a name or position")                      \
  CODE(E, 0706, incomplete_lens, "half of a lens")                                                      \
  CODE(W, 0707, unusable_up, "a camera whose up says nothing")                                          \
  CODE(E, 0801, no_camera, "a render without a camera")                                                 \
  CODE(W, 0802, camera_assumed, "a render whose camera had to be guessed")                              \
  CODE(E, 0803, no_file_name, "a render without a file name")                                           \
  CODE(W, 0804, spaces_in_file_name, "a file name with spaces")                                         \
  CODE(E, 0805, stray_word, "a word that does not belong in a render")                                  \
  CODE(W, 0806, extra_render_numbers, "more numbers than a render takes")                               \
  CODE(E, 0807, unknown_integrator, "an unknown integrator")                                            \
  CODE(E, 0808, no_resolution, "a picture without a resolution")                                        \
  CODE(W, 0811, name_used_twice, "pictures of the same name")                                           \
  CODE(W, 0812, other_format, "a picture in another format than its name says")                         \
  CODE(W, 0813, shapes_left_out, "shapes that are too large or too small to be drawn")                  \
  CODE(W, 0814, no_light, "a scene without light")                                                      \
  CODE(W, 0815, black_picture, "a picture that no light reaches")                                       \
  CODE(W, 0816, empty_view, "a camera that sees nothing")                                               \
  CODE(W, 0817, noise_left, "noise that is left")                                                       \
  CODE(W, 0818, samples_left_out, "samples that are not finite")                                        \
  CODE(W, 0819, other_denoiser, "noise that is taken out in another way")                               \
  CODE(E, 0820, undrawable_scene, "a scene that cannot be drawn as asked")                              \
  CODE(W, 0821, film_of_one_picture, "a film of one picture")                                           \
  CODE(W, 0822, outside_animation, "a time outside of an animation")                                    \
  CODE(W, 0823, white_picture, "a picture that is mostly white")                                        \
  CODE(W, 0824, far_scene, "a scene far from the origin")                                               \
  CODE(W, 0825, repaired_environment, "an environment with values that cannot be light")                \
  CODE(E, 0901, nothing_to_draw, "a model with nothing to draw")                                        \
  CODE(W, 0902, geometry_left_out, "parts of a model that cannot be drawn")                             \
  CODE(W, 0903, texture_left_out, "a picture of a model that cannot be used")                           \
  CODE(W, 0904, faulty_number, "a faulty number in a model")                                            \
  CODE(W, 0905, textures_halved, "pictures of a model that are made smaller")                           \
  CODE(W, 0906, file_elsewhere, "a file of a model that is not where the model says")                   \
  CODE(W, 0907, far_from_origin, "a model far from the origin")                                         \
  CODE(E, 1001, not_gltf, "a file that is not glTF")                                                    \
  CODE(E, 1002, gltf_version, "another version of glTF")                                                \
  CODE(E, 1003, broken_glb, "a .glb that is broken")                                                    \
  CODE(W, 1004, cut_glb, "a .glb that is cut off")                                                      \
  CODE(W, 1005, gltf_property, "a faulty property of a glTF model")                                     \
  CODE(W, 1006, unsupported_extension, "an extension of glTF that is not supported")                    \
  CODE(W, 1007, unreadable_buffer, "a buffer of a glTF model that cannot be read")                      \
  CODE(W, 1008, unreadable_accessor, "an accessor of a glTF model that cannot be read")                 \
  CODE(W, 1009, undrawn_primitive, "a primitive of a glTF model that is not drawn")                     \
  CODE(E, 1010, unfolds_too_far, "a glTF model that is larger than its files can hold")                 \
  CODE(W, 1011, faulty_animation, "a faulty animation of a glTF model")                                 \
  CODE(W, 1012, faulty_node, "a faulty node of a glTF model")                                           \
  CODE(W, 1013, faulty_skin, "a faulty skin of a glTF model")                                           \
  CODE(W, 1014, faulty_view, "a faulty camera or light of a glTF model")                                \
  CODE(W, 1015, faulty_gltf_material, "a faulty material of a glTF model")                              \
  CODE(W, 1101, unknown_obj_keyword, "an unknown keyword in OBJ or MTL")                                \
  CODE(W, 1102, undrawn_obj, "elements of OBJ that are not drawn")                                      \
  CODE(W, 1103, faulty_face, "a faulty face in OBJ")                                                    \
  CODE(W, 1104, missing_vertex, "a vertex that an OBJ model does not have")                             \
  CODE(W, 1105, missing_obj_material, "a material that is in no MTL file")                              \
  CODE(W, 1106, unreadable_mtl, "an MTL file that cannot be used")                                      \
  CODE(W, 1107, missing_obj_word, "a line of OBJ or MTL that lacks a word")                             \
  CODE(W, 1108, unread_color, "a colour of MTL in another form")                                        \
  CODE(W, 1109, parts_joined, "an OBJ model of very many parts")                                        \
  CODE(E, 1110, not_obj, "a file that is not OBJ")                                                      \
  CODE(E, 1201, ply_header, "a faulty header of a PLY file")                                            \
  CODE(W, 1202, ply_data, "faulty data of a PLY file")                                                  \
  CODE(E, 1301, not_stl, "a file that is not STL")                                                      \
  CODE(W, 1302, stl_text, "a faulty line of an STL file")                                               \
  CODE(W, 1303, stl_bytes, "a binary STL file of the wrong size")
// clang-format on

/// `none` is for notes, and for what has no code yet.
enum class DiagnosticCode {
  none,
#define LICHTRAUM_ENUMERATOR(letter, number, name, title) name,
  LICHTRAUM_DIAGNOSTIC_CODES(LICHTRAUM_ENUMERATOR)
#undef LICHTRAUM_ENUMERATOR
};

struct DiagnosticCodeEntry {
  DiagnosticCode code;
  std::string_view text;   ///< "E0412"; empty for none
  std::string_view title;  ///< "a material that is not defined"
};

/// All of them, by number, after the one for DiagnosticCode::none.
inline constexpr DiagnosticCodeEntry diagnostic_codes[] = {{DiagnosticCode::none, "", ""},
#define LICHTRAUM_ENTRY(letter, number, name, title) {DiagnosticCode::name, #letter #number, title},
                                                           LICHTRAUM_DIAGNOSTIC_CODES(LICHTRAUM_ENTRY)
#undef LICHTRAUM_ENTRY
};

/// "E0412"; empty for none.
constexpr std::string_view code_text(DiagnosticCode code) {
  return diagnostic_codes[static_cast<std::size_t>(code)].text;
}

}  // namespace lichtraum
