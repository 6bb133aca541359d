"""Reading, checking, editing and saving."""

import pytest

import scenefile


def test_read_gives_the_values_of_the_file(ball):
    scene = scenefile.read(ball)
    assert scene.camera.position == (3, 2.2, 4)
    assert scene.camera.height_angle_deg == 35
    assert [light.type for light in scene.lights] == ["point"]
    (sphere,) = scene.primitives
    assert sphere.shape == "sphere"
    assert sphere.material.diffuse == (0.9, 0.3, 0.2)
    assert scene.diagnostics == ()


def test_errors_carry_their_diagnostics(tmp_path):
    path = tmp_path / "broken.xml"
    path.write_text('<scenefile>\n<object type="tree" name="root"><transblock>'
                    '<object type="primitive" name="sphere"><difuse r="1" g="0" b="0"/></object>'
                    '</transblock></object></scenefile>')
    with pytest.raises(scenefile.SceneError) as raised:
        scenefile.read(path)
    codes = [d.code for d in raised.value.diagnostics if d.severity == "error"]
    assert codes == ["xml.misspelled-element"]
    finding = next(d for d in raised.value.diagnostics if d.severity == "error")
    assert finding.line == 2 and finding.column > 1
    assert "did you mean <diffuse>?" in finding.message
    assert finding.message in str(raised.value)
    assert finding.help


# SECURITY.md
def test_files_that_are_not_scenes_are_not_shown(tmp_path):
    for name, text in [("passwd", "secret:x:0:0\n"), ("pom.xml", "<secret/>\n"),
                       ("package.json", '{"secret": 1}\n')]:
        path = tmp_path / name
        path.write_text(text)
        link = tmp_path / "scene.xml"
        link.unlink(missing_ok=True)
        link.symlink_to(name)
        for file in (path, link):
            with pytest.raises(scenefile.SceneError) as raised:
                scenefile.read(file)
            report = scenefile.check(file)
            for shown in (str(raised.value), str(report).rstrip("\n"), repr(report)):
                assert "secret" not in shown
                assert "\n" not in shown
            assert str(raised.value).startswith(f"{file}: error: ")
            (finding,) = raised.value.diagnostics
            assert "secret" not in finding.message
        with pytest.raises(scenefile.SceneError) as raised:
            scenefile.read_text(text)
        assert "secret" not in str(raised.value)


def test_a_missing_file_is_an_os_error():
    with pytest.raises(OSError, match="no-such-scene.xml"):
        scenefile.read("no-such-scene.xml")
    with pytest.raises(OSError):
        scenefile.check("no-such-scene.xml")


def test_check_says_what_the_program_says(scenes, ball, tmp_path, program):
    assert str(scenefile.check(ball)) == program("check", ball)
    broken = tmp_path / "broken.xml"
    broken.write_text(ball.read_text().replace("diffuse r", "difuse r"))
    report = scenefile.check(broken)
    assert not report
    assert report.verdict == "errors" and report.errors == 1
    assert str(report) == program("check", broken, status=1)
    assert report.data["verdict"] == "errors"


def test_policy_of_check(ball):
    text = ball.read_text().replace("<cameradata>", "<cameradata><near v='1'/>")
    ball.write_text(text)
    plain = scenefile.check(ball)
    if plain.warnings:
        assert not scenefile.check(ball, deny_warnings=True)
    with pytest.raises(ValueError, match="no.such-code"):
        scenefile.check(ball, deny=["no.such-code"])


def test_editing_changes_what_is_saved(ball, tmp_path):
    scene = scenefile.read(ball)
    scene.camera.position += (0, 2, 0)
    scene.camera.look_at((0, 0, 0))
    light = scene.lights[0]
    light.color *= 0.5
    sphere = scene.primitives[0]
    sphere.material.diffuse = (0.25, 0.5, 0.75)
    sphere.material.shininess = 20
    sphere.shape = "cone"
    again = tmp_path / "again.json"
    scene.save(again)
    read = scenefile.read(again)
    assert read.camera.position == (3, 4.2, 4)
    assert read.lights[0].color == (0.5, 0.5, 0.5)
    assert read.primitives[0].shape == "cone"
    assert read.primitives[0].material.diffuse == (0.25, 0.5, 0.75)
    assert read.primitives[0].material.shininess == 20


def test_a_scene_from_nothing(tmp_path):
    scene = scenefile.Scene()
    scene.camera.position = (0, 0, 5)
    scene.camera.look_at((0, 0, 0))
    scene.root.add_light("directional").direction = (0, 0, -1)
    arm = scene.root.add_child("arm")
    arm.transforms = [scenefile.Translate((0, 1, 0)), scenefile.Rotate((0, 0, 1), 45), scenefile.Scale((2, 1, 1))]
    arm.add_primitive("cube").material.diffuse = (0, 0, 1)
    assert scene.check()
    path = tmp_path / "made.xml"
    scene.save(path)
    assert scenefile.diff(scene, path).same_meaning
    read = scenefile.read(path)
    assert arm.transforms in [node.transforms for node in read.nodes]


