#pragma once

namespace lichtraum::view {

/// What a number is after a widget, which only has floats, has shown it: as it was if that is the same float, or none
/// that is finite, else the decimal number of fewest digits that is. So what nobody touched stays, and what is saved
/// reads 0.763 and not 0.7630000114440918.
double edited_number(double number, float shown);

/// The same of a channel of a colour, within what eSDF takes of light.
double edited_channel(double channel, float shown);

/// What a share of the light leaves another one: 0.3 of 0.7, and not 0.30000000000000004. Their sum is 1 at most.
double rest_of(double share);

}  // namespace lichtraum::view
