"""Scenes that are made in Python."""

import copy
import math
import os
import pickle
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import lichtraum as lt

PROGRAM = os.path.join(os.path.dirname(lt.__file__), "bin", "lichtraum")
SIZE = {"size": (64, 48), "progress": False}
RED = lt.Phong(ambient=0.2, diffuse=(0.9, 0.1, 0.1), specular=0.5, exponent=40, reflect=0.3)
HELLO = Path(__file__).parents[2] / "scenes" / "hello.sdf"
CUBE = lt.Box((-1, -1, -1), (1, 1, 1))


@pytest.fixture(scope="module")
def renderer():
    return lt.Renderer()


def everything():
    shared = lt.Sphere((0, 0, 0), 0.4, lt.Phong(diffuse=0.1, transmit=0.8, ior=1.5))
    pair = lt.Group([shared, lt.Cone((1, 0, 0), (1, 1, 0), 0.3, RED)], name="pair")
    pair.rotate(30, (0, 1, 0))
    pair.translate((0, 0, -5))
    again = lt.Group([pair, shared])
    again.scale((1, 0.5, 1))
    triangles = lt.Mesh([(-1, 0, -6), (1, 0, -6), (0, 1.5, -6)], [(0, 1, 2)], RED)
    cylinder = lt.Cylinder((-2, -1, -6), (-2, 1, -6), 0.4)
    floor = lt.Plane((0, -1, 0), (0, 1, 0), lt.Phong(emission=(0.1, 0, 0)))
    items = [again, triangles, cylinder, floor, lt.Box((1, -1, -7), (2, 0, -6), RED)]
    lights = [lt.Light.point((5, 8, 2), (0.9, 0.9, 0.8)), lt.Light.ambient(0.2)]
    return lt.Scene(items + lights, camera=lt.Camera(50, eye=(0.5, 1, 1), target=(0, 0, -5)), background=(0.1, 0.2, 0.3))


def test_saved_scene_is_the_same_picture(renderer, tmp_path):
    scene = everything()
    scene.save(tmp_path / "scene.sdf")
    mine = renderer.render(scene, integrator="whitted", **SIZE)
    command = [PROGRAM, "render", tmp_path / "scene.sdf", "--integrator=whitted", "--size=64x48", f"--output={tmp_path}/other.png", "-q"]
    subprocess.run(command, check=True)
    assert mine.encoded("png") == (tmp_path / "other.png").read_bytes()
    assert len(np.unique(mine.developed.reshape(-1, 3), axis=0)) > 100
    assert sorted(path.name for path in tmp_path.iterdir()) == ["other.png", "scene.sdf", "scene_mesh_1.ply"]


def test_mesh_is_where_its_vertices_are(renderer):
    corners = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    faces = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]
    camera = lt.Camera(40, eye=(3, 4, 6), target=(0, 0, 0))
    depths = [
        renderer.render(lt.Scene([shape], camera=camera), planes="depth", **SIZE).planes["depth"]
        for shape in (CUBE, lt.Mesh(corners, faces), lt.Mesh.from_trimesh(SimpleNamespace(vertices=corners, faces=np.array(faces))))
    ]
    assert 200 < np.isfinite(depths[0]).sum() < 3000
    for depth in depths[1:]:
        np.testing.assert_allclose(depth, depths[0], rtol=1e-5)


@pytest.mark.parametrize("eye, target, up", [
    ((0, 0, 9), (0, 0, 0), (0, 1, 0)),
    ((3, 4, 6), (0, 1, 0), (0, 1, 0)),
    ((-3, -4, -6), (1, 0, 0), (1, 2, 0.5)),
    ((0, 9, 0), (0, 0, 0), (0, 0, -1)),
    ((0, 9, 1), (0, -3, 0.5), (1, 0, 1)),
])
def test_camera_stands_as_the_program_places_one(renderer, eye, target, up):
    """`look_at` of the options is other code, in C++."""
    cubes = [CUBE, lt.Box((1, 1, 1), (1.5, 3, 1.2))]
    placed = lt.Scene(cubes, camera=lt.Camera(50, eye=eye, target=target, up=up))
    other = lt.Scene(cubes, camera=lt.Camera(50))
    planes = [renderer.render(placed, planes="position", **SIZE), renderer.render(other, planes="position", eye=eye, look_at=target, up=up, **SIZE)]
    mine, wanted = (image.planes["position"] for image in planes)
    assert (wanted != 0).any()
    close = np.isclose(mine, wanted, atol=1e-4).all(axis=-1)
    assert close.mean() > 0.99  # all but edges


