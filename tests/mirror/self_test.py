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

/// One of two.
template <typename T>
struct Pair
{
    T near = T(0); // the first
    T far;
};

/// One of [0,1] and kLargestFp16, as
/// lvsm::second does. Result: each in [0,1].
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

/// One of two.
struct lvsm_Pair
{
    float near;
    float far;
};

/// One of [0,1] and LVSM_LARGEST_FP16,
/// as lvsm_second does. Result: each in [0,1].
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

# As wgsl.py makes it, which the case `nothing` shows.
WGSL = """// Needs: no other.
// A topic.

// A constant.
const LVSM_LARGEST_FP16: f32 = 65504.0;

/// One of two.
struct lvsm_Pair
{
    near: f32,
    far: f32,
}

/// One of [0,1] and LVSM_LARGEST_FP16,
/// as lvsm_second does. Result: each in [0,1].
fn lvsm_first(depth: f32, interval: vec2f) -> vec2f
{
    return vec2f(depth, interval.x);
}

/// Changes splits in place.
fn lvsm_second(splits: ptr<function, array<f32, LVSM_MAX_LAYERS + 1>>, weights: array<f32, LVSM_MAX_LAYERS + 1>,
               layerCount: i32)
{
    if (layerCount > 0)
    {
        (*splits)[0] = weights[0];
    }
}
"""

HOST = """// Needs: no other.
// Whole images.
// On the host alone: no shader has it.
#ifndef LVSM_PLACE_HPP
#define LVSM_PLACE_HPP

namespace lvsm
{

/// How to place.
struct PlaceOptions
{
    int rounds = 3;
};

/// Places.
inline int place(const PlaceOptions& options = {})
{
    return options.rounds;
}

} // namespace lvsm

#endif
"""

UMBRELLA = ("// Needs: every topic.\n//\n// Topics: depth{2}. No more.\n#ifndef LVSM_LVSM_{0}\n#define LVSM_LVSM_{0}\n\n"
            "#include \"depth.{1}\"\n{3}\n#endif\n")
CONFIG = "// Needs: no other.\n#ifndef LVSM_CONFIG_{0}\n#define LVSM_CONFIG_{0}\n\n#endif\n"
WRAPPER = "// Needs: no other.\n/// Reads.\nfloat lvsm_sample(float x)\n{\n    return x;\n}\n"

FILES = {
    "include/lvsm/depth.hpp": HPP,
    "glsl/lvsm/depth.glsl": GLSL,
    "hlsl/lvsm/depth.hlsli": GLSL.replace("vec2", "float2").replace("const", "static const").replace("_GLSL", "_HLSLI"),
    "wgsl/lvsm/depth.wgsl": WGSL,
    "include/lvsm/config.hpp": CONFIG.format("HPP"),
    "glsl/lvsm/config.glsl": CONFIG.format("GLSL"),
    "hlsl/lvsm/config.hlsli": CONFIG.format("HLSLI"),
    "wgsl/lvsm/config.wgsl": "// Needs: no other.\nconst LVSM_MAX_LAYERS: i32 = 8;\n",
    "include/lvsm/place.hpp": HOST,
    "include/lvsm/lvsm.hpp": UMBRELLA.format("HPP", "hpp", "; on the host also place", '#include "place.hpp"\n'),
    "glsl/lvsm/lvsm.glsl": UMBRELLA.format("GLSL", "glsl", "", ""),
    "hlsl/lvsm/lvsm.hlsli": UMBRELLA.format("HLSLI", "hlsli", "", ""),
    "wgsl/lvsm/lvsm.wgsl": "// Needs: every topic.\n//\n// Topics: depth. No more.\n",
    "glsl/lvsm/sampling/all.glsl": "// Needs: sampling/all/one.\n#include \"all/one.glsl\"\n",
    "glsl/lvsm/sampling/all/one.glsl": WRAPPER,
    "hlsl/lvsm/passes/blur.hlsl": "// Needs: no other.\n",
    "wgsl/lvsm/sampling/all/one.wgsl": "// Needs: no other.\n\n/// Reads.\nfn lvsm_sampleOne(x: f32) -> f32\n{\n    return x;\n}\n",
    "wgsl/lvsm/passes/mip.wgsl": "// Needs: no other.\n",
    "README.md": "| topic | what |\n|---|---|\n| `depth` | depths; `place` runs on the host |\n",
    "tests/CMakeLists.txt": "add_subdirectory(unit)\nadd_subdirectory(parity)\nadd_subdirectory(sampling)\n",
    "tests/unit/CMakeLists.txt": "file(GLOB tests CONFIGURE_DEPENDS *_test.cpp)\nadd_executable(lvsm_unit main.cpp ${tests})\n",
    "tests/unit/main.cpp": "int main() {}\n",
    "tests/unit/depth_test.cpp": "// first\nTEST(first(1)) TEST(second(1)) TEST(place())\n",
    "tests/parity/CMakeLists.txt": "add_executable(lvsm_parity domains.cpp)\n",
    "tests/parity/domains.cpp": '        {"pairs", {}},\n',
    "tests/parity/functions.def": "// FUNCTION(name)\nFUNCTION(first, Vec2, (A(0), V2(1)), pairs, 0.0, 1.0)\n"
                                  "FUNCTION(second, Splits, (splits, weights, N(19)), pairs, -FLT_MAX, FLT_MAX)\n",
    "tests/sampling/CMakeLists.txt": "add_executable(lvsm_sampling passes.cpp)\n",
    "tests/sampling/passes.cpp": "// blur mip\n",
    "tests/sampling/kernels/all.wgsl": "lvsm_sampleOne(1.0);\n",
    "tests/sampling/kernels/all.comp": "lvsm_sample(1.0);\n",
    "tests/cost/estimates.def": "// ESTIMATE(name)\nESTIMATE(One, 1, lvsm_first())\n",
}

