"""A semester project on variance and exponential variance shadow maps: its text, pictures and tables."""
from claims import Claim

NAME = "project on EVSM"
ITEMS = ["bleeding reduction", "quality", "ground edges", "memory", "taps", "table of techniques", "table of blurs"]

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
    Claim("table of techniques", "Basic, PCF 2x2, 3x3, 3x3 and 9x9 Gauss, VSM with 3x3 PCF, VSM with 9x9 blur, over VSM at 1024.",
          "0.98, 0.83, 1.16, 1.16, 6.24, 1.18, 1.85",
          "{basic_over:.2f}, {pcf2_over:.2f}, {pcf3_over:.2f}, {pcf3_gauss_over:.2f}, {pcf9_gauss_over:.2f}, "
          "{vsm_pcf3_over:.2f}, {vsm_9_over:.2f}", "basic < vsm < vsm_9 < pcf9_gauss and pcf2 < pcf3 < pcf9_gauss",
          of="time_project1024", why="Theirs have the scene's geometry in each time; these do not."),
    Claim("table of techniques", "VSM and EVSM are comparable in speed.", "with 9x9 blur 1.02, 1.01, 1.01 at 2048, 1024, 512",
          "{time_project2048.evsm_9_of:.2f}, {time_project1024.evsm_9_of:.2f}, {time_project512.evsm_9_of:.2f}",
          "max(time_project2048.evsm_9_of, time_project1024.evsm_9_of, time_project512.evsm_9_of) < 1.25"),
    Claim("table of techniques", "EVSM with filtering, mip maps and 9x9 blur is twice as fast as PCF 9x9.",
          "0.56, 0.47, 0.40 of its time at 2048, 1024, 512",
          "{time_project2048.evsm_full_of:.2f}, {time_project1024.evsm_full_of:.2f}, {time_project512.evsm_full_of:.2f} at "
          "1920 x 1080 pixels",
          "max(time_project2048.evsm_full_of, time_project1024.evsm_full_of, time_project512.evsm_full_of) < 1",
          why="Blur and levels go by the map's texels, PCF by the screen's pixels. On a processor a texel of the map takes "
          "as long as a pixel does, so that a map of 2048, of twice as many texels as the screen has pixels, costs more "
          "than it saves; smaller ones save."),
    Claim("table of blurs", "3x3 and 5x5 in one pass.", "5x5 2.60 times 3x3", "{blur_one:.2f}", "one_pass5 > one_pass3",
          of="time_blurs"),
    Claim("table of blurs", "5x5 separable against one pass.", "0.49", "{blur_separable:.2f}", "blur_separable < 1",
          of="time_blurs",
          why="On this device a pass of the library's blur takes {blur_pass:.1f} ms before its first fetch, for it reads and "
          "writes every texel and has a border, and a fetch {blur_fetch:.1f} ms: what 15 fetches fewer save, the second "
          "pass costs."),
    Claim("table of blurs", "7x7 and 9x9 separable against 5x5.", "1.28, 1.58", "{blur7:.2f}, {blur9:.2f}",
          "1 < blur7 < blur9", of="time_blurs"),
    Claim("table of blurs", "9x9 with linear sampling against 5x5 separable.", "1.01, the same number of taps",
          "{blur_linear:.2f}", "blur_linear < 1.25", of="time_blurs",
          why="A linear fetch reads four texels, which a sampler in hardware does as fast as one, and a processor does not."),
]
