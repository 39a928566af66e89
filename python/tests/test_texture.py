"""Textures of materials that are made in Python."""

import copy
import pickle

import numpy as np
import pytest

import lichtraum as lt

CORNERS = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1)]
FACES = [(0, 1, 2), (0, 2, 3)]
TEXCOORDS = [(0, 0), (1, 0), (1, 1), (0, 1)]
# Red and green above, blue and white below.
FOUR = np.array([[(255, 0, 0), (0, 255, 0)], [(0, 0, 255), (255, 255, 255)]], dtype=np.uint8)


@pytest.fixture(scope="module")
def renderer():
    return lt.Renderer()


def square(material, **options):
    return lt.Mesh(CORNERS, FACES, material, **options)


def drawn(renderer, *shapes, **options):
    """The square fills the picture."""
    scene = lt.Scene(shapes, camera=lt.Camera(90, size=(16, 16)), background=0.5)
    return np.array(renderer.render(scene, size=(16, 16), samples=16, denoise="off", progress=False, **options))


def shown(picture):
    """Above, then below."""
    return [picture[y, x] for y in (4, 12) for x in (4, 12)]


def unlit(picture, **options):
    return lt.Pbr(base_color_texture=lt.Texture(picture, filter="nearest", **options), metallic=0, unlit=True)


def test_a_texture_stands_upright_with_its_colours(renderer):
    picture = drawn(renderer, square(unlit(FOUR), texcoords=TEXCOORDS))
    assert np.allclose(shown(picture), [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)], atol=1e-3)


def test_colours_are_stored_in_srgb(renderer):
    grey = np.full((1, 1), 188, dtype=np.uint8)
    assert np.allclose(shown(drawn(renderer, square(unlit(grey), texcoords=TEXCOORDS))), 0.503, atol=2e-3)


def test_what_is_not_opaque_shows_what_is_behind(renderer):
    alpha = np.dstack((FOUR, [[255, 0], [0, 255]])).astype(np.uint8)
    picture = drawn(renderer, square(unlit(alpha), texcoords=TEXCOORDS))
    assert np.allclose(shown(picture), [(1, 0, 0), (0.5,) * 3, (0.5,) * 3, (1, 1, 1)], atol=1e-3)


@pytest.mark.parametrize(("wrap", "outer", "inner"), [("repeat", 0, 1), ("mirror", 1, 0), ("clamp", 0, 0)])
def test_beyond_its_edges_a_texture_goes_on_as_told(renderer, wrap, outer, inner):
    # Moved to the right by 0.8 of its width: most of the square is beyond its left edge.
    moved = [(u - 0.8, v) for u, v in TEXCOORDS]
    picture = drawn(renderer, square(unlit(FOUR, wrap=wrap), texcoords=moved))
    colors = np.array([(1, 0, 0), (0, 1, 0)])
    assert np.allclose(picture[4, 2], colors[outer], atol=1e-3)  # u = -0.64
    assert np.allclose(picture[4, 10], colors[inner], atol=1e-3)  # u = -0.14


def test_a_file_is_read_as_a_picture(renderer, tmp_path):
    # eSDF's colours are stored as they are, and read as sRGB.
    lt.render(lt.Scene(background=(0.2, 0.5, 0.8)), size=(4, 4), progress=False).save(tmp_path / "plain.png")
    picture = drawn(renderer, square(unlit(tmp_path / "plain.png"), texcoords=TEXCOORDS))
    assert np.allclose(shown(picture), (0.0331, 0.214, 0.604), atol=0.005)


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda thing: pickle.loads(pickle.dumps(thing))])
def test_textures_and_what_has_them_can_be_copied(renderer, tmp_path, copied):
    alpha = np.dstack((FOUR, [[255, 0], [0, 255]])).astype(np.uint8)
    lt.render(lt.Scene(background=(0.2, 0.5, 0.8)), size=(3, 2), progress=False).save(tmp_path / "plain.png")
    for texture in (lt.Texture(alpha, wrap="mirror", filter="nearest"), lt.Texture(FOUR), lt.Texture(tmp_path / "plain.png", wrap="clamp")):
        materials = [lt.Pbr(base_color_texture=each, metallic=0, unlit=True) for each in (texture, copied(texture))]
        moved = [(u - 0.8, v) for u, v in TEXCOORDS]
        assert np.array_equal(*(drawn(renderer, square(material, texcoords=moved)) for material in materials))
    both = copied((lt.Pbr(base_color_texture=texture), lt.Pbr(base_color_texture=texture)))
    assert both[0] == both[1]  # one texture, still
    image = renderer.render(lt.Scene([square(both[0], texcoords=TEXCOORDS)]), size=(4, 4))
    with pytest.raises(lt.FileError, match="is read for this picture"):
        image.save(tmp_path / "plain.png")


