"""What is told of mistakes: errors, warnings, and options that are refused."""

import copy
import errno
import os
import pickle
import warnings
from functools import partial
from pathlib import Path

import numpy as np
import pytest

import lichtraum as lt
from lichtraum._options import as_here

HELLO = Path(__file__).parents[2] / "scenes" / "hello.sdf"


@pytest.mark.parametrize("name, value", [
    ("time", 2), ("animation", 1), ("scene", 0), ("variant", "a"), ("max_texture", 64), ("point_size", 1), ("both_sides", True),
    ("strict", True), ("keep_going", True), ("transform_order", "local"), ("rotation", "left"), ("material_extras", "ignore"),
    ("allow_path", "/tmp"),
])
def test_what_was_loaded_is_not_read_again(renderer, film, name, value):
    scene = lt.load(film)
    for draw in (renderer.render, lt.render):
        with pytest.raises(lt.UsageError, match=f"^{name}: .*film.sdf.* give {name} to lt.load"):
            draw(scene, size=(8, 8), **{name: value})
    assert renderer.render(scene, size=(8, 8), **{name: None}).size == (8, 8)


def test_pictures_are_those_of_files(renderer, film):
    with pytest.raises(lt.UsageError, match="render the file for its picture 1"):
        renderer.render(lt.load(film), picture=1)
    for material in (lt.Phong(), lt.Pbr()):
        with pytest.raises(lt.UsageError, match="no picture 1: a Scene has one"):
            renderer.render(lt.Scene([lt.Sphere((0, 0, -5), 1, material)]), picture=1)


@pytest.mark.parametrize("material", [lt.Phong(), lt.Pbr()])
def test_scenes_are_read_as_asked(renderer, material):
    """By way of eSDF, whether that can say all of them or not."""
    shining = lt.Sphere((0, 0, -5), 1, lt.Phong(emission=1))
    with pytest.raises(lt.UsageError, match="emission"):
        renderer.render(lt.Scene([shining, lt.Sphere((9, 9, 9), 0.1, material)]), strict=True)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"up": (0, 0, 0)}, "up 0,0,0: it has no direction"),
        ({"focus": 3}, "focus: without a lens everything is sharp; aperture says"),
        ({"ground": True, "integrator": "whitted"}, "ground: whitted draws none; integrator='path' does"),
        ({"traversal": "deep"}, "traversal: expected auto, scalar, wide or packet, not 'deep'"),
    ],
)
def test_errors_name_options_as_python_does(options, message):
    with pytest.raises(lt.UsageError, match=f"^{message}"):
        lt.render(HELLO, size=(8, 8), **options)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("allow_path", ""), ("allow_path", [""]), ("allow_path", []), ("planes", []), ("planes", ""), ("camera", ""),
        ("samples", []), ("environment", ""), ("root", ""), ("device", ""), ("traversal", ""),
    ],
)
def test_empty_values_are_refused(name, value):
    """They were given the next option for a value."""
    with pytest.raises(lt.UsageError) as caught:
        lt.render(HELLO, **{name: value}, size=(32, 18))
    assert str(caught.value) == f"{name}: expected a value, not {value!r}"
    if name in ("device", "traversal"):
        with pytest.raises(lt.UsageError, match=f"^{name}: expected a value"):
            lt.Renderer(**{name: value})


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"time": 1}, "time has no effect: a scene's models stand as in their files"),
        ({"both_sides": True}, "both_sides has no effect"),
        ({"clamp": 3}, "clamp has no effect"),
        ({"environment_rotation": 3, "integrator": "path"}, "environment_rotation has no effect: the scene has no environment"),
    ],
)
def test_options_without_effect_are_told(renderer, options, message):
    with pytest.warns(lt.SceneWarning, match=message):
        image = renderer.render(HELLO, size=(8, 8), denoise="off", **options)
    assert [each.code for each in image.diagnostics] == ["W0101"]
    if "time" not in options and "both_sides" not in options:
        with pytest.warns(lt.SceneWarning, match=message):
            renderer.render(lt.load(HELLO), size=(8, 8), denoise="off", **options)


