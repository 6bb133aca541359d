"""The words that the program explains, `help vocabulary --json`, are those of the schemas and of docs/format.md."""

import json
import pathlib
import re
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


def problems(words):
    texts = texts_of_rng()
    values = {value["xml"] for value in words["values"]}  # scripts/make-schemas writes their texts
    if words["xml"].keys() != texts["element"].keys():
        yield f"elements: {words['xml'].keys() ^ texts['element'].keys()}"
    attributes = set()
    for name, element in words["xml"].items():
        attributes |= element["attributes"].keys()
        for child in element["children"]:
            if child not in words["xml"]:
                yield f"<{child}> in <{name}>"
        if name in values:
            continue
        if element["about"] not in texts["element"].get(name, ()):
            yield f"<{name}>: {element['about']}"
        for key, attribute in element["attributes"].items():
            if attribute["about"] not in texts["attribute"].get(key, ()):
                yield f"attribute {key} of <{name}>: {attribute['about']}"
    if attributes != texts["attribute"].keys():
        yield f"attributes: {attributes ^ texts['attribute'].keys()}"
    for name, keys in words["json"].items():
        for key, value in keys.items():
            if value.get("in", "") not in words["json"]:
                yield f"{name}.{key} has an unknown object"
            if "example" in value:
                json.loads(value["example"])
    page = (SCHEMA.parent / "docs" / "format.md").read_text()
    rows = [re.findall("`(\\w+)`", " ".join(line.split("|")[1:3])) for line in page.splitlines()]
    for value in words["values"]:
        names = {value["xml"], value["json"], *value["repeats"]} - {""}
        if not any(names <= set(row) for row in rows):
            yield f"docs/format.md has no row of {names}"


found = list(problems(json.loads(subprocess.run(
    [sys.argv[1], "help", "vocabulary", "--json"], check=True, capture_output=True).stdout)))
print("\n".join(found))
sys.exit(1 if found else 0)
