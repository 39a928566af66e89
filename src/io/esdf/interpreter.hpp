#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/suggester.hpp"
#include "io/esdf/arguments.hpp"
#include "io/mesh_format.hpp"
#include "io/text/diagnostics.hpp"
#include "lichtraum/esdf.hpp"
#include "lichtraum/scene.hpp"

namespace lichtraum::esdf {

using Code = DiagnosticCode;

using DrawFunction = std::function<bool(Scene const&, RenderCommand const&)>;

/// "did you mean 'red'?"; empty for an empty name.
std::string did_you_mean(std::string_view name);

/// What has names of its own.
enum class Kind { material, shape, light, camera };

/// What stays the same while a text is interpreted.
struct Source {
  std::string_view text;         ///< without lone CRs, see normalise_line_breaks
  std::string name;              ///< stands for the file in messages
  std::filesystem::path folder;  ///< relative paths start here
  std::span<MeshFormat const> mesh_formats;
};

/// Executes the statements of a text, one after the other, on a scene. The functions of statements.hpp do the work and
/// report here what they find.
class Interpreter {
 public:
  Interpreter(Source const& source, EsdfOptions const& options);

  /// Executes everything. `draw`, if there is one, is called at each `render`, and may stop the run with false.
  void run(DrawFunction const* draw = nullptr);

  /// Whether a `render` is followed by something that may change the scene.
  bool is_animated() const { return is_animated_; }
  bool has_errors() const { return diagnostics_.errors() > 0; }
  /// What was found; with options.keep_going errors have become warnings.
  std::vector<Diagnostic> take_diagnostics();

  Source const& source;
  EsdfOptions const& options;
  Scene scene;

  // For statements: reporting. `at` is a part of the current line.
  void error(Code code, Token at, std::string message, std::string hint = {});
  void warning(Code code, Token at, std::string message, std::string hint = {});
  /// A form that the standard does not know: an error and false with options.strict, else a note.
  bool dialect(Token at, std::string_view form);
  /// The same with a warning instead of a note.
  bool dialect_warning(Code code, Token at, std::string message, std::string hint = {});
  /// A hint on what is done with a form that options.strict refuses.
  std::string done_unless_strict(std::string done) const { return options.strict ? "without --strict: " + done : done; }
  /// The one of `names` that was probably meant by `word`, or an empty text.
  template <class... Names>
  std::string_view nearest(Token word, Names const&... names) {
    if (diagnostics_.has_all_errors()) return {};
    suggester_.look_for(word);
    (suggester_.consider_all(names), ...);
    return suggester_.best();
  }
  /// "did you mean 'x'?" for that name, or an empty text.
  template <class... Names>
  std::string suggest(Token word, Names const&... names) {
    return did_you_mean(nearest(word, names...));
  }

  // For statements: names. A name whose definition was faulty is known as such, so that what refers to it does not
  // count as a second error.
  void mark_faulty(Kind kind, Token name) { faulty_[static_cast<std::size_t>(kind)].insert(name); }
  /// The same for what the words of a faulty line define.
  void mark_faulty(std::span<Token const> definition);
  bool is_faulty(Kind kind, Token name) const { return faulty_[static_cast<std::size_t>(kind)].count(name) > 0; }

  /// The material of that name. An undefined one is reported, and is a clearly visible magenta.
  std::shared_ptr<Material> const& material(Token name);
  // Adds to the scene. A second thing of the same name is reported, and takes the first one's place.
  void define(Token name, std::shared_ptr<Shape> shape);
  void define(Token name, std::shared_ptr<Material> material);
  void define(Token name, Camera camera);
  void define(Token name, Light light);
  /// The only one: a second is reported, and takes the first one's place.
  void define(Token name, EnvironmentLight environment);
  /// Whether a light or the environment has that name.
  bool is_light(Token name) const;
  /// Reports a reference to something that does not exist, with what was probably meant. Once for each name.
  template <class... Names>
  void report_undefined(Code code, std::string_view what, std::initializer_list<Kind> kinds, Token name,
                        Names const&... names) {
    auto const first = static_cast<std::size_t>(*kinds.begin());
    auto const [known, is_new] = undefined_[first].try_emplace(name, Diagnostics::no_finding);
    if (!is_new) return diagnostics_.add_again(known->second);
    std::string hint;
    for (Kind const kind : kinds) {
      if (hint.empty()) hint = defined_later(kind, name);
    }
    if (hint.empty()) hint = defined_as_another_kind(name);
    if (hint.empty()) hint = suggest(name, names...);
    error(code, name, std::string(what) + ' ' + in_quotes(name) + " is not defined", std::move(hint));
    known->second = diagnostics_.last();
  }

  /// "it is defined later, in line 7: statements run in order", or an empty text.
  std::string defined_later(Kind kind, Token name);

  /// Tells whoever wants to know (options.on_statement) what the current line did.
  void tell(EsdfStatement::Kind kind, std::string_view name) const;

  /// Adds the command, whose file is named `at` a part of the current line, to the scene, and draws it when somebody
  /// wants to see it drawn.
  void render(RenderCommand command, Token at);

 private:
  void execute();
  bool check_tokens(TokenTraits const& traits);
  /// Whether there are some, in a line that is to be `key=value`.
  bool report_spaces_around_equals();
  /// Whether there is one.
  bool report_unseen_character();
  /// Reports it, so that the rest of the line is read as if it were not there.
  void drop_semicolon();
  void report_duplicate(Kind kind, Token name);
  /// Before the current line, or from it on.
  enum class Lines { before, after };
  /// The first of these lines that defines `name`; 0: none found.
  std::size_t find_definition(Kind kind, Token name, Lines where);
  /// "'red' is a material, defined in line 1", for what is not of the kind that was looked for.
  std::string defined_as_another_kind(Token name);

  Diagnostics diagnostics_;
  Suggester suggester_;
  std::vector<Token> tokens_;
  std::unordered_set<std::string_view> faulty_[4];                  // by Kind
  std::unordered_map<std::string_view, std::size_t> undefined_[4];  // by Kind: what diagnostics_ calls the finding
  std::shared_ptr<Material> magenta_;
  std::shared_ptr<Material>* last_material_ = nullptr;
  DrawFunction const* draw_ = nullptr;
  std::size_t search_budget_ = std::size_t{1} << 28;  // bytes that find_definition may still read
  std::size_t stopped_at_ = 0;                        // the line at which there were too many errors
  bool has_bad_encoding_ = false;
  bool has_rendered_ = false;
  bool is_animated_ = false;
  bool is_stopped_ = false;
};

}  // namespace lichtraum::esdf
