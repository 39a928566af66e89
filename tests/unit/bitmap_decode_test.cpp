#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/image/decode.hpp"
#include "lichtraum/obj.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;

namespace {

using Color = std::array<std::uint8_t, 4>;
using Colors = std::vector<Color>;

std::string bytes(std::vector<int> const& values) {
  std::string text;
  for (int const value : values) text.push_back(char(value));
  return text;
}

/// Its header; `palette`: how many colours of so many bits.
std::string tga(int type, int width, int height, int bits, int descriptor, std::pair<int, int> palette = {0, 0}) {
  return bytes({0, palette.first > 0, type, 0, 0, palette.first, 0, palette.second, 0, 0, 0, 0, width, 0, height, 0,
                bits, descriptor});
}

/// Its headers: a picture without compression, 40 bytes of BITMAPINFOHEADER, and `before` bytes until the pixels.
std::string bmp(int width, int height, int bits, int before = 0, int compression = 0) {
  int const sign = height < 0 ? 255 : 0;
  return "BM" + bytes({0, 0, 0, 0, 0, 0, 0, 0, 54 + before, 0, 0, 0}) +
         bytes({40, 0, 0, 0, width, 0, 0, 0, height, sign, sign, sign, 1, 0, bits, 0, compression, 0, 0, 0}) +
         std::string(20, '\0');
}

Colors pixels_of(std::string const& file) {
  std::string reason;
  auto const image = decode_image(file, 64, TexelContent::data, reason);
  INFO(reason);
  REQUIRE(image);
  CHECK(decoded_size(file, 64) == ImageSize{image->width, image->height});
  Colors colors;
  for (std::size_t i = 0; i < image->rgba.size(); i += 4) {
    colors.push_back({image->rgba[i], image->rgba[i + 1], image->rgba[i + 2], image->rgba[i + 3]});
  }
  return colors;
}

std::string reason_of(std::string const& file) {
  std::string reason;
  CHECK(!decode_image(file, 64, TexelContent::data, reason));
  return reason;
}

Color const red{255, 0, 0, 255}, green{0, 255, 0, 255}, blue{0, 0, 255, 255}, white{255, 255, 255, 255};
// Red and green above blue and white, as BGR.
std::string const upper = bytes({0, 0, 255, 0, 255, 0}), lower = bytes({255, 0, 0, 255, 255, 255});
Colors const four{red, green, blue, white};

}  // namespace

TEST_CASE("TGA pictures begin at any corner", "[unit][image][bitmap]") {
  CHECK(pixels_of(tga(2, 2, 2, 24, 0) + lower + upper) == four);
  CHECK(pixels_of(tga(2, 2, 2, 24, 0x20) + upper + lower) == four);
  std::string const mirrored = bytes({0, 255, 0, 0, 0, 255, 255, 255, 255, 255, 0, 0});
  CHECK(pixels_of(tga(2, 2, 2, 24, 0x30) + mirrored) == four);
  std::string const with_id = bytes({3, 0, 2}) + tga(2, 2, 2, 24, 0x20).substr(3) + "abc" + upper + lower;
  CHECK(pixels_of(with_id) == four);
}

TEST_CASE("TGA pictures have colours, greys and palettes", "[unit][image][bitmap]") {
  CHECK(pixels_of(tga(2, 2, 1, 32, 0x28) + bytes({1, 2, 3, 4, 5, 6, 7, 8})) == Colors{{3, 2, 1, 4}, {7, 6, 5, 8}});
  CHECK(pixels_of(tga(2, 2, 1, 32, 0x20) + bytes({1, 2, 3, 0, 5, 6, 7, 0})) == Colors{{3, 2, 1, 255}, {7, 6, 5, 255}});
  CHECK(pixels_of(tga(2, 2, 1, 16, 0x20) + bytes({0x00, 0x7C, 0x10, 0x00})) == Colors{red, {0, 0, 132, 255}});
  CHECK(pixels_of(tga(3, 2, 1, 8, 0x20) + bytes({9, 200})) == Colors{{9, 9, 9, 255}, {200, 200, 200, 255}});
  CHECK(pixels_of(tga(3, 1, 1, 16, 0x28) + bytes({9, 200})) == Colors{{9, 9, 9, 200}});
  CHECK(pixels_of(tga(1, 3, 1, 8, 0x20, {2, 24}) + upper + bytes({1, 0, 1})) == Colors{green, red, green});
  std::string from_five = tga(1, 1, 1, 8, 0x20, {2, 24}) + upper + bytes({6});
  from_five[3] = 5;
  CHECK(pixels_of(from_five) == Colors{green});
}

TEST_CASE("TGA pictures have runs, also across rows", "[unit][image][bitmap]") {
  std::string const packed = bytes({0x82, 0, 0, 255, 0x02, 0, 255, 0, 255, 0, 0, 255, 255, 255});
  CHECK(pixels_of(tga(10, 2, 3, 24, 0x20) + packed) == Colors{red, red, red, green, blue, white});
  CHECK(pixels_of(tga(9, 4, 1, 8, 0x20, {2, 24}) + upper + bytes({0x82, 1, 0x00, 0})) ==
        Colors{green, green, green, red});
  CHECK(pixels_of(tga(11, 130, 1, 8, 0x20) + bytes({0xFF, 7, 0x81, 8})).size() == 33);  // halved twice
}

