"""RELAX NG validators, and variants of XML scenes."""

import copy
import functools
import pathlib
import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree

SUFFIX = ".xml"
SCHEMA = pathlib.Path(__file__).resolve().parent.parent.parent / "schema"
FILES_AT_ONCE = 500
# Values at the limits of ranges, and just beyond.
LIMITS = (-1, 0, 0.0009, 0.001, 1, 1.001, 5, 5.001, 7, 8, 16, 16.01, 100, 100.1, 179.9, 180, 180.1,
          10000, 10001)


def validators():
    """The installed validators by name."""
    return {name: call for name, call in (("jing", jing), ("xmllint", xmllint))
            if shutil.which(name)}


WANTED = "jing or xmllint (package libxml2-utils)"


def refusals(paths, validate):
    """The first error for each rejected file."""
    result = {}
    together = []
    for path in paths:
        match kind_of(path):
            case "broken":
                result[path] = "not well-formed"
            case "with a DTD":
                result |= validate([path])
            case _:
                together.append(path)
    for i in range(0, len(together), FILES_AT_ONCE):
        result |= validate(together[i:i + FILES_AT_ONCE])
    return result


@functools.cache
def kind_of(path):
    """Cached, because every validator requests the same files."""
    data = pathlib.Path(path).read_bytes()
    if not is_well_formed(data):
        return "broken"
    return "with a DTD" if b"<!DOCTYPE" in data else "plain"


def without_stricter(data):
    """The scene without what the schema rejects on purpose although the reader accepts it.
    None if it is not well-formed."""
    if not is_well_formed(data):
        return None
    root = ElementTree.fromstring(data)
    for element in root.iter():
        # The reader ignores namespaces.
        element.tag = local_name(element.tag)
        element.attrib = {local_name(name): value for name, value in element.attrib.items()}
        # The reader accepts any four children of a matrix as its rows; an editor should suggest
        # their names and check them.
        if element.tag == "matrix":
            for row in element:
                row.tag = "row"
        # The reader accepts ids above 7 if there are more than eight lights; an editor should
        # suggest 0 to 7.
        if element.tag == "lightdata":
            for number in element.iter("id"):
                if re.fullmatch(WHOLE_NUMBER, number.get("v", "")) and float(number.get("v")) > 7:
                    number.set("v", "7")
    return ElementTree.tostring(root)


WHOLE_NUMBER = r"\s*\+?[0-9]+(\.0*)?\s*"


def local_name(name):
    return name.rpartition("}")[2]


def is_well_formed(data):
    try:
        ElementTree.fromstring(data)
    except (ElementTree.ParseError, LookupError, ValueError):
        return False
    return True


def jing(paths):
    """Jing stops at the first file that is not well-formed, or whose DTD is missing; such files are
    passed separately."""
    run = subprocess.run(["jing", SCHEMA / "scenefile.rng", *paths], text=True, errors="replace",
                         capture_output=True)
    given = {str(pathlib.Path(p).absolute()): p for p in paths}
    result = {}
    for line in run.stdout.splitlines():
        match = re.fullmatch(r"(.+?):\d+:\d+: (?:error|warning): (.*)", line)
        if match and match[1] in given:
            result.setdefault(given[match[1]], match[2])
        elif len(paths) == 1:
            result[paths[0]] = line
        else:
            raise RuntimeError(f"jing says: {line}")
    return result


def xmllint(paths, *schema):
    """Without libxml2's limits, and without network access."""
    schema = schema or ("--relaxng", SCHEMA / "scenefile.rng")
    run = subprocess.run(["xmllint", "--noout", "--nonet", "--huge", *schema, *paths], text=True,
                         errors="replace", capture_output=True)
    result = {path: "" for path in paths}
    for line in run.stderr.splitlines():
        if line.endswith(" validates"):
            result.pop(line.removesuffix(" validates"), None)
        elif (path := line.split(":", 1)[0]) in result:
            result[path] += line.removeprefix(path) + "; "
    return {path: complaint or "xmllint refuses it" for path, complaint in result.items()}


