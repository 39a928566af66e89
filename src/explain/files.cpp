#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr Explanation file_table[] = {
    {DiagnosticCode::not_a_scene,
     R"(The file is not an eSDF scene: its first bytes are those of a picture, an office
document, a web page or an archive. Often a scene was saved by a word processor,
or a web page in its place. Save it as plain text in UTF-8, and check that you
named the right file.
)",
     R"(<!DOCTYPE html>
<title>scene.sdf</title>
)",
     R"(define camera eye 45
)"},
    {DiagnosticCode::file_outside,
     R"(A scene may use files in its own folder and in folders below it, so that a scene
from somebody else cannot read whatever it likes. Its pictures go to the folder
that lichtraum runs in, or that of --output-dir, and below it. Move the file
there, or permit its folder with --allow-path.
)",
     R"(define shape mesh teapot ../teapot.obj
)",
     R"(define shape mesh teapot teapot.obj
)"},
    {DiagnosticCode::unreadable_file,
     R"(A file that the scene names does not exist, cannot be opened, or is faulty; the
message says which. Names are relative to the scene's folder, and upper and
lower case differ.
)",
     R"(define shape mesh teapot Teapod.obj
)",
     R"(define shape mesh teapot teapot.obj
)"},
    {DiagnosticCode::unread_format,
     R"(The file is a model in a format that lichtraum does not read. It reads glTF
(.gltf, .glb), Wavefront OBJ, PLY and STL. The hint names a program that
converts the model, where there is one.
)",
     R"(define shape mesh robot robot.fbx
)",
     R"(define shape mesh robot robot.obj
)"},
    {DiagnosticCode::too_many_findings,
     R"(Only the first 100 findings are shown. After 100 errors the rest of the file is
not even read, unless there is --keep-going. Mend the first ones and check
again: one mistake, such as a missing material, often leads to many. For
example, a scene of 200 spheres of a material that is misspelt where it is
defined has 200 errors.
)",
     "", ""},
    {DiagnosticCode::missing_input,
     R"(A file that the command line names does not exist, or may not be read. The
message says why. Check its name and the folder that you are in; a name that
begins with '-' comes after '--'. For example, lichtraum render helo.sdf, where
the file is called hello.sdf.
)",
     "", ""},
    {DiagnosticCode::unwritable_output,
     R"(A picture cannot be written to its place: the folder does not exist or may not
be written to, or a folder has the name of the file. The message says which. -o
and --output-dir choose another place. For example, -o pictures/a.png, where
there is no folder called pictures.
)",
     "", ""},
    {DiagnosticCode::failed_transfer,
     R"(Reading or writing began and could not be finished. Most often the disk is full,
or the program that lichtraum writes to has ended. A picture that was there
before is still whole. For example, a file system that is mounted from another
machine goes away while a film is drawn.
)",
     "", ""},
    {DiagnosticCode::try_again,
     R"(Something that a job needs is not there now, but may be later: units that others
have not drawn yet, a file in a shared folder, or room on the disk. Nothing is
lost. Run the command again later, or let the queue do so; the exit status is
75. For example, lichtraum job merge while a machine still draws.
)",
     "", ""},
};
static_assert(explains_all(file_table, "02"));

}  // namespace

std::span<Explanation const> files() { return file_table; }

}  // namespace lichtraum::explain
