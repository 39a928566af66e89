#include <iterator>
#include <regex>
#include <set>

#include "lichtraum.hpp"
#include "support/catch.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

namespace {

char const* const commands[] = {"render", "view", "preview", "thumbnail", "job",   "denoise",
                                "check",  "info", "explain", "devices",   "doctor"};
char const* const job_commands[] = {"plan", "work", "status", "merge", "script"};

std::vector<std::string> matches(std::string const& text, std::string const& pattern) {
  std::regex const expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) found.push_back((*it)[1]);
  return found;
}

/// The long options that a help text lists.
std::set<std::string> options_of(std::string const& help) {
  auto const found = matches(help, "\n  (?:-[a-zA-Z],)?(--[a-z-]+)");
  return {found.begin(), found.end()};
}

}  // namespace

TEST_CASE("every command has a help text that fits a terminal", "[app][help]") {
  Lichtraum const lichtraum;
  std::vector<std::string> ways = {"--help", "-h", "help", "help render", "info -h"};
  for (std::string const command : commands) ways.push_back(command + " --help");
  for (std::string const command : job_commands) ways.push_back("job " + command + " --help");
  for (std::string const& words : ways) {
    auto const result = lichtraum(words);
    INFO(words);
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK_THAT(result.out, contains_text("Usage: lichtraum") && contains_text("Examples:"));
    for (std::string const& line : matches(result.out, "([^\n]*)\n")) CHECK(line.size() <= 80);
  }
  CHECK_THAT(lichtraum("render --help").out, contains_text("\nQuality:\n"));
  CHECK(lichtraum("--version").out.substr(0, 10) == "lichtraum ");
}