@pytest.mark.parametrize(
    ("options", "code", "message"),
    [
        ({"eye": (0, 50, 0), "look_at": (0, 90, 1)}, "W0816", "the camera 'eye' sees nothing: the scene is behind the camera"),
        ({"exposure": 9}, "W0823", r"% of what it shows is pure white \[W0823\]\n  hint: exposure=7 darkens it, and tonemap='neutral' shows"),
        ({"integrator": "path", "environment": "black.hdr"}, "W0815", "the picture is black: no light reaches"),
    ],
)
@pytest.mark.parametrize("is_loaded", [False, True])
def test_pictures_that_show_nothing_are_told(renderer, tmp_path, options, code, message, is_loaded):
    scene = tmp_path / "scene.sdf"
    lamp = "" if code == "W0815" else "define light ambient sky 0.5 0.5 0.5\n"
    scene.write_text("define material m 1 1 1 1 1 1 0 0 0 1\ndefine shape sphere ball 0 0 -5 1 m\ndefine camera eye 60 16 16\n" + lamp)
    (tmp_path / "black.hdr").write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + bytes(8))
    if "environment" in options:
        options = {**options, "environment": str(tmp_path / "black.hdr")}
    with pytest.warns(lt.SceneWarning, match=message):
        image = renderer.render(lt.load(scene) if is_loaded else scene, size=(16, 16), denoise="off", **options)
    assert [each.code for each in image.diagnostics] == [code]
    part = renderer.render(scene, size=(16, 16), region=(0, 0, 2, 2), eye=(0, 50, 0), look_at=(0, 90, 1))
    assert part.diagnostics == []  # of a region that may well be


def test_scenes_made_here_get_hints_in_python(renderer):
    dark = lt.Scene([lt.Sphere((0, 0, -5), 1)], camera=lt.Camera())
    with pytest.warns(lt.SceneWarning, match=r"nothing gives light.*\n  hint: Light.point\(\(10, 10, 10\)\) among its items$"):
        renderer.render(dark, size=(8, 8))
    far = lt.Scene([lt.Sphere((1e6, 0, -5), 1), lt.Light.point((1e6, 10, 10))])
    with pytest.warns(lt.SceneWarning, match=r"2 across and 1e\+06 from the origin.* are lost \[W0824\]\n  hint: move it.*by -1e\+06 0 5$"):
        renderer.render(far, size=(8, 8), eye=(1e6, 0, 0), look_at=(1e6, 0, -5))
    lit = lt.Scene([lt.Sphere((0, 0, -5), 1), lt.Light.point((10, 10, 10))], camera=lt.Camera())
    assert renderer.render(lit, size=(8, 8)).diagnostics == []


@pytest.mark.parametrize(
    ("here", "there"),
    [
        ("exposure=-2 darkens it, and tonemap='neutral' shows more", "--exposure -2 darkens it, and --tonemap neutral shows more"),
        ("integrator='path' environment='studio' lights it", "--integrator path --environment studio lights it"),
        ("environment_brightness=0.5.", "--environment-brightness 0.5."),
        ("both_sides shows them; size 640x480, region 0,0,9,9", "--both-sides shows them; --size 640x480, --region 0,0,9,9"),
        ("look_at and up, --json 1", "--look-at and --up, --json 1"),
    ],
)
def test_options_in_sentences_are_those_of_python(here, there):
    assert as_here(there) == here


def test_reading_warns_of_what_has_no_effect_there():
    with pytest.warns(lt.SceneWarning, match="time has no effect: a scene's models stand as in their files"):
        scene = lt.load(HELLO, time=1)
    assert [each.code for each in scene.diagnostics] == ["W0101"]


def test_options_with_an_effect_are_not(renderer):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert renderer.render(HELLO, size=(8, 8), integrator="path", samples=2, clamp=3, depth=2).diagnostics == []


