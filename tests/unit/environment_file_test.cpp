#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "io/image/environment_decoders.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/image_io.hpp"
#include "support/catch.hpp"
#include "support/film_of.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
using test::film_of;

namespace {

constexpr float quiet_nan = std::numeric_limits<float>::quiet_NaN();

/// As files have it, from the least byte on.
std::string bytes_of(std::int32_t value) { return {reinterpret_cast<char const*>(&value), sizeof value}; }

/// No row or column like another.
Image sample_image(int width = 37, int height = 23) {
  Image image(Resolution{width, height});
  std::mt19937 random(1);
  for (float& v : image.data()) v = std::ldexp(float(random() % 256), int(random() % 12) - 8);
  return image;
}

std::string encode(Image const& image, char const* format) {
  return image_format_named(format).encode_film(film_of(image), {});
}

EnvironmentMap decode(std::string const& bytes) { return decode_environment({bytes, "sky"}); }

/// The message that it is refused with.
std::string refusal(std::string const& bytes, std::int64_t max_pixels = max_environment_pixels) {
  try {
    decode_environment({bytes, "sky", max_pixels});
  } catch (Error const& error) {
    CHECK(error.kind() == ErrorKind::scene);
    return error.what();
  }
  return "it was read";
}

bool contains(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

using Rgbe = std::array<int, 4>;
enum class Packing { none, old_runs, components };

std::string bytes_of(Rgbe const& pixel) {
  std::string bytes;
  for (int const value : pixel) bytes += char(value);
  return bytes;
}

std::string pack_row(std::vector<Rgbe> const& row, Packing packing) {
  std::string bytes;
  if (packing == Packing::components) {
    bytes = bytes_of({2, 2, int(row.size() / 256), int(row.size() % 256)});
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t i = 0; i < row.size();) {
        std::size_t run = 1;
        while (i + run < row.size() && run < 127 && row[i + run][c] == row[i][c]) ++run;
        bytes += run > 1 ? char(128 + run) : char(1);
        bytes += char(row[i][c]);
        i += run;
      }
    }
    return bytes;
  }
  for (std::size_t i = 0; i < row.size();) {
    std::size_t run = 0;
    while (packing == Packing::old_runs && i > 0 && i + run < row.size() && row[i + run] == row[i - 1]) ++run;
    if (run == 0) {
      bytes += bytes_of(row[i++]);
      continue;
    }
    for (std::size_t rest = run; rest > 0; rest /= 256) bytes += bytes_of({1, 1, 1, int(rest % 256)});
    i += run;
  }
  return bytes;
}

std::vector<std::vector<Rgbe>> sample_rows(int width, int height) {
  std::mt19937 random(2);
  std::vector<std::vector<Rgbe>> rows(static_cast<std::size_t>(height));
  for (auto& row : rows) {
    while (row.size() < std::size_t(width)) {
      // Not 1, 1, 1, which would be a run, and not 2, 2 at a row's begin.
      Rgbe const pixel{int(random() % 250) + 3, int(random() % 256), int(random() % 256), int(random() % 20) + 120};
      std::size_t const count = random() % 3 == 0 ? 1 : random() % 700;
      row.insert(row.end(), std::min(count, std::size_t(width) - row.size()), pixel);
    }
  }
  return rows;
}

std::string hdr(std::vector<std::vector<Rgbe>> const& rows, Packing packing, std::string const& header = "",
                std::string const& resolution = "") {
  std::string bytes = "#?RADIANCE\n# made for a test\nFORMAT=32-bit_rle_rgbe\n" + header + "\n";
  bytes += resolution.empty() ? fmt::format("-Y {} +X {}", rows.size(), rows.at(0).size()) : resolution;
  bytes += "\n";
  for (auto const& row : rows) bytes += pack_row(row, packing);
  return bytes;
}

void check_rows(EnvironmentMap const& map, std::vector<std::vector<Rgbe>> const& rows, double scale = 1) {
  REQUIRE(std::size_t(map.height) == rows.size());
  REQUIRE(std::size_t(map.width) == rows[0].size());
  float const* value = map.radiance.data();
  for (auto const& row : rows) {
    for (Rgbe const& pixel : row) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (*value++ != float(scale * std::ldexp(double(pixel[c]), pixel[3] - 136))) FAIL("value");
      }
    }
  }
}

}  // namespace