TEST_CASE("BMP pictures have colours, palettes and masks", "[unit][image][bitmap]") {
  std::string const pad(2, '\0');
  CHECK(pixels_of(bmp(2, 2, 24) + lower + pad + upper + pad) == four);
  CHECK(pixels_of(bmp(2, 2, 24) + lower + pad + upper) == four);
  CHECK(pixels_of(bmp(2, -2, 24) + upper + pad + lower + pad) == four);
  CHECK(pixels_of(bmp(2, 1, 32) + bytes({1, 2, 3, 4, 5, 6, 7, 8})) == Colors{{3, 2, 1, 4}, {7, 6, 5, 8}});
  CHECK(pixels_of(bmp(1, 1, 32) + bytes({1, 2, 3, 0})) == Colors{{3, 2, 1, 255}});
  CHECK(pixels_of(bmp(2, 1, 16) + bytes({0x00, 0x7C, 0x10, 0x00})) == Colors{red, {0, 0, 132, 255}});
  std::string const masks_565 = bytes({0, 0xF8, 0, 0, 0xE0, 0x07, 0, 0, 0x1F, 0, 0, 0});
  CHECK(pixels_of(bmp(2, 1, 16, 12, 3) + masks_565 + bytes({0xE0, 0x07, 0x00, 0xF8})) == Colors{green, red});
  std::string const palette = bytes({0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0, 0, 255, 255, 255, 0});
  auto const of_palette = [&](int bits, std::string const& row, int count) {
    std::string file = bmp(4, 1, bits, 4 * count) + palette.substr(0, 4 * std::size_t(count)) + row;
    file[46] = char(count);
    return file;
  };
  CHECK(pixels_of(of_palette(8, bytes({3, 2, 1, 0}), 4)) == Colors{white, blue, green, red});
  CHECK(pixels_of(of_palette(4, bytes({0x32, 0x10, 0, 0}), 4)) == Colors{white, blue, green, red});
  CHECK(pixels_of(of_palette(1, bytes({0x50, 0, 0, 0}), 2)) == Colors{red, green, red, green});
  std::string const old = "BM" + bytes({0, 0, 0, 0, 0, 0, 0, 0, 26, 0, 0, 0, 12, 0, 0, 0, 2, 0, 2, 0, 1, 0, 24, 0});
  CHECK(pixels_of(old + lower + pad + upper + pad) == four);
}

TEST_CASE("what is wrong in TGA and BMP pictures is told", "[unit][image][bitmap]") {
  std::string const whole_tga = tga(2, 2, 2, 24, 0) + lower + upper, whole_bmp = bmp(2, 2, 16) + std::string(8, '\1');
  std::string const packed = tga(10, 2, 2, 24, 0) + bytes({0x01, 0, 0, 255, 0, 0, 255, 0x81, 0, 0, 255});
  CHECK(pixels_of(packed).size() == 4);
  for (std::string const& whole : {whole_tga, whole_bmp, packed}) {
    for (std::size_t size = 0; size < whole.size(); ++size) CHECK(!reason_of(whole.substr(0, size)).empty());
  }
  CHECK(reason_of(whole_tga.substr(0, 29)) == "the TGA data ends too early");
  CHECK(reason_of(packed.substr(0, 25)) == "the TGA data ends too early");
  CHECK(reason_of(whole_bmp.substr(0, 61)) == "the BMP data ends too early");
  CHECK(reason_of("BM") == "the header gives no size");
  CHECK(reason_of(tga(1, 1, 1, 8, 0, {2, 24}) + upper + bytes({2})) ==
        "the TGA data has a colour that its palette lacks");
  std::string few = bmp(1, 1, 8, 4) + bytes({0, 0, 255, 0, 1, 0, 0, 0});
  few[46] = 1;
  CHECK(reason_of(few) == "the BMP data has a colour that its palette lacks");
  CHECK(reason_of(bmp(1, 1, 8, 0, 1)) == "compressed BMP pictures cannot be decoded");
  CHECK(reason_of(bmp(1, 1, 7)) == "the BMP header is damaged");
  std::string large = tga(2, 255, 255, 24, 0);
  large[13] = large[15] = '\x7F';
  CHECK_THAT(reason_of(large), contains_text("up to 2^26 can be read"));
  std::string promises = tga(2, 255, 255, 32, 0);  // a gigabyte, of which nothing is there
  promises[13] = promises[15] = '\x1F';
  CHECK(reason_of(promises) == "the TGA data ends too early");
  std::string endless = bmp(1, 1, 24);
  endless.replace(22, 4, bytes({0, 0, 0, 0x80}));
  CHECK_THAT(reason_of(endless), contains_text("up to 2^26 can be read"));
  CHECK_THAT(reason_of("no picture of any kind, but long"), contains_text("it is not a PNG, JPEG, WebP, BMP or TGA"));
}

TEST_CASE("an OBJ model has pictures in TGA and BMP", "[unit][obj][bitmap]") {
  TemporaryFolder const folder;
  folder.write("a.tga", tga(2, 2, 2, 24, 0x20) + upper + lower);
  folder.write("b.bmp", bmp(2, 2, 24) + lower + "  " + upper + "  ");
  folder.write("m.mtl", "newmtl a\nmap_Kd a.tga\nnewmtl b\nmap_Kd b.bmp\n");
  Model const model = import_obj_text(
      "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1/1 2/1 3/1\n", "m.obj",
      std::filesystem::path(folder / "."), {});
  CHECK(model.diagnostics.empty());
  for (char const* const name : {"a", "b"}) {
    auto const* const material = model.scene.materials.find(name);
    REQUIRE(material);
    REQUIRE((*material)->pbr());
    CHECK((*material)->pbr()->base_color_texture.texture->image->rgba[0] == 255);
  }
}
