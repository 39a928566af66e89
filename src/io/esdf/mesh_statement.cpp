#include "io/esdf/mesh_statement.hpp"

#include <fmt/format.h>

#include "io/esdf/interpreter.hpp"
#include "io/esdf/named_file.hpp"
#include "io/model_cache.hpp"
#include "io/unread_model.hpp"

// define shape mesh <name> <file> [<material>]
// Dialect: define shape obj <file>, whose name is the file's.

namespace lichtraum::esdf {
namespace {

std::string known_formats(std::span<MeshFormat const> formats) {
  if (formats.empty()) return "this build reads no model formats";
  std::string result = "known formats:";
  for (MeshFormat const& format : formats) {
    for (std::string_view const extension : format.extensions) result += fmt::format(" {}", extension);
  }
  return result;
}

/// Null, after a report, when the file cannot be used.
std::shared_ptr<Shape> load_mesh(Interpreter& interpreter, Token name, Token file,
                                 std::shared_ptr<Material const> material) {
  auto const path = find_named_file(interpreter, file);
  if (!path) return nullptr;
  MeshFormat const* const format = find_mesh_format(interpreter.source.mesh_formats, *path);
  if (auto const unread = recognise_unread_model(*path); !format && unread) {
    interpreter.error(Code::unread_format, file, fmt::format("cannot read {}: it is {}", in_quotes(file), unread->what),
                      unread->hint);
    return nullptr;
  }
  if (!format) {
    interpreter.error(Code::unread_format, file, fmt::format("cannot read {}: unknown model format", in_quotes(file)),
                      known_formats(interpreter.source.mesh_formats));
    return nullptr;
  }
  try {
    ModelOptions options;
    options.allowed_paths = interpreter.options.allowed_paths;
    options.material = std::move(material);
    options.on_read = interpreter.options.on_read;
    options.is_part_of_scene = true;
    return interpreter.options.models->shape(*format, *path, options, std::string(name));
  } catch (SceneError const& problem) {
    std::string const first = problem.diagnostics().empty() ? problem.what() : problem.diagnostics().front().message;
    interpreter.error(Code::unreadable_file, file, fmt::format("cannot read {}: {}", in_quotes(file), first));
  } catch (Error const& problem) {
    interpreter.error(Code::unreadable_file, file, fmt::format("cannot read {}: {}", in_quotes(file), problem.what()));
  }
  return nullptr;
}

void define_model(Interpreter& interpreter, Token name, Token file, std::shared_ptr<Material const> material) {
  if (auto shape = load_mesh(interpreter, name, file, std::move(material))) {
    interpreter.define(name, std::move(shape));
  } else {
    interpreter.mark_faulty(Kind::shape, name);
  }
}

}  // namespace

void define_mesh(Interpreter& interpreter, Statement const& statement) {
  if (statement.size() != 2 && statement.size() != 3) {
    interpreter.error(Code::wrong_count, statement.size() > 3 ? statement.rest(3) : place_after(statement.last()),
                      fmt::format("mesh: expected a name, a file and perhaps a material, found {} argument{}",
                                  statement.size(), statement.size() == 1 ? "" : "s"));
    if (statement.size() > 0) interpreter.mark_faulty(Kind::shape, statement[0]);
    return;
  }
  define_model(interpreter, statement[0], statement[1],
               statement.size() == 3 ? interpreter.material(statement[2]) : nullptr);
}

void define_obj(Interpreter& interpreter, Statement const& statement) {
  if (statement.size() != 1) {
    interpreter.error(Code::wrong_count, statement.size() > 1 ? statement.rest(1) : place_after(statement.last()),
                      fmt::format("obj: expected a file, found {} arguments", statement.size()),
                      "for more, use define shape mesh <name> <file> [<material>]");
    if (statement.size() > 0) interpreter.mark_faulty(Kind::shape, statement[0]);
    return;
  }
  define_model(interpreter, statement[0], statement[0], nullptr);
}

}  // namespace lichtraum::esdf
