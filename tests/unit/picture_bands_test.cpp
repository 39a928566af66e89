#include "app/picture_bands.hpp"

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
using namespace lichtraum::app;

TEST_CASE("a signal that ends the process removes the file of bands that are not written yet", "[unit]") {
  TemporaryFolder const folder;
  PicturePlan plan;
  plan.output.path = folder / "picture.png";
  plan.output.format = &image_format_named("png");
  plan.job.region = Region{0, 0, 4, 2};
  remove_unfinished_file();  // of which there is none
  {
    BandWriter writer(plan, {FilmPlane::radiance});
    writer.add(Image({4, 1}));
    CHECK(folder.names().size() == 1);
    remove_unfinished_file();
    CHECK(folder.names().empty());
  }
  BandWriter writer(plan, {FilmPlane::radiance});
  writer.add(Image({4, 2}));
  writer.finish();
  remove_unfinished_file();
  CHECK(folder.names() == std::vector<std::string>{"picture.png"});
}
