"""Materials and lamps that eSDF does not have, and changes of scenes that were loaded."""

import json
import math
import os
import struct
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import lichtraum as lt

PROGRAM = os.path.join(os.path.dirname(lt.__file__), "bin", "lichtraum")
SIZE = {"size": (64, 48), "progress": False}
SCENE = """# a comment that stays
define material red 0.3 0 0  0.9 0.1 0.1  0.6 0.6 0.6  40
define material grey 0.3 0.3 0.3  0.5 0.5 0.5  0 0 0  1
define shape sphere ball 0 0 -5 1 red
define shape box floor -9 -2 -9 9 -1 0 grey
define shape composite both ball
define light diffuse sun 5 8 2  0.9 0.9 0.8
define light ambient sky 0.2 0.2 0.2
define camera eye 60
transform eye translate 0 0.5 0
render eye one.png 32 24
transform ball translate 0.2 0 0
render eye two.png 40 24
"""
GREEN = lt.Phong(ambient=0.2, diffuse=(0.1, 0.8, 0.1), reflect=0.2)


@pytest.fixture(scope="module")
def renderer():
    return lt.Renderer()


@pytest.fixture
def loaded(tmp_path):
    (tmp_path / "scene.sdf").write_text(SCENE)
    return lt.load(tmp_path / "scene.sdf")


def pixels(renderer, scene, **options):
    return np.array(renderer.render(scene, **SIZE, **options))


def move(scene):
    scene.shape("ball").translate((0.5, 0.3, 0))
    scene.shape("both").rotate(20, (0, 0, 1))
    scene.shape("ball").scale((1, 0.7, 1))