def test_what_moves_is_drawn_where_it_is(renderer):
    ball = lt.Sphere((0, 0, 0), 1)
    scene = lt.Scene([ball], camera=lt.Camera(eye=(0, 0, 8)))
    middles = []
    for _ in range(3):
        hit = np.isfinite(renderer.render(scene, planes="depth", **SIZE).planes["depth"])
        middles.append(np.nonzero(hit)[1].mean())
        ball.translate((1, 0, 0))
    assert middles[0] == pytest.approx(31.5) and np.diff(middles) == pytest.approx(32 / np.tan(np.radians(22.5)) / 8, rel=0.1)


def test_model_from_another_folder(renderer, tmp_path):
    path = tmp_path / "triangle.obj"
    path.write_text("v -1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    model = lt.Model(path)
    model.rotate(20, (0, 1, 0))
    scene = lt.Scene([lt.Group([model])], camera=lt.Camera(eye=(0, 0, 4)))
    assert np.isfinite(renderer.render(scene, planes="depth", **SIZE).planes["depth"]).sum() > 50


@pytest.mark.parametrize("make, message", [
    (lambda: lt.Sphere((0, 0), 1), "^center: expected three numbers, not 2"),
    (lambda: lt.Sphere((0, 0, float("nan")), 1), "^center: expected a finite number"),
    (lambda: lt.Sphere((0, 0, 0), -1), "^radius: expected a number above 0, not -1.0"),
    (lambda: lt.Mesh([(0, 0, 0)], [(0, 0, 1)]), "from 0 to 0"),
    (lambda: lt.Mesh([(0, 0, 0)], [(0.0, 0.0, 0.0)]), "whole numbers"),
    (lambda: lt.Mesh([0, 0, 0], [(0, 0, 0)]), "N x 3"),
    (lambda: lt.Mesh([("a", 0, 0)], [(0, 0, 0)]), "^vertices: expected an array of numbers: "),
    (lambda: lt.Mesh([(0, 0, 0)], [(0, 0, 0), (0, 0)]), "^faces: expected an array of numbers: "),
    (lambda: setattr(lt.Group([CUBE]), "material", RED), "^material: a group has none: set those of the shapes in it"),
    (lambda: CUBE.rotate(3, (0, 0, 0)), "^axis: expected a direction, not zero"),
    (lambda: CUBE.scale(0), "^factor: a scale factor must not be 0"),
    (lambda: lt.Light.spot((0, 0, 0), (0, 0, 1), range=-2), "^range: expected a number above 0"),
    (lambda: lt.Camera(eye=(1, 1, 1), target=(1, 1, 1)), "^target: .*stands"),
    (lambda: lt.Camera(eye=(0, 1, 0), target=(0, 0, 0)), "^up: "),
    (lambda: lt.Camera(size=(640, 480, 1)), "^size: expected width and height in pixels, at least 1 x 1, not 640 x 480 x 1"),
    (lambda: lt.Camera(size=(0, 480)), "^size: .*not 0 x 480"),
    (lambda: lt.Camera(orthographic=0), "^orthographic: expected a number above 0"),
    (lambda: lt.Plane((0, 0, 0), (0, 0, 0)), "^normal: expected a direction"),
    (lambda: lt.Phong(specular=(1, 2)), "^specular: expected three numbers, not 2"),
    (lambda: lt.Phong(reflect=float("nan")), "^reflect: expected a finite number"),
    (lambda: lt.Pbr(roughness=2), "^roughness: expected a number from 0 to 1, not 2.0"),
    (lambda: lt.Pbr(sheen_color=(1, -1, 1)), "^sheen_color: expected a number that is at least 0"),
    (lambda: lt.Pbr(ior=math.inf), "^ior: expected a finite number"),
    (lambda: lt.Pbr(attenuation_distance=0), "^attenuation_distance: "),
])
def test_what_makes_no_sense_is_refused(make, message):
    with pytest.raises(lt.UsageError, match=message):
        make()


@pytest.mark.parametrize("use, message", [
    (lambda: lt.Scene(camera="eye"), "^camera: expected a lichtraum.Camera, not 'eye'"),
    (lambda: setattr(lt.Scene(), "camera", 3), "^camera: expected a lichtraum.Camera, not 3"),
    (lambda: lt.Sphere((0, 0, 0), 1, "red"), "^material: expected a lichtraum.Phong or Pbr, not 'red'"),
    (lambda: setattr(lt.Sphere((0, 0, 0), 1), "material", None), "^material: .*not None"),
    (lambda: lt.Model("a.glb", "red"), "^material: .*'red'"),
    (lambda: setattr(CUBE, "material", "red"), "^material: .*'red'"),
    (lambda: lt.Group([CUBE, lt.Light.ambient()]), "^a group's child: expected a shape or a group, not Light"),
    (lambda: lt.Group().add("ball"), "^a group's child: .*'ball'"),
    (lambda: lt.load(HELLO).set_material("any", "red"), "^material: .*'red'"),
    (lambda: lt.load(HELLO).set_light("any", CUBE), "^light: expected a lichtraum.Light"),
    (lambda: lt.load(HELLO).set_camera("any", "eye"), "^camera: .*'eye'"),
    (lambda: lt.load(HELLO, strict="no"), "^strict: expected True or False, not 'no'"),
])
def test_what_is_of_another_kind_is_refused(use, message):
    with pytest.raises(TypeError, match=message):
        use()


def test_faulty_scenes(renderer, tmp_path):
    group = lt.Group([CUBE])
    group.add(lt.Group([lt.Group([CUBE, group])]))
    twice = [lt.Sphere((0, 0, 0), 1, name="a"), lt.Sphere((0, 0, 0), 1, name="a")]
    for items, message in (([group], "itself"), ([lt.Group()], "at least one"), (twice, "called 'a'"), ([lt.Sphere((0, 0, 0), 1, name="a b")], "name")):
        with pytest.raises(lt.UsageError, match=message):
            lt.Scene(items).save(tmp_path / "scene.sdf")
    assert list(tmp_path.iterdir()) == []
    with pytest.raises(TypeError):
        lt.Scene([3])
    with pytest.raises(lt.UsageError, match="transmit must not exceed 1, in 'define material .* transmit=0.9'$"):
        renderer.render(lt.Scene([lt.Sphere((0, 0, 0), 1, lt.Phong(reflect=0.9, transmit=0.9))]), **SIZE)
    with pytest.raises(lt.FileError, match="nowhere"):
        lt.Scene([CUBE]).save(Path("/nowhere/scene.sdf"))


@pytest.mark.parametrize("kind", [list, np.array, tuple, lambda numbers: np.array(numbers, dtype=np.float32)])
@pytest.mark.parametrize("material", [lambda color: lt.Phong(diffuse=color), lambda color: lt.Pbr(base_color=color)])
def test_colours_are_any_three_numbers(renderer, kind, material):
    colour = kind([0.5, 0.25, 1])
    mine, same = material(colour), material((0.5, 0.25, 1))
    assert mine == same and hash(mine) == hash(same)
    images = [renderer.render(lt.Scene([lt.Sphere((0, 0, -5), 1, each), lt.Light.ambient(colour)]), denoise="off", **SIZE) for each in (mine, same)]
    assert np.array_equal(*images) and np.max(images[0]) > 0


@pytest.mark.parametrize("kind", [np.float32, np.int64, np.array])
def test_numbers_are_numpys_as_well(renderer, kind):
    def image(two):
        ball = lt.Sphere((0, 0, -9), 1, lt.Phong(diffuse=two))
        ball.scale(two)
        return renderer.render(lt.Scene([ball, lt.Light.point((0, 9, 0), two)], background=two), **SIZE)

    assert np.array_equal(image(kind(2)), image(2))


def test_arrays_of_meshes_can_be_replaced(renderer):
    """By numbers of any kind, which are checked as those that it is made of."""
    camera = lt.Camera(40, eye=(0, 1, 0), target=(0, 1, -6))

    def depth(made):
        return renderer.render(lt.Scene([made], camera=camera), planes="depth", **SIZE).planes["depth"]

    moved, texcoords = mesh(1), [(0, 0), (1, 0), (0, 1)]
    moved.vertices = moved.vertices + np.array([0, 0.5, 0])
    moved.normals = np.array([(0, 0, 1)] * 3)
    moved.texcoords = np.array(texcoords)
    moved.material = lt.Pbr(base_color_texture=lt.Texture(np.full((1, 1), 255, dtype=np.uint8)))
    other = mesh(1)
    other.translate((0, 0.5, 0))
    assert np.isfinite(depth(other)).any() and np.array_equal(depth(moved), depth(other))
    for name, values, message in [
        ("vertices", [(0, 0, 0)], "^faces: a vertex is a number from 0 to 0"),
        ("vertices", [(0, 0, 0)] * 4, "^normals: expected an array of 4 x 3, not of 3 x 3"),
        ("vertices", [(0, 0, float("nan"))] * 3, "^vertices: expected finite"),
        ("faces", [(0, 1, 2**32)], "^faces: a vertex is a number from 0 to 2"),
        ("texcoords", [0, 0], "^texcoords: expected an array of 3 x 2, not of 2"),
    ]:
        wrong = lt.Mesh(moved.vertices, moved.faces, normals=moved.normals, texcoords=texcoords)
        setattr(wrong, name, values)
        with pytest.raises(lt.UsageError, match=message):
            depth(wrong)


def test_names_are_given_to_what_has_none(renderer, tmp_path):
    def ball(name=None):
        return lt.Sphere((0, 0, -5), 1, name=name)

    items = [ball(), ball("sphere_1"), lt.Group([ball("sphere_2"), ball()]), lt.Light.ambient(), lt.Light.ambient(name="light_1"), ball("camera_1")]
    lt.Scene(items).save(tmp_path / "scene.sdf")
    scene = lt.load(tmp_path / "scene.sdf")
    assert scene.shapes == ["sphere_3", "sphere_1", "sphere_2", "sphere_4", "composite_1", "camera_1"]
    assert scene.lights == ["light_2", "light_1"] and scene.cameras == ["camera_2"]


def mesh(height):
    return lt.Mesh([(-1, 0, -6), (1, 0, -6), (0, height, -6)], [(0, 1, 2)])


def test_saving_replaces_no_file_but_its_own(renderer, tmp_path):
    """What happens to lie where a mesh would be written, as a model of the scene or not, is somebody's."""
    own, foreign = tmp_path / "table_mesh_1.ply", tmp_path / "table_mesh_2.ply"
    lt.Scene([mesh(3)]).save(tmp_path / "other.sdf")
    (tmp_path / "other_mesh_1.ply").rename(own)
    foreign.write_text("dear to somebody")
    before = own.read_bytes()
    scene = lt.Scene([mesh(1), lt.Model(own), lt.Light.ambient(1)])
    drawn = renderer.render(scene, **SIZE)
    for _ in range(2):
        scene.save(tmp_path / "table.sdf")
        assert own.read_bytes() == before and foreign.read_text() == "dear to somebody"
        assert sorted(path.name for path in tmp_path.glob("table*")) == ["table.sdf", own.name, foreign.name, "table_mesh_3.ply"]
        assert np.array_equal(drawn, renderer.render(tmp_path / "table.sdf", integrator=drawn.job["integrator"], **SIZE))


def test_saving_again_replaces_its_own_meshes_but_those_that_it_reads(tmp_path):
    target, written = tmp_path / "table.sdf", tmp_path / "table_mesh_1.ply"
    lt.Scene([mesh(1)]).save(target)
    first = written.read_bytes()
    lt.Scene([mesh(2)]).save(target)
    second = written.read_bytes()
    assert first != second and len(list(tmp_path.iterdir())) == 2
    lt.Scene([mesh(3), lt.Model(written)]).save(target)
    assert written.read_bytes() == second and "table_mesh_2.ply" in target.read_text()


def test_scene_is_not_saved_over_its_model(tmp_path):
    (tmp_path / "model.ply").write_text("dear to somebody")
    with pytest.raises(lt.UsageError, match="model of this scene"):
        lt.Scene([lt.Model(tmp_path / "model.ply")]).save(tmp_path / "model.ply")
    assert (tmp_path / "model.ply").read_text() == "dear to somebody"


def test_scene_is_not_saved_over_a_picture(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    picture = tmp_path / "dear.png"
    picture.write_text("dear to somebody")
    lt.Scene([lt.Sphere((0, 0, -5), 1)]).save("ball.sdf")
    for scene in (lt.Scene(), lt.load("ball.sdf")):
        with pytest.raises(lt.UsageError, match="named as a picture"):
            scene.save(picture)
    assert picture.read_text() == "dear to somebody"


def test_scene_that_cannot_be_saved_leaves_its_meshes(tmp_path):
    lt.Scene([mesh(1)]).save(tmp_path / "table.sdf")
    before = (tmp_path / "table_mesh_1.ply").read_bytes()
    with pytest.raises(lt.UsageError, match="Pbr"):
        lt.Scene([mesh(2), lt.Sphere((0, 0, 0), 1, lt.Pbr())]).save(tmp_path / "table.sdf")
    assert (tmp_path / "table_mesh_1.ply").read_bytes() == before


def test_threads_draw_and_save_one_scene(renderer, tmp_path):
    meshes = [mesh(1), mesh(2)]
    scene = lt.Scene([meshes[0], lt.Light.ambient(1)])
    wanted = {renderer.render(lt.Scene([each, lt.Light.ambient(1)]), **SIZE).encoded() for each in meshes}

    def draw(number):
        scene.items[0] = meshes[number % 2]
        return renderer.render(scene, **SIZE).encoded()

    def save(_):
        scene.save(tmp_path / "scene.sdf")
        return lt.load(tmp_path / "scene.sdf").shapes

    with ThreadPoolExecutor(8) as threads:
        drawn, saved = list(threads.map(draw, range(60))), list(threads.map(save, range(60)))
    assert set(drawn) == wanted and set(map(tuple, saved)) == {("mesh_1",)}
    assert sorted(path.name for path in tmp_path.iterdir()) == ["scene.sdf", "scene_mesh_1.ply"]


def test_scene_is_drawn_while_it_is_drawn(renderer):
    scene, small = lt.Scene([mesh(1), lt.Light.ambient(1)]), []

    def show(_):
        if not small:
            small.append(lt.Renderer().render(scene, size=(8, 8)))

    renderer.render(scene, size=(1500, 1500), samples=64, progress=show)
    assert [image.size for image in small] == [(8, 8)]


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda scene: pickle.loads(pickle.dumps(scene))])
def test_scene_can_be_copied_after_it_was_drawn(renderer, copied):
    scene = lt.Scene([mesh(1), lt.Light.ambient(1)])
    wanted = renderer.render(scene, **SIZE).encoded()
    other = copied(scene)
    del scene
    assert renderer.render(other, **SIZE).encoded() == wanted