def test_errors_say_where(tmp_path):
    path = tmp_path / "broken.sdf"
    path.write_text("define shpe sphere\nrender eye x.png\n")
    with pytest.raises(lt.SceneError, match="cannot define 'shpe'") as caught:
        lt.load(path)
    first = caught.value.diagnostics[0]
    assert (first.file, first.line, first.column, first.severity) == (str(path), 1, 8, "error")
    assert first.message == "cannot define 'shpe': unknown kind" and first.hint == "did you mean 'shape'?"
    with pytest.raises(lt.SceneError):
        lt.render(path)
    with pytest.raises(lt.FileError, match="nowhere.sdf"):
        lt.load(tmp_path / "nowhere.sdf")
    with pytest.raises(lt.FileError, match="-"):
        lt.load("-")  # a file, not standard input


@pytest.fixture
def errors(tmp_path):
    """One of each class."""
    (tmp_path / "broken.sdf").write_text("define shpe sphere\nrender eye x.png\n")
    uses = [
        lambda: lt.load(tmp_path / "broken.sdf"),
        lambda: lt.load(HELLO, time="x"),
        lambda: lt.load(tmp_path / "nowhere.sdf"),
        lambda: lt.Renderer("abacus"),
        lambda: lt.Scene().save("/nowhere/scene.sdf"),
    ]
    found = [lt.JobError("nobody answers", 75)]
    for use in uses:
        with pytest.raises(lt.Error) as caught:
            use()
        found.append(caught.value)
    return found


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, *(partial(lambda p, e: pickle.loads(pickle.dumps(e, p)), p) for p in range(2, 6))])
def test_errors_go_to_other_processes(errors, copied):
    for kind in (lt.SceneError, lt.UsageError, lt.FileError, lt.DeviceError, lt.JobError):
        assert any(isinstance(error, kind) for error in errors)
    for error in errors:
        other = copied(error)
        assert type(other) is type(error) and str(other) == str(error) and len(other.diagnostics) == len(error.diagnostics)
        assert [str(each) for each in other.diagnostics] == [str(each) for each in error.diagnostics]
        for mine, theirs in zip(error.diagnostics, other.diagnostics):
            for name in ("severity", "file", "line", "column", "code", "message", "hint", "source_line"):
                assert getattr(mine, name) == getattr(theirs, name)
        assert getattr(other, "status", 0) == getattr(error, "status", 0)


@pytest.mark.parametrize("use", [
    lt.load, lt.render, lt.Texture, lambda path: lt.render(HELLO, environment=path), lambda path: lt.render(lt.load(HELLO), environment=path),
    lambda path: lt.render(lt.Scene([lt.Model(path)])), lambda path: lt.render(lt.Scene([lt.Model(path, lt.Pbr())])), lambda path: lt.render(HELLO, size=(8, 8)).save(path), lambda path: lt.Scene().save(path), lambda path: lt.load(HELLO).save(path),
], ids=["load", "render", "texture", "map", "map of loaded", "model", "model with Pbr", "save", "scene.sdf", "loaded.sdf"])
@pytest.mark.parametrize("folder, number, kind", [("nowhere", errno.ENOENT, FileNotFoundError), ("file", errno.ENOTDIR, OSError)])
def test_errors_of_files_are_as_pythons(tmp_path, request, use, folder, number, kind):
    (tmp_path / "file").touch()
    extension = ".sdf" if ".sdf" in request.node.name else ".png"
    path = str(tmp_path / folder / "a") + extension
    with pytest.raises(lt.FileError) as caught:
        use(path)
    for error in (caught.value, pickle.loads(pickle.dumps(caught.value))):
        assert isinstance(error, kind)
        assert (error.errno, error.strerror, error.filename) == (number, os.strerror(number), path)
        assert str(error).startswith("cannot ") and path in str(error) and "Errno" not in str(error)


@pytest.mark.parametrize(
    "options, message",
    [
        ({"size": (0, 4)}, "^size: expected at least 1x1"),
        ({"integrator": "magic"}, "^integrator: expected whitted or path"),
        ({"look_at": (1, 2)}, "^look_at: expected"),
        ({"region": (0, 0, 9999, 1)}, "does not lie in the picture"),
        ({"camera": "nobody"}, "nobody"),
        ({"root": "nobody"}, "nobody"),
    ],
)
def test_wrong_values(renderer, options, message):
    with pytest.raises(lt.UsageError, match=message):
        renderer.render(HELLO, **options)