def refused_by_xsd(paths):
    """Those that the XSD rejects. It accepts more than RELAX NG, see schema/scenefile-xsd.rnc."""
    result = {}
    for i in range(0, len(paths), FILES_AT_ONCE):
        result |= xmllint(paths[i:i + FILES_AT_ONCE], "--schema", SCHEMA / "scenefile.xsd")
    return result


def variants(data, tried):
    """Scenes that differ from this one in one place, one for each kind of place. `tried` contains the kinds
    already used for other files; those of this file are added."""
    try:
        root = ElementTree.fromstring(data)
    except ElementTree.ParseError:
        return
    shorten(root)
    text = ElementTree.tostring(root)
    for i, (element, kind) in enumerate(with_kinds(root)):
        if kind in tried:
            continue
        tried.add(kind)
        where = f"<{element.tag}> number {i}"
        for what, edit in edits(element):
            scene = ElementTree.fromstring(text)
            parents = {child: parent for parent in scene.iter() for child in parent}
            target = list(scene.iter())[i]
            if edit(target, parents.get(target)) is not False:
                yield f"{where} {what}", ElementTree.tostring(scene)


def shorten(root):
    """Leaves out the space between elements, and what repeats kinds: a validator's time grows with the file."""
    kind_of_element = dict(with_kinds(root))
    seen = set()
    for element in root.iter():
        element.text = element.tail = None
        for part in element.findall("transblock")[1:]:
            kinds = {kind_of_element[e] for e in part.iter()}
            if kinds <= seen:
                element.remove(part)
            seen |= kinds
        seen.add(kind_of_element[element])


def with_kinds(root):
    """Every element in the order of the file, with a description of its parents and contents."""
    found = []
    todo = [(root, ())]
    while todo:
        element, parent = todo.pop()
        kind = (element.tag, *element.attrib, element.get("type"), element.get("name") == "mesh")
        light_type = element.find("type")
        around = (element.tag, light_type.get("v") if light_type is not None else None)
        found.append((element, (kind, around, parent)))
        todo += [(child, (around, element.get("name") == "root")) for child in reversed(element)]
    return found


def edits(element):
    yield "removed", remove
    yield "doubled", double
    yield "moved to the front of its parent", move_first
    yield "renamed", lambda e, _: setattr(e, "tag", "thingummy")
    yield "with an unknown attribute", lambda e, _: e.set("thingummy", "1")
    yield "with text", lambda e, _: setattr(e, "text", "words")
    yield "with an unknown child", lambda e, _: ElementTree.SubElement(e, "thingummy") and None
    yield "with a known child", lambda e, _: ElementTree.SubElement(e, "diffuse", r="1", g="1", b="1") and None
    for name, value in element.attrib.items():
        yield f"without {name}", lambda e, _, n=name: e.attrib.pop(n) and None
        yield f"with {name} renamed", rename(name)
        for other in other_values(value):
            yield f"with {name}={other!r}", lambda e, _, n=name, o=other: e.set(n, o)


def other_values(value):
    yield from ("", "words", value + "x", " " + value, value.upper())
    if re.fullmatch(r"[-+.0-9eE]+", value):
        yield from ("+2", "1e2", ".5", "5.", "1.2.3", "1e39", "-1e39", "NaN", "INF", "0x10", "1e")
        yield from map(str, LIMITS)
    else:
        yield from ("root", "tree", "master", "primitive", "cube", "mesh", "point", "directional",
                    "spot", "area")


def remove(element, parent):
    if parent is None:
        return False
    parent.remove(element)
    return True


def double(element, parent):
    if parent is None:
        return False
    parent.insert(list(parent).index(element), copy.deepcopy(element))
    return True


def move_first(element, parent):
    if parent is None or parent[0] is element:
        return False
    parent.remove(element)
    parent.insert(0, element)
    return True


def rename(name):
    def edit(element, _):
        element.attrib = {("thingummy" if n == name else n): v for n, v in element.attrib.items()}
    return edit