def test_groups_are_as_deep_as_they_are(renderer, tmp_path):
    """Python's recursion ends at a thousand calls, the library's loops do not."""
    ball = lt.Sphere((0, 0, -5), 1)
    group = lt.Group([ball])
    for _ in range(3000):
        group = lt.Group([group])
        group.translate((1e-4, 0, 0))
    scene = lt.Scene([group, lt.Light.ambient(1)])
    wanted = renderer.render(scene, **SIZE).encoded()
    scene.save(tmp_path / "deep.sdf")
    assert renderer.render(tmp_path / "deep.sdf", integrator="whitted", **SIZE).encoded() == wanted
    copies = [copy.deepcopy((ball, scene)), pickle.loads(pickle.dumps((ball, scene)))]
    for copied_ball, copied in copies:
        assert renderer.render(copied, **SIZE).encoded() == wanted
        copied_ball.translate((0, 1, 0))  # is the scene's
        assert renderer.render(copied, **SIZE).encoded() != wanted


def test_lights_that_are_twice_in_a_scene_shine_twice(renderer):
    lamp, ball = lt.Light.ambient(0.25), lt.Sphere((0, 0, -5), 1)
    twice, bright = (lt.Scene([ball, *lamps]) for lamps in ([lamp, lamp], [lt.Light.ambient(0.5)]))
    assert np.array_equal(renderer.render(twice, **SIZE), renderer.render(bright, **SIZE))


def test_scenes_leave_no_folder(child, tmp_path):
    """Neither when one is forgotten, nor at Python's end; and nobody is warned of it."""
    draw = "scene = lt.Scene([lt.Sphere((0, 0, -5), 1), lt.Light.ambient(1)]); lt.render(scene, size=(4, 4), progress=False)"
    code = f"import os, lichtraum as lt\n{draw}\nassert os.listdir({str(tmp_path)!r})\ndel scene\nassert not os.listdir({str(tmp_path)!r})\n{draw}"
    run = child(code, TMPDIR=str(tmp_path))
    assert (run.returncode, run.stderr) == (0, "") and list(tmp_path.iterdir()) == []


def test_failed_save_leaves_nothing(tmp_path):
    for name in ("\ud800.sdf", "scene.sdf"):
        group = lt.Group([CUBE], name="\ud800")
        with pytest.raises(ValueError):
            lt.Scene([group]).save(tmp_path / name)
    lt.Scene([CUBE]).save(tmp_path / os.fsdecode(b"\xff.sdf"))
    assert [os.fsencode(path.name) for path in tmp_path.iterdir()] == [b"\xff.sdf"]