@pytest.mark.parametrize("name, message", [("sec\0.png", "NUL"), (os.fsdecode(b"\xff.png"), "UTF-8")])
def test_names_that_no_file_can_have(renderer, tmp_path, monkeypatch, name, message):
    """What is behind a NUL was cut off, and another file overwritten."""
    monkeypatch.chdir(tmp_path)
    Path("sec").write_text("dear to somebody")
    image = renderer.render(HELLO, size=(8, 8))
    for use in (image.save, lt.load, lt.render, lt.Texture, lt.Model):
        with pytest.raises(lt.UsageError, match=message):
            use(name)
    assert os.listdir() == ["sec"] and Path("sec").read_text() == "dear to somebody"


@pytest.mark.parametrize("use", [
    lambda: lt.render(HELLO, environment="studio\0"),
    lambda: lt.load(HELLO, allow_path=["/tmp", "/\0"]),
    lambda: lt.load(HELLO).save("a\0.sdf"),
    lambda: lt.Scene().save("a\0.sdf"),
])
def test_nul_is_refused(tmp_path, monkeypatch, use):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ValueError, match="NUL|null"):
        use()
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("options", "name", "how", "message"),
    [
        ({"planes": "radiance,depth"}, "a.png", {}, "planes radiance,depth: '{}' has room for one; .exr has for all"),
        ({"planes": "depth,normal"}, "a.pfm", {}, "planes normal,depth: '{}' has room for one; .exr has for all"),
        ({"background": "none"}, "a.jpg", {}, "'{}' cannot be transparent: .png and .exr pictures can"),
        ({"background": "none"}, "a.pfm", {}, "'{}' cannot be transparent: .png and .exr pictures can"),
        ({}, "a.jpg", {"bits": 16}, "bits=16: '{}' has 8 bits per channel; .png and .ppm have 16"),
    ],
)
def test_what_a_format_cannot_hold_is_refused(renderer, tmp_path, monkeypatch, options, name, how, message):
    monkeypatch.chdir(tmp_path)
    image = renderer.render(HELLO, size=(8, 8), **options)
    for use, shown in ((image.save, name), (image.encoded, name[2:])):
        with pytest.raises(lt.UsageError) as caught:
            use(shown, **how)
        assert str(caught.value) == message.format(shown)
    assert not os.listdir()
    image.save("a.exr")
    assert image._repr_png_().startswith(b"\x89PNG")  # which only shows


