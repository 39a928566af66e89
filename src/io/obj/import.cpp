#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <new>
#include <set>

#include "core/read_file.hpp"
#include "io/image/decode_all.hpp"
#include "io/model_file.hpp"
#include "io/model_scene.hpp"
#include "io/obj/material_from_mtl.hpp"
#include "io/obj/part_geometry.hpp"
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
      : name_(name), folder_(folder), options_(options), diagnostics_(name, max_findings) {}

  Model run(std::string text) {
    normalise_line_breaks(text);
    join_continued_lines(text);
    ObjFile const file = read_obj(text, diagnostics_);
    if (!options_.material) {
      read_libraries(file);
      read_materials(file);
    }
    Model model;
    std::vector<ModelPart> parts;
    PartGeometry geometry(file);
    for (Part const& part : file.parts) {
      parts.push_back(named(part, geometry.of(part, pictured_.contains(part.material)), model.scene));
    }
    if (parts.empty())
      diagnostics_.add(Severity::error, DiagnosticCode::nothing_to_draw, {},
                       "the model has nothing to draw: it has no triangles");
    bool const has_failed = parts.empty();
    model.diagnostics = std::move(diagnostics_).finish(0);
    model.diagnostics.insert(model.diagnostics.end(), of_libraries_.begin(), of_libraries_.end());
    check_static(options_, name_, false, model.diagnostics);
    if (has_failed) throw SceneError(std::move(model.diagnostics));
    add_parts(std::move(parts), fs::path(name_).stem().string(), model.scene);
    return model;
  }

 private:
  ModelPart named(Part const& part, std::shared_ptr<MeshGeometry const> geometry, Scene& scene) {
    std::shared_ptr<Material const> material = options_.material;
    if (!material) {
      auto const found = materials_.find(part.material);
      auto const own = found != materials_.end() ? found->second : default_material(!geometry->colors.empty());
      if (!scene.materials.contains(own->name())) scene.materials.insert(own);
      material = own;
    }
    std::string name = part.name.empty() ? part.material : part.name;
    if (!part.name.empty() && !part.material.empty()) name += "." + part.material;
    return {name.empty() ? "mesh" : std::move(name), std::move(geometry), std::move(material)};
  }

  void read_libraries(ObjFile const& file) {
    std::set<std::string> known;
    std::size_t bytes = 0;
    for (Mention const& mention : file.libraries) {
      diagnostics_.begin_line(mention.line);
      for (std::string const& name : names_of_libraries(mention.word)) {
        if (!known.insert(name).second) continue;
        if (known.size() > max_libraries || bytes > max_library_bytes) {
          return diagnostics_.add(Severity::warning, DiagnosticCode::unreadable_mtl, mention.word,
                                  "too many material files: this one is left out");
        }
        std::string reason;
        if (auto text = read_model_file(folder_, options_.allowed_paths, options_.on_read, name, reason)) {
          bytes += text->size();
          read_library(name, std::move(*text));
        } else {
          diagnostics_.add(Severity::warning, DiagnosticCode::unreadable_mtl, mention.word, reason);
        }
      }
    }
  }

  /// Several names, or one with blanks in it: then there is such a file.
  std::vector<std::string> names_of_libraries(std::string_view words) const {
    std::string whole(words);
    std::replace(whole.begin(), whole.end(), '\\', '/');
    std::error_code error;
    bool const has_blanks = whole.find_first_of(" \t") != std::string::npos;
    if (!has_blanks || (folder_ && fs::exists(*folder_ / whole, error))) return {whole};
    std::vector<std::string> names;
    std::string_view rest = whole;
    for (Token name = next_token(rest); !name.empty(); name = next_token(rest)) names.emplace_back(name);
    return names;
  }

  void read_library(std::string const& name, std::string text) {
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
    for (Mention const& mention : file.used_materials) {
      auto const found = sources_.find(std::string(mention.word));
      if (found != sources_.end()) {
        used.push_back(&found->second);
      } else {
        diagnostics_.begin_line(mention.line);
        diagnostics_.add(Severity::warning, DiagnosticCode::missing_obj_material, mention.word,
                         fmt::format("there is no material {}", in_quotes(mention.word)));
      }
    }
    for (Source const* source : used) {
      for (auto const map : mtl_textures) fetch(source->material.*map, source->library);
    }
    std::string const halved = decode_images(jobs_, options_.max_texture);
    MadePictures made;
    for (Source* const source : used) {
      MtlMaterial& m = source->material;
      for (auto const map : mtl_textures) (m.*map).image = picture_of(m.*map, source->library);
      if (m.map_kd.image) pictured_.insert(m.name);
      materials_[m.name] = material_from_mtl(m, !file.colors.empty(), made);
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

  /// As seen from the model's folder.
  std::string path_of(MtlTexture const& texture, std::size_t library) const {
    fs::path const path = texture.file;
    return path.is_absolute() ? texture.file : (libraries_[library].folder / path).string();
  }

  void fetch(MtlTexture const& texture, std::size_t library) {
    if (texture.file.empty()) return;
    auto const [found, is_new] = job_numbers_.emplace(path_of(texture, library), jobs_.size());
    if (!is_new) return;
    ImageJob job;
    job.name = texture.file;
    job.is_wanted = true;
    auto bytes = read_model_file(folder_, options_.allowed_paths, options_.on_read, found->first, job.reason);
    if (bytes) {
      job.owned = std::make_shared<std::string const>(std::move(*bytes));
      job.bytes = *job.owned;
    }
    jobs_.push_back(std::move(job));
  }

  std::shared_ptr<TextureImage const> picture_of(MtlTexture const& texture, std::size_t library) {
    if (texture.file.empty()) return nullptr;
    ImageJob const& job = jobs_[job_numbers_.at(path_of(texture, library))];
    if (!job.image) {
      libraries_[library].findings->begin_line(texture.line);
      libraries_[library].findings->add(Severity::warning, DiagnosticCode::texture_left_out, {},
                                        fmt::format("the picture is left out: {}", job.reason));
    }
    return job.image;
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
  std::vector<Library> libraries_;
  std::vector<Diagnostic> of_libraries_;
  std::map<std::string, Source> sources_;
  std::map<std::string, std::shared_ptr<Material>> materials_;
  std::set<std::string> pictured_;  // materials whose colours a picture gives
  std::vector<ImageJob> jobs_;
  std::map<std::string, std::size_t> job_numbers_;
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
