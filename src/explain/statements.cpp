#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr Explanation statement_table[] = {
    {DiagnosticCode::unknown_statement,
     R"(A line starts with a word that is no statement. A statement starts with define,
transform, render, camera or ambient, in lower case; a comment starts with '#'.
)",
     R"(defin camera eye 45
)",
     R"(define camera eye 45
)"},
    {DiagnosticCode::unknown_definition,
     R"('define' is followed by a word that says what is defined: material, shape,
light, camera or background, in lower case. The kind of a shape comes after
'shape'.
)",
     R"(define materiel red  1 0 0  1 0 0  0 0 0  10
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
)"},
    {DiagnosticCode::wrong_count,
     R"(A statement has fewer or more arguments than it takes. The message says how many
it takes, how many there are, and what is probably missing. A comment at the end
of a line starts with '#'.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
)"},
    {DiagnosticCode::unknown_key,
     R"(A statement does not know the word before '='. The hint lists the keys that it
takes, or says that it takes none.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10  reflects=0.2
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10  reflect=0.2
)"},
    {DiagnosticCode::expected_key,
     R"(After its numbers a statement takes arguments of the form key=value only. Most
often there is one number or one word too many before this place, or '=' was
left out.
)",
     R"(define camera eye 45 aperture=0.1 3
)",
     R"(define camera eye 45 aperture=0.1 focus=3
)"},
    {DiagnosticCode::key_without_value,
     R"(Nothing follows '='. The value is written right after it, without a space.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10  reflect=
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10  reflect=0.2
)"},
    {DiagnosticCode::given_twice,
     R"(A statement has the same key or the same colour twice, and it is not clear which
one is meant. Leave one out.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10  reflect=0.2 reflect=0.3
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10  reflect=0.3
)"},
    {DiagnosticCode::spaces_around_equals,
     R"(Spaces separate arguments, so there are none around '='.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10  reflect = 0.2
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10  reflect=0.2
)"},
    {DiagnosticCode::color_with_equals,
     R"(The name of a colour, such as emission, is followed by three numbers: red, green
and blue. Only single numbers are written with '='.
)",
     R"(define material lamp  0 0 0  0 0 0  0 0 0  1  emission=4
)",
     R"(define material lamp  0 0 0  0 0 0  0 0 0  1  emission 4 4 4
)"},
    {DiagnosticCode::semicolon,
     R"(A statement ends with its line. Leave the semicolon out.
)",
     R"(define camera eye 45;
)",
     R"(define camera eye 45
)"},
    {DiagnosticCode::conflict_marker,
     R"(The file has a conflict that git left to you. Keep one of the two versions, or
what is right of both, and remove the lines with the markers.
)",
     R"(define camera eye 45
=======
)",
     R"(define camera eye 45
)"},
    {DiagnosticCode::placeholder,
     R"(The file is a template: what stands in double braces is to be replaced before
lichtraum reads it. Run the program that does so, or write the value yourself.
)",
     R"(define camera eye {{angle}}
)",
     R"(define camera eye 45
)"},
    {DiagnosticCode::control_character,
     R"(The line has a character that cannot be seen, such as escape or a zero byte, or
one that only looks like a blank, such as a no-break space. It often comes from
text that was copied from a terminal, a web page or a PDF, or from a damaged
file. Delete it, or write an ordinary space; many editors show such characters
when asked to. For example, text from a terminal that was in colour has an
escape, ^[, before [31m.
)",
     "", ""},
    {DiagnosticCode::not_utf8,
     R"(A name has bytes that are not UTF-8, most often because the file was saved as
Latin-1 or Windows-1252. It is read all the same, but messages and file names
may show wrong letters. Save the file as UTF-8. It is reported once per file.
For example, a u with two dots is the one byte FC in Latin-1.
)",
     "", ""},
    {DiagnosticCode::not_standard,
     R"(With --strict only the standard's forms are accepted, and this is one that
lichtraum knows besides. Write the standard's form, or leave --strict out.
docs/ESDF.md lists both.
)",
     R"(define light lamp  0 5 0  1 1 1
)",
     R"(define light diffuse lamp  0 5 0  1 1 1
)",
     "lichtraum check --strict scene.sdf"},
};
static_assert(explains_all(statement_table, "03"));

}  // namespace

std::span<Explanation const> statements() { return statement_table; }

}  // namespace lichtraum::explain
