#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/denoise.hpp"
#include "lichtraum/device.hpp"
#include "lichtraum/esdf.hpp"
#include "lichtraum/renderer.hpp"
#include "lichtraum/tone_map.hpp"

/// The words that stand for values, on command lines as in JSON.

namespace LICHTRAUM_API lichtraum {

template <class Value>
struct Word {
  std::string_view word;
  Value value;
};

inline constexpr auto tone_map_words = std::to_array<Word<ToneMap>>({{"auto", ToneMap::automatic},
                                                                     {"neutral", ToneMap::neutral},
                                                                     {"agx", ToneMap::agx},
                                                                     {"aces", ToneMap::aces},
                                                                     {"reinhard", ToneMap::reinhard},
                                                                     {"none", ToneMap::none}});
inline constexpr auto transfer_words =
    std::to_array<Word<Transfer>>({{"linear", Transfer::linear}, {"srgb", Transfer::srgb}});
inline constexpr auto denoising_words = std::to_array<Word<Denoising>>(
    {{"auto", Denoising::automatic}, {"on", Denoising::on}, {"off", Denoising::off}, {"builtin", Denoising::builtin}});
inline constexpr auto transform_order_words =
    std::to_array<Word<TransformOrder>>({{"parent", TransformOrder::parent}, {"local", TransformOrder::local}});
inline constexpr auto rotation_words =
    std::to_array<Word<RotationSense>>({{"right", RotationSense::right}, {"left", RotationSense::left}});
inline constexpr auto material_extra_words =
    std::to_array<Word<MaterialExtra>>({{"reflectance", MaterialExtra::reflectance},
                                        {"transmittance", MaterialExtra::transmittance},
                                        {"opacity", MaterialExtra::opacity},
                                        {"ior", MaterialExtra::ior},
                                        {"ignore", MaterialExtra::ignore}});
#define LICHTRAUM_INTEGRATOR_WORD(name) {#name, Integrator::name},
inline constexpr auto integrator_words = std::to_array<Word<Integrator>>({INTEGRATORS(LICHTRAUM_INTEGRATOR_WORD)});
#undef LICHTRAUM_INTEGRATOR_WORD
inline constexpr auto ground_words =
    std::to_array<Word<Ground>>({{"none", Ground::none}, {"matt", Ground::matt}, {"glossy", Ground::glossy}});
inline constexpr auto device_kind_words = std::to_array<Word<DeviceKind>>({{"reference", DeviceKind::reference},
                                                                           {"cpu", DeviceKind::cpu},
                                                                           {"gpu", DeviceKind::gpu},
                                                                           {"accelerator", DeviceKind::accelerator}});
inline constexpr auto pattern_words =
    std::to_array<Word<Sampling::Pattern>>({{"grid", Sampling::Pattern::grid}, {"seeded", Sampling::Pattern::seeded}});

/// Names of planes.
inline std::vector<Word<FilmPlane>> plane_words() {
  std::vector<Word<FilmPlane>> words;
  for (std::size_t i = 0; i < plane_count; ++i) words.push_back({info_of(FilmPlane(i)).name, FilmPlane(i)});
  return words;
}

/// Null for an unknown word.
template <class Value>
Value const* find_value(std::span<Word<Value> const> words, std::string_view text) {
  for (Word<Value> const& entry : words) {
    if (entry.word == text) return &entry.value;
  }
  return nullptr;
}

/// The word that stands for a value; empty where none does.
template <class Value>
std::string_view find_word(std::span<Word<Value> const> words, Value const& value) {
  for (Word<Value> const& entry : words) {
    if (entry.value == value) return entry.word;
  }
  return {};
}

/// "right or left".
template <class Value>
std::string list_of(std::span<Word<Value> const> words) {
  std::string list;
  for (Word<Value> const& entry : words) {
    list += list.empty() ? "" : &entry == &words.back() ? " or " : ", ";
    list += entry.word;
  }
  return list;
}

}  // namespace lichtraum
