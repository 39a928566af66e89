#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <new>
#include <set>

#include "core/ascii.hpp"
#include "core/counted.hpp"
#include "core/read_file.hpp"
#include "io/another_file.hpp"
#include "io/far_origin.hpp"
#include "io/model_file.hpp"
#include "io/model_scene.hpp"
#include "io/obj/material_from_mtl.hpp"
#include "io/obj/part_geometry.hpp"
#include "io/obj/pictures.hpp"
#include "lichtraum/obj.hpp"

namespace lichtraum {
namespace obj {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_findings = 100;
constexpr std::size_t max_libraries = 256;
constexpr std::size_t max_library_bytes = std::size_t(1) << 26;

class Importer {
 public:
  Importer(std::string const& name, std::optional<fs::path> const& folder, ModelOptions const& options)
      : name_(name),
        folder_(folder),
        options_(options),
        diagnostics_(name, max_findings),
        finder_(folder, options.allowed_paths),
        pictures_(folder, options, finder_) {}

  Model run(std::string text) {
    if (!is_obj(text) && is_another_file(text, "an OBJ model", DiagnosticCode::not_obj, diagnostics_)) {
      throw SceneError(std::move(diagnostics_).finish(0));
    }
    normalise_line_breaks(text);
    join_continued_lines(text);
    ObjFile file = read_obj(text, diagnostics_);
    if (!options_.material) {
      read_libraries(file);
      read_materials(file);
    }
    Model model;
    std::vector<ModelPart> parts;
    PartGeometry geometry(file);
    for (Part const& part : file.parts) {
      parts.push_back(named(part, file.draws, geometry.of(part, pictured_.contains(part.material)), model.scene));
    }
    if (parts.empty())
      diagnostics_.add(Severity::error, DiagnosticCode::nothing_to_draw, {},
                       "the model has nothing to draw: it has no triangles, lines or points");
    bool const has_failed = parts.empty();
    model.diagnostics = std::move(diagnostics_).finish(0);
    model.diagnostics.insert(model.diagnostics.end(), of_libraries_.begin(), of_libraries_.end());
    check_static(options_, name_, file.draws != Drawn::triangles, model.diagnostics);
    if (file.origin) {
      model.origin = *file.origin;
      model.diagnostics.push_back(moved_from(*file.origin, name_));
    }
    if (has_failed) throw SceneError(std::move(model.diagnostics));
    add_parts(std::move(parts), fs::path(name_).stem().string(), model.scene, options_.point_size);
    return model;
  }

 private:
  ModelPart named(Part const& part, Drawn drawn, std::shared_ptr<MeshGeometry const> geometry, Scene& scene) {
    std::shared_ptr<Material const> material = options_.material;
    if (!material) {
      auto const found = materials_.find(part.material);
      auto const own = found != materials_.end() ? found->second : default_material(!geometry->colors.empty());
      if (!scene.materials.contains(own->name())) scene.materials.insert(own);
      material = own;
    }
    std::string name = part.name.empty() ? part.material : part.name;
    if (!part.name.empty() && !part.material.empty()) name += "." + part.material;
    return {name.empty() ? part_name(drawn) : std::move(name), std::move(geometry), std::move(material)};
  }

  void read_libraries(ObjFile const& file) {
    bool const is_one_used = !file.used_materials.empty();
    for (Mention const& mention : file.libraries) {
      diagnostics_.begin_line(mention.line);
      for (std::string const& name : names_of_libraries(mention.word)) {
        if (!known_libraries_.insert(name).second) continue;
        if (known_libraries_.size() > max_libraries || library_bytes_ > max_library_bytes) {
          return diagnostics_.add(Severity::warning, DiagnosticCode::unreadable_mtl, mention.word,
                                  "too many material files: this one is left out");
        }
        read_library_named(name, mention.word, is_one_used);
      }
    }
    if (file.libraries.empty() && is_one_used) read_namesake(file.used_materials.front());
  }

