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
    yield from problems_of_page(words)


def rows_of_page():
    """Of each row in docs/format.md: its block, the names in its first two columns, its cells by column."""
    blocks = {"## Global coefficients": "globals", "## Camera": "camera", "## Lights": "light",
              "## Materials": "material"}
    block, header = "", []
    for line in (SCHEMA.parent / "docs" / "format.md").read_text(encoding="utf-8").splitlines():
        block = blocks.get(line, block)
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if not line.startswith("|"):
            header = []
        elif not header:
            header = cells
        elif header[:2] == ["XML", "JSON"]:
            yield block, set(re.findall(r"`(\w+)`", " ".join(cells[:2]))), dict(zip(header, cells))


def default_of(value, keys):
    """What counts if the value is missing; None if that depends on other values."""
    if value["kind"] == "image":
        return "none, 1, 1"
    text = value.get("assumed_in_xml", value.get("default"))
    if text is None and not value["required_in_xml"] and (value["required_in_json"] or "needed_by" in value):
        text = keys[value["json"]].get("example")
    return text and re.sub(r"[\[\]]", "", text).replace(",", " ")


def value_of(value):
    """What is written: its kind and its range."""
    kinds = {"vector": "3 numbers", "color": "3 numbers", "coefficients": "3 numbers", "choice": "word", "text": "text",
             "image": "file, 2 numbers"}
    number = "{:g}".format
    bounds = [words + number(value[key]) for key, words in
              {"minimum": "at least ", "exclusiveMinimum": "above ", "maximum": "at most ", "exclusiveMaximum": "below "}
              .items() if key in value]
    if "minimum" in value and "maximum" in value:
        bounds = [f"{number(value['minimum'])} to {number(value['maximum'])}"]
    return ", ".join([kinds.get(value["kind"], "number"), *bounds])


def problems_of_page(words):
    rows = list(rows_of_page())
    keys = {key: word for block in words["json"].values() for key, word in block.items()}
    for value in words["values"]:
        names = {value["xml"], value["json"], *value["repeats"]} - {""}
        row = next((cells for block, found, cells in rows if block == value["block"] and names <= found), None)
        if row is None:
            yield f"docs/format.md has no row of {names}"
            continue
        wanted = {"value": value_of(value), "default": default_of(value, keys),
                  "used by": ", ".join(value.get("used_by", [])) or None}
        for column, text in wanted.items():
            if text is not None and row[column] != text:
                yield f"docs/format.md, row of {names}: {column} is {row[column]}, not {text}"
        for dialect in ("xml", "json"):
            if (row[dialect.upper()] == "none") != (value[dialect] == ""):
                yield f"docs/format.md, row of {names}: {dialect} has {value[dialect] or 'no such value'}"


found = list(problems(json.loads(subprocess.run(
    [sys.argv[1], "help", "vocabulary", "--json"], check=True, capture_output=True).stdout)))
print("\n".join(found))
sys.exit(1 if found else 0)
