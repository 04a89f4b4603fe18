#!/usr/bin/env python3
"""Breaks a small library of one topic in one place, and passes when check.py says so:  self_test.py CASE

Without CASE, lists the cases. The case `nothing` breaks nothing, and check.py must find nothing.
"""
import pathlib
import sys
import tempfile

import check

HPP = """// Needs: no other.
// A topic.
#ifndef LVSM_DEPTH_HPP
#define LVSM_DEPTH_HPP

namespace lvsm
{

// A constant.
template <typename T>
constexpr T kLargestFp16 = T(65504.0);

namespace detail
{

template <typename T>
T hidden(T x)
{
    return x;
}

} // namespace detail

/// One of [0,1] and kLargestFp16, as
/// lvsm::second does.
template <typename T, glm::qualifier Q>
glm::vec<2, T, Q> first(T depth, const glm::vec<2, T, Q>& interval)
{
    return {depth, interval.x};
}

/// Changes splits in place.
template <typename T>
void second(T* splits, const T* weights, int layerCount)
{
    if (layerCount > 0) { splits[0] = weights[0]; }
}

} // namespace lvsm

#endif
"""

GLSL = """// Needs: no other.
// A topic.
#ifndef LVSM_DEPTH_GLSL
#define LVSM_DEPTH_GLSL

// A constant.
const float LVSM_LARGEST_FP16 = 65504.0;

/// One of [0,1] and LVSM_LARGEST_FP16,
/// as lvsm_second does.
vec2 lvsm_first(float depth, vec2 interval)
{
    return vec2(depth, interval.x);
}

/// Changes splits in place.
void lvsm_second(inout float splits[LVSM_MAX_LAYERS + 1], float weights[LVSM_MAX_LAYERS + 1], int layerCount)
{
    if (layerCount > 0) { splits[0] = weights[0]; }
}

#endif
"""

UMBRELLA = "// Needs: every topic.\n#ifndef LVSM_LVSM_{0}\n#define LVSM_LVSM_{0}\n\n#include \"depth.{1}\"\n\n#endif\n"

FILES = {
    "include/lvsm/depth.hpp": HPP,
    "glsl/lvsm/depth.glsl": GLSL,
    "hlsl/lvsm/depth.hlsli": GLSL.replace("vec2", "float2").replace("const", "static const").replace("_GLSL", "_HLSLI"),
    "include/lvsm/lvsm.hpp": UMBRELLA.format("HPP", "hpp"),
    "glsl/lvsm/lvsm.glsl": UMBRELLA.format("GLSL", "glsl"),
    "hlsl/lvsm/lvsm.hlsli": UMBRELLA.format("HLSLI", "hlsli"),
    "tests/parity/functions.def": "FUNCTION(first, Vec2)\nFUNCTION(second, Splits)\n",
}

