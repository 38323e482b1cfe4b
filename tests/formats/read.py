"""Files whose names end in `.arrow` and `.png`, read by others than those that wrote them: `read.py LINKWRIGHT FOLDER BATCH`."""

import json
import math
import subprocess
import sys
from pathlib import Path

import pyarrow
from PIL import Image

CRANK = "docs/mechanisms/crank_rocker.mech"


def run(*arguments):
    return subprocess.run([sys.argv[1], *arguments], check=True, capture_output=True, text=True).stdout


def file(name, *arguments):
    path = Path(sys.argv[2]) / name
    run(*arguments, "--out", str(path))
    return path


def a_run():
    """The columns are those of the comma-separated values, to the bit, with names, units, and what the run was."""
    arguments = ["run", CRANK, "--for", "0.5s", "--input", "drive=2*sin(pi*t)", "--show", "outputs,energy,reactions"]
    head, *lines = run(*arguments).splitlines()
    rows = [[float(number) for number in line.split(",")] for line in lines]
    assert len(rows) == 501, len(rows)
    table = pyarrow.ipc.open_file(file("run.arrow", *arguments)).read_all()
    names = [f"{field.name} [{field.metadata[b'unit'].decode()}]" for field in table.schema]
    assert names == head.split(","), (names, head)
    columns = [column.to_pylist() for column in table.columns]
    assert [list(row) for row in zip(*columns)] == rows
    about = table.schema.metadata
    assert about[b"mechanism"] == b"CrankRocker" and about[b"step"] == b"0.001 s", about
    assert [it["name"] for it in json.loads(about[b"parameters"])] == ["crank_length", "payload"], about
    print(f"{len(rows)} rows of {len(names)} columns in Arrow")


def a_batch():
    """A row for each step that was recorded and each member, to the bit; who could not be prepared is no number."""
    path = Path(sys.argv[2]) / "batch.arrow"
    text = subprocess.run([sys.argv[3], str(path)], check=True, capture_output=True, text=True).stdout
    rows = [line.split(",") for line in text.splitlines()]
    table = pyarrow.ipc.open_file(path).read_all()
    assert table.column_names == ["step", "member", "height", "across"], table.column_names
    assert [str(field.type) for field in table.schema] == ["uint64", "uint64", "double", "double"], table.schema
    assert table.num_rows == len(rows) == 4 * 13, len(rows)
    for row, (step, member, *numbers) in zip(table.to_pylist(), rows):
        assert (row["step"], row["member"]) == (int(step), int(member)), row
        for name, number in zip(["height", "across"], numbers):
            # Of member 0, whose length is out of bounds, NaN.
            assert row[name] == float(number) or member == "0" and math.isnan(row[name]), (row, number)
    assert -1.25 <= min(row["height"] for row in table.to_pylist()[1:13] + table.to_pylist()[40:]) < -0.2
    print(f"{len(rows)} rows of a batch in Arrow")


def pictures():
    """Pictures have paper, lines and letters in the colours of the SVG."""

    def share(image, *colour):
        near = sum(all(abs(a - b) < 8 for a, b in zip(pixel, colour)) for pixel in image.get_flattened_data())
        return near / (image.width * image.height)

    plot = Image.open(file("plot.png", "plot", CRANK, "--for", "1s")).convert("RGBA")
    for name, colour, least in [
        ("paper", (255, 255, 255, 255), 0.8),
        ("lines", (0x1F, 0x6F, 0xD1, 255), 1e-3),
        ("letters", (0x58, 0x63, 0x73, 255), 3e-4),
    ]:
        assert share(plot, *colour) > least, (name, share(plot, *colour))
    with_names = Image.open(file("drawing.png", "draw", CRANK, "--dimensions")).convert("RGBA")
    svg = file("drawing.svg", "draw", CRANK, "--dimensions").read_text()
    width, height = (float(svg.split(f' {name}="')[1].split('"')[0]) for name in ("width", "height"))
    assert abs(with_names.width - 2 * width) <= 1 and abs(with_names.height - 2 * height) <= 1, with_names.size
    assert share(with_names, 255, 255, 255, 255) > 0.9
    assert share(with_names, 0x1B, 0x23, 0x30, 255) > 3e-3, "nothing is drawn"
    influence = ["influence", CRANK, "--along", "--svg", "--for", "1s"]
    assert Image.open(file("influence.png", *influence)).width > 600
    print(f"three pictures in PNG, the drawing of {with_names.width} × {with_names.height} pixels")


a_run()
a_batch()
pictures()
