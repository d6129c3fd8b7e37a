#!/usr/bin/env python3
"""Breaks the package on purpose, one change at a time, and sees whether a test notices.

    mutations.py --list                     whether each mutation still applies; a test does that
    mutations.py FOLDER [--layer NAME]      whether a test notices each; in FOLDER, which is made for it

A mutation of mutations.txt replaces a piece of text, which must occur exactly once, in a copy of the sources;
the tests named for it are built and run, and one of them must fail. That takes as long as these tests take to
compile, so it is done by hand. The status is 1 if a mutation goes unnoticed or does not apply.
"""
import argparse
import shutil
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

TOP = Path(__file__).resolve().parents[2]
INTERNAL = "Anisotropic_mesh_2/internal/"


class Mutation(NamedTuple):
    layer: str
    name: str
    header: str   # below include/CGAL
    before: str
    after: str
    tests: tuple


def read_mutations():
    """the blocks of mutations.txt: `layer | name | header | tests`, then the text before, `=>`, the text after"""
    for block in (TOP / "test/Anisotropic_mesh_2/mutations.txt").read_text().split("\n----\n"):
        lines = [line for line in block.split("\n") if not line.startswith("#")]
        head, *body = "\n".join(lines).strip("\n").split("\n")
        if not head:
            continue
        layer, name, header, tests = (field.strip() for field in head.split("|"))
        before, _, after = ("\n".join(body) + "\n").partition("\n=>\n")
        yield Mutation(layer, name, header.replace("INTERNAL/", INTERNAL), before, after.removesuffix("\n"), tuple(tests.split()))


def complaint(mutation, sources):
    """why a mutation does not apply; None if it does"""
    header = sources / "include/CGAL" / mutation.header
    n = header.read_text().count(mutation.before) if header.exists() else 0
    return None if n == 1 else f"DOES NOT APPLY: its text occurs {n} times"


def run(command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)


class Laboratory:
    """a copy of the sources that is broken and mended"""

    def __init__(self, build):
        self.sources, self.build = build / "sources", build / "build"
        if self.sources.exists():
            shutil.rmtree(self.sources)
        shutil.copytree(TOP, self.sources, ignore=shutil.ignore_patterns("build*", ".git"))
        run(["cmake", "-S", self.sources, "-B", self.build, "-D", "ANISOTROPIC_MESH_2_BUILD_EXAMPLES=OFF"], check=True)

    def outcome(self, mutation):
        header = self.sources / "include/CGAL" / mutation.header
        text = header.read_text()
        header.write_text(text.replace(mutation.before, mutation.after))
        try:
            return next((f"noticed by {test}" for test in mutation.tests if not self.passes(test)), "UNNOTICED")
        finally:
            header.write_text(text)

    def passes(self, test):
        built = run(["cmake", "--build", self.build, "--target", test])
        if built.returncode:
            sys.exit(f"{test} does not compile:\n{built.stdout[-3000:]}")
        try:
            program = self.build / "test/Anisotropic_mesh_2" / test
            return run([program, self.sources / "test/Anisotropic_mesh_2/data"], timeout=900).returncode == 0
        except subprocess.TimeoutExpired:
            return False


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=Path, nargs="?")
    parser.add_argument("--layer")
    parser.add_argument("--list", action="store_true", help="tell only which mutations apply")
    arguments = parser.parse_args()
    if arguments.folder is None and not arguments.list:
        parser.error("a folder to build in, or --list")
    laboratory = None if arguments.list else Laboratory(arguments.folder.resolve())
    status = 0
    for mutation in read_mutations():
        if arguments.layer in (None, mutation.layer):
            outcome = complaint(mutation, TOP) or ("applies" if arguments.list else laboratory.outcome(mutation))
            status |= outcome.split()[0].isupper()
            print(f"{mutation.layer}: {mutation.name}: {outcome}", flush=True)
    return status


if __name__ == "__main__":
    sys.exit(main())
