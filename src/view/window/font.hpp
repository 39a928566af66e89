#pragma once

namespace lichtraum::view {

/// The height in pixels of Dear ImGui's own font, which is made of whole pixels.
constexpr float own_font_height = 13;

/// Puts the font of text and widgets into Dear ImGui's atlas: its own at its own height, else a monospaced one of the
/// system, if there is one. In either case with the system's letters of Latin, Greek and Cyrillic, for names.
void load_font(float height_pixels);

}  // namespace lichtraum::view
