#include <turbojpeg.h>

#include <memory>
#include <vector>

#include "io/image/encoders.hpp"
#include "io/image/quantize.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {

std::string encode_jpeg(Image const& image, ImageEncoding const& encoding) {
  check_encodable(image, encoding, "jpg");
  std::vector<unsigned char> pixels(image.data().size());
  quantize_8(image.data().data(), pixels.size(), pixels.data());

  std::unique_ptr<void, int (*)(tjhandle)> const compressor(tjInitCompress(), tjDestroy);
  unsigned char* raw = nullptr;
  unsigned long size = 0;
  // Rendered edges are sharp and coloured: halving the chroma resolution shows.
  int const status = !compressor
                         ? -1
                         : tjCompress2(compressor.get(), pixels.data(), image.width(), 0, image.height(), TJPF_RGB,
                                       &raw, &size, TJSAMP_444, encoding.jpeg_quality, TJFLAG_ACCURATEDCT);
  std::unique_ptr<unsigned char, void (*)(unsigned char*)> const bytes(raw, tjFree);
  if (status != 0) {
    throw Error(ErrorKind::internal, std::string("libjpeg-turbo: ") + tjGetErrorStr2(compressor.get()));
  }
  return {reinterpret_cast<char const*>(raw), size};
}

}  // namespace lichtraum
