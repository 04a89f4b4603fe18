"""An article on variance shadow maps in an engine, with its constants for three lights."""
from claims import Claim

NAME = "article on VSM"
ITEMS = ["directional light", "spot light", "point light"]


def acne(light, item, constants):
    return Claim(item, f"With {constants} shadow acne is eliminated.", "eliminated",
                 f"mean loss of what is fully lit {{{light}_dark:.4f}}; the library's own, linear depth, "
                 f"{{{light}_ours_dark:.4f}}", f"{light}_dark < 1 / 255", of="article")


def edges(light, item, constants, why):
    return Claim(item, f"With {constants} edges are softened.", "softened; sometimes too soft",
                 f"RMSE in penumbrae {{{light}_penumbra:.3f}}, of all {{{light}:.4f}}; linear depth, the format's floor and a "
                 f"reduction of 0.1: {{{light}_ours_penumbra:.3f}} and {{{light}_ours:.4f}}",
                 f"{light}_penumbra < 2 * {light}_ours_penumbra", of="article", why=why)


CLAIMS = [
    acne("directional", "directional light", "a floor of 2e-6 and a reduction of 0.6"),
    edges("directional", "directional light", "a floor of 2e-6 and a reduction of 0.6",
          "A reduction of 0.6 takes what is less than 0.6 lit for unlit, and so moves every edge outwards."),
    acne("spot", "spot light", "a floor of 4e-7 and a reduction of 0.9997"),
    edges("spot", "spot light", "a floor of 4e-7 and a reduction of 0.9997",
          "What is less than 0.9997 lit counts as unlit, so nothing is left of a penumbra: edges are hard. With 0.1 in its "
          "place, on the same depth and floor, penumbrae err {spot_less_penumbra:.3f}, and a mean of {spot_less_bleed:.3f} "
          "bleeds into full shadow."),
    acne("point", "point light", "a floor of 9e-6 and a reduction of 0.997"),
    edges("point", "point light", "a floor of 9e-6 and a reduction of 0.997", "As for the spot light. With 0.1 in its place penumbrae err {point_less_penumbra:.3f}, and a mean of "
          "{point_less_bleed:.3f} bleeds into full shadow: projected depth crowds at the far end, and the floor is as "
          "large as the squared differences there."),
]
