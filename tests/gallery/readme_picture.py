#!/usr/bin/env python3
"""The README's picture: parts of two of the gallery's, side by side.

    readme_picture.py LVSM_GALLERY           renders the gallery and fails where docs/gallery.png is another picture
    readme_picture.py LVSM_GALLERY --write   writes it

Exit status 77: no Vulkan device. Pixels may differ a little, since drivers round differently.
"""
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

PICTURE = pathlib.Path(__file__).resolve().parents[2] / "docs/gallery.png"
PARTS = ["bench-directional-vsm.png", "bench-directional-lvsm4.png"]
LEFT, TOP, WIDTH, HEIGHT = 140, 166, 400, 260
GAP = 8
SIGNATURE = b"\x89PNG\r\n\x1a\n"
# Of the difference between the two parts, how much of a difference from the README's picture is rounding.
SHARE = 0.1


def read_png(path):
    """Rows of RGB bytes, of a file with 8 bits a channel and no interlacing."""
    data = path.read_bytes()
    at, packed = len(SIGNATURE), b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        chunk = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, *form = struct.unpack(">IIBBBBB", chunk)
            assert form[:2] == [8, 2] and form[4] == 0, f"{path}: not RGB of 8 bits"
        packed += chunk if kind == b"IDAT" else b""
        at += length + 12
    return unfiltered(zlib.decompress(packed), width, height)


def unfiltered(data, width, height):
    rows, above, step = [], bytearray(3 * width), 3 * width + 1
    for y in range(height):
        kind, row = data[y * step], bytearray(data[y * step + 1:(y + 1) * step])
        for x, value in enumerate(row):
            left, corner = (row[x - 3], above[x - 3]) if x >= 3 else (0, 0)
            up = above[x]
            if kind == 4:
                guess = min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))[2]
            else:
                guess = (0, left, up, (left + up) // 2)[kind]
            row[x] = (value + guess) & 255
        rows.append(row)
        above = row
    return rows


def png(rows):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    # Each row less the one above it, which compresses well.
    lines = b"".join(b"\2" + bytes((a - b) & 255 for a, b in zip(row, above))
                     for row, above in zip(rows, [bytes(len(rows[0])), *rows]))
    return SIGNATURE + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b"")


def composed(folder):
    parts = [[row[3 * LEFT:3 * (LEFT + WIDTH)] for row in read_png(folder / name)[TOP:TOP + HEIGHT]] for name in PARTS]
    return [bytes(a) + b"\xff" * 3 * GAP + bytes(b) for a, b in zip(*parts)]


def difference(some, others):
    return sum(abs(a - b) for row, other in zip(some, others) for a, b in zip(row, other)) / sum(map(len, some))


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch) / "gallery"
        done = subprocess.run([sys.argv[1], "--output", str(folder), "--scene", "bench", "--technique", "vsm",
                               "--technique", "lvsm4"], stdout=subprocess.DEVNULL)
        if done.returncode != 0:
            return done.returncode
        rows = composed(folder)
    if "--write" in sys.argv:
        PICTURE.write_bytes(png(rows))
        return 0
    there = read_png(PICTURE)
    if [len(row) for row in there] != [len(row) for row in rows]:
        print(f"{PICTURE} has another size; tests/gallery/readme_picture.py build/examples/gallery/lvsm_gallery --write mends it")
        return 1
    allowed = SHARE * difference([row[:3 * WIDTH] for row in rows], [row[-3 * WIDTH:] for row in rows])
    found = difference(there, rows)
    print(f"mean difference of a channel {found:.3f} of 255, {allowed:.3f} allowed")
    return 0 if found <= allowed else 1


if __name__ == "__main__":
    sys.exit(main())
