#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "app/console.hpp"
#include "app/picture_plan.hpp"
#include "lichtraum/seen_point.hpp"
#include "view/file_watch.hpp"
#include "view/object_tree.hpp"
#include "view/overlays.hpp"
#include "view/refinement.hpp"
#include "view/scene_values.hpp"

namespace lichtraum::view {

/// A picture for the window.
struct Frame {
  Image image;
  std::vector<unsigned char> pixels;  ///< the image's, see display_pixels, with the overlays on them
  OverlayLayer overlays;
  Refinement::Pass pass;
  unsigned view_number = 0;  ///< of the view, see Worker::show
  RenderStatistics statistics;
  SceneStatistics scene;
};

/// What the window has to know of a scene.
struct SceneView {
  std::string file;
  RenderRequest request;  ///< through the camera that comes first
  std::vector<Camera> cameras;
  bool has_own_cameras = true;  ///< as Scene::has_own_cameras
  Bounds bounds;                ///< of what is of interest; empty when nothing is drawn
  Vec3 up{0, 1, 0};             ///< of any length but 0
  std::shared_ptr<DrawnObjects const> objects;
  SceneValues values;
  Development development;                         ///< as the scene has its picture
  std::shared_ptr<app::LoadedScene const> loaded;  ///< keeps what both of them point to
  std::shared_ptr<ModelCache> models;              ///< what the scene includes: to read it again soon
  std::optional<double> time_seconds;              ///< of a model's pose; nothing: as its nodes stand
  unsigned number = 0;                             ///< one more each time it is read
};

/// The outline of the selected objects in a picture.
struct Marking {
  Resolution size;
  std::vector<unsigned char> pixels;  ///< see outline_pixels
};

/// What another time of an animation changes besides the picture.
struct PosedView {
  unsigned scene_number = 0;
  double time_seconds = 0;
  RenderRequest request;  ///< through the camera that comes first
  std::vector<Camera> cameras;
  Bounds bounds;  ///< as SceneView::bounds
};

/// What edits change of how a scene is drawn, where they do.
struct EditedView {
  unsigned scene_number = 0;
  RenderRequest request;  ///< as SceneView::request
};

/// What was found under a pixel.
struct Look {
  unsigned scene_number = 0;
  std::optional<SeenPoint> seen;
};

/// Traces views in a thread of its own, the newest first, and reads the scene again when its file is saved.
class Worker {
 public:
  /// `options` and `console` must outlive it. `console`: for what is said about the device and the scene. `wake`:
  /// called from the thread whenever there is news.
  Worker(app::SceneSource const& source, app::RenderOptions const& options, bool is_watching,
         app::Console const& console, std::function<void()> wake);
  ~Worker();
  Worker(Worker const&) = delete;
  Worker& operator=(Worker const&) = delete;

  /// Reads another file from now on. What was seen stays until it is there, and where it cannot be read.
  void open(std::filesystem::path const& file);
  /// Poses scene `number`, whose `loaded` can be posed, as its animation has it at that time; the last time that was
  /// asked for is the one that counts.
  void pose(unsigned number, double time_seconds);
  /// Reads scene `number`, a model, again with another of its animations.
  void choose_animation(unsigned number, std::size_t animation);
  /// What is looked at from now on. Whatever is traced for an older view is given up. Returns its number, as do edit
  /// and overlay, with which it is another.
  unsigned show(RenderRequest const& view);

  /// From now on scene `number` has other lights and materials; nothing happens when it was read again meanwhile.
  unsigned edit(unsigned number, SceneEdits edits);
  /// From now on its pictures are developed in this way, also the one that is shown.
  void develop(unsigned number, Development const& development);
  /// From now on these are drawn over the pictures.
  unsigned overlay(Overlays const& overlays);
  /// Finds out what is under a pixel of the view.
  void look_at(int x, int y);
  /// Outlines these objects in each view that stays; none when there are none.
  void mark(ObjectTree::Objects const& objects);

  struct News {
    std::optional<Frame> frame;
    std::optional<Look> look;
    std::optional<Marking> marking;
    std::optional<SceneView> scene;      ///< it was read, for the first time or again
    std::optional<PosedView> posed;      ///< it was posed
    std::optional<EditedView> edited;    ///< it is drawn by another integrator since it was edited
    std::optional<std::string> problem;  ///< why it could not be read, posed or edited; empty: it was read
    std::string device;
  };
  /// What has come since the last call. Throws what made the thread end: an Error of the device, or of the first load,
  /// unless that is a mistake in a file that is watched.
  News news();

