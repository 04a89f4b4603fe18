"""Lauritzen & McCool, Layered Variance Shadow Maps, Graphics Interface 2008."""
from claims import Claim

NAME = "LVSM"
ITEMS = ["equation 4", "equation 5", "figure 2", "figure 3", "figure 4", "figure 5", "figure 6", "figure 8", "figure 9", "figure 10",
         "section 3.3", "section 4", "section 4.1", "section 5", "section 6"]

CLAIMS = [
    Claim("equation 4", "Behind two occluders that share a window, a VSM bleeds by this much, falling like 1 / y².",
          "x² / 4 / (x² / 2 + xy + y²)", "differs by {difference:.0e} at most; falls like y to the power {power:.3f}",
          "difference < 1e-12 and abs(power + 2) < 0.01", of="equation4"),
    Claim("equation 5", "The step warp at the receiver's depth removes all bleeding there, and says nothing of the "
          "occluder in front.", "visibility 0 at C, 1 at B", "{c:.3f} at C, {b:.3f} at B; unwarped {plain:.3f} at C",
          "c == 0 and b == 1 and plain > 0", of="equation5"),
    Claim("figure 2", "Object B hides C, and the penumbra of A bleeds through all the same.",
          "bleeding on C; none is right",
          "visibility on C behind B at most {vsm_shielded:.3f} with a VSM; {manual_shielded:.4f} with two layers, split "
          "by hand behind B", "vsm_shielded > 10 / 255 and manual_shielded < 1 / 255", of="figure2"),
    Claim("figure 3", "The penumbra of the tree bleeds through the bench.", "bleeding under the bench",
          "visibility of the ground behind the seat at most {vsm_shielded:.3f}", "vsm_shielded > 10 / 255", of="figure3"),
    Claim("figure 5", "A single well-positioned layer boundary eliminates the light bleeding.", "none left",
          "at most {manual_shielded:.4f} with a split half-way from the seat to the ground",
          "manual_shielded < 1 / 255", of="figure3"),
    Claim("figure 5", "Four layers, placed by the relaxation, leave none.", "none left",
          "at most {relaxed_shielded:.3f} (a VSM: {vsm_shielded:.3f})", "relaxed_shielded < 1 / 255", of="figure3",
          why="Splits go to peaks of second occluders, and behind leaves the ground is one far more often than the seat. "
          "So the last layer begins at {last_begin:.3f}, behind the ground under the seat, and that ground is in the "
          "layer that begins at {before_begin:.3f}, in front of the seat: x is cut, not removed. By hand the split is at "
          "{manual_split:.3f}."),
    Claim("figure 6", "Several layers reduce or eliminate significant bleeding.", "picture",
          "mean visibility of what is in full shadow {vsm_bleed:.4f} with a VSM, {relaxed_bleed:.4f} with LVSM-4 relaxed; "
          "RMSE {vsm_rmse:.4f} and {relaxed_rmse:.4f}", "relaxed_bleed < vsm_bleed / 3", of="figure6"),
    Claim("section 3.3", "Where all occluders are in front of the receiver's layer, visibility is exact.", "exact",
          "differs by {worst:.0e} at most", "worst < 1e-12", of="exact"),
    Claim("section 3.3", "With one layer the technique is a VSM.", "the same", "differs by {difference:.0e} at most",
          "difference < 1e-12", of="oneLayer"),
    Claim("section 3.3", "The layer that holds the receiver gives the least bound of all, so it alone need be sampled.",
          "no layer in front gives less",
          "half a window at 0, half at 1, receiver at 0.8, split at 0.5: {own:.3f} in its layer, {front:.3f} in front, "
          "which is right. LVSM-8, the least of all layers in front too: less by 0.01 at {bench_share:.3f} of the pixels "
          "of figure 3 and {blocks_share:.3f} of figure 6, RMSE {bench_own:.4f} to {bench_least:.4f} and "
          "{blocks_own:.4f} to {blocks_least:.4f}",
          "front >= own and bench_share == 0 and blocks_share == 0", of="section33",
          why="It holds while nothing in the window is deeper than the receiver. A deeper sample counts against the "
          "receiver's layer with its own distance, raising the mean and with it the bound; in a layer in front both "
          "warp to 1. At every silhouette seen from the light there is such a sample. `bracketedVisibility` makes use "
          "of the layer in front."),
    Claim("section 3.3", "A receiver takes one sample whatever the number of layers.", "1",
          "samples in the compiled wrapper, with 2, 4, 8 and 14 layers: {lvsm2:.0f}, {lvsm4:.0f}, {lvsm8:.0f}, "
          "{lvsm14:.0f}, of which one is taken in a transition only", "lvsm2 == lvsm4 == lvsm8 == lvsm14 == 2",
          of="samples"),
    Claim("figure 4", "Where a split cuts through a receiver, shadows have a lit gradient and lit regions a dark one.",
          "picture, left", "largest jump between quarters of a texel {lit:.3f} in light, {shadow:.3f} in shadow",
          "min(lit, shadow) > 10 / 255", of="figure4"),
    Claim("figure 4", "Small overlaps eliminate both completely.", "picture, right",
          "with an overlap of {overlap:.2f}: {lit_overlap:.4f} in light, {shadow_overlap:.4f} in shadow",
          "max(lit_overlap, shadow_overlap) < 1 / 255", of="figure4",
          why="In light the overlap must be as long as the filter's reach down the slope; in shadow what is left is "
          "v / (v + d²) of the floor v and the overlap d, so d must be 16 times the root of v."),
    Claim("section 4", "A split between the first and the second occluder still reduces bleeding.", "reduces",
          "{at0:.3f} without; a quarter, half and three quarters of the way {at25:.3f}, {at50:.3f}, {at75:.3f}; "
          "{at100:.3f} at the second", "at0 > at25 > at50 > at75 > at100", of="between"),
    Claim("section 4.1", "The mean plus the deviation is the second occluder's depth where each covers half.", "max(a, b)",
          "differs by {half:.0e} at most; where the nearer covers a quarter, by {quarter:.3f}", "half < 1e-7",
          of="secondOccluder"),
    Claim("section 5", "16-bit fixed point gives sufficient precision with even a small number of layers.", "sufficient",
          "RMSE over that with 32-bit floats, figures 3 and 6: LVSM-2 {bench2:.3f} and {blocks2:.3f}, LVSM-4 {bench4:.3f} "
          "and {blocks4:.3f}, LVSM-8 {bench8:.3f} and {blocks8:.3f}; VSM {bench1:.3f} and {blocks1:.3f}",
          "max(bench2, blocks2, bench4, blocks4, bench8, blocks8) < 1.05", of="bits16"),
    Claim("section 5", "The same where the light's range is twenty times as long as the scene.", "sufficient",
          "VSM {bench_far1:.3f} and {blocks_far1:.3f}, LVSM-2 {bench_far2:.3f} and {blocks_far2:.3f}, LVSM-4 "
          "{bench_far4:.3f} and {blocks_far4:.3f}, LVSM-8 {bench_far8:.3f} and {blocks_far8:.3f}",
          "max(bench_far2, blocks_far2, bench_far4, blocks_far4, bench_far8, blocks_far8) < 1.05", of="bits16",
          why="The relaxation of two layers puts its one split inside the scene, so that the layer in front is nearly as "
          "long as the range and rounds as a VSM does. From four layers on the claim holds."),
    Claim("section 5", "Blending two layers near a split avoids discontinuities in bleeding regions.", "no discontinuity",
          "visibility jumps by {without:.3f} at the split, and by {with_:.4f} at most from one depth to the next, 1e-5 "
          "deeper, with a transition of 0.02", "without > 10 / 255 and with_ < 1 / 255", of="transition"),
    Claim("section 5", "It can be skipped with minimal quality loss.", "minimal",
          "RMSE without over with, figures 3 and 6: LVSM-2 {bench2:.3f} and {blocks2:.3f}, LVSM-4 {bench4:.3f} and "
          "{blocks4:.3f}, LVSM-8 {bench8:.3f} and {blocks8:.3f}",
          "max(bench2, blocks2, bench4, blocks4, bench8, blocks8) < 1.05", of="transition"),
    Claim("section 5", "Two splits a frame converge very fast.", "within few frames",
          "frames until the clustering is within a twentieth of its end, from uniform splits, figures 3 and 6: two layers "
          "{bench2:.0f} and {blocks2:.0f}, four {bench4:.0f} and {blocks4:.0f}, eight {bench8:.0f} and {blocks8:.0f}",
          "max(bench2, blocks2, bench4, blocks4, bench8, blocks8) <= 12", of="convergence",
          why="It holds for few layers. Each frame moves two of N - 1 splits, and Lloyd's relaxation comes nearer by a "
          "share of what is left, less of it the more clusters a peak is cut into: a split only learns of what is beyond "
          "its neighbours through them. `lloydRelax` and `optimalSplits` need no frames."),
    Claim("section 5", "The same for dynamic scenes.", "within few frames",
          "a light that turns by half a degree a frame, four layers: no split is further from where it would come to rest "
          "than {bench:.4f} and {blocks:.4f}, less than an overlap of 0.01", "max(bench, blocks) < 0.01", of="moving"),
    Claim("section 5", "Teleportation greatly improves the final solutions.", "greatly",
          "mean squared distance to the nearest split, with over without, figures 3 and 6 in the last third of the range: four "
          "layers {bench_far4:.2f} and {blocks_far4:.2f}, eight {bench_far8:.2f} and {blocks_far8:.2f}; bleeding likewise "
          "{bench_far4_bleed:.2f} and {blocks_far4_bleed:.2f}, {bench_far8_bleed:.2f} and {blocks_far8_bleed:.2f}. In a "
          "range that fits the scene: {bench4:.2f} and {blocks4:.2f}, {bench8:.2f} and {blocks8:.2f}",
          "max(bench_far4, blocks_far4, bench_far8, blocks_far8) < 0.5", of="teleportation"),
    Claim("section 6", "A 16-bit LVSM-2 takes the memory of a standard VSM.", "the same",
          "{lvsm2:.0f} bits a texel, VSM {vsm:.0f}", "lvsm2 == vsm", of="memory"),
    Claim("figure 8", "At equal storage LVSM are better than CSM.", "better in each column",
          "RMSE at 64, 128 and 256 bits: CSM-4, 8, 16 {csm4:.4f}, {csm8:.4f}, {csm16:.4f}; uniform LVSM-2, 4, 8 "
          "{uniform2:.4f}, {uniform4:.4f}, {uniform8:.4f}; relaxed {relaxed2:.4f}, {relaxed4:.4f}, {relaxed8:.4f}",
          "csm4 > max(uniform2, relaxed2) and csm8 > max(uniform4, relaxed4) and csm16 > max(uniform8, relaxed8)",
          of="figure8"),
    Claim("figure 8", "Particularly where Lloyd relaxation is used.", "relaxed better than uniform",
          "bleeding in full shadow at 64, 128 and 256 bits: uniform {uniform2_bleed:.4f}, {uniform4_bleed:.4f}, "
          "{uniform8_bleed:.4f}; relaxed {relaxed2_bleed:.4f}, {relaxed4_bleed:.4f}, {relaxed8_bleed:.4f}",
          "relaxed2_bleed <= uniform2_bleed and relaxed4_bleed <= uniform4_bleed and relaxed8_bleed <= uniform8_bleed",
          of="figure8",
          why="Here the range fits the scene, so that uniform splits are spread over it already; and the strongest second "
          "occluder is the empty background behind the ground's edge, which holds no shadow and draws the last split of "
          "four layers to {relaxed4_last:.3f}, of eight to {relaxed8_last:.3f}. Where the range does not fit the scene, "
          "relaxation gains what the row on teleportation shows."),
    Claim("figure 8", "LVSM have a problem with overlapping occluders only, CSM with all.", "picture",
          "visibility in full shadow of one surface less than 0.03 in front: CSM {csm4_contact:.3f}, {csm8_contact:.3f}, "
          "{csm16_contact:.3f}; relaxed LVSM {relaxed2_contact:.3f}, {relaxed4_contact:.3f}, {relaxed8_contact:.3f}",
          "csm4_contact > 10 * relaxed2_contact and csm8_contact > 10 * relaxed4_contact and "
          "csm16_contact > 10 * relaxed8_contact", of="figure8"),
    Claim("figure 8", "Both fully eliminate the artifacts of this example with more storage.", "eliminate",
          "at 512 bits: mean visibility in full shadow CSM-32 {csm32_bleed:.4f}, LVSM-16 {relaxed16_bleed:.4f}; less than "
          "0.03 behind an occluder {csm32_contact:.3f} and {relaxed16_contact:.3f}",
          "max(csm32_bleed, relaxed16_bleed) < 1 / 255 and max(csm32_contact, relaxed16_contact) < 10 / 255", of="figure8",
          why="LVSM do. A CSM of M terms needs its receivers moved by 1 / (2 M) towards the light for lit surfaces to be "
          "lit, and so lights what is that close behind an occluder: 0.016 with 32 terms. Only M beyond any memory "
          "removes it."),
    Claim("figure 10", "EVSM look better than both CSM and LVSM, from four 32-bit floats.", "picture",
          "RMSE {evsm4:.4f} with exponents 42; best of CSM to 256 bits {csm16:.4f}, of LVSM at the same 128 bits "
          "{relaxed4:.4f}, bleeding {evsm4_bleed:.4f} and {relaxed4_bleed:.4f}",
          "evsm4 < min(csm16, uniform4, relaxed4)", of="figure8"),
    Claim("section 6", "A 2-layer, 16-bit, uniform LVSM provides similar performance to a VSM.", "similar",
          "map of 1024 made and shaded without transitions: LVSM-2 takes {ratio2:.2f} times a VSM, "
          "{lvsm2_map:.0f} + {lvsm2_shade:.0f} ms against {vsm_map:.0f} + {vsm_shade:.0f}",
          "ratio2 < 1.25", of="time_single",
          why="On a processor the search of the layer, its interval and two more components to filter are paid for one by "
          "one. What they take on GPUs is in docs/cost.md."),
    Claim("figure 9", "One sample a fragment keeps the cost of shading down: LVSM-14 against VSM.", "little more",
          "shading alone, without transitions, over a VSM: LVSM-2, 4, 8 and 14 {shade_ratio2:.2f}, {shade_ratio4:.2f}, "
          "{shade_ratio8:.2f}, {shade_ratio14:.2f}", "shade_ratio14 < 1.05", of="time_single",
          why="The one sample does not grow: from 2 layers to 14 shading takes {shade_growth14:.2f} times as long, for the search "
          "among 13 splits, which on a processor is a comparison each."),
    Claim("figure 9", "Time rises with layers and with the map's size.", "curves",
          "LVSM-2, 4, 8, 14 over VSM, all made each frame, with transitions, levels and 16 x anisotropy: at 256 "
          "{time_layers256.ratio2:.2f}, {time_layers256.ratio4:.2f}, {time_layers256.ratio8:.2f}, "
          "{time_layers256.ratio14:.2f}; 512 {time_layers512.ratio2:.2f}, {time_layers512.ratio4:.2f}, "
          "{time_layers512.ratio8:.2f}, {time_layers512.ratio14:.2f}; 1024 {time_layers1024.ratio2:.2f}, "
          "{time_layers1024.ratio4:.2f}, {time_layers1024.ratio8:.2f}, {time_layers1024.ratio14:.2f}; 2048 "
          "{time_layers2048.ratio2:.2f}, {time_layers2048.ratio4:.2f}, {time_layers2048.ratio8:.2f}, "
          "{time_layers2048.ratio14:.2f}",
          "time_layers1024.lvsm2 < time_layers1024.lvsm4 < time_layers1024.lvsm8 < time_layers1024.lvsm14 and "
          "time_layers256.lvsm14 < time_layers512.lvsm14 < time_layers1024.lvsm14 < time_layers2048.lvsm14",
          why="Without the relaxation, which their frames have."),
    Claim("figure 9", "The cost is at worst linear in the number of layers.", "linear",
          "14 layers over 2: {time_layers256.growth14:.2f}, {time_layers512.growth14:.2f}, {time_layers1024.growth14:.2f}, "
          "{time_layers2048.growth14:.2f} at 256, 512, 1024 and 2048, where linear is 7",
          "max(time_layers256.growth14, time_layers512.growth14, time_layers1024.growth14, time_layers2048.growth14) <= 7"),
    Claim("figure 8", "As storage increases, LVSM outperform CSM, which sample all coefficients.", "outperform",
          "CSM over LVSM, map of 1024 made and shaded, at 64, 128 and 256 bits: {csm_over2:.2f}, {csm_over4:.2f}, "
          "{csm_over8:.2f}", "1 < csm_over2 < csm_over4 < csm_over8", of="time_storage",
          why="Shading alone: {csm_shade_over2:.2f}, {csm_shade_over4:.2f}, {csm_shade_over8:.2f}."),
    Claim("figure 10", "EVSM are faster than both CSM and LVSM.", "faster; 140 frames a second",
          "over EVSM4: CSM-4, 8, 16 {csm4_over:.2f}, {csm8_over:.2f}, {csm16_over:.2f}; LVSM-2, 4, 8 {lvsm2_over:.2f}, "
          "{lvsm4_over:.2f}, {lvsm8_over:.2f}", "min(csm4_over, csm8_over, csm16_over, lvsm2_over, lvsm4_over, lvsm8_over) > 1",
          of="time_storage"),
]
