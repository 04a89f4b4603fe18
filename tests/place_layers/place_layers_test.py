"""Runs one case: place_layers_test.py CASE PROGRAM [OPTIONS]. Without arguments, lists the cases."""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import zlib

from image_files import exr, pfm, png

PEAKS = [0.25, 0.5, 0.875]
METHODS = ["uniform", "lloyd", "optimal"]

cases = {}


def case(function):
    cases[function.__name__] = function


def stripes(depths=PEAKS, background=0.0, width=48, height=16):
    """Two columns of background, then two of each depth in turn: where columns meet, the second occluder is the deeper."""
    return [[background if x % 4 < 2 else depths[x // 4 % len(depths)] for x in range(width)] for _ in range(height)]


def run(*arguments, **more):
    done = subprocess.run([program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **more)
    print(done.stdout, done.stderr, sep="", end="")
    return done


def write(path, content):
    path.write_bytes(content)
    return path


def placed(*arguments):
    done = run(*arguments, "--format", "json")
    assert done.returncode == 0, f"exit status {done.returncode}"
    return json.loads(done.stdout)


def is_near(one, other, tolerance=1e-6):
    return len(one) == len(other) and all(abs(a - b) <= tolerance for a, b in zip(one, other))


def expect_refusal(done, *named):
    assert done.returncode != 0 and done.stdout == "", f"exit status {done.returncode}"
    for name in named:
        assert str(name) in done.stderr, f"no word of {name}"


@case
def theMethodsAreTheLibrarys(folder):
    path = write(folder / "d.pfm", pfm(stripes()))
    by = {method: placed(path, "--layers", 4, "--method", method)["splits"] for method in METHODS}
    assert by["uniform"] == [0, 0.25, 0.5, 0.75, 1]
    # Relaxation puts the splits on the second occluders; the splits of least spread part four depths.
    assert is_near(by["lloyd"], [0, *PEAKS, 1], 1e-5), by
    between = [a < split < b for a, b, split in zip([0, *PEAKS], PEAKS, by["optimal"][1:])]
    assert all(between), by


@case
def everyFormatGivesTheSameDepths(folder):
    rows = stripes()
    expected = placed(write(folder / "d.pfm", pfm(rows)))["splits"]
    others = {"big.pfm": pfm(rows, big_endian=True), "colour.pfm": pfm(rows, colours=3), "z.exr": exr(rows),
              "grey.exr": exr(rows, ["Y"], "Y"), "layer.exr": exr(rows, ["R", "A", "View.Depth.Z"], "View.Depth.Z"),
              "red.exr": exr(rows, ["R", "G", "B"], "R"), "one.exr": exr(rows, ["depth"], "depth")}
    for name, content in others.items():
        assert placed(write(folder / name, content))["splits"] == expected, name
    # Of 16 bits, within half a step.
    assert is_near(placed(write(folder / "d.png", png(rows)))["splits"], expected, 1e-3)


@case
def depthsAreMadeLinear(folder):
    linear = stripes(background=0.125)
    expected = placed(write(folder / "d.pfm", pfm(linear)))["splits"]
    near, far = 2.0, 10.0
    planes = ["--near", near, "--far", far]

    def each(convert):
        return pfm([[convert(depth) for depth in row] for row in linear])

    def projected(depth):
        distance = near + depth * (far - near)
        return far * (distance - near) / (distance * (far - near))

    distances = write(folder / "distances.pfm", each(lambda depth: near + depth * (far - near)))
    assert is_near(placed(distances, *planes)["splits"], expected, 1e-4)
    perspective = write(folder / "projected.pfm", each(projected))
    assert is_near(placed(perspective, *planes, "--projected")["splits"], expected, 1e-3)
    reverse = write(folder / "reversed.pfm", each(lambda depth: 1 - projected(depth)))
    assert is_near(placed(reverse, *planes, "--reversed-z")["splits"], expected, 1e-3)
    orthographic = write(folder / "orthographic.pfm", each(lambda depth: 1 - depth))
    assert is_near(placed(orthographic, "--reversed-z")["splits"], expected, 1e-3)


@case
def pixelsCountAsTheirWeights(folder):
    # The left half parts at 0.5, the right one at 0.875; what does not count does not matter.
    left, right = stripes([0.5], width=24), stripes([0.875], width=24)
    path = write(folder / "d.pfm", pfm([a + b for a, b in zip(left, right)]))
    screen = write(folder / "screen.png", png([[1.0] * 23 + [0.0] * 25 for _ in left], bits=8))
    other = write(folder / "other.png", png([[0.0] * 24 + [1.0] * 24 for _ in left], bits=8))
    lloyd = ["--layers", 2, "--method", "lloyd"]
    assert is_near(placed(path, *lloyd, "--weights", screen)["splits"], [0, 0.5, 1], 1e-5)
    assert is_near(placed(path, *lloyd, "--weights", other)["splits"], [0, 0.875, 1], 1e-5)
    assert not is_near(placed(path, *lloyd)["splits"], [0, 0.5, 1], 0.05)
    # The first row is on top, in each format.
    top = stripes([0.5], height=9) + stripes([0.875], height=9)
    upper = write(folder / "upper.png", png([[1.0] * 48] * 8 + [[0.0] * 48] * 10, bits=8))
    for name, content in {"top.pfm": pfm(top), "top.exr": exr(top), "top.png": png(top)}.items():
        found = placed(write(folder / name, content), *lloyd, "--weights", upper)["splits"]
        assert is_near(found, [0, 0.5, 1], 1e-3), (name, found)
    optimal = ["--layers", 2]
    first = placed(path, *optimal, "--weights", screen)["splits"][1]
    second = placed(path, *optimal, "--weights", other)["splits"][1]
    assert first < second - 0.1, (first, second)


@case
def predictedErrorsAreThoseOfTheWindows(folder):
    # Windows from each pixel on, worked out here: Cantelli's bound, at receivers 0.01 in front of the surfaces.
    rows = [[0.0, 0.0, 0.0, 0.5, 0.5]] * 5
    row = placed(write(folder / "d.pfm", pfm(rows)), "--layers", 1)
    windows = [[rows[v][u] for v in range(y, 5) for u in range(x, 5)] for y in range(5) for x in range(5)]
    total, count = 0.0, 0
    for taps in windows:
        m1, m2 = sum(taps) / len(taps), sum(t * t for t in taps) / len(taps)
        v = max(1e-5, m2 - m1 * m1)
        for depth in [max(0, tap - 0.01) for tap in taps]:
            bound = 1.0 if depth <= m1 else v / (v + (depth - m1) ** 2)
            lit = sum(t >= depth for t in taps) / len(taps)
            total, count = total + (bound - lit) ** 2, count + 1
    for estimate in ("layered", "bracketed"):
        assert abs(row["errors"]["uniform"][estimate] - math.sqrt(total / count)) < 1e-6, row
    # Three depths in a window: two layers between them leave the bracketed estimate no error but the floors'.
    three = write(folder / "three.pfm", pfm(stripes([0.25, 0.875], 0.5)))
    errors = placed(three, "--layers", 3)["errors"]
    assert errors["optimal"]["bracketed"] < 0.5 * errors["optimal"]["layered"], errors
    assert placed(three, "--layers", 3, "--overlap", 0.01)["errors"]["optimal"].keys() == {"layered"}


@case
def wordsSayTheErrorsAndTheLayers(folder):
    done = run(write(folder / "d.pfm", pfm(stripes())), "--layers", 3)
    assert done.returncode == 0 and done.stderr == ""
    edges = [line.split()[3::2] for line in done.stdout.splitlines() if line.startswith("layer ")]
    numbers = [float(begin) for begin, _ in edges] + [float(edges[-1][1])]
    assert len(numbers) == 4 and numbers == sorted(numbers) and numbers[0] == 0 and numbers[-1] == 1, numbers
    for method in METHODS:
        assert re.search(rf"^  {method} +0\.\d{{4}} +0\.\d{{4}}", done.stdout, re.MULTILINE), method


def compiles(folder, name, source, *command):
    path = folder / name
    path.write_text(source)
    done = subprocess.run([*map(str, command), str(path)], capture_output=True, text=True)
    assert done.returncode == 0, f"{name} does not compile:\n{source}\n{done.stdout}{done.stderr}"


@case
def whatIsPastedCompiles(folder):
    for tool in (options.glslang, options.dxc):
        if tool.endswith("NOTFOUND"):
            print("no shader compiler")
            sys.exit(77)
    # The name of a file gets into a comment, and must not get out of it.
    path = write(folder / "d \\\nx.pfm", pfm(stripes()))
    pasted = {language: run(path, "--layers", 4, "--overlap", 0.015625, "--format", language).stdout
              for language in ("glsl", "hlsl", "cpp")}
    expected = placed(path, "--layers", 4)["splits"]
    glsl = options.sources / "glsl"
    use = "lvsm_layerIndex(depth, kSplits, kLayerCount)"
    for version in ("#version 450", "#version 310 es\nprecision highp float;\nprecision highp int;"):
        compiles(folder, "use.comp", f"""{version}
#extension GL_GOOGLE_include_directive : require
#define LVSM_MAX_LAYERS 4
#include "lvsm/lvsm.glsl"
{pasted["glsl"]}
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Depths {{ float depth; int index; float overlap; }};
void main() {{ index = {use}; overlap = kOverlap; }}
""", options.glslang, "-V" if "450" in version else "-G", f"-I{glsl}", "-o", folder / "use.spv")
    hlsl = f"""#define LVSM_MAX_LAYERS 4
#include "lvsm/lvsm.hlsli"
{pasted["hlsl"]}
float main(float depth : DEPTH) : SV_Target {{ return kOverlap + float({use}); }}
"""
    compiles(folder, "use.hlsl", hlsl, options.dxc, "-T", "ps_6_0", "-I", options.sources / "hlsl", "-Fo", folder / "use.dxil")
    values = ", ".join(f"{x!r}f" if "." in repr(x) or "e" in repr(x) else f"{x}.0f" for x in expected)
    cpp = f"""{pasted["cpp"]}
constexpr float kExpected[] = {{{values}}};
int main() {{
    bool same = kLayerCount == 4 && kOverlap == 0.015625f;
    for (int i = 0; i <= kLayerCount; ++i) same = same && kSplits[i] == kExpected[i];
    return same ? 0 : 1;
}}
"""
    compiles(folder, "use.cpp", cpp, options.cxx, "-std=c++17", "-Wall", "-Wextra", "-Werror", "-o", folder / "use")
    assert subprocess.run([folder / "use"]).returncode == 0, "other splits than JSON has"


def pixels(content):
    """Rows of a PNG of 8-bit RGB whose filters are undone."""
    width, height = (int.from_bytes(content[at:at + 4], "big") for at in (16, 20))
    at, data = 8, b""
    while at < len(content):
        size, kind = int.from_bytes(content[at:at + 4], "big"), content[at + 4:at + 8]
        data += content[at + 8:at + 8 + size] if kind == b"IDAT" else b""
        at += 12 + size
    lines, stride, rows, before = zlib.decompress(data), 3 * width, [], bytes(3 * width)
    for y in range(height):
        kind, line = lines[y * (stride + 1)], bytearray(lines[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a, b, c = line[i - 3] if i >= 3 else 0, before[i], before[i - 3] if i >= 3 else 0
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            line[i] = (line[i] + [0, a, b, (a + b) // 2, paeth][kind]) & 255
        before = bytes(line)
        rows.append([tuple(before[i:i + 3]) for i in range(0, stride, 3)])
    return rows


@case
def thePlotHasTheHistogramAndTheSplits(folder):
    path = write(folder / "d.pfm", pfm(stripes()))
    plot = folder / "plots" / "d.png"
    splits = placed(path, "--layers", 4, "--plot", plot)["splits"]
    assert [p.name for p in plot.parent.iterdir()] == ["d.png"], "left behind"
    rows = pixels(plot.read_bytes())
    assert len(rows[0]) == 1000 and len(rows) == 560
    # Depth 0 is at 110 pixels from the left and 1 at 970; of three peaks each has 1/6 of the pixels, depth 0 half.
    bars = [sum(row[x] == (86, 180, 233) for row in rows) for x in range(1000)]
    assert bars[112] == 320 and bars[540] == round(320 * math.sqrt(1 / 3)), bars[530:550]
    assert sum(bars) == sum(bars[x] for x in range(110, 970))
    for split in splits[1:-1]:
        x = 110 + split * 860
        inks = [x for x in range(1000) if all(row[x] == (40, 40, 40) for row in rows[60:380])]
        assert any(abs(ink - x) <= 2 for ink in inks), (split, inks)


# What cannot be read or placed, by name.


@case
def anImageThatIsNotThereIsNamed(folder):
    expect_refusal(run(folder / "none.exr"), folder / "none.exr")
    expect_refusal(run(folder), folder)
    expect_refusal(run(write(folder / "empty.png", b"")), folder / "empty.png")
    expect_refusal(run(write(folder / "text.exr", b"this is no image at all\n")), folder / "text.exr")
    expect_refusal(run(), "IMAGE")


@case
def aTruncatedImageIsNamed(folder):
    rows = stripes()
    for name, content in {"d.png": png(rows), "d.exr": exr(rows), "d.pfm": pfm(rows)}.items():
        for share in (0.05, 0.5, 0.99):
            path = write(folder / name, content[:int(share * len(content))])
            expect_refusal(run(path), path)
    for name, content in {"zero.pfm": b"Pf\n0 9\n-1\n", "large.pfm": b"Pf\n99999999 99999999\n-1\n0000",
                          "gigabyte.pfm": b"Pf\n16384 16384\n-1\n0000",
                          "scale.pfm": b"Pf\n2 2\n0\n" + bytes(16), "words.pfm": b"Pf\nno size\n-1\n"}.items():
        expect_refusal(run(write(folder / name, content)), folder / name)


@case
def aBrokenHeaderIsNamedOrMakesNoDifference(folder):
    rows = stripes(width=12, height=4)
    for name, content in {"d.png": png(rows), "d.exr": exr(rows), "d.pfm": pfm(rows)}.items():
        for at in range(4, min(64, len(content)), 2):
            broken = bytearray(content)
            broken[at] ^= 0x55
            done = run(write(folder / name, broken), errors="replace")
            assert done.returncode in (0, 1), f"byte {at} of {name}: exit status {done.returncode}"
            assert done.returncode == 0 or str(folder / name) in done.stderr


@case
def anExrWithoutADepthIsNamed(folder):
    path = write(folder / "d.exr", exr(stripes(), ["U", "V"], "U"))
    expect_refusal(run(path), path, "channel")


@case
def eightBitsAreAWarning(folder):
    path = write(folder / "d.png", png(stripes(), bits=8))
    done = run(path)
    assert done.returncode == 0 and "warning" in done.stderr and "8 bits" in done.stderr and str(path) in done.stderr
    assert run(write(folder / "d16.png", png(stripes()))).stderr == ""


@case
def pixelsThatAreNotFiniteAreCountedAndIgnored(folder):
    rows = stripes()
    expected = placed(write(folder / "d.pfm", pfm(rows)))
    holed = [list(row) for row in rows]
    holed[3][5], holed[7][9], holed[11][20] = math.nan, math.inf, -math.inf
    path = write(folder / "holed.pfm", pfm(holed))
    done = run(path, "--format", "json")
    assert done.returncode == 0 and "3 pixels" in done.stderr and str(path) in done.stderr
    found = json.loads(done.stdout)
    assert found["ignored"] == 3 and is_near(found["splits"], expected["splits"], 0.01), found
    path = write(folder / "all.pfm", pfm([[math.nan] * 4] * 4))
    expect_refusal(run(path), path, "finite")


@case
def constantDepthIsNamed(folder):
    path = write(folder / "flat.exr", exr([[0.5] * 8] * 8))
    expect_refusal(run(path), path, "0.5")


@case
def moreLayersThanDepthsAreNamed(folder):
    path = write(folder / "d.pfm", pfm(stripes()))
    expect_refusal(run(path, "--layers", 5), "--layers", path, "4 depths")
    assert run(path, "--layers", 4).returncode == 0
    many = write(folder / "many.pfm", pfm([[x / 99 for x in range(100)]] * 4))
    expect_refusal(run(many, "--layers", 17), "--layers", "16")
    assert len(placed(many, "--layers", 17, "--method", "lloyd")["splits"]) == 18
    for layers in (0, 65, "many"):
        expect_refusal(run(path, "--layers", layers), "--layers")


@case
def depthsOutsideTheirRangeAreNamed(folder):
    path = write(folder / "d.pfm", pfm(stripes([3.0, 40.0])))
    expect_refusal(run(path), path, "40", "--near")
    expect_refusal(run(path, "--near", 1, "--far", 50, "--projected"), path, "projected")
    done = run(path, "--near", 1, "--far", 20, "--layers", 2)
    assert done.returncode == 0 and "warning" in done.stderr and "--near" in done.stderr
    for wrong in (["--near", 1], ["--far", 1], ["--near", 2, "--far", 1], ["--near", 0, "--far", 1, "--projected"],
                  ["--near", "nan", "--far", 1],
                  ["--projected"]):
        expect_refusal(run(path, *wrong), "--near")
    expect_refusal(run(path, "--near", 1, "--far", "inf"), "--far")
    expect_refusal(run(path, "--near", "nowhere", "--far", 1), "--near")


@case
def weightsThatDoNotFitAreNamed(folder):
    path = write(folder / "d.pfm", pfm(stripes()))
    small = write(folder / "small.png", png([[1.0] * 8] * 8, bits=8))
    expect_refusal(run(path, "--weights", small), "--weights", small, "8 x 8")
    black = write(folder / "black.png", png([[0.0] * 48] * 16, bits=8))
    expect_refusal(run(path, "--weights", black), "--weights", black)
    expect_refusal(run(path, "--weights", folder / "none.png"), folder / "none.png")


@case
def anOutputThatCannotBeWrittenIsNamedAndNothingIsLeft(folder):
    path = write(folder / "d.pfm", pfm(stripes()))
    before = sorted(p.name for p in folder.iterdir())
    for plot in (folder / "d.pfm" / "plot.png", "/proc/plot.png", folder):
        expect_refusal(run(path, "--plot", plot), "--plot", plot)
    assert sorted(p.name for p in folder.iterdir()) == before, "left behind"
    with open("/dev/full", "w") as full:
        done = subprocess.run([program, str(path)], stdout=full, stderr=subprocess.PIPE, text=True)
    assert done.returncode != 0 and "standard output" in done.stderr, done.stderr


@case
def optionsThatAreNoneAreNamed(folder):
    path = write(folder / "d.pfm", pfm(stripes()))
    for wrong in (["--method", "best"], ["--format", "wgsl"], ["--overlap", "-1"], ["--overlap", "nan"]):
        expect_refusal(run(path, *wrong), wrong[0])


if len(sys.argv) < 2:
    print(*cases, sep="\n")
    sys.exit(0)
parser = argparse.ArgumentParser()
parser.add_argument("case")
parser.add_argument("program")
parser.add_argument("--sources", type=pathlib.Path)
parser.add_argument("--glslang")
parser.add_argument("--dxc")
parser.add_argument("--cxx")
options = parser.parse_args()
program = options.program
with tempfile.TemporaryDirectory() as scratch:
    cases[options.case](pathlib.Path(scratch))