TEST_CASE("environments are read from what OpenEXR and PFM pictures hold", "[unit][environment]") {
  for (Image const& image : {sample_image(), sample_image(1, 1), sample_image(64, 1)}) {
    for (char const* const format : {"exr", "pfm"}) {
      INFO(format);
      EnvironmentMap const map = decode(encode(image, format));
      CHECK(map.width == image.width());
      CHECK(map.height == image.height());
      CHECK(map.radiance == image.data());
    }
  }
  // Big endian, and of one channel.
  auto const float_bytes = [](float value, bool is_big) {
    auto bytes = std::bit_cast<std::array<char, 4>>(value);
    if (is_big) std::reverse(bytes.begin(), bytes.end());
    return std::string(bytes.data(), 4);
  };
  std::string const values = float_bytes(1.5f, true) + float_bytes(4, true);
  CHECK(decode("Pf\n1 2\n1.0\n" + values).radiance == std::vector<float>{4, 4, 4, 1.5f, 1.5f, 1.5f});
  CHECK(decode("PF 1 1 -1 " + float_bytes(1, false) + float_bytes(2, false) + float_bytes(3, false)).radiance ==
        std::vector<float>{1, 2, 3});
}

TEST_CASE("an OpenEXR environment may be stored in tiles", "[unit][environment]") {
  TemporaryFolder const folder;
  Image const image = sample_image(9, 5);
  Imf::Header header(9, 5);
  header.setTileDescription(Imf::TileDescription(2, 2, Imf::MIPMAP_LEVELS));
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < 3; ++c) {
    char const* const name = std::array{"R", "G", "B"}[c];
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    auto* const first = const_cast<float*>(image.data().data()) + c;
    frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(first), 12, 12 * 9));
  }
  {
    Imf::TiledOutputFile file((folder / "a.exr").c_str(), header);
    file.setFrameBuffer(frame);
    for (int level = 0; level < file.numLevels(); ++level) {  // the smaller ones are of no matter
      file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
    }
  }
  CHECK(decode(folder.read("a.exr")).radiance == image.data());
}

TEST_CASE("an OpenEXR environment may be of luminance alone, of any type", "[unit][environment]") {
  TemporaryFolder const folder;
  for (Imf::PixelType const type : {Imf::HALF, Imf::FLOAT, Imf::UINT}) {
    for (bool const is_luminance : {true, false}) {
      std::string const path = folder / "a.exr";
      Imf::Header header(2, 1);
      std::uint32_t const whole[] = {3, 5};
      float const real[] = {3, 5};
      std::uint16_t const half_floats[] = {0x4200, 0x4500};
      void const* const data = type == Imf::UINT   ? static_cast<void const*>(whole)
                               : type == Imf::HALF ? static_cast<void const*>(half_floats)
                                                   : static_cast<void const*>(real);
      std::size_t const size = type == Imf::HALF ? 2 : 4;
      Imf::FrameBuffer frame;
      for (char const* const name : {is_luminance ? "Y" : "R", is_luminance ? "Z" : "G", is_luminance ? "A" : "B"}) {
        header.channels().insert(name, Imf::Channel(type));
        frame.insert(name, Imf::Slice(type, static_cast<char*>(const_cast<void*>(data)), size, 2 * size));
      }
      {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(1);
      }
      CHECK(decode(folder.read("a.exr")).radiance == std::vector<float>{3, 3, 3, 5, 5, 5});
    }
  }
}

TEST_CASE("Radiance's pictures are read whichever way they are packed", "[unit][environment]") {
  for (int const width : {1, 7, 8, 300, 2000, 32767, 40000}) {
    auto const rows = sample_rows(width, 3);
    for (Packing const packing : {Packing::none, Packing::old_runs, Packing::components}) {
      if (packing == Packing::components && (width < 8 || width > 32767)) continue;
      INFO(width << ", packing " << int(packing));
      check_rows(decode(hdr(rows, packing)), rows);
    }
  }
  auto const rows = sample_rows(9, 2);
  check_rows(decode(hdr(rows, Packing::none, "EXPOSURE=2\nEXPOSURE= 4.0\nSOFTWARE=a\n")), rows, 0.125);
  std::vector<std::vector<Rgbe>> turned{rows[1], rows[0]};
  for (auto& row : turned) std::reverse(row.begin(), row.end());
  check_rows(decode(hdr(rows, Packing::components, "", "+Y 2 -X 9")), turned);
  // Nothing is 0, whatever the mantissas.
  CHECK(decode(hdr({{{255, 255, 255, 0}}}, Packing::none)).radiance == std::vector<float>{0, 0, 0});
}

