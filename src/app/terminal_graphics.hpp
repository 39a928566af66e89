#pragma once

#include <string>

#include "lichtraum/image.hpp"

/// Pictures as what terminals show. Values are clamped to [0, 1]; nothing is developed here.

namespace lichtraum::app {

enum class TerminalGraphics {
  blocks,  ///< two pixels a character, in 24-bit colour: every terminal of today
  kitty,   ///< https://sw.kovidgoyal.net/kitty/graphics-protocol
  sixel,   ///< DEC's, as xterm and others still understand it
};

/// One character for two pixels above each other, "\u2580" in both colours; a line of text for two rows of pixels.
std::string encode_blocks(Image const& image);
/// 24 bits a pixel, where the cursor is.
std::string encode_kitty(Image const& image);
/// In the 6 x 6 x 6 colours of the cube, with error diffusion (Floyd and Steinberg 1976).
std::string encode_sixel(Image const& image);

}  // namespace lichtraum::app