CHANGES = {
    "move": move,
    "material": lambda scene: scene.set_material("red", GREEN),
    "lamp": lambda scene: scene.set_light("sun", lt.Light.point((-5, 8, 2), (0.5, 0.5, 0.9))),
    "more light": lambda scene: scene.set_light("more", lt.Light.ambient(0.4)),
    "less light": lambda scene: scene.remove_light("sky"),
    "camera": lambda scene: scene.set_camera("eye", lt.Camera(40, eye=(2, 1, 0), target=(0, 0, -5), up=(0.1, 1, 0))),
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_change_is_seen_and_saved(renderer, loaded, change, tmp_path):
    before = pixels(renderer, loaded)
    change(loaded)
    after = pixels(renderer, loaded)
    assert not np.array_equal(before, after)
    assert np.array_equal(after, pixels(lt.Renderer(), loaded))  # nothing of the old scene is kept
    saved = tmp_path / "saved.sdf"
    loaded.save(saved)
    assert np.array_equal(after, pixels(renderer, saved))
    text = saved.read_text()
    assert text.startswith("# a comment that stays\n") and text.count("render ") == 1
    change_of_saved = lt.load(saved)
    assert change_of_saved.shapes == loaded.shapes


def test_all_changes_at_once(renderer, loaded, tmp_path):
    for change in CHANGES.values():
        change(loaded)
    loaded.save(tmp_path / "scene.sdf")  # over its own file
    assert np.array_equal(pixels(renderer, loaded), pixels(renderer, tmp_path / "scene.sdf"))


@pytest.mark.parametrize("make", [lambda: lt.load("scene.sdf"), lambda: lt.Scene([lt.Sphere((0, 0, -5), 1)])], ids=["loaded", "made"])
def test_saving_writes_where_links_lead_to_and_keeps_permissions(loaded, tmp_path, monkeypatch, make):
    monkeypatch.chdir(tmp_path)
    secret = tmp_path / "folder" / "secret.sdf"
    secret.parent.mkdir()
    secret.touch()
    secret.chmod(0o600)
    Path("link.sdf").symlink_to(secret)
    make().save("link.sdf")
    assert Path("link.sdf").is_symlink() and secret.stat().st_mode & 0o777 == 0o600
    assert lt.load(secret).cameras and os.listdir("folder") == ["secret.sdf"]
    assert sorted(os.listdir()) == ["folder", "link.sdf", "scene.sdf"]


def test_what_was_loaded_by_a_relative_name_is_saved_from_elsewhere(loaded, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    scene = lt.load("scene.sdf")
    Path("folder").mkdir()
    monkeypatch.chdir("folder")
    scene.save("saved.sdf")
    assert lt.load("saved.sdf").shapes == scene.shapes


def test_threads_save_to_one_file(loaded, tmp_path):
    scenes = [lt.load(tmp_path / "scene.sdf") for _ in range(4)]
    for number, scene in enumerate(scenes):
        scene.set_material("red", lt.Phong(diffuse=number / 4))

    def save(number):
        scenes[number % 4].save(tmp_path / "saved.sdf")
        return lt.load(tmp_path / "saved.sdf").shapes

    with ThreadPoolExecutor(8) as threads:
        assert all(shapes == loaded.shapes for shapes in threads.map(save, range(60)))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["saved.sdf", "scene.sdf"]


DIALECT = """\ufeff// material red is below\x0crender eye never.png
define material red 0.3 0 0  0.9 0.1 0.1  0.6 0.6 0.6  40 # render eye never.png
define material grey 0.3 0.3 0.3  0.5 0.5 0.5  0 0 0  1\r
define shape sphere eye 0 0 -5 1 red
define shape sphere ball 1 1 -5 1 grey
ambient 0.1 0.1 0.2
define ambient sky 0.1 0.1 0.1 2\rdefine light lamp 5 8 2  0.9 0.9 0.8 3
define light diffuse far -5 8 2  0.1 0.1 0.2
define camera other 60 32 24 0 0.5 0 0 0 -1
define camera second 30 aperture=0.1 focus=5
define transform other rotate 5 z
define transform second translate 0 0 4
define render other one.png samples=4
transform eye translate 0.2 0 0
define renderer second two.png 40 24 integrator=path
transform ball scale 2
"""


@pytest.mark.parametrize("change", [
    lambda s: s.shape("eye").rotate(30, (1, 2, 0.3)),
    lambda s: s.set_material("red", GREEN),
    lambda s: s.set_light("ambient light 1", lt.Light.ambient((0.3, 0, 0))),
    lambda s: s.remove_light("ambient light 1"),
    lambda s: s.set_light("sky", lt.Light.ambient(0.3)),
    lambda s: s.set_light("sky", lt.Light.point((1, 5, 3), 0.3, radius=0.5)),
    lambda s: [s.set_light("lamp", lt.Light.point((1, 9, 3), 0.3)), s.remove_light("sky")],
    lambda s: [s.remove_light("far"), s.set_light("more", lt.Light.point((1, 9, 3))), s.set_light("far", lt.Light.ambient(0.1))],
    lambda s: s.set_camera("other", lt.Camera(40, eye=(2, 1, 0), target=(0, 0, -5), up=(0.1, 1, 0))),
    lambda s: s.set_camera("other", lt.Camera(40, eye=(2, 1, 0), target=(0, 0, -5), orthographic=7.5)),
    lambda s: s.set_camera("second", lt.Camera(40, eye=(2, 1, 0), target=(0, 0, -5))),
])
def test_any_form_is_changed_where_it_stands(renderer, tmp_path, change):
    (tmp_path / "dialect.sdf").write_bytes(DIALECT.encode())
    scene = lt.load(tmp_path / "dialect.sdf")
    change(scene)
    scene.save(tmp_path / "saved.sdf")
    saved = tmp_path / "saved.sdf"
    for camera in (None, "other", "second"):
        how = {"camera": camera, "size": (64, 48), "progress": False}
        assert renderer.render(scene, **how).encoded("png") == renderer.render(saved, **how).encoded("png")
    kept = set(DIALECT.removeprefix("\ufeff").replace("\r", "\n").split("\n"))
    assert len(kept - set(saved.read_bytes().decode().split("\n"))) <= 4
    assert renderer.render(scene, progress=False).encoded("png") == renderer.render(saved, progress=False).encoded("png")


@pytest.mark.parametrize("change, message", [
    (lambda s: s.set_camera("ball", lt.Camera(40, eye=(0, 0, 2))), "another scene"),  # 'transform ball' moves the shape
    (lambda s: s.set_camera("a b", lt.Camera()), "no spaces"),
    (lambda s: s.set_light("ambient light 1", lt.Light.point((0, 5, 0))), "no spaces"),
    (lambda s: [s.remove_light("sky"), s.remove_light("lamp")], "another scene"),  # eSDF's tone map hangs on them
    (lambda s: Path(s.name).write_text(SCENE), "another scene"),
])
def test_what_would_be_another_scene_is_not_saved(tmp_path, monkeypatch, change, message):
    monkeypatch.chdir(tmp_path)
    Path("dialect.sdf").write_bytes(DIALECT.encode())
    scene = lt.load("dialect.sdf")
    change(scene)
    Path("saved.sdf").write_text("before")
    with pytest.raises(lt.UsageError, match=message):
        scene.save("saved.sdf")
    assert Path("saved.sdf").read_text() == "before" and sorted(os.listdir()) == ["dialect.sdf", "saved.sdf"]


def test_refused_save_names_the_line_that_is_wrong(tmp_path):
    text = SCENE.replace("0 0 0  1\n", "0 0 0  1 0.5\n").replace("render eye one", "transform nobody scale 2\nrender eye one")
    (tmp_path / "scene.sdf").write_text(text)
    with pytest.warns(lt.SceneWarning):
        scene = lt.load(tmp_path / "scene.sdf", keep_going=True)
    with pytest.raises(lt.UsageError, match="line 11 would be wrong: .*nobody"):
        scene.save(tmp_path / "saved.sdf")


def test_long_names_of_materials_are_still_found(renderer, tmp_path):
    name = "a_name_that_is_longer_than_what_a_string_holds_in_itself"
    (tmp_path / "long.sdf").write_text(SCENE.replace("red", name))
    scene = lt.load(tmp_path / "long.sdf")
    for color in (0.1, 0.9):
        scene.set_material(name, lt.Phong(diffuse=color))
    assert name in scene.materials
    scene.save(tmp_path / "saved.sdf")
    assert np.array_equal(pixels(renderer, scene), pixels(renderer, tmp_path / "saved.sdf"))


def test_another_camera(renderer, loaded):
    loaded.set_camera("above", lt.Camera(60, eye=(0, 5, -4), target=(0, 0, -5)))
    assert loaded.cameras == ["eye", "above"]
    assert not np.array_equal(pixels(renderer, loaded), pixels(renderer, loaded, camera="above"))


@pytest.mark.parametrize("change, message", [
    (lambda s: s.shape("nobody"), "no shape 'nobody'"),
    (lambda s: s.shape("ball").scale(0), "^factor: a scale factor must not be 0"),
    (lambda s: s.set_material("nobody", GREEN), "no material 'nobody'"),
    (lambda s: s.set_material("red", lt.Phong(reflect=0.9, transmit=0.9)), "transmit"),
    (lambda s: s.set_material("red", lt.Pbr(metallic=2)), "from 0 to 1"),
    (lambda s: s.set_material("red", lt.Pbr(ior=0.5)), "at least 1"),
    (lambda s: s.remove_light("nobody"), "no light 'nobody'"),
    (lambda s: s.set_camera("eye", lt.Camera(190)), "angle"),
    (lambda s: s.set_camera("eye", lt.Camera(orthographic=0)), "^orthographic: expected a number above 0"),
    (lambda s: lt.Light.spot((0, 0, 0), (0, 0, 0)), "^direction: expected a direction, not zero"),
    (lambda s: lt.Light.spot((0, 0, 0), (0, 0, 1), inner_degrees=50), "inner"),
    (lambda s: lt.Light.directional((0, 0, 0)), "^direction: expected a direction, not zero"),
])
def test_what_makes_no_sense_is_refused(renderer, loaded, change, message):
    before = pixels(renderer, loaded)
    with pytest.raises(lt.UsageError, match=message):
        change(loaded)
    assert np.array_equal(before, pixels(renderer, loaded))


def gltf_of(path, material, light):
    """A triangle and a lamp, written by hand."""
    corners = struct.pack("<9f", -2, -2, -5, 2, -2, -5, 0, 2, -5)
    (path.parent / "corners.bin").write_bytes(corners)
    path.write_text("""{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
      "nodes": [{"mesh": 0}, {"camera": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}, "rotation": [%s],
      "translation": [%s]}],
      "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1.3333, "znear": 0.1}}],
      "extensionsUsed": ["KHR_lights_punctual"], "extensions": {"KHR_lights_punctual": {"lights": [%s]}},
      "buffers": [{"uri": "corners.bin", "byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-2, -2, -5],
      "max": [2, 2, -5]}], "materials": [%s],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}]}""" % (*light, material))


def test_pbr_and_lamps_are_those_of_gltf(renderer, tmp_path):
    """The same material and lamp, from a file and from code."""
    material = '{"name": "m", "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.3, 0.1, 1], "metallicFactor": 0.4, "roughnessFactor": 0.3}}'
    plain = '{"name": "m"}'
    how = {"samples": 16, "denoise": "off"}
    lamps = [
        ("0, 0, 0, 1", "0, 0, 0", '{"name": "l", "type": "directional", "color": [1, 0.9, 0.8]}'),
        ("0, 0, 0, 1", "0, 0.5, 0", '{"name": "l", "type": "spot", "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.3}}'),
    ]
    for number, light in enumerate(lamps):
        wanted, base = tmp_path / f"wanted{number}.gltf", tmp_path / f"base{number}.gltf"
        gltf_of(wanted, material, light)
        gltf_of(base, plain, light)
        command = [PROGRAM, "info", wanted, "--json"]
        known = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)["lights"][0]
        if known["kind"] == "directional":
            made = lt.Light.directional((0, 0, -1), known["ld"])
        else:
            cone = {"inner_degrees": math.degrees(0.1), "outer_degrees": math.degrees(0.3)}
            made = lt.Light.spot((0, 0.5, 0), (0, 0, -1), known["ld"], **cone)
        scene, theirs = lt.load(base), pixels(renderer, wanted, **how)
        scene.set_material("m", lt.Pbr(base_color=(0.8, 0.3, 0.1), metallic=0.4, roughness=0.3))
        scene.set_light("l", lt.Light.point((0, 0, 5), 3))
        assert not np.array_equal(pixels(renderer, scene, **how), theirs)
        scene.set_light("l", made)
        np.testing.assert_allclose(pixels(renderer, scene, **how), theirs, rtol=1e-4, atol=1e-6)


def test_scene_with_pbr_and_lamps_is_drawn_but_not_saved(renderer, tmp_path):
    def scene(material, lamp):
        return lt.Scene([lt.Sphere((0, 0, -5), 1, material), lamp], camera=lt.Camera(40))

    rough, smooth = lt.Pbr(base_color=(1, 0.7, 0.3), metallic=1, roughness=0.9), lt.Pbr(metallic=1, roughness=0.1)
    sun, spot = lt.Light.directional((-1, -1, -1), 2), lt.Light.spot((0, 3, 0), (0, -3, -5), 30, outer_degrees=20)
    how = {"samples": 16, "denoise": "off"}
    drawn = [pixels(renderer, scene(*each), **how) for each in ((rough, sun), (smooth, sun), (rough, spot))]
    assert all(each.max() > 0.1 for each in drawn)
    assert not np.array_equal(drawn[0], drawn[1]) and not np.array_equal(drawn[0], drawn[2])
    image = renderer.render(scene(rough, sun), denoise="builtin", **SIZE)
    assert image.job["integrator"] == "path"
    for faulty, message in ((scene(rough, lt.Light.ambient()), "Pbr"), (scene(lt.Phong(), spot), "spot"), (scene(lt.Phong(), sun), "directional")):
        with pytest.raises(lt.UsageError, match=message):
            faulty.save(tmp_path / "scene.sdf")
    assert list(tmp_path.iterdir()) == []


def test_what_esdf_cannot_say_is_not_saved(loaded, tmp_path):
    target = tmp_path / "saved.sdf"
    loaded.set_light("spot", lt.Light.spot((0, 3, 0), (0, -1, 0)))
    with pytest.raises(lt.UsageError, match="no spot lamp"):
        loaded.save(target)
    loaded.remove_light("spot")
    loaded.save(target)
    loaded.set_material("red", lt.Pbr())
    with pytest.raises(lt.UsageError, match="Pbr"):
        loaded.save(tmp_path / "other.sdf")
    (tmp_path / "t.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    with pytest.raises(lt.UsageError, match="model"):
        lt.load(tmp_path / "t.obj").save(tmp_path / "other.sdf")
    (tmp_path / "mesh.sdf").write_text("define shape mesh t t.obj\n" + SCENE)
    (tmp_path / "below").mkdir()
    with pytest.raises(lt.UsageError, match="folder"):
        lt.load(tmp_path / "mesh.sdf").save(tmp_path / "below" / "other.sdf")
    lt.load(tmp_path / "mesh.sdf").save(tmp_path / "other.sdf")
    (tmp_path / "turned.sdf").write_text(SCENE.replace("translate 0 0.5 0", "rotate 10 0 1 0"))
    lt.load(tmp_path / "turned.sdf", rotation="right").save(tmp_path / "right.sdf")
    with pytest.raises(lt.UsageError, match="another scene: .* rotation"):
        lt.load(tmp_path / "turned.sdf", rotation="left").save(tmp_path / "left.sdf")
    assert not (tmp_path / "left.sdf").exists() and not list(tmp_path.glob("*.partial"))
    with pytest.raises(lt.FileError, match="nowhere"):
        lt.load(tmp_path / "scene.sdf").save(Path("/nowhere/scene.sdf"))


@pytest.mark.parametrize("name", ["with space/plain.gltf", "plain/with space.gltf", "a # b/c d.gltf"])
def test_model_whose_path_has_spaces(renderer, tmp_path, name):
    path = tmp_path / name
    path.parent.mkdir()
    gltf_of(path, '{"name": "m"}', ("0, 0, 0, 1", "0, 0, 0", '{"name": "l", "type": "directional"}'))
    other = tmp_path / "other" / "model.gltf"
    other.parent.mkdir()
    gltf_of(other, '{"name": "m"}', ("0, 0, 0, 1", "0, 0, 0", '{"name": "l", "type": "directional"}'))
    scenes = [lt.Scene([lt.Model(each), lt.Light.point((0, 3, 5))], camera=lt.Camera(60)) for each in (path, other)]
    mine, theirs = (pixels(renderer, scene, integrator="whitted") for scene in scenes)
    assert theirs.max() > 0.1 and np.array_equal(mine, theirs)
    with pytest.raises(lt.UsageError, match="spaces"):
        scenes[0].save(tmp_path / "scene.sdf")


def test_shape_that_is_scaled_beyond_numbers(tmp_path):
    (tmp_path / "a.sdf").write_text("define material m 1 1 1 1 1 1 1 1 1 1\ndefine shape sphere a 0 0 -5 1 m\ndefine camera eye 45\n")
    scene = lt.load(tmp_path / "a.sdf")
    scene.shape("a").scale(1e300)
    with pytest.raises(lt.UsageError, match="inverse"):
        lt.render(scene, size=(4, 4))
