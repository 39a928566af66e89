#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/interruption.hpp"
#include "app/picture_plan.hpp"
#include "app/picture_writer.hpp"

namespace lichtraum::app {

/// The region of a picture, cut into bands that are drawn and written one after the other where that spares memory:
/// one band, where it is small, or where something needs the whole picture. `is_denoised`: noise will be taken out.
std::vector<Region> bands_of(PicturePlan const& plan, bool is_denoised);

/// The file of a picture that is drawn in bands.
class BandWriter {
 public:
  /// `planes`: that were traced. Throws as NewFile does.
  BandWriter(PicturePlan const& plan, PlaneSet const& planes);

  /// From the top.
  void add(Drawn const& band);
  /// After the last one.
  void finish();

 private:
  std::optional<UnfinishedFile> removed_on_signal_;
  NewFile file_;
  std::variant<std::unique_ptr<RowEncoder<Film>>, std::unique_ptr<RowEncoder<Image>>> encoder_;
};

}  // namespace lichtraum::app
