#include <fmt/format.h>

#include <bit>

#include "io/image/encoders.hpp"

namespace lichtraum {

static_assert(std::endian::native == std::endian::little, "PFM is written as the floats lie in memory");

namespace {

/// The first row of the file is the lowest, so it grows towards its beginning.
class PfmRows final : public RowEncoder<Film> {
 public:
  PfmRows(Resolution const& size, PlaneSet const& planes, ByteSink& sink)
      : sink_(sink), plane_(planes.list().at(0)), rows_left_(size.height) {
    std::size_t const channels = info_of(plane_).channels.size();
    // A negative scale says little endian.
    std::string const header = fmt::format("{}\n{} {}\n-1.0\n", channels == 3 ? "PF" : "Pf", size.width, size.height);
    header_bytes_ = header.size();
    row_bytes_ = sizeof(float) * channels * std::size_t(size.width);
    sink_.write(header);
  }

  void add(Film const& rows) override {
    bool const is_number = info_of(plane_).is_number;
    auto const numbers = is_number ? rows.numbers(plane_) : std::span<std::uint32_t const>();
    std::vector<float> const values =
        is_number ? std::vector<float>(numbers.begin(), numbers.end()) : rows.values(plane_);
    std::string upside_down;
    upside_down.reserve(sizeof(float) * values.size());
    std::string_view const bytes(reinterpret_cast<char const*>(values.data()), sizeof(float) * values.size());
    for (int y = rows.size().height; y-- > 0;) upside_down += bytes.substr(row_bytes_ * std::size_t(y), row_bytes_);
    rows_left_ -= rows.size().height;
    sink_.seek(header_bytes_ + row_bytes_ * std::uint64_t(rows_left_));
    sink_.write(upside_down);
  }
  void finish() override {}

 private:
  ByteSink& sink_;
  FilmPlane plane_;
  int rows_left_;
  std::size_t header_bytes_ = 0;
  std::size_t row_bytes_ = 0;
};

}  // namespace

std::unique_ptr<RowEncoder<Film>> begin_pfm(Resolution const& size, PlaneSet const& planes,
                                            ImageEncoding const& /*encoding*/, ByteSink& sink) {
  return std::make_unique<PfmRows>(size, planes, sink);
}

std::string encode_pfm(Film const& film, ImageEncoding const&) {
  check_encodable(film, "pfm");
  MemorySink sink;
  PfmRows(film.size(), film.planes(), sink).add(film);
  return sink.take();
}

}  // namespace lichtraum
