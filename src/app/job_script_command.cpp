#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/arguments.hpp"
#include "app/job_commands.hpp"
#include "app/values.hpp"
#include "core/quoted_for_shell.hpp"
#include "core/whole_path.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* job_script_description =
    "Prints what a queue needs to draw the plan in the folder DIR: a script or a job\n"
    "description for slurm, openjd, opencue, flamenco, or parallel (GNU parallel).\n"
    "Each of its tasks is a 'lichtraum job work' on some of the units. What is done\n"
    "already is skipped when a task runs; job merge is left to you.";

constexpr char const* job_script_examples =
    "  lichtraum job script slurm shared > work.sh       (then: sbatch work.sh)\n"
    "  lichtraum job script parallel shared > work.sh    (then: sh work.sh)\n"
    "  lichtraum job script openjd shared > work.json\n";

/// What queues take in one job: OpenJD's lists end there, and so does Slurm's usual MaxArraySize.
constexpr std::int64_t most_tasks = 1000;

struct ScriptTasks {
  std::string folder;  ///< absolute
  std::int64_t unit_count = 0;
  std::int64_t task_units = 1;

  std::int64_t count() const { return (unit_count - 1) / task_units + 1; }
  std::string units(std::int64_t task) const {
    return fmt::format("{}..{}", task * task_units, std::min(unit_count, (task + 1) * task_units) - 1);
  }
};

/// A text in JSON, and in JavaScript and Python as well.
std::string json_quoted(std::string const& text) {
  try {
    return nlohmann::json(text).dump();
  } catch (nlohmann::json::type_error const&) {
    throw Error(ErrorKind::usage, "the folder's name is not UTF-8, and cannot be written into the script");
  }
}

std::string slurm_script(ScriptTasks const& tasks) {
  return fmt::format(R"script(#!/bin/sh
#SBATCH --job-name=lichtraum
#SBATCH --array=0-{}
#SBATCH --requeue
# PoCL's cache is for one machine.
POCL_CACHE_DIR="${{TMPDIR:-/tmp}}/pocl-$(id -u)"
export POCL_CACHE_DIR
first=$((SLURM_ARRAY_TASK_ID * {}))
last=$((first + {}))
[ "$last" -lt {} ] || last={}
lichtraum job work {} -q --units "$first..$last"
status=$?
# It may succeed later; and above 128 the worker was killed.
if {{ [ "$status" -eq 75 ] || [ "$status" -gt 128 ]; }} && [ "${{SLURM_RESTART_COUNT:-0}}" -lt 5 ]; then
  scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID"
fi
exit "$status"
)script",
                     tasks.count() - 1, tasks.task_units, tasks.task_units - 1, tasks.unit_count, tasks.unit_count - 1,
                     quoted_for_shell(tasks.folder));
}

std::string parallel_script(ScriptTasks const& tasks) {
  return fmt::format(R"script(#!/bin/sh
# Options go to GNU parallel: -S host1,host2 for machines, -j 1 for one task at a time on each.
seq 0 {} {} | while read -r first; do
  last=$((first + {}))
  [ "$last" -lt {} ] || last={}
  echo "$first..$last"
done | parallel -j 1 --retries 3 "$@" lichtraum job work {} -q --units
)script",
                     tasks.task_units, tasks.unit_count - 1, tasks.task_units - 1, tasks.unit_count,
                     tasks.unit_count - 1, quoted_for_shell(quoted_for_shell(tasks.folder)));
}

std::string openjd_template(ScriptTasks const& tasks) {
  using Json = nlohmann::ordered_json;
  Json ranges = Json::array();
  for (std::int64_t task = 0; task < tasks.count(); ++task) ranges.push_back(tasks.units(task));
  Json const parameter = {{"name", "Units"}, {"type", "STRING"}, {"range", std::move(ranges)}};
  json_quoted(tasks.folder);  // throws for what is no text
  Json const run = {{"command", "lichtraum"},
                    {"args", {"job", "work", tasks.folder, "-q", "--units", "{{Task.Param.Units}}"}}};
  Json const step = {{"name", "work"},
                     {"parameterSpace", {{"taskParameterDefinitions", Json::array({parameter})}}},
                     {"script", {{"actions", {{"onRun", run}}}}}};
  Json const job = {
      {"specificationVersion", "jobtemplate-2023-09"}, {"name", "lichtraum"}, {"steps", Json::array({step})}};
  return job.dump(2) + "\n";
}

