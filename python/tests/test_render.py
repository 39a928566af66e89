"""Pictures, drawn by the package and by the program."""

import os
import signal
import subprocess
import sys
import threading
import time
import warnings
from pathlib import Path

import numpy as np
import pytest

import lichtraum as lt

ROOT = Path(__file__).parents[2]
HELLO = ROOT / "scenes" / "hello.sdf"
PROGRAM = os.path.join(os.path.dirname(lt.__file__), "bin", "lichtraum")

OPTIONS = [
    {},
    {"samples": 16, "seed": 3},
    {"samples": (2, 2), "exposure": -0.5, "tonemap": "agx", "transfer": "srgb"},
    {"integrator": "path", "samples": 16, "denoise": "builtin", "ground": "glossy", "clamp": 3.5},
    {"orbit": (-35, 20), "fov_y": 40, "background": ((0, 0, 1), (1, 0, 0))},
    {"background": "none", "region": (3, 2, 40, 20)},
    {"integrator": "path", "samples": 32, "environment": "studio", "environment_rotation": -90, "denoise": False},
    {"eye": np.array([1, 2, 8.5]), "look_at": (0, 1, 0), "aperture": 0.2, "samples": 16},
    {"integrator": "path", "noise": 0.5, "denoise": "off"},
]


def words(options):
    """Written out once more, so that what the package makes of keywords is not compared with itself."""
    text = {
        "samples": {16: "16", 32: "32", (2, 2): "2x2"},
        "background": {((0, 0, 1), (1, 0, 0)): "0,0,1,1,0,0", "none": "none"},
        "region": {(3, 2, 40, 20): "3,2,40,20"},
        "orbit": {(-35, 20): "-35,20"},
        "look_at": {(0, 1, 0): "0,1,0"},
        "denoise": {False: "off"},
    }
    for name, value in options.items():
        if name == "eye":
            yield "--eye=1,2,8.5"
            continue
        yield f"--{name.replace('_', '-')}={text.get(name, {}).get(value, value)}"


@pytest.mark.parametrize("extension", ["png", "exr"])
@pytest.mark.parametrize("options", OPTIONS, ids=lambda options: ",".join(options) or "plain")
def test_files_are_those_of_the_program(renderer, tmp_path, options, extension):
    mine, other = tmp_path / f"mine.{extension}", tmp_path / f"other.{extension}"
    renderer.render(HELLO, size=(64, 36), progress=False, **options).save(mine)
    command = [PROGRAM, "render", str(HELLO), "--size=64x36", f"--output={other}", "--quiet", *words(options)]
    subprocess.run(command, check=True)
    assert mine.read_bytes() == other.read_bytes()


@pytest.mark.parametrize("keywords, option", [({"bits": 16}, "--bits=16"), ({"format": "ppm", "ppm_ascii": True}, "--ppm-ascii")])
def test_save_has_the_options_of_the_program(renderer, tmp_path, keywords, option):
    name = "picture." + keywords.get("format", "png")
    renderer.render(HELLO, size=(16, 9)).save(tmp_path / name, **keywords)
    other = tmp_path / ("other" + name)
    subprocess.run([PROGRAM, "render", HELLO, "--size=16x9", f"--output={other}", "--quiet", option], check=True)
    assert (tmp_path / name).read_bytes() == other.read_bytes()


def test_each_option_of_the_program_is_a_keyword_or_named_here():
    help_text = subprocess.run([PROGRAM, "render", "--help"], check=True, capture_output=True, text=True).stdout
    from lichtraum import _native
    from lichtraum._options import RenderOptions

    assert set(RenderOptions.__annotations__) == {name.replace("-", "_") for name in _native.option_names()}
    of_save = {"output", "format", "bits", "quality", "ppm-ascii"}
    of_programs = {"output-dir", "show", "json", "frames", "fps", "turntable", "resume", "format-in", "help", "quiet", "verbose"}
    there = {line.split("--", 1)[1].split()[0].split("=")[0].rstrip(",") for line in help_text.splitlines() if line.strip().startswith("-") and "--" in line}
    there = {name.split("[")[0] for name in there}
    assert there == set(_native.option_names()) | of_save | of_programs


def test_array_is_linear_and_shared(renderer):
    image = renderer.render(HELLO, size=(64, 36))
    pixels = np.asarray(image)
    assert pixels.shape == (36, 64, 3) and pixels.dtype == np.float32 and not pixels.flags.writeable
    assert np.shares_memory(pixels, np.asarray(image)) and np.shares_memory(pixels, np.from_dlpack(image))
    assert np.array_equal(pixels, image.planes["radiance"])
    brighter = renderer.render(HELLO, size=(64, 36), exposure=1, tonemap="none")
    assert np.array_equal(np.asarray(brighter), pixels)
    np.testing.assert_array_equal(brighter.developed, 2 * pixels)
    del image
    assert pixels.max() > 0.5  # the picture's memory stays
    assert np.array(brighter, dtype=np.float64).dtype == np.float64


