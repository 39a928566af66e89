#include "lichtraum/exr_layers.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <half.h>

#include <random>

#include "io/image/exr_streams.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/film.hpp"
#include "lichtraum/image_io.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

/// A file of another program: 3x2 pixels in a window elsewhere, halves, floats and numbers.
std::string foreign_file() {
  Imf::Header header(Imath::Box2i({0, 0}, {9, 9}), Imath::Box2i({4, -1}, {6, 0}));
  header.compression() = Imf::PIZ_COMPRESSION;
  header.insert("owner", Imf::StringAttribute("somebody"));
  header.insert("views", Imf::StringVectorAttribute({"left", "", "right"}));
  header.insert("lichtraumFingerprint", Imf::StringAttribute("abc"));
  std::vector<half> halves(6);
  std::vector<float> floats(6);
  std::vector<unsigned> numbers(6);
  for (std::size_t i = 0; i < 6; ++i) {
    halves[i] = half(0.5f * float(i));
    floats[i] = 0.1f * float(i);
    numbers[i] = 4000000000u + unsigned(i);
  }
  Imf::FrameBuffer frame;
  auto const add = [&](char const* name, Imf::PixelType type, void* values, std::size_t bytes) {
    header.channels().insert(name, Imf::Channel(type));
    frame.insert(name, Imf::Slice::Make(type, values, header.dataWindow(), bytes, 3 * bytes));
  };
  add("R", Imf::HALF, halves.data(), 2);
  add("G", Imf::FLOAT, floats.data(), 4);
  add("B", Imf::HALF, halves.data(), 2);
  add("crypto.id", Imf::UINT, numbers.data(), 4);
  StringOutput output;
  {
    Imf::OutputFile file(output, header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(2);
  }
  return output.take();
}

std::string why_refused(std::string const& bytes) {
  try {
    ExrLayers(bytes, "a.exr");
  } catch (Error const& error) {
    CHECK(error.kind() == ErrorKind::scene);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("OpenEXR files of others keep all that is not replaced", "[unit][image]") {
  ExrLayers layers(foreign_file(), "a.exr");
  CHECK(layers.size() == Resolution{3, 2});
  CHECK(layers.channels() == std::vector<std::string>{"B", "G", "R", "crypto.id"});
  CHECK(layers.has({"R", "G", "B"}));
  CHECK_FALSE(layers.has({"R", "A"}));
  auto const before = layers.values({"R", "G"});
  CHECK(before[10] == 2.5f);
  CHECK(before[11] == 0.5f);

  layers.set_values({"R", "G", "B"}, std::vector<float>(18, 1.0f / 3));
  std::string const encoded = layers.encode();
  ExrLayers const again(encoded, "b.exr");
  CHECK(again.values({"B", "R"}) == std::vector<float>(12, 1.0f / 3));
  CHECK(again.values({"crypto.id"}) == layers.values({"crypto.id"}));
  CHECK(again.values({"crypto.id"})[5] == 4000000005.0f);
  CHECK_THAT(encoded, contains_text("somebody"));
  CHECK_THAT(encoded, !contains_text("Fingerprint"));
  CHECK(again.encode() == encoded);
}

TEST_CASE("OpenEXR files whose layers are no picture's are refused", "[unit][image]") {
  std::string const whole = foreign_file();
  CHECK_THAT(why_refused("\x89PNG\r\n"), contains_text("'a.exr' is a PNG picture, not an OpenEXR file"));
  CHECK_THAT(why_refused("P6 1 1 255 abc"), contains_text("'a.exr' cannot be read as an OpenEXR file"));
  for (std::size_t size = 0; size < whole.size(); size += 7) CHECK_FALSE(why_refused(whole.substr(0, size)).empty());

  Imf::Header half_size(8, 8);
  half_size.channels().insert("Y", Imf::Channel(Imf::FLOAT));
  half_size.channels().insert("RY", Imf::Channel(Imf::FLOAT, 2, 2));
  StringOutput output;
  {
    std::vector<float> values(64);
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, values.data(), half_size.dataWindow(), 4, 32));
    frame.insert("RY", Imf::Slice::Make(Imf::FLOAT, values.data(), half_size.dataWindow(), 4, 16, 2, 2));
    Imf::OutputFile file(output, half_size, 0);
    file.setFrameBuffer(frame);
    file.writePixels(8);
  }
  CHECK(why_refused(output.take()) ==
        "'a.exr': the channel 'RY' is of another size than the picture: it has a value for each 2x2 pixels");

  std::vector<Imf::Header> headers(2, Imf::Header(4, 4));
  StringOutput parts;
  {
    for (Imf::Header& header : headers) {
      header.setName(&header == &headers[0] ? "left" : "right");
      header.setType(Imf::SCANLINEIMAGE);
      header.channels().insert("R", Imf::Channel(Imf::FLOAT));
    }
    std::vector<float> values(16);
    Imf::FrameBuffer frame;
    frame.insert("R", Imf::Slice::Make(Imf::FLOAT, values.data(), headers[0].dataWindow(), 4, 16));
    Imf::MultiPartOutputFile file(parts, headers.data(), 2, false, 0);
    for (int i = 0; i < 2; ++i) {
      Imf::OutputPart part(file, i);
      part.setFrameBuffer(frame);
      part.writePixels(4);
    }
  }
  CHECK(why_refused(parts.take()) == "'a.exr' has 2 parts: layers are read from a file of one");
}

TEST_CASE("sizes that nobody has memory for are refused, whatever the file's own", "[unit][image]") {
  std::string bytes = foreign_file();
  std::string const key = std::string("dataWindow\0box2i\0", 17);
  auto const at = bytes.find(key) + key.size() + 4;
  std::int32_t const far = 2000000000;
  for (std::size_t const corner : {8u, 12u}) std::memcpy(&bytes[at + corner], &far, sizeof(far));
  CHECK_THAT(why_refused(bytes), contains_text("memory") || contains_text("cannot be read"));
}

TEST_CASE("damaged OpenEXR files give an error or a picture", "[unit][image]") {
  std::string const whole = foreign_file();
  std::mt19937 generator(5);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string bytes = whole;
    for (int k = 0; k < 3; ++k) bytes[generator() % bytes.size()] = char(generator());
    refused += !why_refused(bytes).empty();
  }
  CHECK(refused > 500);
  CHECK(refused < 2000);
}

TEST_CASE("layers take as many numbers as they have, of channels that are there", "[exr]") {
  Film const film({0, 0, 4, 3}, PlaneSet{FilmPlane::radiance}, 0);
  ExrLayers layers(image_format_named("exr").encode_film(film, {}), "layers.exr");
  CHECK_THROWS_AS(layers.set_values({"R", "G"}, std::vector<float>(23)), std::invalid_argument);
  CHECK_THROWS_AS(layers.values({"Q"}), std::invalid_argument);
}
