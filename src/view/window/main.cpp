#include "app/program.hpp"
#include "app/view_options.hpp"
#include "view/window/window.hpp"

int main(int argc, char* argv[]) {
  using namespace lichtraum;
  return app::run_program([&](app::Console& console) {
    app::ViewOptions options;
    if (!app::parse_view(app::Arguments(argv + 1, argv + argc), options, console)) return 0;
    app::SceneSource const source(options.scene);
    view::Window(source, options, console).run();
    return 0;
  });
}