TEST_CASE("the examples in the help texts are good commands", "[app][help]") {
  Lichtraum const lichtraum;
  std::string const folder = std::filesystem::path(LICHTRAUM_PROGRAM).parent_path();
  // A faulty scene shows that the command line was understood, without drawing for long.
  for (char const* const name : {"hello.sdf", "film.sdf", "old.sdf", "a.sdf", "b.sdf", "model.glb"}) {
    lichtraum.folder.write(name, "define nonsense\n");
  }
  std::filesystem::create_directory(lichtraum.folder / "frames");
  lichtraum.folder.write("frames/1.sdf", "define nonsense\n");
  std::size_t count = 0;
  for (std::string const command :
       {"", "render", "view", "preview", "thumbnail", "denoise", "check", "info", "explain", "devices", "doctor", "job",
        "job plan", "job work", "job status", "job merge", "job script"}) {
    std::string const help = lichtraum(command + " --help").out;
    std::string const examples = help.substr(help.find("Examples:"));
    for (std::string const& example : matches(examples, "\n  (lichtraum [^\n]*?)(?=  |\n)")) {
      INFO(example);
      Process shell = lichtraum.process("");
      shell.arguments = {"sh", "-c", example};
      shell.environment = {{"PATH", folder + ":" + std::getenv("PATH")}, {"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
      int const code = run_process(shell).exit_code;
      bool const opens_a_window = command == "view";  // which is refused without a display
      bool const reads_a_scene =
          !opens_a_window && (example.find(".sdf") != std::string::npos || example.find(".glb") != std::string::npos);
      bool const lacks_its_file =
          command == "denoise" || (command.starts_with("job") && example.find("job plan") == std::string::npos);
      CHECK((lacks_its_file   ? code == 66
             : reads_a_scene  ? code == 65
             : opens_a_window ? code == 69
                              : code == 0 || code == 69));
      ++count;
    }
  }
  CHECK(count >= 15);
}

TEST_CASE("the man page and the completions know every command and option", "[app][help]") {
  Lichtraum const lichtraum;
  std::string const man = read_project_file("docs/lichtraum.1");
  std::string const bash = read_project_file("completions/lichtraum.bash");
  std::string const zsh = read_project_file("completions/_lichtraum");
  std::string const fish = read_project_file("completions/lichtraum.fish");
  std::set<std::string> all;
  for (std::string const command : commands) {
    INFO(command);
    CHECK_THAT(man, contains_text(".Cm " + command));
    CHECK_THAT(bash, contains_text(command));
    CHECK_THAT(zsh, contains_text("'" + command + ":"));
    CHECK_THAT(fish, contains_text("-a " + command));
    auto const options = options_of(lichtraum(command + " --help").out);
    REQUIRE(options.count("--help") == 1);
    all.insert(options.begin(), options.end());
  }
  for (std::string const command : job_commands) {
    INFO(command);
    CHECK_THAT(man, contains_text(".It Cm job " + command));
    CHECK_THAT(fish, contains_text(command));
    CHECK_THAT(zsh, contains_text(command));
    auto const options = options_of(lichtraum("job " + command + " --help").out);
    REQUIRE(options.count("--help") == 1);
    all.insert(options.begin(), options.end());
  }
  CHECK(all.size() >= 26);
  for (std::string const& option : all) {
    INFO(option);
    std::string const word = option.substr(2);
    CHECK(std::regex_search(man, std::regex("Fl -" + word + "\\b(?!-)")));
    CHECK(std::regex_search(bash, std::regex(option + "\\b(?!-)")));
    CHECK(std::regex_search(zsh, std::regex(option + "\\b(?!-)")));
    CHECK(std::regex_search(fish, std::regex("-l " + word + "\\b(?!-)")));
  }
  // And the other way round: no option of the man page that the program does not have.
  for (std::string const& word : matches(man, "\n\\.It Fl (?:[a-zA-Z] , )?(?:Fl )?-([a-z-]+)")) {
    INFO(word);
    CHECK((all.count("--" + word) == 1 || word == "version"));
  }
}

TEST_CASE("bash completes each command with its options, and with no others", "[app][help]") {
  if (!is_installed("bash")) SKIP_TEST("bash is not installed");
  Lichtraum const lichtraum;
  for (std::string const command : commands) {
    Process shell = lichtraum.process("");
    shell.arguments = {"bash", "-c",
                       "source " + project_path("completions/lichtraum.bash") + "; COMP_WORDS=(lichtraum " + command +
                           " --); COMP_CWORD=2; _lichtraum; printf '\\n  %s' \"${COMPREPLY[@]}\""};
    INFO(command);
    CHECK(options_of(run_process(shell).out) == options_of(lichtraum(command + " --help").out));
  }
  for (std::string const command : job_commands) {
    Process shell = lichtraum.process("");
    shell.arguments = {"bash", "-c",
                       "source " + project_path("completions/lichtraum.bash") + "; COMP_WORDS=(lichtraum job " +
                           command + " --); COMP_CWORD=3; _lichtraum; printf '\\n  %s' \"${COMPREPLY[@]}\""};
    INFO(command);
    CHECK(options_of(run_process(shell).out) == options_of(lichtraum("job " + command + " --help").out));
  }
}

TEST_CASE("bash completes values after =, as a word or as three", "[app][help]") {
  if (!is_installed("bash")) SKIP_TEST("bash is not installed");
  Lichtraum const lichtraum;
  auto const completed = [&](std::string const& words) {
    Process shell = lichtraum.process("");
    shell.arguments = {"bash", "-c",
                       "source " + project_path("completions/lichtraum.bash") + "; COMP_WORDS=(lichtraum render " +
                           words + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _lichtraum; echo \"${COMPREPLY[@]}\""};
    return run_process(shell).out;
  };
  CHECK(completed("--tonemap n") == "neutral none\n");
  CHECK(completed("--tonemap = n") == "neutral none\n");
  CHECK(completed("--transfer =") == "linear srgb\n");
  CHECK(completed("--tonemap=n") == "--tonemap=neutral --tonemap=none\n");
  CHECK(completed("--ground = g") == "glossy\n");
}

TEST_CASE("bash completes names of files as such, with their blanks", "[app][help]") {
  if (!is_installed("bash")) SKIP_TEST("bash is not installed");
  Lichtraum const lichtraum;
  std::string const completion = project_path("completions/lichtraum.bash");
  for (std::string const option : {"-o", "--output-dir", "--allow-path", "--environment"}) {
    INFO(option);
    Process shell = lichtraum.process("");
    shell.arguments = {"bash", "-c",
                       "source " + completion + "; compopt() { echo \"$@\"; }; COMP_WORDS=(lichtraum render " + option +
                           " x); COMP_CWORD=3; _lichtraum"};
    CHECK_THAT(run_process(shell).out, contains_text("-o filenames"));
  }
}