  /// Several names, or one with blanks in it: then there is such a file, or none but its end ends like a name.
  std::vector<std::string> names_of_libraries(std::string_view words) const {
    std::string whole(words);
    std::replace(whole.begin(), whole.end(), '\\', '/');
    std::error_code error;
    if (folder_ && fs::exists(*folder_ / whole, error)) return {whole};
    std::vector<std::string> names;
    std::string_view rest = whole;
    for (Token name = next_token(rest); !name.empty(); name = next_token(rest)) names.emplace_back(name);
    auto const ends_like_name = [](std::string const& name) { return to_lower_ascii(name).ends_with(".mtl"); };
    bool const are_several = std::any_of(names.begin(), names.end() - 1, ends_like_name);
    return are_several ? names : std::vector{whole};
  }

  std::optional<std::string> text_of(std::string const& name, std::string& reason) const {
    return read_model_file(folder_, options_.allowed_paths, options_.on_read, name, reason);
  }

  void read_library_named(std::string const& name, Token at, bool is_one_used) {
    std::string reason;
    auto text = text_of(name, reason);
    if (text) return read_library(name, std::move(*text));
    fs::path const homes[] = {""};
    auto found = finder_.find(name, homes);
    if (found && known_libraries_.contains(found->path)) return;  // named twice, in two ways
    if (!found && is_one_used) found = namesake();
    if (found) text = text_of(found->path, reason);
    if (!text) {
      has_lost_library_ = true;
      std::string hint = hint_for_place(folder_, options_.allowed_paths, name);
      return diagnostics_.add(Severity::warning, DiagnosticCode::unreadable_mtl, at, reason, std::move(hint));
    }
    diagnostics_.add(found->is_elsewhere ? Severity::warning : Severity::note, DiagnosticCode::file_elsewhere, at,
                     used_instead(name, *found));
    known_libraries_.insert(found->path);
    read_library(found->path, std::move(*text));
  }

  /// The MTL file that is called like the model, unless it was read: programs write both.
  std::optional<FoundFile> namesake() {
    auto const path = finder_.in_any_case("", fs::path(name_).stem().concat(".mtl"));
    if (!path || known_libraries_.contains(path->string())) return std::nullopt;
    return FoundFile{path->string(), true};
  }

  void read_namesake(Mention const& material) {
    auto const found = namesake();
    std::string reason;
    auto text = found ? text_of(found->path, reason) : std::nullopt;
    if (!text) return;
    diagnostics_.begin_line(material.line);
    diagnostics_.add(Severity::warning, DiagnosticCode::file_elsewhere, material.word,
                     fmt::format("no mtllib names an MTL file: {} is used", in_quotes(found->path)));
    read_library(found->path, std::move(*text));
  }

  void read_library(std::string const& name, std::string text) {
    library_bytes_ += text.size();
    normalise_line_breaks(text);
    libraries_.push_back({(fs::path(name_).parent_path() / name).string(),
                          fs::path(name).parent_path(),
                          std::make_unique<std::string>(std::move(text)),
                          {}});
    Library& library = libraries_.back();
    library.findings = std::make_unique<Diagnostics>(library.shown, max_findings);
    for (MtlMaterial& material : read_mtl(*library.text, *library.findings)) {
      std::string key = material.name;
      sources_.emplace(std::move(key),
                       Source{std::move(material), libraries_.size() - 1});  // the first of a name counts
    }
  }

