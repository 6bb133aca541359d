"""Helpers of the programs in this folder."""
import datetime
import os
import pathlib
import platform
import subprocess
import sys
import tempfile
import time

# Options that POV-Ray is compared with: no super-sampling, no lenses.
FEATURES = "shadows,reflect,refract,texture,texture-filter"
HERE = pathlib.Path(__file__).resolve().parent


def run(command, folder=".", environment=None):
    """CPU seconds (user and system), peak memory in MB and wall seconds of a process that must succeed."""
    with tempfile.TemporaryFile() as said:
        start = time.monotonic()
        process = subprocess.Popen([str(c) for c in command], cwd=folder, stdin=subprocess.DEVNULL,
                                   stdout=said, stderr=said, env={**os.environ, **(environment or {})})
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.monotonic() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            said.seek(0)
            tail = said.read()[-2000:].decode(errors="replace")
            sys.exit(f"{' '.join(process.args)}: status {process.returncode}\n{tail}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024 / 1e6, wall


def least(results):
    """The minimum of several runs of a command, because other programs can only add to its time."""
    return {"cpu_seconds": round(min(cpu for cpu, _, _ in results), 3),
            "peak_mb": round(max(mb for _, mb, _ in results), 1)}


def render(program, scene, picture, *options):
    return [program, "render", scene, "-o", picture, "--profile", "course", "--threads", 1,
            "--size", "1024x768", "--allow-missing", "-q", *options]


def generate(build, kind, count, path):
    run([build / "bench" / "scenefile_bench_load", kind, count, path])


def machine():
    model = platform.processor()
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
            break
    answer = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=HERE, text=True,
                            capture_output=True)
    return {"machine": f"{model}, {os.cpu_count()} processors",
            "date": datetime.date.today().isoformat(),
            "commit": answer.stdout.strip() or "unknown"}


def heading(result):
    return (f"{result['machine']}, {result['date']}, commit {result['commit']}, "
            f"least of {result['runs']}.\n")
