#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/job.hpp"

namespace lichtraum::app {

/// Numbers of frames, both included; 0 <= first <= last.
struct FrameRange {
  int first = 0;
  int last = 0;
};

}  // namespace lichtraum::app

/// Values of options from text. Each throws std::invalid_argument that says what was expected.

namespace lichtraum::app {

Resolution parse_size(std::string_view text);     ///< 640x480
Region parse_region(std::string_view text);       ///< x,y,width,height
Sampling parse_samples(std::string_view text);    ///< 16: seeded; 4x4: a grid
int parse_depth(std::string_view text);           ///< 0..1000
std::uint64_t parse_seed(std::string_view text);  ///< any 64-bit number
double parse_time(std::string_view text);         ///< seconds
FrameRange parse_frames(std::string_view text);   ///< 0..99, both included
FrameRange parse_units(std::string_view text);    ///< the same
double parse_ui_scale(std::string_view text);     ///< 0.5..8
double parse_frame_rate(std::string_view text);   ///< frames a second: > 0, <= 1000
int parse_count(std::string_view text);           ///< 1..100000
int parse_texture_size(std::string_view text);    ///< 1..65536
double parse_point_size(std::string_view text);   ///< 1e-6..1000
int parse_thumbnail_side(std::string_view text);  ///< 1..2048
int parse_bits(std::string_view text);            ///< 8 or 16
int parse_quality(std::string_view text);         ///< 1..100
PlaneSet parse_planes(std::string_view text);     ///< names of planes, commas between
Vec3 parse_point(std::string_view text);          ///< three finite numbers
double parse_aperture(std::string_view text);
JobView::Focus parse_focus(std::string_view text);
double parse_fov(std::string_view text);                                  ///< degrees: > 0, < 180
JobView::Orbit parse_orbit(std::string_view text);                        ///< two angles, or these and a distance
JobBackground parse_background(std::string_view text);                    ///< none, environment, one colour or two
double parse_clamp(std::string_view text);                                ///< > 0
double parse_noise(std::string_view text);                                ///< 0 < noise <= 1
double parse_exposure(std::string_view text);                             ///< stops: -100..100
Ground parse_ground(std::string_view text);                               ///< true (matt), none, matt, glossy
Integrator parse_integrator(std::string_view text);                       ///< whitted, path
double parse_environment_rotation(std::string_view text);                 ///< degrees: -1e6..1e6
double parse_environment_brightness(std::string_view text);               ///< 0..1e6
std::optional<Traversal> parse_traversal(std::string_view text);          ///< auto (nothing), scalar, wide, packet
ToneMap parse_tone_map(std::string_view text);                            ///< as tone_map_words has them
Denoising parse_denoising(std::string_view text);                         ///< auto, on, off, builtin
Transfer parse_transfer(std::string_view text);                           ///< linear, srgb
TransformOrder parse_transform_order(std::string_view text);              ///< parent, local
RotationSense parse_rotation(std::string_view text);                      ///< right, left
std::string parse_input_format(std::string_view text);                    ///< sdf or one of model_formats()
std::vector<MaterialExtra> parse_material_extras(std::string_view text);  ///< words with commas between

}  // namespace lichtraum::app