  /// Those that faces use, with their pictures.
  void read_materials(ObjFile const& file) {
    std::vector<Source*> used;
    std::vector<Mention> missing;
    for (Mention const& mention : file.used_materials) {
      auto const found = sources_.find(std::string(mention.word));
      if (found != sources_.end()) {
        used.push_back(&found->second);
      } else {
        missing.push_back(mention);
      }
    }
    warn_of_missing(std::move(missing));
    for (Source const* source : used) {
      for (auto const map : mtl_textures) {
        bool const is_color = map == &MtlMaterial::map_kd || map == &MtlMaterial::map_ke;
        pictures_.read(source->material.*map, libraries_[source->library].folder,
                       is_color ? TexelContent::color : TexelContent::data);
      }
    }
    std::string const halved = pictures_.decode();
    MadePictures made;
    for (Source* const source : used) {
      MtlMaterial& m = source->material;
      Library& library = libraries_[source->library];
      for (auto const map : mtl_textures) {
        (m.*map).image = pictures_.image_of(m.*map, library.folder, *library.findings);
      }
      if (m.map_kd.image) pictured_.insert(m.name);
      materials_[m.name] = material_from_mtl(m, {!file.colors.empty(), options_.is_part_of_scene}, made);
    }
    diagnostics_.begin_line({});
    if (!halved.empty()) diagnostics_.add(Severity::warning, DiagnosticCode::textures_halved, {}, halved);
    if (made.is_full()) {
      diagnostics_.add(
          Severity::warning, DiagnosticCode::texture_left_out, {},
          fmt::format("map_d, map_Pr, map_Pm and map_Bump of some materials are left out: the pictures made of "
                      "them need more than {} bytes; a smaller --max-texture helps",
                      MadePictures::max_bytes));
    }
    for (Library& library : libraries_) {
      auto findings = std::move(*library.findings).finish(0);
      of_libraries_.insert(of_libraries_.end(), findings.begin(), findings.end());
    }
  }

  /// One by one, as each may be misspelt, unless there is one reason for all.
  void warn_of_missing(std::vector<Mention> materials) {
    std::string more;
    if (materials.size() > 0 && (has_lost_library_ || libraries_.empty())) {
      if (materials.size() > 1) more = fmt::format(" nor {}", counted(materials.size() - 1, "other"));
      more += has_lost_library_ ? ": an MTL file is missing" : ": no mtllib names an MTL file";
      materials.resize(1);
    }
    for (Mention const& material : materials) {
      diagnostics_.begin_line(material.line);
      diagnostics_.add(Severity::warning, DiagnosticCode::missing_obj_material, material.word,
                       fmt::format("there is no material {}{}", in_quotes(material.word), more));
    }
  }

  struct Library {
    std::string shown;  // in messages
    fs::path folder;    // in the model's
    std::unique_ptr<std::string> text;
    std::unique_ptr<Diagnostics> findings;
  };
  struct Source {
    MtlMaterial material;
    std::size_t library;
  };

  std::string const& name_;
  std::optional<fs::path> const& folder_;
  ModelOptions const& options_;
  Diagnostics diagnostics_;
  FileFinder finder_;
  Pictures pictures_;
  std::set<std::string> known_libraries_;  // names and paths
  std::size_t library_bytes_ = 0;          // read so far
  bool has_lost_library_ = false;          // one could not be read
  std::vector<Library> libraries_;
  std::vector<Diagnostic> of_libraries_;
  std::map<std::string, Source> sources_;
  std::map<std::string, std::shared_ptr<Material>> materials_;
  std::set<std::string> pictured_;  // materials whose colours a picture gives
};

}  // namespace
}  // namespace obj

Model import_obj_text(std::string text, std::string const& name, std::optional<std::filesystem::path> const& folder,
                      ModelOptions const& options) {
  try {
    return obj::Importer(name, folder, options).run(std::move(text));
  } catch (std::bad_alloc const&) {
    throw Error(ErrorKind::scene, fmt::format("{}: the model needs more memory than there is", name));
  }
}

bool is_obj(std::string_view bytes) {
  constexpr std::size_t examined_bytes = 4096;
  constexpr std::array keywords{"v", "vn", "vt", "vp", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl"};
  std::string_view const head = bytes.substr(0, examined_bytes);
  bool const is_cut = head.size() < bytes.size();
  bool has_content = false;
  Line line;
  for (LineReader lines(is_cut ? head.substr(0, head.rfind('\n') + 1) : head); lines.next(line);) {
    std::string_view rest = line.text;
    Token const word = next_token(rest);
    if (word.empty() || word.starts_with('#')) continue;
    if (std::ranges::find(keywords, word) == keywords.end()) return false;
    has_content = has_content || word == "v" || word == "mtllib";
  }
  return has_content;
}

Model import_obj(std::filesystem::path const& path, ModelOptions const& options) {
  if (options.on_read) options.on_read(path);
  return import_obj_text(read_file(path), path.string(), path.parent_path(), options);
}

}  // namespace lichtraum