LAST = GLSL[GLSL.index("/// Changes"):GLSL.index("#endif")]
ROW = FILES["tests/parity/functions.def"].splitlines(keepends=True)[-1]
END = "} // namespace lvsm\n"
# Of each case: the file or None for all, the text that is replaced, what replaces it, and a part of the message that must
# come. Text None: the file gets another name. Replacement None: there is no such file.
CASES = {
    "nothing": ("tests/parity/functions.def", "FUNCTION(first", "FUNCTION(first", None),
    "function_removed_in_glsl": ("glsl/lvsm/depth.glsl", LAST, "", "second is missing in GLSL"),
    "function_removed_in_hlsl": ("hlsl/lvsm/depth.hlsli", LAST, "", "second is missing in HLSL"),
    "function_added_in_glsl": ("glsl/lvsm/depth.glsl", LAST, LAST + LAST.replace("second", "third"), "third is missing in C++"),
    "function_removed_in_wgsl": ("wgsl/lvsm/depth.wgsl", WGSL[WGSL.index("/// Changes"):], "", "second is missing in WGSL"),
    "functions_reordered": ("glsl/lvsm/depth.glsl", GLSL, GLSL.replace(LAST, "").replace("/// One of", LAST + "/// One of"),
                            "another order in GLSL"),
    "parameters_swapped": ("glsl/lvsm/depth.glsl", "(float depth, vec2 interval)", "(vec2 interval, float depth)",
                           "first's parameters differ in GLSL"),
    "parameter_renamed": ("hlsl/lvsm/depth.hlsli", "(float depth,", "(float z,", "first's parameters differ in HLSL"),
    "parameter_type_changed": ("hlsl/lvsm/depth.hlsli", "float2 interval)", "float3 interval)",
                               "first's parameter types differ in HLSL"),
    "inout_dropped": ("glsl/lvsm/depth.glsl", "inout float splits", "float splits", "second's parameter types differ"),
    "pointer_dropped": ("wgsl/lvsm/depth.wgsl", "ptr<function, array<f32, LVSM_MAX_LAYERS + 1>>", "array<f32, LVSM_MAX_LAYERS + 1>",
                        "second's parameter types differ in WGSL"),
    "parameter_renamed_in_wgsl": ("wgsl/lvsm/depth.wgsl", "(depth: f32", "(z: f32", "first's parameters differ in WGSL"),
    "result_changed_in_wgsl": ("wgsl/lvsm/depth.wgsl", "-> vec2f", "-> vec3f", "float3 in WGSL"),
    "doc_changed_in_wgsl": ("wgsl/lvsm/depth.wgsl", "Changes splits", "Keeps splits", "second's doc comment differs in WGSL"),
    "constant_changed_in_wgsl": ("wgsl/lvsm/depth.wgsl", "65504.0", "65505.0", "65505.0 in WGSL"),
    "struct_member_renamed_in_wgsl": ("wgsl/lvsm/depth.wgsl", "far: f32", "end: f32", "Pair's members differ in WGSL"),
    "name_without_prefix_in_wgsl": ("wgsl/lvsm/depth.wgsl", "const", "const HALF: f32 = 0.5;\nconst", "HALF could collide"),
    "body_changed_in_wgsl": ("wgsl/lvsm/depth.wgsl", "weights[0]", "weights[1]", "wgsl/lvsm/depth.wgsl is not what is made of GLSL"),
    "glsl_unsayable_in_wgsl": ("glsl/lvsm/depth.glsl", "splits[0] = weights[0];", "layerCount = 0;",
                               "WGSL writes to no parameter: layerCount"),
    "glsl_unknown_to_wgsl": ("glsl/lvsm/depth.glsl", "interval.x)", "tanh(interval.x))", "the function tanh is not known"),
    "result_changed": ("glsl/lvsm/depth.glsl", "vec2 lvsm_first", "float lvsm_first", "first's result is float2"),
    "doc_word_changed": ("glsl/lvsm/depth.glsl", "Changes splits", "Keeps splits", "second's doc comment differs in GLSL"),
    "doc_missing_in_all": (None, "/// Changes splits in place.\n", "", "second has no /// comment"),
    "constant_changed": ("hlsl/lvsm/depth.hlsli", "65504.0", "65505.0", "LVSM_LARGEST_FP16 differs"),
    "constant_missing": ("glsl/lvsm/depth.glsl", "const float LVSM_LARGEST_FP16 = 65504.0;", "", "LVSM_LARGEST_FP16 differs"),
    "literal_over_the_largest_float": ("glsl/lvsm/depth.glsl", "65504.0", "3.40282347e38", "3.40282347e38 is more than"),
    "precise_in_glsl_alone": ("glsl/lvsm/depth.glsl", "vec2 interval)\n{\n", "vec2 interval)\n{\n    LVSM_PRECISE float x = 0.0;\n",
                              "first says LVSM_PRECISE in one of"),
    "precise_not_rounded_in_cpp": ("glsl/lvsm/depth.glsl", "vec2 interval)\n{\n", "vec2 interval)\n{\n    LVSM_PRECISE float x = 0.0;\n",
                                   "first says LVSM_PRECISE in shaders, and not"),
    "needs_not_said": ("glsl/lvsm/depth.glsl", "// Needs: no other.\n", "", "depth.glsl is to say in its first lines"),
    "needs_more_than_it_says": ("hlsl/lvsm/depth.hlsli", "#define LVSM_DEPTH_HLSLI", '#define LVSM_DEPTH_HLSLI\n#include "lvsm.hlsli"',
                                "// Needs: lvsm."),
    "row_missing": ("tests/parity/functions.def", ROW, "", "second has no row"),
    "row_without_function": ("tests/parity/functions.def", "second", "sceond", "a row for sceond"),
    "row_indented": ("tests/parity/functions.def", ROW, "    " + ROW, "a row stands in one line"),
    "row_in_two_lines": ("tests/parity/functions.def", "weights, N", "weights,\n    N", "a row stands in one line"),
    "row_behind_if": ("tests/parity/functions.def", ROW, "#if 0\n" + ROW + "#endif\n", "outside #if"),
    "row_twice": ("tests/parity/functions.def", ROW, ROW + ROW, "two rows for second"),
    "row_range_widened": ("tests/parity/functions.def", "pairs, 0.0, 1.0", "pairs, -FLT_MAX, FLT_MAX",
                          "first's row in tests/parity/functions.def has the range -FLT_MAX to FLT_MAX"),
    "row_range_widened_above": ("tests/parity/functions.def", "pairs, 0.0, 1.0", "pairs, 0.0, 1.01", "has the range 0.0 to 1.01"),
    "range_not_in_the_comment": (None, "Result: each in [0,1].", "", "gives no range"),
    "domain_undefined": ("tests/parity/domains.cpp", "pairs", "pears", "names the domain pairs"),
    "domain_without_row": ("tests/parity/domains.cpp", '        {"pairs"', '        {"pears", {}},\n        {"pairs"',
                           "defines pears"),
    "estimate_indented": ("tests/cost/estimates.def", "ESTIMATE(One", " ESTIMATE(One", "begins its line"),
    "undocumented_noexcept": ("include/lvsm/depth.hpp", END, "inline int third(int x) noexcept\n{\n    return x;\n}\n" + END,
                              "third has no /// comment"),
    "undocumented_trailing_return": ("include/lvsm/depth.hpp", END, "inline auto third(int x) -> int\n{\n    return x;\n}\n" + END,
                                     "third has no /// comment"),
    "noexcept_in_cpp_alone": ("include/lvsm/depth.hpp", END, "/// One.\ninline int third(int x) noexcept\n{\n    return x;\n}\n"
                              + END, "third is missing in GLSL"),
    "trailing_return_in_cpp_alone": ("include/lvsm/depth.hpp", END, "/// One.\ninline auto third(int x) -> int\n{\n    return x;\n}\n"
                                     + END, "third is missing in HLSL"),
    "overloaded": ("include/lvsm/depth.hpp", END, "/// Another.\ninline int first(int x)\n{\n    return x;\n}\n" + END,
                   "first is there twice"),
    "unreadable": ("include/lvsm/depth.hpp", END, "bool operator!(Pair<int>)\n{\n    return true;\n}\n" + END, "cannot read"),
    "struct_in_cpp_alone": ("include/lvsm/depth.hpp", END, "/// Three.\nstruct Three\n{\n    int x;\n};\n" + END,
                            "type Three is missing in GLSL"),
    "struct_undocumented": (None, "/// One of two.\n", "", "Pair has no /// comment"),
    "struct_member_changed": ("hlsl/lvsm/depth.hlsli", "float far;", "float2 far;", "Pair's members differ in HLSL"),
    "struct_member_renamed": ("glsl/lvsm/depth.glsl", "float far;", "float end;", "Pair's members differ in GLSL"),
    "struct_doc_changed": ("glsl/lvsm/depth.glsl", "One of two", "One of three", "Pair's doc comment differs in GLSL"),
    "host_function_undocumented": ("include/lvsm/place.hpp", "/// Places.\n", "", "place has no /// comment"),
    "host_type_undocumented": ("include/lvsm/place.hpp", "/// How to place.\n", "", "PlaceOptions has no /// comment"),
    "host_topic_not_said": ("include/lvsm/place.hpp", "// On the host alone: no shader has it.\n", "", "topic place is missing in GLSL"),
    "topic_not_in_readme": ("README.md", "`place`", "place", "table of topics does not name the topic place"),
    "readme_names_no_topic": ("README.md", "| `depth` |", "| `depht` |", "names depht, which is no topic"),
    "readme_table_missing": ("README.md", "| topic |", "| matter |", "no table"),
    "topic_not_in_manual": ("include/lvsm/lvsm.hpp", "; on the host also place", "", "of lvsm.hpp does not name the topic place"),
    "manual_names_no_topic": ("glsl/lvsm/lvsm.glsl", "Topics: depth", "Topics: depth, place", "of lvsm.glsl names place"),
    "manual_without_topics": ("hlsl/lvsm/lvsm.hlsli", "Topics:", "Matters:", "of lvsm.hlsli is missing"),
    "function_without_unit_test": ("tests/unit/depth_test.cpp", "TEST(first(1))", "", "calls first"),
    "unit_test_misnamed": ("tests/unit/depth_test.cpp", None, "tests/unit/depth_tests.cpp", "tests/unit/depth_tests.cpp is not built"),
    "source_unlisted": ("tests/parity/CMakeLists.txt", "domains.cpp", "main.cpp", "tests/parity/domains.cpp is not built"),
    "folder_unlisted": ("tests/CMakeLists.txt", "add_subdirectory(parity)\n", "", "tests/parity/CMakeLists.txt is not read"),
    "wrapper_not_called": ("tests/sampling/kernels/all.comp", "lvsm_sample", "sample", "calls lvsm_sample"),
    "wrapper_not_included": ("glsl/lvsm/sampling/all.glsl", "// Needs: sampling/all/one.\n#include \"all/one.glsl\"\n",
                             "// Needs: no other.\n", "all.glsl does not include glsl/lvsm/sampling/all/one.glsl"),
    "pass_not_run": ("tests/sampling/passes.cpp", "// blur", "//", "runs hlsl/lvsm/passes/blur.hlsl"),
    "wgsl_pass_not_run": ("tests/sampling/passes.cpp", " mip", "", "runs wgsl/lvsm/passes/mip.wgsl"),
    "wgsl_wrapper_not_called": ("tests/sampling/kernels/all.wgsl", "lvsm_sampleOne", "lvsm_sample", "calls lvsm_sampleOne"),
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
            if changed == name and old is None:
                name = new
            elif changed in (None, name):
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
