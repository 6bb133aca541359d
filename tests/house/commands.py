#!/usr/bin/env python3
"""Checks that every command of `make help` is run by .ci/run or .ci/full, so that none stops working unnoticed."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOT_RUN = {
    "help": "prints the list",
    "clean": "removes what the other checks have built",
    "format": "changes the sources; format-check runs",
    "accept-readings": "replaces what tests expect, which someone has to look at",
    "screenshots": "replaces pictures of the documentation, which someone has to look at",
    "web-serve": "runs until it is stopped; web-test uses the same server",
    "packages-tried": "release-check tries the packages of both Debians",
    "ci-full": "runs .ci/full",
}

makefile = (ROOT / "Makefile").read_text()
helped = [name for names in re.findall(r"^([a-z -]+):.*## ", makefile, flags=re.M) for name in names.split()]
needs = {name: before.split() for name, before in re.findall(r"^([a-z-]+):([a-z -]*)(?:##|$)", makefile, flags=re.M)}
run = set()
for script in (".ci/run", ".ci/full", ".ci/release", "scripts/bare-machine"):
    lines = [line for line in (ROOT / script).read_text().splitlines() if not line.lstrip().startswith("#")]
    run |= set(re.findall(r"\bmake ([a-z][a-z-]*)", "\n".join(lines)))
waiting = list(run)
while waiting:
    for name in needs.get(waiting.pop(), []):
        if name not in run:
            run.add(name)
            waiting.append(name)

assert len(helped) > 20, helped
targets = {name for names in re.findall(r"^([a-z][a-z -]*):", makefile, flags=re.M) for name in names.split()}
unknown = sorted((run | NOT_RUN.keys()) - targets)
assert not unknown, f"the Makefile has no target {unknown}"
missing = [name for name in helped if name not in run and name not in NOT_RUN]
assert not missing, f"neither .ci/run nor .ci/full runs: make {' '.join(missing)}"
needless = [name for name in NOT_RUN if name in run]
assert not needless, f"is run, although NOT_RUN lists it: {needless}"
