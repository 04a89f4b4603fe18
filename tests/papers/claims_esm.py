"""Annen, Mertens, Seidel, Flerackers & Kautz, Exponential Shadow Maps, Graphics Interface 2008."""
from claims import Claim

NAME = "ESM"
ITEMS = ["figure 1", "figure 2", "section 3.1", "figure 3", "figure 4", "figure 5", "figure 6", "figure 7", "figure 8",
         "figure 9", "figure 10", "table 1", "table 2", "table 3"]

def table(item, widths, sizes, key):
    """The figures of a table as text, rows of one filter, and as what an expression takes."""
    names = [[f"time_{item}{size}_{width}.{key}" for size in sizes] for width in widths]
    text = "; ".join(", ".join(f"{{{name}:.2f}}" for name in row) for row in names)
    return "times " + text, ", ".join(name for row in names for name in row)


TABLE1, TABLE2 = ("esm", (1, 3, 7), (512, 1024, 2048)), ("tests", (1, 3, 5), (128, 256, 512, 1024))
THRESHOLD, _ = table(*TABLE1, "threshold_over")
Z_MAX, Z_MAX_OVER_VSM = table(*TABLE1, "z_max_over")
_, Z_MAX_OVER_THRESHOLD = table(*TABLE1, "z_over")
CSM, CSM_OVER_VSM = table(*TABLE1, "csm_over")
TESTS, TESTS_OVER = table(*TABLE2, "z_over")