std::string opencue_outline(ScriptTasks const& tasks) {
  return fmt::format(R"script(#!/usr/bin/env python3
# A job for OpenCue: run it with PyOutline installed, and CUEBOT_HOSTS set. Its frames are the plan's units.
import getpass

import outline
import outline.cuerun
import outline.modules.shell

job = outline.Outline("lichtraum", shot="lichtraum", show="testing", user=getpass.getuser())
job.add_layer(outline.modules.shell.Shell(
    "work",
    command=["lichtraum", "job", "work", {}, "-q", "--units", "#FRAME_START#..#FRAME_END#"],
    range="0-{}",
    chunk={}))
outline.cuerun.launch(job, use_pycuerun=False)
)script",
                     json_quoted(tasks.folder), tasks.unit_count - 1, tasks.task_units);
}

std::string flamenco_job_type(ScriptTasks const& tasks) {
  return fmt::format(
      R"script(// A job type for Flamenco 3: put it into the folder "scripts" beside Flamenco Manager, and submit a job of it.
const JOB_TYPE = {{
  label: "lichtraum",
  settings: [
    {{ key: "folder", type: "string", required: true, default: {}, description: "Folder of the plan" }},
    {{ key: "units", type: "int32", required: true, default: {}, description: "Units of the plan" }},
    {{ key: "task_units", type: "int32", required: true, default: {}, description: "Units of a task" }},
  ],
}};

function compileJob(job) {{
  const {{ folder, units, task_units }} = job.settings;
  for (let first = 0; first < units; first += task_units) {{
    const last = Math.min(first + task_units, units) - 1;
    const task = author.Task("units " + first + ".." + last, "misc");
    task.addCommand(author.Command("exec", {{
      exe: "lichtraum",
      args: ["job", "work", folder, "-q", "--units", first + ".." + last],
    }}));
    job.addTask(task);
  }}
}}
)script",
      json_quoted(tasks.folder), tasks.unit_count, tasks.task_units);
}

struct Queue {
  std::string_view name;
  std::string (*script)(ScriptTasks const& tasks);
};
constexpr auto queues = std::to_array<Queue>({{"slurm", slurm_script},
                                              {"openjd", openjd_template},
                                              {"opencue", opencue_outline},
                                              {"flamenco", flamenco_job_type},
                                              {"parallel", parallel_script}});

Queue const& queue_named(std::string const& name) {
  for (Queue const& queue : queues) {
    if (queue.name == name) return queue;
  }
  std::string names;
  for (Queue const& queue : queues) {
    names += names.empty() ? "" : &queue == &queues.back() ? " and " : ", ";
    names += queue.name;
  }
  throw Error(ErrorKind::usage, fmt::format("no queue is called '{}': there are {}", name, names));
}

}  // namespace

int job_script_command(Arguments const& arguments, Console& console) {
  std::vector<std::string> words;
  int task_units = 0;
  auto const parser = make_parser("job script", job_script_description, job_script_examples);
  add_inputs(*parser, words, "QUEUE DIR");
  add_value(*parser, "--units-per-task", task_units, parse_count, "N",
            "Units of a task (default: as few as make at most\n1000 tasks)", "Tasks");
  add_verbosity(*parser, console);
  if (!parse(*parser, arguments)) return 0;
  if (words.size() != 2) {
    throw Error(ErrorKind::usage, "expected a queue and a folder (lichtraum job script --help shows how)");
  }
  Queue const& queue = queue_named(words[0]);
  farm::PlanFolder const folder(words[1]);
  ScriptTasks tasks;
  tasks.folder = whole_path(words[1]).string();
  tasks.unit_count = folder.plan().unit_count();
  std::int64_t const fewest = (tasks.unit_count - 1) / most_tasks + 1;
  tasks.task_units = task_units > 0 ? task_units : fewest;
  if (tasks.task_units < fewest) {
    throw Error(ErrorKind::usage, fmt::format("--units-per-task: {} make more than {} tasks: at least {} do not",
                                              tasks.task_units, most_tasks, fewest));
  }
  write_standard_output(queue.script(tasks));
  return 0;
}

}  // namespace lichtraum::app
