#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lichtraum/device.hpp"
#include "lichtraum/file_stamp.hpp"
#include "lichtraum/job.hpp"

/// Pictures that many machines draw together, by way of files in a folder that all of them see.

namespace lichtraum::farm {

/// What a device computes, not what it is called: devices of one class draw the same bytes.
struct DeviceClass {
  std::string hash;
  DeviceKind kind = DeviceKind::cpu;
  std::string name;  ///< of the device, for messages
  friend bool operator==(DeviceClass const&, DeviceClass const&) = default;
};

/// A file that the scenes are made of.
struct ReadFile {
  std::string path;
  std::string hash;  ///< of its bytes; empty: there was none
  friend bool operator==(ReadFile const&, ReadFile const&) = default;
};

struct PlannedScene {
  std::string file;
  int picture_count = 1;
  friend bool operator==(PlannedScene const&, PlannedScene const&) = default;
};

/// Both included.
struct Frames {
  int first = 0;
  int last = 0;
  friend bool operator==(Frames const&, Frames const&) = default;
};

/// A unit's part of the work: samples of a region of a picture.
struct Unit {
  std::int64_t number = 0;
  int picture = 0;  ///< of all that the scenes have
  Region region;
  SampleRange samples;
  friend bool operator==(Unit const&, Unit const&) = default;
};

/// What is to be drawn, and how it is cut into units. All pictures have one size, and as many samples. The units are
/// told by a formula, so that a plan is as large for ten as for a million: picture by picture, region by region from
/// the left to the right and down, block of samples by block of samples.
struct Plan {
  std::string version;  ///< of lichtraum
  DeviceClass device;
  std::string traversal;  ///< as --traversal has it; empty: the device's default
  Job job;                ///< what the pictures have in common; its scene is the first one
  std::vector<PlannedScene> scenes;
  std::optional<Frames> frames;
  std::optional<double> frames_per_second;
  int turntable = 0;

  Region region;          ///< of each picture
  PlaneSet planes;        ///< that are stored
  int sample_count = 1;   ///< of each pixel
  Resolution tile;        ///< of a unit's region, but for those at the right and lower edges
  int unit_samples = 16;  ///< of a unit; a multiple of Film::block_size, but where one unit has all samples
  std::vector<ReadFile> files;
  friend bool operator==(Plan const&, Plan const&) = default;

  int picture_count() const;
  int columns() const { return (region.width - 1) / tile.width + 1; }
  int rows() const { return (region.height - 1) / tile.height + 1; }
  int sample_blocks() const { return (sample_count - 1) / unit_samples + 1; }
  std::int64_t units_of_picture() const { return std::int64_t(columns()) * rows() * sample_blocks(); }
  std::int64_t unit_count() const { return units_of_picture() * picture_count(); }
  /// 0 <= number < unit_count().
  Unit unit(std::int64_t number) const;
};

/// Plans of more are refused: their parts would be too small, and no folder takes as many files.
inline constexpr std::int64_t most_units = 100'000'000;

std::string to_json(Plan const& plan);
/// Throws Error{usage} as job_from_json does. May be given text that nobody trusts.
Plan plan_from_json(std::string_view text);

/// The folder of a plan. All may be called on many machines at once.
class PlanFolder {
 public:
  /// Reads the plan. Throws Error{no_input} when there is none, Error{scene} for one that cannot be read.
  explicit PlanFolder(std::filesystem::path folder);
  /// Makes the folder, with the plan. Throws Error{cannot_create} when it has another plan already.
  PlanFolder(std::filesystem::path folder, Plan plan);

  std::filesystem::path const& path() const { return folder_; }
  bool is_there() const;  ///< with a plan, now
  Plan const& plan() const { return plan_; }
  /// Of the plan's bytes; the units know it.
  std::string const& hash() const { return hash_; }
  /// Where the finished unit is; its folder may be missing yet.
  std::filesystem::path unit_file(std::int64_t number) const;
  std::filesystem::path units_folder() const { return folder_ / ("units-" + hash_); }

 private:
  std::filesystem::path folder_;
  Plan plan_;
  std::string hash_;
};

/// Of a file's bytes; empty when there is none. Throws Error when it cannot be read.
std::string hash_of_file(std::filesystem::path const& path);

/// The files that were read for a plan, which must outlive it.
class PlannedFiles {
 public:
  explicit PlannedFiles(Plan const& plan) : plan_(plan) {}
  /// Throws Error{scene} that names the first that is not as it was, Error{try_again} for one that cannot be read.
  /// Reads those that were written since the last call: asked again after they have been used, it says whether what was
  /// used was right.
  void check();

 private:
  Plan const& plan_;
  std::vector<std::optional<FileStamp>> checked_;
};

}  // namespace lichtraum::farm