def test_templates_and_instances():
    scene = scenefile.Scene()
    scene.add_template("leg").add_primitive("cylinder")
    scene.root.add_child("left").instance_of = "leg"
    assert list(scene.templates) == ["leg"]
    assert scene.check()
    scene.root.add_child("right").instance_of = "wing"
    report = scene.check()
    assert not report
    assert any("wing" in d.message for d in report.diagnostics)


def test_what_is_removed_is_gone_and_handles_say_so(ball):
    scene = scenefile.read(ball)
    node = scene.primitives[0].node
    first = scene.primitives[0]
    second = node.add_primitive("cube")
    first.remove()
    with pytest.raises(RuntimeError, match="look it up again"):
        second.shape
    assert [p.shape for p in scene.primitives] == ["cube"]
    child = scene.root.add_child("gone")
    child.remove()
    assert child not in scene.nodes
    with pytest.raises(ValueError, match="root"):
        scene.root.remove()


def test_a_broken_edit_is_found_when_it_matters(ball, tmp_path):
    scene = scenefile.read(ball)
    scene.camera.up = scene.camera.look
    with pytest.raises(scenefile.SceneError) as raised:
        scene.render(size=(8, 6))
    assert [d.code for d in raised.value.diagnostics] == ["camera.up-parallel-to-look"]
    with pytest.raises(scenefile.SceneError):
        scene.save(tmp_path / "no.xml")
    assert not (tmp_path / "no.xml").exists()


def test_saving_replaces_no_input(ball, tmp_path):
    scene = scenefile.read(ball)
    texture = tmp_path / "wood.png"
    scene.render(size=(8, 6)).save(texture)
    scene.primitives[0].material.texture = scenefile.TextureUse("wood.png")
    path = tmp_path / "textured.xml"
    scene.save(path)
    textured = scenefile.read(path)
    before = path.read_bytes(), texture.read_bytes()
    (tmp_path / "link.png").symlink_to(texture)
    picture = textured.render(size=(8, 6), layers=["depth"])
    for name in ["wood.png", "link.png"]:
        with pytest.raises(ValueError, match="would replace the texture wood.png of the scene"):
            picture.save(tmp_path / name)
    (tmp_path / "x.depth.png").symlink_to(path)
    with pytest.raises(ValueError, match="the layer .*x.depth.png would replace the scene"):
        picture.save(tmp_path / "x.png")
    assert not (tmp_path / "x.png").exists()
    (tmp_path / "link.xml").symlink_to(texture)
    with pytest.raises(ValueError, match="would replace the texture"):
        textured.save(tmp_path / "link.xml")
    assert (path.read_bytes(), texture.read_bytes()) == before
    textured.save(path)  # its own file


def test_values_that_make_no_sense(ball, tmp_path):
    scene = scenefile.read(ball)
    with pytest.raises(TypeError):
        scene.camera.position = (1, 2)
    with pytest.raises(TypeError):
        scene.camera.position = "abc"
    with pytest.raises(ValueError, match="not one of cube, cone"):
        scene.primitives[0].shape = "ball"
    with pytest.raises(ValueError, match=".xml or .json"):
        scene.save(tmp_path / "x.txt")
    with pytest.raises(AttributeError):
        scene.camera.focus = (0, 0, 0)
    with pytest.raises(TypeError):
        scene.camera.position[1] = 5


def test_textures(scenes):
    scene = scenefile.read(scenes / "showcase.xml")
    textured = [p for p in scene.primitives if p.material.texture]
    assert textured
    material = textured[0].material
    use = material.texture
    material.texture = scenefile.TextureUse(use.file, 2, 3)
    assert (material.texture.repeat_u, material.texture.repeat_v) == (2, 3)
    material.texture = None
    assert material.texture is None


def test_diff(ball, tmp_path):
    scene = scenefile.read(ball)
    assert scenefile.diff(scene, ball).equal
    scene.lights[0].position = (0, 9, 0)
    differences = scenefile.diff(ball, scene)
    assert not differences.same_meaning
    assert len(differences) == 1
    assert differences.left_out == 0
    assert differences.differences[0].where == "point light"
    assert differences.differences[0].b == '<position x="0" y="9" z="0"/>'
    assert '\n+    <position x="0" y="9" z="0"/>\n' in str(differences)


def test_vec3():
    v = scenefile.Vec3(1, 2, 3)
    assert v + (1, 1, 1) == (2, 3, 4)
    assert (1, 1, 1) + v == (2, 3, 4)
    assert 2 * v == v * 2 == (2, 4, 6)
    assert v - (1, 1, 1) == (0, 1, 2) and (1, 1, 1) - v == (0, -1, -2)
    assert -v / 2 == (-0.5, -1, -1.5)
    assert (v.x, v.y, v.z) == tuple(v)
