#pragma once

#include "lichtraum.hpp"
#include "support/catch.hpp"
#include "support/decode.hpp"

/// Draws `scene` with the given words and reads the picture back.
inline DecodedImage draw(Lichtraum const& lichtraum, std::string const& words, std::string const& scene = ball_scene) {
  bool const has_format = words.find("--format") != std::string::npos;
  auto const result = lichtraum.render((has_format ? "- -q -o - " : "- -q -o - --format ppm ") + words, scene);
  INFO(words);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return decode(result.out);
}

inline float red_in_the_middle(DecodedImage const& image) { return image.at(image.width / 2, image.height / 2, 0); }