TEST_CASE("an environment that is cut short is refused, wherever it is cut", "[unit][environment]") {
  auto const rows = sample_rows(40, 3);
  for (std::string const& bytes : {hdr(rows, Packing::components), hdr(rows, Packing::old_runs),
                                   encode(sample_image(9, 5), "exr"), encode(sample_image(9, 5), "pfm")}) {
    REQUIRE(refusal(bytes) == "it was read");
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      INFO(bytes.substr(0, 2) << ", " << size << " of " << bytes.size() << " bytes");
      std::string const message = refusal(bytes.substr(0, size));
      CHECK(message.starts_with("sky: "));
      if (size > 20) CHECK((contains(message, "cut short") || contains(message, "never finished")));
    }
  }
  CHECK(contains(refusal(hdr(rows, Packing::none).substr(0, 100)), "at byte 100: the file ends here"));
}

TEST_CASE("an environment of no pixels, or of too many, is refused before memory is taken", "[unit][environment]") {
  for (char const* const text :
       {"#?RADIANCE\n\n-Y 0 +X 0\n", "#?RADIANCE\n\n-Y 0 +X 8\n", "PF\n0 0\n-1\n", "PF\n4 0\n-1\n"}) {
    INFO(text);
    CHECK(contains(refusal(text), "so no light"));
  }
  for (char const* const text : {"#?RADIANCE\n\n-Y 100000 +X 100000\n", "PF\n100000 100000\n-1\n"}) {
    INFO(text);
    CHECK(contains(refusal(text), "100000 x 100000 pixels"));
    CHECK(contains(refusal(text), "134217728"));
  }
  // One that lies about its size ends where its bytes do.
  CHECK(contains(refusal("PF\n16384 8192\n-1\n1234"), "cut short"));
  CHECK(contains(refusal("#?RADIANCE\n\n-Y 8192 +X 16384\n1234"), "cut short"));
  std::string exr = encode(sample_image(9, 5), "exr");
  std::size_t const window = exr.find("dataWindow");
  REQUIRE(window != std::string::npos);
  std::int32_t const last = 99999;
  for (std::size_t const at : {exr.find("dataWindow") + 11 + 6 + 4 + 8, exr.find("displayWindow") + 14 + 6 + 4 + 8}) {
    std::memcpy(&exr[at], &last, 4);
    std::memcpy(&exr[at + 4], &last, 4);
  }
  std::string const message = refusal(exr);
  CHECK((contains(message, "100000 x 100000 pixels") || contains(message, "OpenEXR cannot read it")));
  CHECK(contains(refusal(encode(sample_image(9, 5), "exr"), 44), "9 x 5 pixels"));
}

TEST_CASE("no memory is taken for what an OpenEXR header claims and its file cannot hold", "[unit][environment]") {
  std::string const whole = encode(sample_image(9, 5), "exr");
  auto const with_attribute = [&](std::string const& type, std::int32_t claimed, std::string const& value) {
    std::string const attribute =
        "owner" + std::string(1, '\0') + type + std::string(1, '\0') + bytes_of(claimed) + value;
    return std::string(whole).insert(8, attribute);
  };
  for (char const* const type : {"string", "stringvector", "floatvector", "of their own"}) {
    INFO(type);
    CHECK(contains(refusal(with_attribute(type, 2147483647, "Anna")), "'owner' claims to have 2147483647 bytes"));
    CHECK(contains(refusal(with_attribute(type, -1, "Anna")), "'owner' claims to have 4294967295 bytes"));
  }
  CHECK(contains(refusal(with_attribute("stringvector", 8, bytes_of(2147483647) + "Anna")), "2147483647 bytes"));

  // A table of where each block of lines begins.
  std::string tall = whole;
  for (char const* const window : {"dataWindow", "displayWindow"}) {
    std::size_t const value = tall.find(window) + std::strlen(window) + 1 + std::strlen("box2i") + 1 + 4;
    tall.replace(value + 12, 4, bytes_of(2147483646));
  }
  CHECK(contains(refusal(tall), "9 x 2147483647 pixels in"));
  std::string const tiles = "tiles" + std::string(1, '\0') + "tiledesc" + std::string(1, '\0') + bytes_of(9) +
                            bytes_of(1) + bytes_of(1) + std::string(1, '\0');
  CHECK(contains(refusal(std::string(tall).insert(8, tiles)), "9 x 2147483647 pixels in 19327352823 blocks"));

  // A block of pixels, before it is decompressed.
  std::string wide = whole;
  for (char const* const window : {"dataWindow", "displayWindow"}) {
    std::size_t const value = wide.find(window) + std::strlen(window) + 1 + std::strlen("box2i") + 1 + 4;
    wide.replace(value + 8, 4, bytes_of(134217727));
  }
  CHECK(contains(refusal(wide), "blocks of pixels of"));
}