def test_no_picture_takes_the_place_of_what_it_is_drawn_from(renderer, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    for name in ("map.exr", "wood.png"):
        renderer.render(HELLO, size=(8, 8)).save(name)
    Path("scene.sdf").write_bytes(HELLO.read_bytes())
    Path("model.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    Path("link.png").symlink_to("map.exr")
    lit = {"size": (8, 8), "integrator": "path", "environment": "map.exr", "denoise": "off"}
    model = lt.Model("model.obj", lt.Pbr(base_color_texture=lt.Texture("wood.png")))
    model.translate((0, 0, -5))
    files = {"scene.sdf", "map.exr", "link.png"}
    drawn = [
        (renderer.render("scene.sdf", **lit), files),
        (renderer.render("scene.sdf", **lit), files),  # the map is not read again
        (renderer.render(lt.load("scene.sdf"), **lit), files),
        (renderer.render(lt.Scene([model]), **lit), {"model.obj", "wood.png", "map.exr", "link.png"}),
    ]
    Path("scene.sdf").rename("old.sdf")
    Path("scene.sdf").write_bytes(HELLO.read_bytes())  # as editors do
    before = {path: path.read_bytes() for path in tmp_path.glob("*.*")}
    monkeypatch.chdir(tmp_path / "folder")
    for image, names in drawn:
        for name in names:
            with pytest.raises(lt.FileError) as caught:
                image.save(f"../{name}", format="png")
            assert str(caught.value) == f"'../{name}' is read for this picture, which would take its place: give the picture another name"
    assert {path: path.read_bytes() for path in tmp_path.glob("*.*")} == before


@pytest.mark.parametrize("folder", ["plain", "with space"])
def test_models_of_scenes_are_named_as_they_were_given(renderer, tmp_path, folder):
    path = tmp_path / folder / "model.obj"
    model = lt.Scene([lt.Model(path), lt.Light.ambient()])
    with pytest.raises(FileNotFoundError, match=f"^cannot read '{path}': No such file or directory$") as missing:
        renderer.render(model)
    assert isinstance(missing.value, lt.FileError) and missing.value.filename == str(path)
    path.parent.mkdir()
    path.write_text("nothing")
    with pytest.raises(lt.FileError) as empty:
        renderer.render(model)
    assert str(empty.value) == f"cannot read '{path}': the model has nothing to draw: it has no triangles, lines or points"


@pytest.mark.parametrize(
    ("use", "message"),
    [
        (lambda: lt.Phong(diffuse="#ff0000"), "diffuse: expected a number or three for a colour, not '#ff0000'"),
        (lambda: lt.Pbr(base_color=None), "base_color: expected a number or three for a colour, not None"),
        (lambda: lt.Sphere("abc", 1), "center: expected three numbers, not 'abc'"),
        (lambda: lt.Sphere((0, 0, 0), "1"), "radius: expected a number, not '1'"),
        (lambda: lt.Camera("wide"), "fov_x_degrees: expected a number, not 'wide'"),
        (lambda: lt.Camera(size=("a", 1)), "size: expected a whole number, not 'a'"),
        (lambda: lt.Camera(size=640), "size: expected width and height in pixels, not 640"),
        (lambda: lt.Phong(reflect="all"), "reflect: expected a number, not 'all'"),
        (lambda: lt.Pbr(roughness=None), "roughness: expected a number, not None"),
        (lambda: lt.Pbr(normal_texture="a.png"), "normal_texture: expected a lichtraum.Texture, not 'a.png'"),
        (lambda: lt.render(HELLO, picture="0"), "picture: expected a whole number, not '0'"),
        (lambda: lt.render(HELLO, size=(8, 8)).save("a.png", bits=8.0), "bits: expected a whole number, not 8.0"),
        (lambda: lt.render(HELLO, size=(8, 8)).encoded(quality="9"), "quality: expected a whole number, not '9'"),
        (lambda: lt.render(HELLO, size=(8, 8)).encoded(3), "format: expected a text, not 3"),
        (lambda: lt.render(HELLO, size=(8, 8)).encoded("ppm", ppm_ascii=1), "ppm_ascii: expected True or False, not 1"),
        (lambda: lt.render(HELLO, size=(8, 8)).save(3), "expected the name of a file, not 3"),
        (lambda: lt.load(None), "expected the name of a file, not None"),
        (lambda: lt.Scene().save(3), "expected the name of a file, not 3"),
        (lambda: lt.Model(3), "expected the name of a file, not 3"),
        (lambda: lt.render(3), "scene: expected a file's name, a LoadedScene or a Scene, not 3"),
        (lambda: lt.render(HELLO, progress="no"), "progress: expected True, False or a function, not 'no'"),
        (lambda: lt.render(HELLO, eye=b"abc"), "eye: expected a number or a text, not b'abc'"),
        (lambda: lt.render(HELLO, size=(8, None)), "size: expected a number or a text, not None"),
        (lambda: lt.render(HELLO, allow_path=3), "allow_path: expected a folder, or a list of them, not 3"),
        (lambda: lt.Scene(3), "items: expected a list of shapes and lights, not 3"),
        (lambda: lt.Group(3), "children: expected a list of shapes and groups, not 3"),
        (lambda: lt.Scene([lt.Light.ambient(name=3)]).save("a.sdf"), "name: expected a text, not 3"),
        (lambda: lt.Mesh(len, [(0, 1, 2)]), f"vertices: expected an array of numbers, not {len!r}"),
        (lambda: lt.Texture(np.zeros((1, 1), dtype=np.uint8), wrap=3), "wrap: expected a text, not 3"),
        (lambda: lt.Texture("a.png", filter=None), "filter: expected a text, not None"),
        (lambda: lt.load(HELLO).shape(3), "name: expected a text, not 3"),
        (lambda: lt.load(HELLO).set_material(3, lt.Phong()), "name: expected a text, not 3"),
        (lambda: lt.load(HELLO).set_light(3, lt.Light.ambient()), "name: expected a text, not 3"),
        (lambda: lt.load(HELLO).remove_light(3), "name: expected a text, not 3"),
        (lambda: lt.load(HELLO).set_camera(3, lt.Camera()), "name: expected a text, not 3"),
    ],
)
def test_values_of_another_kind_are_type_errors(use, message):
    with pytest.raises(TypeError) as caught:
        use()
    assert str(caught.value) == message


def test_names_of_files_may_be_bytes(renderer, tmp_path):
    for thing, name in ((renderer.render(os.fsencode(HELLO), size=(8, 8)), b"a.png"), (lt.Scene(), b"a.sdf"), (lt.load(HELLO), b"b.sdf")):
        thing.save(os.fsencode(tmp_path) + b"/" + name)
    assert sorted(os.listdir(tmp_path)) == ["a.png", "a.sdf", "b.sdf"]


def test_numbers_that_are_too_large_are_told(renderer):
    for use, name in (
        (lambda: renderer.render(HELLO, picture=2**31), "picture"),
        (lambda: renderer.render(HELLO, size=(8, 8)).encoded(quality=2**40), "quality"),
        (lambda: lt.Camera(size=(2**31, 1)), "size"),
    ):
        with pytest.raises(lt.UsageError, match=f"^{name}: expected a whole number below 2147483648, not "):
            use()


def test_numbers_may_be_numpys(renderer):
    wanted = renderer.render(HELLO, size=(8, 9), exposure=-1.5, eye=(0, 1, 9))
    for number in (np.array, np.float32, np.float64):
        eye = [number(0), number(1), number(9)]
        image = renderer.render(HELLO, picture=np.int64(0), size=(np.array(8), np.int8(9)), exposure=number(-1.5), eye=eye, strict=np.False_)
        assert image.encoded(bits=np.int32(8)) == wanted.encoded()


def test_unknown_names(renderer):
    with pytest.raises(TypeError, match="no option 'sizes'"):
        renderer.render(HELLO, sizes=(1, 1))
    with pytest.raises(TypeError, match="^'size' does not affect how a file is read: pass it to render$"):
        lt.load(HELLO, size=(1, 1))
    with pytest.raises(TypeError, match="^seed cannot be True or False"):
        renderer.render(HELLO, seed=True)
    with pytest.raises(lt.DeviceError, match="abacus"):
        lt.Renderer("abacus")


@pytest.fixture
def doubtful(film):
    """A file whose first line is warned of."""
    film.write_text(film.read_text().replace("40\ndefine shape", "40 0.5\ndefine shape"))
    return film


def test_what_a_scene_warns_of_is_a_warning(doubtful):
    with pytest.warns(lt.SceneWarning, match="film.sdf:1"):
        lt.load(doubtful)


def test_warnings_name_the_line_that_called(tmp_path, renderer, doubtful, child):
    dim = lt.Scene([lt.Sphere((0, 0, -5), 1, lt.Phong(diffuse=-1))])
    shiny = lt.Scene([lt.Sphere((0, 0, -5), 1, lt.Phong(diffuse=-1)), lt.Sphere((0, 0, -5), 1, lt.Pbr())])
    uses = [lambda: lt.load(doubtful)]
    for scene in (doubtful, dim, shiny):
        uses += [lambda scene=scene: lt.render(scene, size=(8, 8)), lambda scene=scene: renderer.render(scene, size=(8, 8))]
    for use in uses:
        with pytest.warns(lt.SceneWarning) as found:
            use()
        assert {warning.filename for warning in found} == {__file__}
    run = child("import lichtraum as lt; lt.Renderer()", OCL_ICD_VENDORS=str(tmp_path), OCL_ICD_FILENAMES="")
    assert run.stderr.startswith("<string>:1: SceneWarning: ") and "reference tracer" in run.stderr