def test_other_factors_take_textures(renderer):
    shining = lt.Pbr(base_color=0, emissive=0.5, emissive_texture=lt.Texture(FOUR, filter="nearest"))
    picture = drawn(renderer, square(shining, texcoords=TEXCOORDS), integrator="path")
    assert np.allclose(shown(picture)[0] - shown(picture)[2], (0.5, 0, -0.5), atol=0.05)


def test_normals_make_a_mesh_smooth(renderer):
    matt = lt.Pbr(metallic=0)
    tilted = [(-0.6, 0, 0.8), (0.6, 0, 0.8), (0.6, 0, 0.8), (-0.6, 0, 0.8)]
    lamp = lt.Light.directional((-1, 0, -0.2), 3)  # from the right
    flat = drawn(renderer, square(matt), lamp)
    smooth = drawn(renderer, square(matt, normals=tilted), lamp)
    assert smooth[8, 14, 0] > flat[8, 14, 0] + 0.1 and smooth[8, 2, 0] < flat[8, 2, 0] - 0.05


def test_coordinates_are_saved_with_the_mesh(tmp_path):
    lt.Scene([square(lt.Phong(), texcoords=TEXCOORDS, normals=[(0, 0, 1)] * 4)]).save(tmp_path / "scene.sdf")
    head = next(tmp_path.glob("*.ply")).read_bytes().split(b"end_header")[0].decode()
    assert [line.split()[-1] for line in head.splitlines() if line.startswith("property float")] == [
        "x", "y", "z", "nx", "ny", "nz", "u", "v"
    ]  # fmt: skip


def test_trimesh_brings_its_coordinates():
    class Visual:
        uv = np.array(TEXCOORDS)

    class Trimesh:
        vertices, faces, visual = np.array(CORNERS), np.array(FACES), Visual()

    assert np.array_equal(lt.Mesh.from_trimesh(Trimesh()).texcoords, TEXCOORDS)


def refused(error, message, make, *arguments, **options):
    with pytest.raises(error, match=message):
        make(*arguments, **options)


def test_what_is_no_texture_is_refused(renderer, tmp_path):
    (tmp_path / "text.png").write_text("no picture")
    refused(lt.UsageError, "not float64", lt.Texture, np.zeros((2, 2, 3)))
    refused(lt.UsageError, "not of 2 x 2 x 2", lt.Texture, np.zeros((2, 2, 2), dtype=np.uint8))
    refused(lt.UsageError, "not of 0 x 2 x 3", lt.Texture, np.zeros((0, 2, 3), dtype=np.uint8))
    refused(lt.UsageError, "wrap: expected", lt.Texture, FOUR, wrap="around")
    refused(lt.UsageError, "filter: expected", lt.Texture, FOUR, filter="cubic")
    refused(lt.FileError, "missing.png", lt.Texture, tmp_path / "missing.png")
    refused(lt.FileError, "text.png' as a picture", lt.Texture, tmp_path / "text.png")
    refused(lt.UsageError, "4 x 2, not of 3 x 2", square, lt.Phong(), texcoords=TEXCOORDS[:3])
    refused(lt.UsageError, "this sphere has none", drawn, renderer, lt.Sphere((0, 0, -5), 1, unlit(FOUR)))
    refused(lt.UsageError, "this mesh has none", drawn, renderer, square(unlit(FOUR)))