TEST_CASE("values that are no light are counted, and the first is named", "[unit][environment]") {
  for (float const wrong : {quiet_nan, std::numeric_limits<float>::infinity(), -0.5f}) {
    for (char const* const format : {"exr", "pfm"}) {
      Image image = sample_image(9, 5);
      image.data()[3 * (2 * 9 + 4) + 1] = wrong;
      image.data().back() = wrong;
      std::string const message = refusal(encode(image, format));
      INFO(message);
      CHECK(contains(message, "2 of its 135 values"));
      CHECK(contains(message, "of green in column 5, row 3"));
    }
  }
  Image black(Resolution{4, 2});
  CHECK(decode(encode(black, "exr")).radiance == std::vector<float>(24));
}

TEST_CASE("a few values that are no light are replaced, and that is told", "[unit][environment]") {
  Image image = sample_image(20, 10);
  image.data()[3 * (2 * 20 + 4) + 1] = -0.5f;
  image.data()[7] = std::numeric_limits<float>::infinity();
  image.data()[9] = -std::numeric_limits<float>::infinity();
  image.data().back() = quiet_nan;
  EnvironmentMap const map = decode(encode(image, "pfm"));
  float largest = 0;
  for (std::size_t i = 0; i < 600; ++i) {
    if (std::isfinite(image.data()[i])) largest = std::max(largest, image.data()[i]);
  }
  for (std::size_t i = 0; i < 600; ++i) {
    float const value = image.data()[i];
    CHECK(map.radiance[i] == (value >= 0 ? std::min(value, largest) : 0));
  }
  CHECK(
      map.repairs ==
      "sky: 4 of its 600 values cannot be light, as they are negative, infinite or no numbers; the first is inf of "
      "green in column 3, row 1 (from 1, the top); 0 stands for them, and the largest of the others for infinite ones");
  CHECK(decode(encode(sample_image(20, 10), "pfm")).repairs.empty());
}

TEST_CASE("what is no environment says what one would be", "[unit][environment]") {
  CHECK(contains(refusal(""), "the file is empty"));
  CHECK(contains(refusal("\x89PNG\r\n"), "it is not a Radiance (.hdr), OpenEXR (.exr) or PFM (.pfm) file"));
  CHECK(contains(refusal("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234"), "32-bit_rle_xyze"));
  CHECK(contains(refusal("#?RADIANCE\n\n+X 1 -Y 1\n1234"), "'+X 1 -Y 1'"));
  CHECK(contains(refusal("#?RADIANCE\n\n-Y 1 +X 1 1\n1234"), "'-Y 1 +X 1 1'"));
  CHECK(contains(refusal("#?RADIANCE\nEXPOSURE=0\n\n-Y 1 +X 1\n1234"), "exposure"));
  CHECK(contains(refusal("#?RADIANCE\n\n-Y 1 +X 9\n" + bytes_of({2, 2, 0, 8})), "another length"));
  CHECK(contains(refusal("#?RADIANCE\n\n-Y 1 +X 9\n" + bytes_of({2, 2, 0, 9}) + char(138) + "a"), "damaged"));
  CHECK(contains(refusal("#?RADIANCE\n\n-Y 1 +X 2\n" + bytes_of({1, 1, 1, 2})), "damaged"));
  CHECK(contains(refusal("PF\nwide 2\n-1\n"), "at byte 3: the header must have the width here"));
  CHECK(contains(refusal("PFM 2 2\n-1\n"), "PF or Pf"));
  Image const image = sample_image(9, 5);
  std::string const depth = image_format_named("exr").encode_film(film_of(image), {});
  std::string renamed = depth;
  std::size_t const at = renamed.find("channels") + 9 + 7 + 4;
  REQUIRE(renamed[at] == 'B');
  renamed[at] = 'C';
  CHECK(contains(refusal(renamed), "R, G and B"));
  TemporaryFolder const folder;
  CHECK_THROWS_AS(read_environment(folder / "none.hdr"), Error);
  CHECK(read_environment(folder.write("a.picture", encode(image, "exr"))).radiance == image.data());
}
