#!/usr/bin/env python3
"""Compares the structs that include/lvsm/passes*.hpp fill with the uniform blocks of the compiled passes, member by member.

WGSL's, of which no compiler here tells the offsets, are laid out by the rules of its specification, 14.4.

    blocks.py --glslang glslangValidator --dxc dxc --disassembler spirv-dis
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Struct, its block in the shaders, a GLSL pass with it, the same in HLSL with its entry point, and what switches it on.
BLOCKS = [("BlurBlock", "lvsm_Blur", "blur.comp", "blur.hlsl", "lvsm_blurCompute", {}),
          ("StoreBlock", "lvsm_Store", "store.comp", "store.hlsl", "lvsm_storeCompute", {}),
          ("PlaceBlock", "lvsm_Place", "place.comp", "place.hlsl", "lvsm_placeCompute", {}),
          ("PlaceBlock", "lvsm_Place", "place_histogram.comp", "place.hlsl", "lvsm_histogramCompute", {}),
          ("FusedBlock", "lvsm_Fused", "fused.comp", "fused.hlsl", "lvsm_fusedCompute", {}),
          ("MipBlock", "lvsm_Mip", "mip.comp", "mip.hlsl", "lvsm_mipCompute", {}),
          ("MixingBlock", "lvsm_Mixing", "mixture.comp", "mixture.hlsl", "lvsm_mixtureCompute", {}),
          ("StepBlock", "lvsm_Step", "step_sums.frag", "step.hlsl", "lvsm_stepSumsPixel", {}),
          ("StepBlock", "lvsm_Step", "step_move.frag", "step.hlsl", "lvsm_stepMovePixel", {}),
          ("DepthBlock", "lvsm_Depths", "store.comp", "store.hlsl", "lvsm_storeCompute",
           {"glsl": "LVSM_DEPTH_SOURCE=layout(binding=4,std140)", "hlsl": "LVSM_DEPTH_SOURCE=b4"})]


def structs():
    """Offset of each member of each struct: all are arrays of four bytes each."""
    text = "".join(path.read_text() for path in sorted((ROOT / "include/lvsm").glob("passes*.hpp")))
    constants = {name: int(value) for name, value in re.findall(r"constexpr int (k\w+) = (\d+);", text)}
    found = {}
    for struct, body in re.findall(r"^struct (\w+Block)\n\{\n(.*?)^\};", text, re.MULTILINE | re.DOTALL):
        offset, members = 0, {}
        for line in re.sub(r" *//[^\n]*", "", body).split(";")[:-1]:
            name, sizes = re.fullmatch(r"\s*(?:float|std::int32_t) (\w+)((?:\[[^\]]+\])*)", line).groups()
            members[name] = offset
            count = 1
            for size in re.findall(r"\[([^\]]+)\]", sizes):
                count *= eval(size, {"__builtins__": {}}, constants)
            offset += 4 * count
        found[struct] = members
    return found


def offsets(disassembly, block):
    """Offset of each member of a block, without the lvsm_ in front of its name."""
    ids = re.findall(rf'OpName (%\S+) "(?:type\.)?{block}"', disassembly)
    for id_ in ids:
        names = re.findall(rf'OpMemberName {re.escape(id_)} (\d+) "lvsm_(\w+)"', disassembly)
        places = dict(re.findall(rf"OpMemberDecorate {re.escape(id_)} (\d+) Offset (\d+)", disassembly))
        if names:
            return {name: int(places[number]) for number, name in names}
    return {}


def commands(options, glsl, hlsl, entry, macros):
    passes = ROOT / "glsl/lvsm/passes", ROOT / "hlsl/lvsm/passes"
    stage = glsl.rsplit(".", 1)[1]
    define = [f"-D{macros[language]}" if macros else "-DUNUSED=1" for language in ("glsl", "hlsl")]
    yield "GLSL", [options.glslang, "-V", "--target-env", "vulkan1.1", define[0], passes[0] / glsl, "-o"]
    yield "HLSL, glslang", [options.glslang, "-D", "-V", "--target-env", "vulkan1.1", "--hlsl-offsets", define[1], "-e",
                            entry, "-S", stage, passes[1] / hlsl, "-o"]
    yield "HLSL, dxc", [options.dxc, "-T", {"comp": "cs_6_0", "frag": "ps_6_0"}[stage], "-E", entry, "-spirv", "-fspv-target-env=vulkan1.1", define[1],
                        passes[1] / hlsl, "-Fo"]


def size_and_alignment(kind, constants):
    """Of a type of WGSL in a uniform block, where the elements of an array lie 16 bytes apart or more."""
    array = re.fullmatch(r"array<(.+), ([^<>]+)>", kind)
    if array:
        size, alignment = size_and_alignment(array[1], constants)
        stride = -(-size // alignment) * alignment
        if stride % 16 != 0:
            raise ValueError(f"{kind} is no array of a uniform block")
        return stride * eval(array[2].replace("/", "//"), {"__builtins__": {}}, constants), alignment
    count = int(re.fullmatch(r"(?:f32|i32|u32|vec([234])[fiu])", kind)[1] or 1)
    return 4 * count, 4 * (4 if count == 3 else count)


def wgsl_offsets(body, constants):
    """Offset of each member of a struct with this text."""
    offset, members = 0, {}
    for name, kind in re.findall(r"^\s*(\w+): (.+),$", body, re.MULTILINE):
        size, alignment = size_and_alignment(kind, constants)
        offset = -(-offset // alignment) * alignment
        members[name] = offset
        offset += size
    return members


def check_wgsl(wanted):
    """Every uniform block of the passes in WGSL, of which each file says what its type is."""
    text = "".join(path.read_text() for path in sorted((ROOT / "wgsl/lvsm/passes").glob("*.wgsl")))
    config = (ROOT / "wgsl/lvsm/config.wgsl").read_text()
    constants = {name: int(value) for name, value in re.findall(r"const (\w+): i32 = (\d+);", config + text)}
    structs_of = {block: struct for struct, block, *_ in BLOCKS}
    used = sorted(set(re.findall(r"var<uniform> \w+: (\w+);", text)))
    if not used:
        print("FAIL no pass in WGSL has a uniform block")
        yield False
    for block in used:
        if block not in structs_of:
            print(f"FAIL {block} of WGSL is compared with no struct: add it to BLOCKS of {__file__}")
            yield False
            continue
        struct = structs_of[block]
        body = re.search(rf"^struct {block}\n{{\n(.*?)^}}", text, re.MULTILINE | re.DOTALL)[1]
        found = wgsl_offsets(body, constants)
        yield agree(struct, block, "WGSL", wanted[struct], found)


def agree(struct, block, how, expected, found):
    """Whether the offsets are the same; says so."""
    expected = {name: offset for name, offset in expected.items() if name != "unused"}
    print(f"{'ok  ' if found == expected else 'FAIL'} {struct} and {block}, {how}: {found}")
    if found != expected:
        print(f"     the struct has {expected}")
    return found == expected


def check(options, folder):
    wanted = structs()
    yield from check_wgsl(wanted)
    for struct, block, glsl, hlsl, entry, macros in BLOCKS:
        for compiler, command in commands(options, glsl, hlsl, entry, macros):
            binary = pathlib.Path(folder) / "pass.spv"
            subprocess.run([str(part) for part in [*command, binary]], check=True, stdout=subprocess.DEVNULL)
            text = subprocess.run([options.disassembler, "--raw-id", binary], check=True, stdout=subprocess.PIPE,
                                  text=True).stdout
            yield agree(struct, block, f"{compiler}, {hlsl}", wanted[struct], offsets(text, block))
    for struct in wanted.keys() - {row[0] for row in BLOCKS}:
        print(f"FAIL {struct} is compared with no shader: add it to BLOCKS of {__file__}")
        yield False


def is_missing(command):
    return not shutil.which(command) or subprocess.run([command, "--version"], stdout=subprocess.DEVNULL).returncode == 77


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
for option in ("--glslang", "--dxc", "--disassembler"):
    parser.add_argument(option, required=True)
arguments = parser.parse_args()
for missing in filter(is_missing, (arguments.glslang, arguments.dxc, arguments.disassembler)):
    print(f"skipped: no {missing}")
    sys.exit(77)
with tempfile.TemporaryDirectory() as temporary:
    results = list(check(arguments, temporary))
sys.exit(0 if results and all(results) else 1)
