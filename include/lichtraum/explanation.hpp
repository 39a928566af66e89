#pragma once

#include <span>
#include <string_view>

#include "lichtraum/api.hpp"
#include "lichtraum/diagnostic_code.hpp"

namespace LICHTRAUM_API lichtraum {

/// What a kind of diagnostic means, and what to do about it. Texts are UTF-8, in lines of at most 80 bytes, each with
/// its line break.
struct Explanation {
  DiagnosticCode code;
  std::string_view text;     ///< what it means, why it matters, what to do
  std::string_view example;  ///< a file that has this finding and no other; empty where it cannot be shown
  std::string_view instead;  ///< the same without it
  /// Finds it; its last word names the file.
  std::string_view command = "lichtraum check scene.sdf";
};

/// Codes whose numbers begin with the same two digits.
struct ExplanationGroup {
  std::string_view title;                     ///< "Names"
  std::span<Explanation const> explanations;  ///< by number
};

/// All of them: every code of diagnostic_codes is in one.
std::span<ExplanationGroup const> explanation_groups();

/// Null for DiagnosticCode::none only.
Explanation const* explanation_of(DiagnosticCode code);

}  // namespace lichtraum
