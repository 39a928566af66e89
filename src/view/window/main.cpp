#include "app/lack_of_memory.hpp"
#include "app/program.hpp"
#include "app/view_options.hpp"
#include "view/window/window.hpp"

int main(int argc, char* argv[]) {
  using namespace lichtraum;
  app::handle_lack_of_memory();
  app::Arguments const arguments(argv + 1, argv + argc);
  app::Arguments command_line{"lichtraum", "view"};
  command_line.insert(command_line.end(), arguments.begin(), arguments.end());
  return app::run_program(command_line, [&](app::Console& console) {
    app::ViewOptions options;
    if (!app::parse_view(arguments, options, console)) return 0;
    app::SceneSource const source(options.scene);
    view::Window(source, options, console).run();
    return 0;
  });
}
