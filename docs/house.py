#!/usr/bin/env python3
"""Draws the house: every folder of code as a room, an arrow where one includes another.

    docs/house.py           writes docs/pictures/house.svg (needs Graphviz)
    docs/house.py --check   fails where that picture is not of today's includes

An arrow that follows from others (a -> b -> c makes a -> c) is left out. The headers at a folder's root are its
front door, which the rooms behind it may include; those arrows are left out, too.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURE = ROOT / "docs/pictures/house.svg"
LAYERS = ["cli", "yaml", "reports", "problems", "algorithms", "framework"]
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def rooms():
    """Each folder of code with the folders that its files include."""
    found = {}
    for layer in LAYERS:
        for file in sorted((ROOT / layer).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            room = file.parent.relative_to(ROOT).as_posix()
            targets = found.setdefault(room, set())
            for path in INCLUDE.findall(file.read_text(encoding="utf-8")):
                target = pathlib.PurePosixPath(path).parent.as_posix()
                behind_its_door = room.startswith(target + "/")
                if target != room and target.split("/")[0] in LAYERS and not behind_its_door:
                    targets.add(target)
    return {room: {target for target in targets if target in found} for room, targets in found.items()}


def reachable(graph, start):
    seen, stack = set(), [start]
    while stack:
        for target in graph[stack.pop()]:
            if target not in seen:
                seen.add(target)
                stack.append(target)
    return seen


def arrows(graph):
    """The arrows that do not follow from others."""
    kept = []
    for room, targets in sorted(graph.items()):
        for target in sorted(targets):
            if not any(target in reachable(graph, other) for other in targets - {target}):
                kept.append((room, target))
    return kept


def dot(graph):
    lines = ["digraph house {", '  graph [rankdir=TB, ranksep=0.5, nodesep=0.2, fontname="DejaVu Sans", style=rounded];',
             '  node [shape=box, style="rounded,filled", fillcolor=white, fontname="DejaVu Sans", fontsize=11];',
             '  edge [color="#666666", arrowsize=0.7];']
    for layer in LAYERS:
        members = [room for room in sorted(graph) if room.split("/")[0] == layer]
        lines.append(f'  subgraph "cluster_{layer}" {{ label="{layer}/"; color="#999999"; bgcolor="#f4f4f4";')
        lines += [f'    "{room}" [label="{room.removeprefix(layer + "/")}"];' for room in members]
        lines.append("  }")
    lines += [f'  "{room}" -> "{target}";' for room, target in arrows(graph)]
    return "\n".join(lines + ["}"]) + "\n"


def drawn():
    """The arrows in the picture: Graphviz writes each as a title."""
    titles = re.findall(r"<title>([^<]+)&#45;&gt;([^<]+)</title>", PICTURE.read_text(encoding="utf-8"))
    return sorted(titles)


def main():
    graph = rooms()
    if sys.argv[1:] == ["--check"]:
        missing = set(arrows(graph)) ^ set(drawn())
        for room, target in sorted(missing):
            print(f"docs/pictures/house.svg is not of today's includes: {room} -> {target}; run docs/house.py")
        return 1 if missing else 0
    svg = subprocess.run(["dot", "-Tsvg"], input=dot(graph), capture_output=True, text=True, check=True).stdout
    PICTURE.write_text(svg, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
