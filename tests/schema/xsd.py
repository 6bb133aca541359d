"""scenefile.xsd accepts every file that scenefile.rng accepts: xsd.py PATH...

It also accepts others, see schema/scenefile-xsd.rnc. Exit code 77: skipped, because xmllint is missing.
"""

import pathlib
import shutil
import sys
import tempfile

import xml_side
from agreement import find_files, make_variants


def main():
    if shutil.which("xmllint") is None:
        print("skipped: xmllint is not installed")
        return 77
    files = find_files(sys.argv[1:], xml_side.SUFFIX)
    with tempfile.TemporaryDirectory() as folder:
        named = [f for f in map(pathlib.Path, sys.argv[1:]) if f in files]
        variants = make_variants(xml_side, named, pathlib.Path(folder))
        tried = [str(f) for f in [*files, *variants]]
        by_rng = xml_side.refusals(tried, xml_side.xmllint)
        by_xsd = xml_side.xsd_refusals(tried)
        accepted = [f for f in tried if f not in by_rng]
        refused = [f for f in accepted if f in by_xsd]
        for path in refused:
            print(f"{variants.get(pathlib.Path(path), path)}: only the XSD refuses it")
    also = sum(f in by_rng and f not in by_xsd for f in tried)
    print(f"{len(accepted)} files accepted by both, {also} only by the XSD")
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main())
