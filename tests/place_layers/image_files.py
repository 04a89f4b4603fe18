"""Writes small images of one number a pixel, as rows of numbers, the first row on top."""
import struct
import zlib


def png(rows, bits=16):
    """Numbers in [0,1], rounded to unsigned whole ones."""
    most = (1 << bits) - 1
    width, height = len(rows[0]), len(rows)
    code = ">H" if bits == 16 else "B"
    lines = b"".join(b"\0" + b"".join(struct.pack(code, round(x * most)) for x in row) for row in rows)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, bits, 0, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))


def pfm(rows, colours=1, big_endian=False):
    """The first of the colours holds the numbers."""
    head = f"{'Pf' if colours == 1 else 'PF'}\n{len(rows[0])} {len(rows)}\n{1.0 if big_endian else -1.0}\n".encode()
    pixels = [x for row in reversed(rows) for depth in row for x in [depth, 7.0, -7.0][:colours]]
    return head + struct.pack(f"{'>' if big_endian else '<'}{len(pixels)}f", *pixels)


def exr(rows, channels=("Z",), depth="Z"):
    """An uncompressed file of scanlines in 32-bit floats; channels other than that of the depth hold 0.5."""
    width, height = len(rows[0]), len(rows)

    def attribute(name, kind, data):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data

    listed = b"".join(name.encode() + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for name in sorted(channels)) + b"\0"
    window = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    head = b"\x76\x2f\x31\x01" + struct.pack("<i", 2) + b"".join([
        attribute("channels", "chlist", listed), attribute("compression", "compression", b"\0"),
        attribute("dataWindow", "box2i", window), attribute("displayWindow", "box2i", window),
        attribute("lineOrder", "lineOrder", b"\0"), attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0)),
        attribute("screenWindowWidth", "float", struct.pack("<f", 1))]) + b"\0"
    size = 4 * width * len(channels)
    first = len(head) + 8 * height
    offsets = b"".join(struct.pack("<Q", first + y * (8 + size)) for y in range(height))
    lines = b"".join(struct.pack("<ii", y, size) + b"".join(
        struct.pack(f"<{width}f", *(row if name == depth else [0.5] * width)) for name in sorted(channels))
        for y, row in enumerate(rows))
    return head + offsets + lines
