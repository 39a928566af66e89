#include "view/window/font.hpp"

#include <imgui.h>

#include <filesystem>

namespace lichtraum::view {
namespace {

/// Columns of text are lined up by spaces.
constexpr char const* monospaced_fonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",  // Debian, Ubuntu
                                            "/usr/share/fonts/dejavu-sans-mono-fonts/DejaVuSansMono.ttf",  // Fedora
                                            "/usr/share/fonts/TTF/DejaVuSansMono.ttf",                     // Arch
                                            "/usr/share/fonts/truetype/liberation/LiberationMono-Regular.ttf"};

constexpr float own_letter_width = 7;  // of Dear ImGui's own font

/// First and last of each block: Latin, Greek, Cyrillic, Vietnamese, punctuation. What a font lacks is left out.
constexpr ImWchar letters[] = {0x20, 0x24f, 0x370, 0x52f, 0x1ea0, 0x1eff, 0x2010, 0x205e, 0};

bool add_system_font(float height, ImFontConfig const& config) {
  for (char const* const file : monospaced_fonts) {
    std::error_code unknown;
    if (std::filesystem::exists(file, unknown) &&
        ImGui::GetIO().Fonts->AddFontFromFileTTF(file, height, &config, letters)) {
      return true;
    }
  }
  return false;
}

}  // namespace

void load_font(float height_pixels) {
  ImGui::GetIO().Fonts->Clear();
  ImFontConfig smooth;
  smooth.OversampleH = 2;
  bool const is_own_height = height_pixels == own_font_height;
  if (!is_own_height && add_system_font(height_pixels, smooth)) return;

  ImFontConfig own;
  own.SizePixels = height_pixels;
  own.OversampleH = 1;
  own.PixelSnapH = true;
  ImGui::GetIO().Fonts->AddFontDefault(&own);
  if (!is_own_height) return;
  ImFontConfig others = own;  // what it lacks, in columns as wide
  others.MergeMode = true;
  others.GlyphMinAdvanceX = others.GlyphMaxAdvanceX = own_letter_width;
  add_system_font(own_font_height, others);
}

}  // namespace lichtraum::view
