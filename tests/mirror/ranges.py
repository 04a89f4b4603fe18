"""Whether the range of a row in functions.def is the one that the function's doc comment promises.

A comment's sentence "Result ..." says it in one of these ways; a row that is wider or narrower is a difference:
    in [0,1]                 and (0, 1], also several of them: the row has the least and the greatest
    in [0, maxVariance]      a bound with a name stands for any positive number
    from 0 to layerCount - 1 whole numbers from 0 or the first one on, up to 65535
    at least minVariance     from 0 on
    any number, unchanged    all finite numbers
    true where ...           0 or 1, of a bool
"""
import re

LARGEST = 3.4028234663852886e38  # FLT_MAX
# A comment rounds its figures to two digits or more.
ROUNDING = 0.005

INTERVAL = re.compile(r"[\[(](?P<low>[-\w.^/]+), ?(?P<high>[-\w.^/]+)[\])]")
BRACKET = re.compile(r"[\[\]]")
ROW = re.compile(r"^FUNCTION\((\w+), (\w+), .*, (?P<low>[^,]+), (?P<high>[^,]+)\)$", re.MULTILINE)


def number(text):
    """What `1/4`, `2^126` or `-6.6e18` stands for; a name for the largest float."""
    parts = re.fullmatch(r"(-?[\d.]+(?:e\d+)?)(?:([/^])(\d+))?", text)
    if not parts:
        return LARGEST
    value = float(parts[1])
    return value / float(parts[3]) if parts[2] == "/" else value ** float(parts[3]) if parts[2] else value


def row_number(text):
    return {"FLT_MAX": LARGEST, "-FLT_MAX": -LARGEST, "lvsm::kHuge<double>": 2.0**126}.get(text) or float(text)


def promised(function):
    """The least and the greatest result that the comment promises, or None where it says nothing that is understood.

    None in place of the greatest stands for a whole number.
    """
    if function.result == "bool":
        return 0.0, 1.0
    match = re.search(r"\bResult\b:?(.*?)(?=\. |\.$|$)", function.doc)
    sentence = match[1] if match else ""
    intervals = [m for m in INTERVAL.finditer(sentence.split(": ")[0]) if BRACKET.search(m.group())]
    if intervals:
        return min(number(m["low"]) for m in intervals), max(number(m["high"]) for m in intervals)
    if re.search(r"\bfrom \d+ to \w+", sentence):
        return 0.0, None
    if "at least" in sentence:
        return 0.0, LARGEST
    if re.search(r"\bunchanged\b|\bany number\b", sentence):
        return -LARGEST, LARGEST
    return None


def agree(row, doc):
    return abs(row - doc) <= ROUNDING * abs(doc)


# What changes splits in place leaves others as they were; a struct's members have a range each, and a code has none.
WITHOUT_RANGE = {"Splits", "Inserted", "Component", "Plane", "Planes", "Mixture", "UVec2", "UVec4"}


def check(text, public):
    """Yields the rows whose range is not the comment's."""
    functions = {function.name: function for function in public}
    for match in ROW.finditer(text):
        name, kind = match[1], match[2]
        if name not in functions or kind in WITHOUT_RANGE:
            continue
        said = promised(functions[name])
        if said is None:
            yield f"{name}'s /// comment gives no range that tests/mirror/ranges.py understands: 'Result in [0,1]'"
            continue
        try:
            low, high = row_number(match["low"]), row_number(match["high"])
        except ValueError:
            yield f"{name}'s row has a range that tests/mirror/ranges.py does not understand: {match['low']}, {match['high']}"
            continue
        whole = said[1] is None and high == int(high) and high <= 65535
        if not agree(low, said[0]) or not (whole or said[1] is not None and agree(high, said[1])):
            yield (f"{name}'s row in tests/parity/functions.def has the range {match['low']} to {match['high']}, "
                   f"its /// comment another: {said[0]:g} to {'a whole number' if said[1] is None else f'{said[1]:g}'}")