 private:
  /// What the window wants of a scene, which may be read again before the thread comes to it.
  template <class Wish>
  struct OfScene {
    unsigned scene_number;
    Wish wish;
  };
  template <class Wish>
  using Asked = std::optional<OfScene<Wish>>;
  /// What is asked of the scene that is shown, which then is no longer; of one before, nothing.
  template <class Wish>
  std::optional<Wish> take(Asked<Wish>& asked) {
    std::lock_guard const lock(mutex_);
    auto taken = std::exchange(asked, std::nullopt);
    if (!taken || taken->scene_number != scene_number_) return std::nullopt;
    return std::move(taken->wish);
  }

  void work(std::stop_token const& stop);
  /// What is read to show a scene.
  struct Reading {
    app::SceneSource source;
    Job job;
  };
  /// Another file, or another animation of the same, where one was asked for.
  std::optional<Reading> asked_reading();
  void load(Renderer& renderer, Reading reading);
  void apply_pose(Renderer& renderer);
  void apply_edits(Renderer& renderer);
  /// As when the edited scene is read from a file: what only paths show may have come, or gone.
  void choose_integrator_again();
  void develop_again(Renderer& renderer);
  void look_at_pixel(Renderer& renderer);
  void trace_marking(Renderer& renderer, std::stop_token const& stop);
  /// Whether one was saved; not more often than makes sense.
  void look_at_files();
  /// What the window shows of shown_.
  Image developed(Renderer& renderer) const;
  void send(Frame frame);
  /// Whether there was something to trace.
  bool trace_next(Renderer& renderer, std::stop_token const& stop);
  /// Gives freed memory back once for each size of the view: with the second picture, when the window has let go of
  /// those of other sizes.
  void tidy_memory(Resolution const& size);
  /// Why something was not done; what was shown before stays.
  void tell_of(std::exception const& problem);
  void restart_refinement();
  /// For another view, whose number it returns.
  unsigned begin_view();
  /// What is outlined has changed, or where it is seen.
  void expect_marking();

  app::RenderOptions const& options_;
  bool is_watching_;
  app::Console const& console_;
  std::function<void()> wake_;
  std::string first_file_;  // whose things options_ may name

  // Of the thread alone.
  Reading reading_;  // of the scene that is shown; before there is one, the last that was tried
  FileWatch files_;  // that it read
  app::LoadOptions load_options_;
  SceneStatistics scene_statistics_;
  std::shared_ptr<app::LoadedScene> loaded_;
  Job loaded_job_;                                 // that of loaded_, with its integrator
  std::shared_ptr<PreparedScene const> prepared_;  // as it was read, or posed
  SceneEdits edits_in_place_;                      // of it
  bool has_edits_ = false;
  unsigned scene_number_ = 0;
  std::string shown_file_;
  bool is_fine_ = false;  // the picture that is shown has a ray for each pixel
  Development development_;
  Denoising denoising_ = Denoising::off;
  Film film_;   // of the last pass; empty when that was given up
  Film shown_;  // the last that was whole, without noise
  FilmPlane shown_plane_ = FilmPlane::radiance;
  Bounds bounds_;            // of the scene
  Frame frame_;              // what is known of shown_, but for the picture
  Resolution tidied_size_;   // of the view when freed memory was last given back
  bool is_growing_ = false;  // its samples are the first of the next pass
  std::chrono::steady_clock::time_point files_looked_at_;
  bool files_have_changed_ = false;
  bool has_tried_ = false;  // to read the scene

  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::optional<std::filesystem::path> new_file_;  // to be read
  std::optional<RenderRequest> view_;
  Overlays overlays_;
  bool is_new_view_ = false;
  unsigned view_number_ = 0;
  bool has_question_ = false;                // what is being traced waits for the answer
  std::optional<double> seconds_per_pixel_;  // of the last passes with one sample a pixel
  Refinement refinement_;
  Asked<SceneEdits> edits_;
  Asked<double> pose_;  // at that time, in seconds
  Asked<std::size_t> new_animation_;
  Asked<Development> new_development_;
  struct Pixel {
    int x, y;
  };
  std::optional<Pixel> looked_at_;  // to be looked at
  ObjectTree::Objects marked_;
  bool is_marking_due_ = false;
  News news_;
  std::exception_ptr failure_;

  std::jthread thread_;
};

}  // namespace lichtraum::view
