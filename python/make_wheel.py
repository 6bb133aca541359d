#!/usr/bin/python3
"""Packs an installed module into a wheel (PEP 427) for the Python that runs this.

    python/make_wheel.py FOLDER VERSION OUT

FOLDER contains the package scenefile with the libraries that it needs and their licenses. The wheel says
that it needs the C library of this machine or a newer one (PEP 600).
"""

import base64
import hashlib
import os
import pathlib
import sys
import zipfile

METADATA = """Metadata-Version: 2.1
Name: scenefile
Version: {version}
Summary: Read, check, explain, render, compare and grade CS123 scene files
License: Apache-2.0
Requires-Python: =={python}.*
Requires-Dist: numpy
"""
WHEEL = """Wheel-Version: 1.0
Generator: make_wheel.py
Root-Is-Purelib: false
Tag: {tag}
"""


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    libc = os.confstr("CS_GNU_LIBC_VERSION").split()[1].replace(".", "_")
    return f"{python}-{python}-manylinux_{libc}_{os.uname().machine}"


def main(folder, version, out):
    python = f"{sys.version_info.major}.{sys.version_info.minor}"
    info = f"scenefile-{version}.dist-info"
    root = pathlib.Path(folder)
    files = {str(path.relative_to(root)): path.read_bytes() for path in sorted(root.rglob("*"))
             if path.is_file() and "__pycache__" not in path.parts}
    files[f"{info}/METADATA"] = METADATA.format(version=version, python=python).encode()
    files[f"{info}/WHEEL"] = WHEEL.format(tag=tag()).encode()
    files[f"{info}/LICENSE"] = (pathlib.Path(__file__).resolve().parents[1] / "LICENSE").read_bytes()
    record = ""
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(data)}\n"
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    wheel = pathlib.Path(out) / f"scenefile-{version}-{tag()}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name)  # with a fixed time: the same files give the same wheel
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, data)


main(*sys.argv[1:])
