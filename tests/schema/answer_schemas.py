"""The schemas of the program's answers in schema/, each with those that it refers to.

Importing this exits with 77, so that the test is skipped, if the Python package jsonschema is missing.
"""

import copy
import json
import pathlib
import subprocess
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)

FOLDER = pathlib.Path(__file__).resolve().parent.parent.parent / "schema"
SCHEMAS = {f"{command}.schema.json": json.loads((FOLDER / f"{command}.schema.json").read_text(encoding="utf-8"))
           for command in ("check", "diff", "explain", "grade")}
IN_PLACE = ("allOf", "anyOf", "oneOf")
CONDITIONS = ("if", "then", "else")


def validator(command):
    schema = SCHEMAS[f"{command}.schema.json"]
    jsonschema.Draft7Validator.check_schema(schema)
    if schema["$id"] != f"{command}.schema.json":
        sys.exit(f"the $id of {command}.schema.json is {schema['$id']}")
    try:
        from referencing import Registry
    except ImportError:  # before jsonschema 4.18
        resolver = jsonschema.RefResolver.from_schema(schema, store=SCHEMAS)
        return jsonschema.Draft7Validator(schema, resolver=resolver)
    return jsonschema.Draft7Validator(schema, registry=Registry().with_contents(SCHEMAS.items()))


def answer(program, *words):
    run = subprocess.run([program, *words, "--json"], capture_output=True, check=False)
    return json.loads(run.stdout)


def changed(document, edit):
    other = copy.deepcopy(document)
    edit(other)
    return other


def applied(schema, file):
    """The schema and those that it applies to the same value, each with its file."""
    if "$ref" in schema:
        name, pointer = schema["$ref"].split("#/")
        target = SCHEMAS[name or file]
        for word in pointer.split("/"):
            target = target[word]
        yield from applied(target, name or file)
        return
    yield schema, file
    for word in IN_PLACE:
        for inner in schema.get(word, ()):
            yield from applied(inner, file)
    for word in CONDITIONS:
        if word in schema:
            yield from applied(schema[word], file)


def undescribed(value, schemas, described, path=""):
    """The members that no schema describes. Adds the identities of the schemas of the others to `described`."""
    schemas = [pair for schema, file in schemas for pair in applied(schema, file)]
    if isinstance(value, dict):
        for name, member in value.items():
            inner = [(schema["properties"][name], file) for schema, file in schemas
                     if name in schema.get("properties", {})]
            described.update(id(schema) for schema, _ in inner)
            if inner:
                yield from undescribed(member, inner, described, f"{path}/{name}")
            else:
                yield f"{path}/{name}"
    elif isinstance(value, list):
        inner = [(schema["items"], file) for schema, file in schemas if "items" in schema]
        for element in value:
            yield from undescribed(element, inner, described, f"{path}[]")


def places(value, path=()):
    """The paths of all members of an answer."""
    for name, member in value.items() if isinstance(value, dict) else ():
        yield (*path, name)
        yield from places(member, (*path, name))
    for index, element in enumerate(value) if isinstance(value, list) else ():
        yield from places(element, (*path, index))


def altered(documents):
    """Answers of another type for each member, and without each: a path, what was done, and the answer. Answers with
    the same members count as one kind, of which each path is altered once."""
    seen = set()
    for document in documents:
        for *path, name in places(document):
            text = "/".join("[]" if isinstance(word, int) else word for word in (*path, name))
            if (kind := (text, *sorted(document))) in seen:
                continue
            seen.add(kind)
            for done in ("of another type", "missing"):
                other = copy.deepcopy(document)
                place = other
                for word in path:
                    place = place[word]
                place[name] = [None]
                if done == "missing":
                    del place[name]
                yield text, done, other


def members(schema, path=""):
    """All members that a schema describes by itself: the path and the schema of each."""
    for name, inner in schema.get("properties", {}).items():
        yield f"{path}/{name}", inner
        yield from members(inner, f"{path}/{name}")
    for name, inner in schema.get("definitions", {}).items():
        yield from members(inner, f"{path}/definitions/{name}")
    if "items" in schema:
        yield from members(schema["items"], f"{path}[]")


def complaints(command, documents, broken=(), optional=None):
    """What is wrong with the schema: answers and members that it does not describe, and broken answers that it
    accepts. With `optional`, the paths of members that may be missing, also members that the schema does not ask for,
    or that no answer has."""
    valid = validator(command)
    file = f"{command}.schema.json"
    described = set()
    unknown = set()
    found = []
    for document in documents:
        found += [f"{'/'.join(map(str, e.path))}: {e.message[:200]}" for e in valid.iter_errors(document)]
        unknown.update(undescribed(document, [(SCHEMAS[file], file)], described))
    found += [f"{path} is not described" for path in sorted(unknown)]
    found += [f"broken answer {i} is accepted" for i, d in enumerate(broken) if valid.is_valid(d)]
    if optional is not None:
        found += [f"{path} may be {done}" for path, done, document in altered(documents)
                  if valid.is_valid(document) and not (done == "missing" and path in optional)]
        found += [f"{path} is in no answer" for path, schema in members(SCHEMAS[file]) if id(schema) not in described]
    return found
