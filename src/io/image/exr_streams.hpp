#pragma once

#include <OpenEXR/ImfIO.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

/// OpenEXR files in memory.

namespace lichtraum {

inline constexpr char const* exr_fingerprint_key = "lichtraumFingerprint";

/// OpenEXR goes back to fill in its table of line offsets.
class StringOutput final : public Imf::OStream {
 public:
  StringOutput() : OStream("picture.exr") {}

  void write(char const data[], int size) override {
    auto const end = position_ + std::size_t(size);
    if (end > bytes_.size()) bytes_.resize(end);
    std::memcpy(bytes_.data() + position_, data, std::size_t(size));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

/// `bytes` must outlive it.
class StringInput final : public Imf::IStream {
 public:
  StringInput(std::string_view bytes, std::string const& name) : IStream(name.c_str()), bytes_(bytes) {}

  bool read(char data[], int size) override {
    if (size < 0 || position_ > bytes_.size() || std::size_t(size) > bytes_.size() - position_) {
      throw std::runtime_error("the file ends early");
    }
    std::memcpy(data, bytes_.data() + position_, std::size_t(size));
    position_ += std::size_t(size);
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
};

}  // namespace lichtraum