LAST = GLSL[GLSL.index("/// Changes"):GLSL.index("#endif")]
# Of each case: the file, the text that is replaced, what replaces it, and a part of the message that must come.
CASES = {
    "nothing": ("tests/parity/functions.def", "FUNCTION(first", "FUNCTION(first", None),
    "function_removed_in_glsl": ("glsl/lvsm/depth.glsl", LAST, "", "second is missing in GLSL"),
    "function_removed_in_hlsl": ("hlsl/lvsm/depth.hlsli", LAST, "", "second is missing in HLSL"),
    "function_added_in_glsl": ("glsl/lvsm/depth.glsl", LAST, LAST + LAST.replace("second", "third"), "third is missing in C++"),
    "functions_reordered": ("glsl/lvsm/depth.glsl", GLSL, GLSL.replace(LAST, "").replace("/// One of", LAST + "/// One of"),
                            "another order in GLSL"),
    "parameters_swapped": ("glsl/lvsm/depth.glsl", "(float depth, vec2 interval)", "(vec2 interval, float depth)",
                           "first's parameters differ in GLSL"),
    "parameter_renamed": ("hlsl/lvsm/depth.hlsli", "(float depth,", "(float z,", "first's parameters differ in HLSL"),
    "parameter_type_changed": ("hlsl/lvsm/depth.hlsli", "float2 interval)", "float3 interval)",
                               "first's parameter types differ in HLSL"),
    "inout_dropped": ("glsl/lvsm/depth.glsl", "inout float splits", "float splits", "second's parameter types differ"),
    "result_changed": ("glsl/lvsm/depth.glsl", "vec2 lvsm_first", "float lvsm_first", "first's result is float2"),
    "doc_word_changed": ("glsl/lvsm/depth.glsl", "Changes splits", "Keeps splits", "second's doc comment differs in GLSL"),
    "doc_missing_in_all": (None, "/// Changes splits in place.\n", "", "second has no /// comment"),
    "constant_changed": ("hlsl/lvsm/depth.hlsli", "65504.0", "65505.0", "LVSM_LARGEST_FP16 differs"),
    "constant_missing": ("glsl/lvsm/depth.glsl", "const float LVSM_LARGEST_FP16 = 65504.0;", "", "LVSM_LARGEST_FP16 differs"),
    "needs_not_said": ("glsl/lvsm/depth.glsl", "// Needs: no other.\n", "", "depth.glsl is to say in its first lines"),
    "needs_more_than_it_says": ("hlsl/lvsm/depth.hlsli", "#define LVSM_DEPTH_HLSLI", '#define LVSM_DEPTH_HLSLI\n#include "lvsm.hlsli"',
                                "// Needs: lvsm."),
    "row_missing": ("tests/parity/functions.def", "FUNCTION(second, Splits)\n", "", "second has no row"),
    "row_without_function": ("tests/parity/functions.def", "second", "sceond", "a row for sceond"),
    "topic_file_missing": ("glsl/lvsm/depth.glsl", GLSL, None, "topic depth is missing in GLSL"),
    "topic_not_in_umbrella": ("hlsl/lvsm/lvsm.hlsli", '#include "depth.hlsli"\n', "", "does not include depth in HLSL"),
    "name_without_prefix": ("glsl/lvsm/depth.glsl", "const float", "const float HALF = 0.5;\nconst float", "HALF could collide"),
    "macro_without_prefix": ("glsl/lvsm/depth.glsl", "const float", "#define HALF 0.5\nconst float", "HALF could collide"),
    "underscores_in_a_row": ("glsl/lvsm/depth.glsl", "const float", "const float LVSM__X = 0.5;\nconst float", "two underscores"),
    "guard_misspelt": ("glsl/lvsm/depth.glsl", "#define LVSM_DEPTH_GLSL", "#define LVSM_DETPH_GLSL", "include guard"),
    "sampler_in_maths": ("glsl/lvsm/depth.glsl", "vec2 interval)", "sampler2D interval)", "refuse 'sampler2D'"),
    "texture_in_maths": ("hlsl/lvsm/depth.hlsli", "static const", "Texture2D lvsm_map;\nstatic const", "refuse 'Texture2D'"),
    "precise_outside_macro": ("glsl/lvsm/depth.glsl", "    return", "    precise float x;\n    return", "refuse 'precise'"),
    "precision_qualifier": ("glsl/lvsm/depth.glsl", "(float depth", "(highp float depth", "refuse 'highp'"),
    "isnan": ("glsl/lvsm/depth.glsl", "layerCount > 0", "isnan(splits[0])", "refuse 'isnan'"),
    "version_directive": ("glsl/lvsm/depth.glsl", "const float", "#version 450\nconst float", "refuse '#version'"),
}


def main():
    if len(sys.argv) < 2:
        print(*CASES, sep="\n")
        return 0
    changed, old, new, expected = CASES[sys.argv[1]]
    with tempfile.TemporaryDirectory() as folder:
        for name, text in FILES.items():
            if changed in (None, name):
                assert changed is None or old in text, "the case breaks nothing"
                text = text.replace(old, new) if new is not None else None
            if text is not None:
                path = pathlib.Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
        found = list(check.differences(folder))
    print(*found, sep="\n")
    passed = any(expected in line for line in found) if expected else not found
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
