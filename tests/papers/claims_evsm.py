"""A semester project on variance and exponential variance shadow maps: its text, pictures and tables."""
from claims import Claim

NAME = "project on EVSM"
ITEMS = ["bleeding reduction", "quality", "ground edges", "memory", "taps"]

CLAIMS = [
    Claim("bleeding reduction", "0, 0.3 and 0.6 reduce bleeding, and quality when set too high.", "picture",
          "the yard at 512 under 9 x 9: mean visibility in full shadow {vsm_bleed:.4f}, {vsm3_bleed:.4f}, {vsm6_bleed:.4f}; "
          "RMSE in penumbrae {vsm_penumbra:.3f}, {vsm3_penumbra:.3f}, {vsm6_penumbra:.3f}",
          "vsm_bleed > vsm3_bleed > vsm6_bleed and vsm_penumbra < vsm3_penumbra < vsm6_penumbra", of="evsm_quality"),
    Claim("quality", "EVSM with 9 x 9 is almost devoid of light bleeding.", "almost none",
          "mean visibility in full shadow {evsm_bleed:.4f}, a VSM {vsm_bleed:.4f}",
          "evsm_bleed < 1 / 255 and evsm_bleed < vsm_bleed / 10", of="evsm_quality"),
    Claim("quality", "EVSM is of better quality than LVSM.", "better",
          "RMSE {evsm:.4f}, LVSM-2 relaxed {lvsm2:.4f}; bleeding {evsm_bleed:.4f} and {lvsm2_bleed:.4f}",
          "evsm < lvsm2 and evsm_bleed < lvsm2_bleed", of="evsm_quality"),
    Claim("memory", "EVSM takes less memory than multi-layered LVSM.", "less",
          "bits a texel: EVSM4 {evsm:.0f}; LVSM-2, 4 and 8 {lvsm2:.0f}, {lvsm4:.0f}, {lvsm8:.0f}", "evsm < lvsm4",
          of="evsm_memory", why="Four 32-bit floats are as much as four layers of 16 bits. It takes less from five on."),
    Claim("ground edges", "Blurred, VSM have artifacts at the ground's edges, which EVSM mostly resolves.", "picture",
          "RMSE where the window holds nothing in part, map cleared to depth 1: VSM {vsm:.4f}, EVSM4 {evsm:.4f}; cleared to "
          "black {vsm_black:.4f} and {evsm_black:.4f}", "max(vsm, vsm_black) > 0.02 and evsm_black < vsm_black / 2",
          of="evsm_edges",
          why="There are none where an empty texel holds depth 1, as it does in this library. Where it holds 0, ground at "
          "the edge is taken to lie behind something near, by both."),
    Claim("taps", "By linear sampling 9 taps cost as many reads as 5 do, 5 in each direction.", "5",
          "{nine_linear:.0f} in place of {nine:.0f}; 5 taps {five:.0f}", "nine_linear == five == 5 and nine == 9",
          of="evsm_taps"),
]