CLAIMS = [
    Claim("figure 1", "Memory of a map of 2048 x 2048 with its mip chain.", "CSM 170 MB, VSM 42, ESM 21",
          "MiB: CSM-16 {csm:.1f}, VSM in floats {vsm:.1f}, ESM {esm:.1f}; beside them PCF without a chain {pcf:.1f}, "
          "LVSM-2, 4, 8 {lvsm2:.1f}, {lvsm4:.1f}, {lvsm8:.1f}, EVSM4 {evsm4:.1f}, MSM4 {msm4:.1f}",
          "int(csm) == 170 and int(vsm) == 42 and int(esm) == 21", of="esm_memory"),
    Claim("figure 2", "One exponential with c = 80 approximates the step better than a CSM of 16 terms with its offset.",
          "better", "mean error over all d - z: {esm_mean:.4f} against {csm_mean:.4f}; largest beyond the offset, "
          "{offset:.3f}: {esm_worst:.3f} against {csm_worst:.3f}", "esm_mean < csm_mean and esm_worst < csm_worst",
          of="esm_figure2"),
    Claim("section 3.1", "c = 80 is unaffected by the precision of 32-bit floats.", "80, found by trial",
          "derived: both factors are normal floats to c = {largest:.4f}", "80 < largest < 88", of="esm_c"),
    Claim("figure 3", "Half a window beyond the receiver: what should be half lit is wrongly lighter, both tests find it, "
          "and the 2 x 2 fallback mends it.", "0.5 right, too light without fallback",
          "{estimate:.2f} without; threshold {threshold:.0f}, Z-Max {z_max:.0f} (1: found); {fallback:.2f} with",
          "estimate > 0.9 and threshold and z_max and abs(fallback - 0.5) < 1e-6", of="esm_figure3"),
    Claim("figure 4", "Without offset PCF shadows itself; with one it does not; ESM need none.", "picture",
          "mean loss of what is fully lit: PCF {pcf:.3f}, with twice the slope {pcf_offset:.5f}, ESM {esm:.5f}",
          "pcf > 0.1 and max(pcf_offset, esm) < 1 / 255", of="esm_figure4"),
    Claim("figure 5", "Z-Max is conservative; the threshold misses some failures.", "small artifacts",
          "pixels too light by a tenth, with a depth beyond by more than the offset, maps of 128, 256 and 512 under 3 x 3: "
          "{fails128:.3f}, {fails256:.3f}, {fails512:.3f} of all; missed by Z-Max {z_max_missed128:.4f}, "
          "{z_max_missed256:.4f}, {z_max_missed512:.4f}, by the threshold {threshold_missed128:.4f}, "
          "{threshold_missed256:.4f}, {threshold_missed512:.4f}",
          "max(z_max_missed128, z_max_missed256, z_max_missed512) == 0 and threshold_missed512 > 0", of="esm_figure5"),
    Claim("figure 5", "The benefit of Z-Max decreases with the size of the map.", "decreases",
          "what the threshold misses: {threshold_missed128:.4f}, {threshold_missed256:.4f}, {threshold_missed512:.4f}",
          "threshold_missed128 > threshold_missed256 > threshold_missed512", of="esm_figure5"),
    Claim("figure 5", "The 2 x 2 filter cannot remove what a convolution adds.", "cannot",
          "of the pixels too light by a tenth, so many still are with it: {left128:.3f}, {left256:.3f}, {left512:.3f} of all",
          "min(left128, left256, left512) > 0", of="esm_figure5"),
    Claim("figure 6", "An offset of 0.001 is underestimated and needs to be larger.", "underestimated",
          "fully lit pixels that are flagged: {offset1:.3f} with 0.001, {offset4:.3f} with 0.004, {offset10:.3f} with 0.01",
          "offset1 > 2 * offset4", of="esm_figure6"),
    Claim("figure 6", "A threshold of 0.02 does.", "picture",
          "fully lit pixels that are flagged: {threshold20:.3f} with 0.02, {threshold100:.3f} with 0.1, {threshold500:.3f} "
          "with 0.5; what is left is next to silhouettes", "threshold20 < 1.25 * threshold500", of="esm_figure6"),
    Claim("figure 7", "To match trilinear ESM, PCF needs 16 to 36 samples.", "16 to 36",
          "footprints of 6 x 6 texels: as calm when half a texel on with {trilinear_as_calm:.0f} tests, as near to the "
          "exact share with {trilinear_as_exact:.0f} already", "16 <= trilinear_as_calm <= 36", of="esm_figure7",
          why="Calm is what is seen as anti-aliasing. By exactness few tests suffice, since the trilinear window is wider "
          "than the footprint."),
    Claim("figure 7", "To match ESM with 5 x 5 Gauss, PCF needs at least 64.", "64",
          "windows of 5 x 5 texels: as calm with {convolved_as_calm:.0f} tests, as exact with {convolved_as_exact:.0f}",
          "convolved_as_calm >= 64", of="esm_figure7",
          why="A window of 5 x 5 texels holds 25 depths: with a test for each there is nothing left to see. Theirs is "
          "minified as well, and holds more texels than tests."),
    Claim("figure 8", "ESM are visually equivalent to CSM.", "equivalent",
          "the yard at 512 under 5 x 5: RMSE {esm:.4f}, CSM-16 {csm:.4f}", "abs(esm - csm) < csm / 10", of="esm_figure8"),
    Claim("figure 8", "ESM perform better at contact shadows.", "picture, lower close-ups",
          "visibility in full shadow of what is less than 0.03 in front: {esm_contact:.3f}, CSM-16 {csm_contact:.3f}; a "
          "VSM {vsm_contact:.3f}", "esm_contact < csm_contact / 2", of="esm_figure8"),
    Claim("figure 8", "ESM leak less than VSM.", "picture, upper close-ups",
          "mean visibility in full shadow {esm_bleed:.4f}, VSM {vsm_bleed:.4f}", "esm_bleed < vsm_bleed / 2",
          of="esm_figure8"),
    Claim("figure 8", "So they are the better of the two.", "better quality than VSM",
          "RMSE {esm:.4f}, VSM {vsm:.4f}", "esm < vsm", of="esm_figure8",
          why="Their comparison looks at shadows. Where the window holds a deeper texel, an ESM without its fallback is "
          "wholly lit: these pixels, next to silhouettes, have {beyond:.0%} of its squared error."),
    Claim("figure 9", "Far away, pixels are incorrectly lit without the fallback.", "picture (a)",
          "footprints of 32 x 3 texels, pixels in full shadow that come out lit by a tenth: {trilinear:.3f}",
          "trilinear > 0.05", of="esm_figure9"),
    Claim("figure 9", "The fallback prevents them.", "picture (b)", "{fallback:.3f} with it", "fallback < trilinear / 3",
          of="esm_figure9"),
    Claim("figure 9", "10 x anisotropic filtering often handles them without.", "picture (c)",
          "{anisotropic:.3f} with ten taps of it", "anisotropic < trilinear / 3", of="esm_figure9"),
    Claim("table 3", "Share of pixels that fail: none, 3 x 3, 5 x 5, 7 x 7.",
          "Z-Max 3.0, 6.1, 7.9, 9.3%; threshold 2.8, 4.9, 6.1, 7.1%",
          "a yard of ours at 1024: Z-Max {z_max1:.1%}, {z_max3:.1%}, {z_max5:.1%}, {z_max7:.1%}; threshold "
          "{threshold1:.1%}, {threshold3:.1%}, {threshold5:.1%}, {threshold7:.1%}",
          "z_max1 < z_max3 < z_max5 < z_max7 < 2 * 0.093 and threshold1 < threshold3 < threshold5 < threshold7 < 2 * 0.071",
          of="esm_table3"),
    Claim("figure 10", "Z-Max flags more than the threshold does.", "more, at each width",
          "Z-Max {z_max1:.1%}, {z_max3:.1%}, {z_max5:.1%}, {z_max7:.1%}; threshold {threshold1:.1%}, {threshold3:.1%}, "
          "{threshold5:.1%}, {threshold7:.1%}",
          "z_max1 > threshold1 and z_max3 > threshold3 and z_max5 > threshold5 and z_max7 > threshold7", of="esm_table3",
          why="Under filters it does. Without one, a depth beyond by less than the offset of {offset:.3f} is let pass by "
          "Z-Max, and raises the shadow by up to e^(80 {offset:.3f}), which the threshold sees."),
    Claim("table 1", "ESM with threshold against VSM: none, 3 x 3 and 7 x 7, each at 512, 1024, 2048.",
          "times 1.05, 1.00, 0.89; 1.06, 0.99, 0.85; 1.06, 1.01, 0.91",
          THRESHOLD, "time_esm2048_1.threshold < time_esm2048_1.vsm and time_esm2048_3.threshold < time_esm2048_3.vsm and "
          "time_esm2048_7.threshold < time_esm2048_7.vsm and time_esm512_1.threshold > time_esm512_1.vsm"),
    Claim("table 1", "Z-Max against VSM, likewise.", "times 1.15, 1.14, 1.05; 1.17, 1.16, 1.12; 1.23, 1.25, 1.28", Z_MAX,
          f"min({Z_MAX_OVER_VSM}) > 1 and min({Z_MAX_OVER_THRESHOLD}) > 1"),
    Claim("table 1", "CSM against VSM, likewise.", "times 1.83, 2.06, 2.65; 1.99, 2.34, 3.22; 2.06, 2.72, 4.11", CSM,
          f"min({CSM_OVER_VSM}) > 1",
          why="Theirs have the scene's geometry in each time, which is the same for all and draws the ratios to 1; these do "
          "not."),
    Claim("table 2", "The threshold is faster than Z-Max: none, 3 x 3, 5 x 5, each at 128, 256, 512, 1024.",
          "times 1.39, 1.41, 1.41, 1.26; 1.48, 1.50, 1.43, 1.37; 1.52, 1.50, 1.40, 1.44", TESTS, f"min({TESTS_OVER}) > 1"),
    Claim("table 2", "Its penalty increases with the size of the map.", "increases",
          "at 128 and 1024 without a filter {time_tests128_1.z_over:.2f} and {time_tests1024_1.z_over:.2f}",
          "time_tests1024_1.z_over > time_tests128_1.z_over"),
]
