"""Every element, attribute and key of the schemas has a description for editors."""

import json
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

SCHEMA = pathlib.Path(__file__).resolve().parent.parent.parent / "schema"
RNG = "{http://relaxng.org/ns/structure/1.0}"
XSD = "{http://www.w3.org/2001/XMLSchema}"
DOCUMENTATION = "{http://relaxng.org/ns/compatibility/annotations/1.0}documentation"


def unexplained_rng():
    for node in ElementTree.parse(SCHEMA / "scenefile.rng").iter():
        if node.tag in (RNG + "element", RNG + "attribute") and node.find(DOCUMENTATION) is None:
            yield f"scenefile.rng: {node.get('name')}"


def unexplained_xsd():
    for node in ElementTree.parse(SCHEMA / "scenefile.xsd").iter():
        if node.tag in (XSD + "element", XSD + "attribute") and node.get("name") is not None \
                and node.find(f"{XSD}annotation/{XSD}documentation") is None:
            yield f"scenefile.xsd: {node.get('name')}"


def unexplained_json(schema, path="scenefile.schema.json"):
    """`if` and `then` repeat keys without their descriptions."""
    if isinstance(schema, list):
        for inner in schema:
            yield from unexplained_json(inner, path)
    if not isinstance(schema, dict):
        return
    for key, value in schema.items():
        if key == "properties":
            for name, inner in value.items():
                yield from unexplained_json(inner, f"{path}: {name}")
                if "$ref" not in inner and not {"title", "description"} <= inner.keys():
                    yield f"{path}: {name}"
        elif key == "definitions":
            for name, inner in value.items():
                yield from unexplained_json(inner, f"{path}: {name}")
        elif key not in ("if", "then", "default", "examples"):
            yield from unexplained_json(value, path)


def main():
    schema = json.loads((SCHEMA / "scenefile.schema.json").read_text(encoding="utf-8"))
    missing = [*unexplained_rng(), *unexplained_xsd(), *unexplained_json(schema)]
    for name in missing:
        print(f"{name} has no explanation")
    return 1 if missing else 0


sys.exit(main())
