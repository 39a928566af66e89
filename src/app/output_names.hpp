#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/scene_source.hpp"
#include "lichtraum/image_io.hpp"
#include "lichtraum/scene.hpp"

namespace lichtraum::app {

/// What the command line says about where pictures go.
struct OutputOptions {
  std::string file;                     ///< -o: a name, a pattern with %d, "-" for standard output; empty: the scene's
  ImageFormat const* format = nullptr;  ///< --format
  std::filesystem::path folder = ".";   ///< --output-dir
  std::vector<std::filesystem::path> allowed_paths;  ///< folders that a scene may write besides `folder`
};

/// Where one picture goes.
struct Output {
  std::filesystem::path path;  ///< empty: standard output
  ImageFormat const* format = nullptr;
  std::string shown;     ///< for messages
  std::string note;      ///< what was decided that the user did not ask for; may be empty
  bool is_film = false;  ///< one of the pictures of the film `path`

  bool is_standard_output() const { return path.empty(); }
  /// Where an unfinished picture goes: picture.partial.png.
  std::filesystem::path partial_path() const;
};

/// Names pictures, one after the other.
class OutputNames {
 public:
  /// Throws Error{usage} for a faulty pattern, and when the file's extension contradicts the format.
  explicit OutputNames(OutputOptions options);

  /// Whether pictures would overwrite each other when there is more than one.
  bool has_one_name() const;
  /// Whether all pictures go into one film.
  bool is_film() const { return is_film_; }
  /// All scenes of the command line: those whose files share a name get others (longer_stems).
  void set_inputs(std::vector<std::string> const& inputs);
  /// What a picture of that scene is called, without extension, when nothing else says.
  std::string stem_of(SceneSource const& source) const;
  /// The number that the next picture gets; 1 unless this is called.
  void start_at(int number) { number_ = scene_end_ = number - 1; }
  /// What follows is a scene of so many pictures. They have their numbers whether they are named or not, so that no
  /// fault in them renumbers the next scene's. Throws Error{usage} for more than job_limits::pictures in all.
  void begin_scene(std::size_t picture_count);

  /// For the next picture; `command`: what the scene says about it. `is_one_of_many`: the scene's name is for more than
  /// this picture, which gets its number in addition (hello_0001.png). Throws SceneError for a name that leads out of
  /// the output folder.
  Output next(RenderCommand const& command, bool is_one_of_many = false);

 private:
  std::filesystem::path path_of(std::string const& number) const;
  Output from_command_line();
  Output from_scene(std::string const& name, SourceLocation const& location) const;

  OutputOptions options_;
  std::map<std::string, std::string> longer_stems_;
  std::string before_number_;
  std::string after_number_;
  std::string number_format_;  // of fmt, empty without a pattern
  int number_ = 0;             // of the last picture named
  int scene_end_ = 0;          // of the scene's last picture
  int picture_count_ = 0;      // of all scenes so far
  bool is_film_ = false;
};

}  // namespace lichtraum::app