def test_planes(renderer):
    image = renderer.render(HELLO, size=(64, 36), planes=["radiance", "depth", "normal", "object"])
    assert list(image.planes) == ["radiance", "normal", "depth", "object"]
    depth, normal, number = (image.planes[name] for name in ("depth", "normal", "object"))
    assert depth.shape == number.shape == (36, 64) and normal.shape == (36, 64, 3)
    assert number.dtype == np.uint32 and depth.dtype == np.float32
    assert np.array_equal(np.isinf(depth), number == 0)
    np.testing.assert_allclose(np.linalg.norm(normal[number > 0], axis=-1), 1, atol=1e-5)
    with pytest.raises(KeyError, match="albedo.*there are: radiance"):
        image.planes["albedo"]
    with pytest.raises(lt.UsageError, match="^the picture has no radiance: planes= asked only for others$"):
        np.asarray(renderer.render(HELLO, size=(8, 8), planes="depth"))


def test_png_shows_itself(renderer):
    assert renderer.render(HELLO, size=(8, 8))._repr_png_().startswith(b"\x89PNG\r\n\x1a\n")


def test_scene_that_was_loaded_is_drawn_as_its_file(renderer, film):
    scene = lt.load(HELLO)
    for options in ({}, {"integrator": "path", "samples": 16, "environment": "studio"}, {}):
        assert np.array_equal(renderer.render(scene, size=(48, 27), **options), renderer.render(HELLO, size=(48, 27), **options))
    assert renderer.render(film).size == (32, 24)
    assert renderer.render(film, picture=1).size == (40, 24)
    assert not np.array_equal(renderer.render(film, size=(8, 8)), renderer.render(film, picture=1, size=(8, 8)))
    assert np.array_equal(renderer.render(lt.load(film), size=(8, 8)), renderer.render(film, picture=1, size=(8, 8)))
    with pytest.raises(lt.UsageError, match="no picture 2"):
        renderer.render(film, picture=2)


def test_model_that_was_loaded_is_drawn_as_its_file(renderer, tmp_path):
    path = tmp_path / "triangle.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    model = lt.load(path)
    for options in ({}, {"integrator": "whitted"}, {}):
        options |= {"size": (32, 32)}
        assert np.array_equal(renderer.render(model, **options), renderer.render(path, **options))
    assert renderer.render(model, size=(8, 8)).job["integrator"] == "path"


def test_model_has_an_option_that_is_called_as_the_first_argument(renderer, tmp_path):
    path = tmp_path / "two.gltf"
    path.write_text('{"asset": {"version": "2.0"}, "scenes": [{"nodes": []}], "nodes": []}')
    for use in (lambda: renderer.render(path, scene=5), lambda: lt.load(path, scene=5)):
        with pytest.raises(lt.Error, match="5"):
            use()


@pytest.mark.parametrize("integrator", ["whitted", "path"])
def test_what_is_up_is_forgotten_after_a_picture(renderer, tmp_path, integrator):
    model = tmp_path / "pyramid.obj"
    model.write_text("v -1 0 1\nv 1 0 1\nv 0 0 -1\nv 0.3 2 0\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
    scene = lt.load(model)
    how = {"size": (32, 24), "eye": (3, 1, 6), "integrator": integrator, "samples": 4, "denoise": "off"}
    before = np.asarray(renderer.render(scene, **how))
    assert not np.array_equal(np.asarray(renderer.render(scene, up=(1, 0, 1), **how)), before)
    assert np.array_equal(np.asarray(renderer.render(scene, **how)), before)


def test_interrupt_stops(renderer):
    renderer.render(HELLO, size=(64, 36), samples=16)

    def interrupt():
        time.sleep(0.5)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        renderer.render(HELLO, size=(4096, 4096), samples=4096)
    thread.join()
    assert renderer.render(HELLO, size=(8, 8)).size == (8, 8)


@pytest.fixture
def stuck(tmp_path):
    """A file that whoever opens it waits for until the test ends, or for ten seconds."""
    path = tmp_path / "stuck.sdf"
    os.mkfifo(path)
    ended, released = threading.Event(), threading.Event()

    def let_go():
        ended.wait(10)
        released.set()
        while any(thread.name == "lichtraum" for thread in threading.enumerate()):
            try:
                os.close(os.open(path, os.O_WRONLY | os.O_NONBLOCK))
            except OSError:  # nobody waits for it at the moment
                time.sleep(0.01)

    thread = threading.Thread(target=let_go)
    thread.start()
    yield path, released
    ended.set()
    thread.join()


def interrupt_in(seconds):
    threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT)).start()


@pytest.mark.parametrize("use", [lt.load, lambda path: lt.Renderer().render(path)], ids=["load", "render"])
def test_interrupt_while_a_file_is_read(stuck, use):
    path, released = stuck
    interrupt_in(0.5)
    with pytest.raises(KeyboardInterrupt):
        use(path)
    assert not released.is_set()  # it did not wait for the file


