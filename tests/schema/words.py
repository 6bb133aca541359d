"""The words of the format that the program explains, `help vocabulary --json`, are those of the schemas."""

import json
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

SCHEMA = pathlib.Path(__file__).resolve().parent.parent.parent / "schema"
RNG = "{http://relaxng.org/ns/structure/1.0}"
DOCUMENTATION = "{http://relaxng.org/ns/compatibility/annotations/1.0}documentation"


def plain(text):
    return " ".join((text or "").split())


def texts_of_rng():
    """The descriptions of each element and attribute; an element may be defined several times."""
    texts = {"element": {}, "attribute": {}}
    for node in ElementTree.parse(SCHEMA / "scenefile.rng").iter():
        kind = node.tag.removeprefix(RNG)
        if kind in texts and node.get("name") is not None:
            texts[kind].setdefault(node.get("name"), set()).add(plain(node.findtext(DOCUMENTATION)))
    return texts


def keys_of(definition):
    for part in [definition] + [p for word in ("oneOf", "anyOf", "allOf") for p in definition.get(word, [])]:
        for name, value in part.get("properties", {}).items():
            if "description" in value:
                yield name, value


def problems(words):
    texts = texts_of_rng()
    if words["xml"].keys() != texts["element"].keys():
        yield f"elements: {words['xml'].keys() ^ texts['element'].keys()}"
    attributes = set()
    for name, element in words["xml"].items():
        if element["about"] not in texts["element"].get(name, ()):
            yield f"<{name}>: {element['about']}"
        for key, attribute in element["attributes"].items():
            attributes.add(key)
            if attribute["about"] not in texts["attribute"].get(key, ()):
                yield f"attribute {key} of <{name}>: {attribute['about']}"
        for child in element["children"]:
            if child not in words["xml"]:
                yield f"<{child}> in <{name}>"
    if attributes != texts["attribute"].keys():
        yield f"attributes: {attributes ^ texts['attribute'].keys()}"
    schema = json.loads((SCHEMA / "scenefile.schema.json").read_text())
    objects = {"": schema, **schema["definitions"]}
    for name, keys in words["json"].items():
        written = dict(keys_of(objects[name]))
        if name == "templateGroup":
            continue  # has the keys of a group
        if keys.keys() != written.keys():
            yield f"keys of {name!r}: {keys.keys() ^ written.keys()}"
        for key, value in keys.items():
            if value["about"] != plain(written.get(key, {}).get("description")):
                yield f"{name}.{key}: {value['about']}"
            if value.get("in", "") not in words["json"]:
                yield f"{name}.{key} has an unknown object"
            if "example" in value:
                json.loads(value["example"])


found = list(problems(json.loads(subprocess.run(
    [sys.argv[1], "help", "vocabulary", "--json"], check=True, capture_output=True).stdout)))
print("\n".join(found))
sys.exit(1 if found else 0)
