#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/error.hpp"

namespace lichtraum::gltf {

/// What an import found wrong. Each finding starts with the place in the model, a JSON pointer (RFC 6901).
class Findings {
 public:
  explicit Findings(std::filesystem::path const& file) : file_(file.string()) {}

  /// Something is left out or repaired; the import goes on. Told once. After the first 100 only the number is kept.
  void warn(DiagnosticCode code, std::string_view pointer, std::string_view message);

  /// The model cannot be imported: throws a SceneError with this and everything found before.
  [[noreturn]] void fail(DiagnosticCode code, std::string_view pointer, std::string_view message);
  /// The same at a place in the text, counted in bytes from its begin.
  [[noreturn]] void fail_at(DiagnosticCode code, std::string_view text, std::size_t offset, std::string_view message);

  /// While it lives, warnings are forgotten.
  class Muted {
   public:
    explicit Muted(Findings& findings) : findings_(findings) { findings_.is_muted_ = true; }
    ~Muted() { findings_.is_muted_ = false; }
    Muted(Muted const&) = delete;
    Muted& operator=(Muted const&) = delete;

   private:
    Findings& findings_;
  };

  bool empty() const { return diagnostics_.empty(); }
  /// Moves them out, with one about those that were not kept.
  std::vector<Diagnostic> take();

 private:
  std::string file_;
  std::vector<Diagnostic> diagnostics_;
  std::size_t dropped_ = 0;
  bool is_muted_ = false;
};

}  // namespace lichtraum::gltf
