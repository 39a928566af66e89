#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/console.hpp"

namespace lichtraum::app {

using Arguments = std::vector<std::string>;

/// One subcommand. `run` takes what follows the subcommand's name and returns the process's exit code; it throws Error.
struct Command {
  std::string_view name;
  std::string_view arguments;
  std::string_view summary;
  int (*run)(Arguments const& arguments, Console& console);
};

int render_command(Arguments const& arguments, Console& console);
int view_command(Arguments const& arguments, Console& console);
int preview_command(Arguments const& arguments, Console& console);
int thumbnail_command(Arguments const& arguments, Console& console);
int job_command(Arguments const& arguments, Console& console);
int denoise_command(Arguments const& arguments, Console& console);
int check_command(Arguments const& arguments, Console& console);
int info_command(Arguments const& arguments, Console& console);
int explain_command(Arguments const& arguments, Console& console);
int devices_command(Arguments const& arguments, Console& console);
int doctor_command(Arguments const& arguments, Console& console);

inline constexpr Command commands[] = {
    {"render", "SCENE...", "draw scenes to pictures", render_command},
    {"view", "SCENE", "open a window on a scene", view_command},
    {"preview", "SCENE", "show a scene in the terminal", preview_command},
    {"thumbnail", "INPUT OUTPUT.png", "draw a small picture for file managers", thumbnail_command},
    {"job", "COMMAND", "draw pictures on many machines", job_command},
    {"denoise", "FILE", "take the noise out of a stored film", denoise_command},
    {"check", "SCENE...", "report what is wrong in scenes, draw nothing", check_command},
    {"info", "FILE", "describe what is in a scene", info_command},
    {"explain", "[CODE...]", "say what a code such as E0412 means", explain_command},
    {"devices", "", "list the devices that can draw", devices_command},
    {"doctor", "", "test every device, say what is missing", doctor_command},
};

}  // namespace lichtraum::app
