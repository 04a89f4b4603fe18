#!/usr/bin/env python3
"""Compiles one shader file for one target, in a program that includes nothing else and calls its every function.

The program of all topics is also compiled with LVSM_MAX_LAYERS at other values and with LVSM_PRECISE defined empty.
Fails on any warning. Without --single a file is included; with it, the file stands in the program as pasted.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import lvsm_api  # noqa: E402

SETTINGS = ["", "#define LVSM_MAX_LAYERS 2\n", "#define LVSM_MAX_LAYERS 16\n", "#define LVSM_PRECISE\n"]
GLSL_TARGETS = {  # #version, and the stages that it has among those used here
    "330": ("330 core", ["frag"]),
    "400": ("400 core", ["frag"]),
    "450": ("450 core", ["frag", "comp"]),
    "300_es": ("300 es", ["frag"]),
    "320_es": ("320 es", ["frag", "comp"]),
    "vulkan": ("450 core", ["frag", "comp"]),
}
HLSL_TARGETS = [f"{stage}_6_0_{form}" for stage in ("cs", "ps") for form in ("dxil", "spirv", "glslang")]
GLSL_MAIN = {
    "frag": "layout(location = 0) out vec4 result;\nvoid main() {\n    vec4 v = gl_FragCoord;\n%s    result = vec4(sum);\n}\n",
    "comp": "layout(local_size_x = 1) in;\nlayout(std430, binding = 0) buffer Result { float result; };\n"
            "void main() {\n    vec4 v = vec4(gl_GlobalInvocationID, 1);\n%s    result = sum;\n}\n",
}
HLSL_MAIN = {
    "ps": "float4 main(float4 v : POSITION) : SV_Target {\n%s    return float4(sum, sum, sum, sum);\n}\n",
    "cs": "RWStructuredBuffer<float> result;\n[numthreads(1, 1, 1)]\nvoid main(uint3 id : SV_DispatchThreadID) {\n"
          "    float4 v = float4(id, 1);\n%s    result[0] = sum;\n}\n",
}


def topics_of(name):
    return sorted(lvsm_api.topics(ROOT, "GLSL")) if name == lvsm_api.UMBRELLA else [name]


def calls(language, name):
    """Statements that call every function of a file with values the compiler does not know, and add up the results."""
    arguments = {"float": "v.x", "float2": "v.xy", "float3": "v.xyz", "float4": "v", "int": "int(v.y)",
                 "int2": "ivec2(v.zw)" if language == "GLSL" else "int2(v.zw)", "float[]": "weights",
                 "inout float[]": "splits", "uint2": "code.xy", "uint4": "code", "MixtureComponent": "component",
                 "Mixture": "mixture", "inout Mixture": "mixture", "MixturePlane": "plane"}
    members = {"MixtureComponent": ".weight", "Mixture": ".components[1].weight", "MixturePlane": ".weight",
               "MixturePlanes": ".planes[1].weight"}
    lines = ["float sum = 0.0;", "float splits[LVSM_MAX_LAYERS + 1];", "float weights[LVSM_MAX_LAYERS + 1];",
             "for (int i = 0; i <= LVSM_MAX_LAYERS; ++i) { splits[i] = v.x + float(i); weights[i] = v.y; }"]
    topics = topics_of(name)
    if {"components", "mixture"} & set(topics):
        lines += ["lvsm_MixtureComponent component = lvsm_tapComponent(v.x);",
                  "lvsm_Mixture mixture = lvsm_mixtureOfTaps(v, v, v, 3);"]
    if "mixture" in topics:
        lines += [f"{'uvec4' if language == 'GLSL' else 'uint4'} code = lvsm_encodeMixture4(mixture, v.x);",
                  "lvsm_MixturePlane plane = lvsm_componentPlane(component);"]
    for topic in topics:
        for function in lvsm_api.functions(ROOT, language, topic):
            call = f"lvsm_{function.name}({', '.join(arguments[type_] for type_, _ in function.parameters)})"
            if function.result == "void":
                changed = "mixture.components[1].weight" if "mixture" in call else "splits[1]"
                lines.append(f"{call}; sum += {changed};")
            elif function.result in members:
                lines.append(f"sum += {call}{members[function.result]};")
            else:
                lines.append(f"sum += float({call}{'.y' if function.result[-1].isdigit() else ''});")
    return "".join(f"    {line}\n" for line in lines)


class Failure(Exception):
    pass


def run(*command):
    if not shutil.which(command[0]):
        print(f"skipped: no {command[0]}")
        sys.exit(77)
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode != 0 or "WARNING:" in result.stdout:  # glslang's; -WX is dxc's
        print(*command, result.stdout, sep="\n")
        if result.returncode == 77:
            sys.exit(77)
        raise Failure


def compile_glsl(options, setting, text, folder):
    version, stages = GLSL_TARGETS[options.target]
    head = f"#version {version}\n"
    if not options.single:
        head += "#extension GL_GOOGLE_include_directive : require\n"
    if version.endswith("es"):
        head += "precision highp float;\nprecision highp int;\n"
    for stage in stages:
        path = f"{folder}/shader.{stage}"
        pathlib.Path(path).write_text(head + setting + text + GLSL_MAIN[stage] % calls("GLSL", options.name))
        if options.target == "vulkan":
            run(options.glslang, "-V", f"-I{ROOT}/glsl", "-o", f"{folder}/out.spv", path)
            run("spirv-val", "--target-env", "vulkan1.0", f"{folder}/out.spv")
        else:
            run(options.glslang, "-l", f"-I{ROOT}/glsl", path)


def compile_hlsl(options, setting, text, folder):
    profile, form = options.target.rsplit("_", 1)
    stage = profile[:2]
    path = f"{folder}/shader.hlsl"
    pathlib.Path(path).write_text(setting + text + HLSL_MAIN[stage] % calls("HLSL", options.name))
    output = f"{folder}/out"
    if form == "glslang":
        run(options.glslang, "-D", "-V", "-e", "main", "-S", {"cs": "comp", "ps": "frag"}[stage], f"-I{ROOT}/hlsl",
            "-o", output, path)
    else:
        run(options.dxc, "-T", profile, "-E", "main", "-WX", "-I", f"{ROOT}/hlsl", "-Fo", output,
            *(["-spirv"] if form == "spirv" else []), path)
    if form != "dxil":
        run("spirv-val", "--target-env", "vulkan1.0", output)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("language", choices=["GLSL", "HLSL"])
    parser.add_argument("name", help="a topic, or lvsm for all")
    parser.add_argument("target", choices=[*GLSL_TARGETS, *HLSL_TARGETS])
    parser.add_argument("--single", type=pathlib.Path, help="the one-file version, in place of the include")
    parser.add_argument("--glslang", default="glslangValidator")
    parser.add_argument("--dxc", default="dxc")
    options = parser.parse_args()

    if options.single:
        text = options.single.read_text()
    else:
        text = f'#include "lvsm/{lvsm_api.source(ROOT, options.language, options.name).name}"\n'
    compile_ = compile_glsl if options.language == "GLSL" else compile_hlsl
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for setting in SETTINGS if options.name == lvsm_api.UMBRELLA else SETTINGS[:1]:
            try:
                compile_(options, setting, text, folder)
            except Failure:
                failed += 1
                print(f"failed with {setting.strip() or 'no setting'}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