def test_interrupt_while_noise_is_taken_out(renderer, stuck, monkeypatch):
    path, released = stuck
    monkeypatch.setenv("LICHTRAUM_OIDN", str(path))
    renderer.render(HELLO, size=(64, 36), samples=16, denoise="off")
    interrupt_in(2)  # long after tracing
    with pytest.raises(KeyboardInterrupt):
        renderer.render(HELLO, size=(64, 36), samples=16, denoise="on")
    assert not released.is_set()


def test_other_threads_run_and_progress_is_told(renderer):
    shown, ran, done = [], [], threading.Event()

    def work():
        while not done.wait(0.001):
            ran.append(len(shown))

    thread = threading.Thread(target=work)
    thread.start()
    renderer.render(HELLO, size=(1280, 720), samples=64, progress=shown.append)
    done.set()
    thread.join()
    assert len(ran) > 10
    assert shown == sorted(shown) and all(0 < fraction <= 1 for fraction in shown) and len(shown) > 1
    assert shown[-1] == 1 and shown.count(1) == 1


@pytest.mark.parametrize("scene", [HELLO, lt.load(HELLO), lt.Scene([lt.Sphere((0, 0, -5), 1), lt.Light.ambient()])], ids=["file", "loaded", "made"])
def test_progress_ends_with_all(renderer, scene):
    shown = []
    renderer.render(scene, size=(8, 8), progress=shown.append)
    assert shown[-1] == 1 and shown.count(1) == 1
    with pytest.raises(lt.UsageError):
        renderer.render(scene, size=(8, 8), camera="nobody", progress=shown.append)
    assert shown.count(1) == 1  # not of what failed


def test_what_progress_raises_comes_out(renderer):
    def refuse(_):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        renderer.render(HELLO, size=(2048, 2048), samples=1024, progress=refuse)


def test_without_opencl_the_reference_tracer_draws(tmp_path):
    code = (
        "import warnings, lichtraum as lt\n"
        "with warnings.catch_warnings(record=True) as found:\n"
        "    warnings.simplefilter('always')\n"
        f"    image = lt.render({str(HELLO)!r}, size=(16, 9))\n"
        "assert len(found) == 1 and 'reference tracer' in str(found[0].message), found\n"
        "print(image.size, image.statistics['device'])\n"
    )
    environment = {**os.environ, "OCL_ICD_VENDORS": str(tmp_path), "OCL_ICD_FILENAMES": ""}
    run = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)
    assert run.returncode == 0 and run.stdout.startswith("(16, 9)"), run.stderr


DRAW = f"import lichtraum as lt; print(lt.render({str(HELLO)!r}, size=(16, 9)).size)"


FORK = f"""
import os, signal, warnings
import lichtraum as lt
warnings.simplefilter("ignore")
def draw(renderer=None):
    return (renderer or lt.Renderer()).render({str(HELLO)!r}, size=(16, 9)).size
def in_child(use):
    if child := os.fork():
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    signal.alarm(60)  # if it hangs
    try:
        use()
    except lt.DeviceError as error:
        os._exit(3 if "spawn" in str(error) else 4)
    os._exit(0)
"""


def test_forked_process_is_told_that_it_cannot_draw(child):
    code = FORK + (
        "before = in_child(draw)\n"
        "renderer = lt.Renderer()\n"
        "draw(renderer)\n"
        "print(before, in_child(draw), in_child(lambda: draw(renderer)), in_child(lambda: draw(lt.Renderer('reference'))))\n"
        "print(draw(), draw(renderer))\n"
    )
    run = child(code)
    no_device = "reference" in lt.Renderer().device
    told = "0 0 0 0" if no_device else "0 3 3 0"
    assert run.stdout == f"{told}\n(16, 9) (16, 9)\n", run.stdout + run.stderr


def test_without_the_loader_of_opencl_importing_says_what_to_install(tmp_path, child):
    (tmp_path / "libOpenCL.so.1").touch()  # found first, and not one
    run = child(DRAW, LD_LIBRARY_PATH=str(tmp_path))
    assert run.returncode == 1 and "ImportError: lichtraum needs OpenCL's loader" in run.stderr, run.stderr
    assert "ocl-icd-libopencl1" in run.stderr


def test_denoiser_is_looked_for_where_the_program_does(renderer):
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        image = renderer.render(HELLO, size=(16, 9), samples=16, denoise="on")
    told = subprocess.run([PROGRAM, "doctor"], capture_output=True, text=True).stdout
    assert f"denoising (--denoise on): {image.statistics['denoiser']}\n" in told
    place = Path(PROGRAM).resolve().parents[1] / "lib" / "lichtraum" / "oidn" / "lib"
    assert not found or str(place) in str(found[0].message)


def test_module_is_the_program():
    run = subprocess.run([sys.executable, "-m", "lichtraum", "--version"], capture_output=True, text=True, check=True)
    assert run.stdout == f"lichtraum {lt.__version__}\n"
