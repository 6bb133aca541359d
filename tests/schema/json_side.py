"""JSON Schema validation, and variants of JSON scenes."""

import copy
import json
import pathlib

try:
    import jsonschema
except ImportError:
    jsonschema = None

SUFFIX = ".json"
SCHEMA = pathlib.Path(__file__).resolve().parent.parent.parent / "schema" / "scenefile.schema.json"
# Values at the limits of ranges, and just beyond.
LIMITS = (-1, 0, 0.0009, 0.001, 1, 1.001, 5, 5.001, 16, 16.01, 100, 100.1, 179.9, 180, 180.1, 10000,
          10001)


def validators():
    """The installed validators by name."""
    return {"jsonschema": refused_by_jsonschema} if jsonschema else {}


WANTED = "the Python package jsonschema (package python3-jsonschema)"


def no_constant(name):
    raise ValueError(f"{name} is not JSON")


def refusals(paths, validate):
    """The first error for each rejected file."""
    return validate(paths)


def refused_by_jsonschema(paths):
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    result = {}
    for path in paths:
        try:
            text = pathlib.Path(path).read_bytes().decode("utf-8-sig")
            error = next(validator.iter_errors(json.loads(text, parse_constant=no_constant)), None)
        except (ValueError, RecursionError) as problem:
            result[path] = str(problem)
            continue
        if error is not None:
            result[path] = f"{error.json_path}: {error.message[:80]}"
    return result


def without_stricter(_):
    """Unchanged: the schema rejects nothing on purpose that the reader accepts."""
    return None


def variants(data, _tried):
    """Scenes that differ from this one in one place each."""
    try:
        scene = json.loads(data)
    except ValueError:
        return
    for path in paths_of(scene):
        for what, edit in edits(get(scene, path)):
            changed = copy.deepcopy(scene)
            if not path:
                changed = edit(changed)
            else:
                parent = get(changed, path[:-1])
                parent[path[-1]] = edit(parent[path[-1]])
            yield f"{list(path)} {what}", json.dumps(changed).encode()
        if path:
            yield f"{list(path)} removed", json.dumps(without(scene, path)).encode()


def paths_of(value, path=()):
    yield path
    items = list(value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ())
    # The numbers of a list, and the rows of a matrix, mean the same to a schema: only the first and the last.
    for key, inner in items[::max(1, len(items) - 1)] if numbers(value) else items:
        yield from paths_of(inner, (*path, key))


def numbers(value):
    return isinstance(value, (int, float)) or isinstance(value, list) and all(map(numbers, value))


def get(value, path):
    for key in path:
        value = value[key]
    return value


def without(scene, path):
    changed = copy.deepcopy(scene)
    del get(changed, path[:-1])[path[-1]]
    return changed


def edits(value):
    limits = LIMITS if numbers(value) else ()
    words = ("cube", "mesh", "point", "directional", "spot", "area", "root") if isinstance(value, str) else ()
    for other in (None, True, "words", "", 0.5, 1, 1e39, -1e39, [], {}, [[]], [1, 2, 3, 4], *words, *limits):
        yield f"replaced by {other!r}", lambda _, o=other: copy.deepcopy(o)
    if isinstance(value, dict):
        yield "with an unknown key", lambda v: v | {"thingummy": 1}
        for key in value:
            yield f"with {key} renamed", lambda v, k=key: {("thingummy" if n == k else n): x
                                                           for n, x in v.items()}
    if isinstance(value, list):
        yield "with one more", lambda v: v + v[-1:]
