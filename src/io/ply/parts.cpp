#include "io/ply/parts.hpp"

#include <fmt/format.h>

#include <map>
#include <numeric>
#include <span>
#include <string_view>

#include "io/image/decode_all.hpp"
#include "io/model_file.hpp"

namespace lichtraum::ply {
namespace {

using Pictures = std::vector<std::shared_ptr<TextureImage const>>;
/// The numbers of triangles by that of their picture; those without a picture last.
using TrianglesOfPictures = std::map<std::uint32_t, std::vector<std::uint32_t>>;

/// Those that the faces can show.
std::span<std::string const> files_of(Header const& header, Data const& data, ModelOptions const& options,
                                      Diagnostics& diagnostics) {
  bool const has_texcoords = data.faces.has_texcoords || !data.geometry.texcoords.empty();
  std::span<std::string const> const files = header.texture_files;
  if (options.material || !has_texcoords || files.empty() || header.draws() != Drawn::triangles) return {};
  if (files.size() == 1 || data.faces.has_pictures) return files;
  diagnostics.add(Severity::warning, DiagnosticCode::texture_left_out, {},
                  fmt::format("pictures are left out: all but {}, the first of {}, as the faces have no texnumber",
                              in_quotes(files[0]), files.size()));
  return files.first(1);
}

TrianglesOfPictures triangles_of_pictures(Data const& data, std::size_t picture_count) {
  std::size_t const count = data.geometry.triangle_count();
  TrianglesOfPictures triangles;
  if (count > 0 && picture_count <= 1) {  // nothing to choose from
    std::vector<std::uint32_t>& all = triangles[picture_count == 1 ? 0 : no_number];
    all.resize(count);
    std::iota(all.begin(), all.end(), 0u);
    return triangles;
  }
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t const number = data.faces.pictures[i];
    triangles[number < picture_count ? number : no_number].push_back(std::uint32_t(i));
  }
  return triangles;
}

Pictures read_pictures(std::span<std::string const> files, TrianglesOfPictures const& triangles,
                       std::optional<std::filesystem::path> const& folder, ModelOptions const& options,
                       Diagnostics& diagnostics) {
  std::vector<ImageJob> jobs;
  std::map<std::string_view, std::size_t> job_of;  // a file may be named more than once
  for (std::size_t i = 0; i < files.size(); ++i) {
    bool const is_wanted = triangles.contains(std::uint32_t(i));
    if (!is_wanted || !job_of.try_emplace(files[i], jobs.size()).second) continue;
    ImageJob& job = jobs.emplace_back();
    job.name = files[i];
    job.is_wanted = true;
    job.content = TexelContent::color;
    auto bytes = read_model_file(folder, options.allowed_paths, options.on_read, job.name, job.reason);
    if (!bytes) continue;
    job.owned = std::make_shared<std::string const>(std::move(*bytes));
    job.bytes = *job.owned;
  }
  std::string const halved = decode_images(jobs, options.max_texture);
  if (!halved.empty()) diagnostics.add(Severity::warning, DiagnosticCode::textures_halved, {}, halved);
  for (ImageJob const& job : jobs) {
    if (job.image) continue;
    diagnostics.add(Severity::warning, DiagnosticCode::texture_left_out, {},
                    fmt::format("the picture is left out: {}", job.reason));
  }
  Pictures pictures(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (auto const job = job_of.find(files[i]); job != job_of.end()) pictures[i] = jobs[job->second].image;
  }
  return pictures;
}

}  // namespace

std::vector<Part> divide(Data data, Header const& header, std::optional<std::filesystem::path> const& folder,
                         ModelOptions const& options, Diagnostics& diagnostics) {
  std::span<std::string const> const files = files_of(header, data, options, diagnostics);
  TrianglesOfPictures const triangles = triangles_of_pictures(data, files.size());
  Pictures const pictures = read_pictures(files, triangles, folder, options, diagnostics);
  auto const picture = [&](std::uint32_t number) { return number < pictures.size() ? pictures[number] : nullptr; };
  std::vector<Part> parts;
  if (triangles.empty()) {
    parts.push_back({std::move(data.geometry), nullptr});
  } else if (triangles.size() == 1 && !data.faces.has_texcoords && !data.faces.has_colors) {
    parts.push_back({std::move(data.geometry), picture(triangles.begin()->first)});
    // Programs that make both from photographs write the same in either: they would darken each other.
    if (parts[0].picture) parts[0].geometry.colors = {};
  } else {
    for (auto const& [number, numbers] : triangles) {
      bool const with_colors = !picture(number);  // as above
      parts.push_back({own_corners(data.geometry, data.faces, numbers, with_colors), picture(number)});
    }
  }
  return parts;
}

}  // namespace lichtraum::ply
