"""Small changes of the maths, one at a time: what a slip of the pen would do to a C++ header or a shader include.

It knows only what these files are made of: a comparison or sum has spaces around its operator, an angle bracket of a
template has none. A mutant is known by its place in words, `topic/function: line with @old => new@`, so that a list of
them survives changes elsewhere in the file.
"""
import collections
import dataclasses
import pathlib
import re

TOKEN = re.compile(r"""(?P<space>\s+|//[^\n]*|\#[^\n]*(?:\\\n[^\n]*)*)
                     |(?P<string>"[^"]*")
                     |(?P<number>0[xX][\da-fA-F]+u?|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[fu]?)
                     |(?P<name>[A-Za-z_]\w*)
                     |(?P<sign><=|>=|==|!=|&&|\|\||[-+*/%&|]=|\+\+|--|->|::|<<|>>|.)""", re.VERBOSE | re.DOTALL)
COMPARISONS = {"<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",), "!=": ("==",)}
SWAPS = {"+": "-", "-": "+", "*": "/", "/": "*", "%": "/", "&&": "||", "||": "&&", "+=": "-=", "-=": "+=", "&=": "|="}
BINDING = {"?": 0, "||": 1, "&&": 2, "==": 3, "!=": 3, "<": 4, "<=": 4, ">": 4, ">=": 4, "+": 6, "-": 6,
           "*": 7, "/": 7, "%": 7}
OTHERS = {"min": "max", "max": "min", "minimum": "maximum", "maximum": "minimum"}
OPENS, CLOSES = "([{", ")]}"
REALS = {"T", "float", "double"}


@dataclasses.dataclass
class Token:
    kind: str
    text: str
    start: int
    end: int
    template: bool = False  # inside the angle brackets of a template


@dataclasses.dataclass
class Mutant:
    topic: str
    function: str
    start: int
    end: int
    new: str
    key: str = ""


def tokens(text):
    """The tokens of a file, comments and preprocessor lines left out."""
    found, angles = [], 0
    for match in TOKEN.finditer(text):
        if match.lastgroup == "space":
            continue
        token = Token(match.lastgroup, match.group(), match.start(), match.end())
        opens = token.text == "<" and (not text[token.start - 1].isspace() or found[-1].text == "template")
        angles += opens
        token.template = angles > 0
        if token.text == ">" and angles > 0:
            angles -= 1
        found.append(token)
    return found


class File:
    """A file's tokens, which bracket closes which, and its functions."""

    def __init__(self, text):
        self.text = text
        self.tokens = tokens(text)
        self.partner = {}
        self.within = []  # the innermost bracket that each token stands in
        stack = []
        for i, token in enumerate(self.tokens):
            self.within.append(self.tokens[stack[-1]].text if stack else "")
            if token.text in OPENS:
                stack.append(i)
            elif token.text in CLOSES:
                self.partner[i] = stack.pop()
                self.partner[self.partner[i]] = i
        self.bodies = []  # (function, first token inside the braces, closing brace)
        self.results = {}  # the type that a function returns, "" for void and constructors, by its first token inside
        self.outside = []  # tokens at the scope of a file, namespace or class
        self._scan(0, len(self.tokens))

    def _scan(self, begin, end):
        i = statement = begin
        while i < end:
            token = self.tokens[i]
            if token.text == "(":
                i = self.partner[i]
            elif token.text == "{":
                close = self.partner[i]
                # The = of <typename T = float> is no initialiser's.
                head = ["" if t.template else t.text for t in self.tokens[statement:i]]
                if "(" in head and "=" not in head[:head.index("(")]:
                    self.bodies.append((head[head.index("(") - 1], i + 1, close))
                    self.results[i + 1] = self._result(statement, statement + head.index("(") - 1)
                elif head and head[0] != "enum" and "enum" not in head and head[-1] != "=":
                    self._scan(i + 1, close)
                i = close
                statement = i + 1
            else:
                self.outside.append(i)
                if token.text in (";", ":") and (token.text == ";" or self.tokens[i - 1].text in ("public", "private")):
                    statement = i + 1
            i += 1

    def _result(self, begin, name):
        """The type in front of a function's name."""
        if self.at(begin) == "template":
            begin += 1
            while self.tokens[begin].template:
                begin += 1
        while self.at(begin) in ("inline", "constexpr", "static"):
            begin += 1
        if self.at(begin) == "explicit" or begin == name or self.at(begin) == "void":
            return self.at(name) if self.at(name - 1) == "operator" else ""
        return self.source(begin, name)

    def at(self, i):
        return self.tokens[i].text if 0 <= i < len(self.tokens) else ""

    def is_binary(self, i):
        before = self.tokens[i - 1]
        if before.text in REALS or before.text == "return":  # a pointer, or a sign
            return False
        return before.kind in ("name", "number") or before.text in (")", "]", ">")

    def operand_end(self, i):
        """The token after the right operand of the operator at i."""
        binding = BINDING[self.at(i)]
        j = i + 1
        while True:
            text = self.at(j)
            if text in OPENS:
                j = self.partner[j]
            elif text in CLOSES or text in (",", ";", ":", "?"):
                return j
            elif j > i + 1 and text in BINDING and not self.tokens[j].template and self.is_binary(j) \
                    and BINDING[text] <= binding:
                return j
            j += 1

    def arguments(self, open_):
        """(first token, token after the last) of each argument of a call."""
        found, begin, i = [], open_ + 1, open_ + 1
        while i <= self.partner[open_]:
            if self.at(i) in OPENS:
                i = self.partner[i]
            elif i == self.partner[open_] or self.at(i) == "," and not self.tokens[i].template:
                found.append((begin, i))
                begin = i + 1
            i += 1
        return found

    def is_bound(self, i):
        """Whether the number at i is all of a bound of clamp, which another mutant takes away."""
        while self.at(i - 1) == "-" or self.at(i - 1) == "(" and self.at(i - 2) in REALS:
            i -= 1 if self.at(i - 1) == "-" else 2
        return self.at(i - 1) == "," and any(self.at(k - 1) == "clamp" and self.partner[k] > i
                                             for k in range(max(i - 40, 0), i) if self.at(k) == "(")

    def source(self, begin, end):
        """The text from one token up to, not including, another."""
        return self.text[self.tokens[begin].start:self.tokens[end - 1].end]


def other_numbers(text, is_real):
    suffix = "f" if text.endswith("f") else ""
    number = text[:-1] if suffix else text
    if float(number) == 0:
        return [number.replace("0", "1", 1) + suffix]
    if is_real:
        return [f"2 * {number}" + suffix, f"0.5{suffix} * {number}" + suffix]
    return [str(int(number) + 1), str(int(number) - 1)]


def numbers(file, i):
    """Changes of the number at token i."""
    token = file.tokens[i]
    before = i - 1 if file.at(i - 1) == "-" else i
    is_real = file.at(before - 1) == "(" and file.at(before - 2) in REALS or bool(re.search(r"[.eE]", token.text))
    if re.match("0[xX]", token.text) or token.text.endswith("u"):  # bits
        return
    if is_real and file.is_bound(i) and float(token.text.rstrip("f")) == 1:
        yield token.start, token.end, "0.5f" if token.text.endswith("f") else "0.5"
        return
    for new in other_numbers(token.text, is_real):
        # GLSL takes no whole number for a real one, and a template of C++ no double beside a float.
        real = "2.0f *" if token.text.endswith("f") else "2.0 *"
        yield token.start, token.end, re.sub(r"^2 \*", real, new) if "." in token.text else new


def calls(file, i):
    """Changes of a call of min, max, clamp, sqrt or abs whose name is token i: an argument let through."""
    name, open_ = file.at(i), i + 1
    while file.tokens[open_].template:
        open_ += 1
    if name not in (*OTHERS, "clamp", "sqrt", "abs") or file.at(open_) != "(":
        return
    first = i
    while file.at(first - 1) == "::":
        first -= 2
    arguments = [file.source(*a) for a in file.arguments(open_)]
    start, end = file.tokens[first].start, file.tokens[file.partner[open_]].end
    prefix = file.source(first, i) if first < i else ""
    if name in OTHERS and len(arguments) == 2:
        yield file.tokens[i].start, file.tokens[i].end, OTHERS[name]
        for argument in arguments:
            yield start, end, f"({argument})"
    elif name == "clamp" and len(arguments) == 3:
        least, most = ("minimum", "maximum") if "minimum(" in file.text or "#include <" in file.text else ("min", "max")
        yield start, end, f"{prefix}{least}({arguments[0]}, {arguments[2]})"
        yield start, end, f"{prefix}{most}({arguments[1]}, {arguments[0]})"
    elif len(arguments) == 1:
        yield start, end, f"({arguments[0]})"


def signs(file, i):
    """Changes of the operator at token i."""
    token = file.tokens[i]
    for new in COMPARISONS.get(token.text, ()):
        yield token.start, token.end, new
    if token.text in ("+", "-", "*", "/", "%") and not file.is_binary(i):
        if token.text == "-" and not file.is_bound(i + 1):
            yield token.start, token.end, ""
        return
    if token.text in SWAPS:
        yield token.start, token.end, SWAPS[token.text]
    if token.text in ("+", "-"):
        yield file.tokens[i - 1].end, file.tokens[file.operand_end(i) - 1].end, ""
    if token.text == "!":
        yield token.start, token.end, ""


def statements(file, i):
    """Changes of the statement that begins at token i: a condition that never holds, a value lost or turned round."""
    if file.at(i) in ("for", "while", "switch", "return", "case", "default", "using", "else"):
        return
    if file.within[i] == "(":  # of a for
        return
    if file.at(i) == "if" and file.at(i + 1) != "(":  # if constexpr
        return
    if file.at(i) == "if":
        yield file.tokens[i + 2].start, file.tokens[file.partner[i + 1]].start, "false"
        return
    end = i
    while file.at(end) not in (";", "{", "}", ""):
        end = file.partner[end] + 1 if file.at(end) in OPENS else end + 1
    if file.at(end) != ";":
        return
    words = [t.text for t in file.tokens[i:end]]
    declared = 1 if words[0] == "const" else 0
    if words[declared] in REALS and len(words) > declared + 3 and words[declared + 2] == "=":
        begin = i + declared + 3
        start, stop = file.tokens[begin].start, file.tokens[end - 1].end
        if re.fullmatch(r"(T\()?0(\.0)?\)?", file.text[start:stop]):
            return
        yield start, stop, "T(0)" if words[declared] == "T" else "0.0"
        yield start, stop, f"-({file.text[start:stop]})"
    elif words[0] in ("break", "continue") or \
            end - i < 80 and file.tokens[i + 1].kind != "name" and words[1] not in ("::", "<") and words[0] != "LVSM_ASSERT":
        yield file.tokens[i].start, file.tokens[end - 1].end, ""


def is_length(file, i):
    """Whether token i is in the length of an array that is declared: a longer one changes nothing."""
    while i > 0 and file.at(i) not in ("[", ";", "{", "}"):
        i -= 1
    return file.at(i) == "[" and file.tokens[i - 1].kind == file.tokens[i - 2].kind == "name" and file.at(i - 2) != "return"


def in_body(file, begin, end):
    skipped = -1  # to the end of an assertion, which states what callers have to keep
    for i in range(begin, end):
        token = file.tokens[i]
        if token.text in ("LVSM_ASSERT", "static_assert"):
            skipped = file.partner[i + 1] + 1
        if token.template or i <= skipped or is_length(file, i):
            continue
        if token.kind == "number":
            yield from numbers(file, i)
        elif token.kind == "name":
            yield from calls(file, i)
            # A whole limit, such as kMaxLayers: one more and one less. In an array's length it would not mean that.
            if re.fullmatch(r"k[A-Z]\w*|LVSM_MAX_\w+", token.text) and file.at(i - 1) not in ("[", "int") \
                    and not file.tokens[i + 1].template:
                for new in (f"({token.text} + 1)", f"({token.text} - 1)"):
                    yield token.start, token.end, new
            if token.text in ("true", "false"):
                yield token.start, token.end, "false" if token.text == "true" else "true"
            if file.at(i + 1) == "?" and file.at(i - 1) in ("=", "(", ",", "return", ":"):
                yield token.start, token.end, f"!{token.text}"
        elif token.kind == "sign":
            yield from signs(file, i)
        if file.at(i - 1) in ("{", "}", ";", ")", "else") and (token.kind == "name"):
            yield from statements(file, i)


def outside_bodies(file):
    """Changes of constants and of members' defaults; whole constants give arrays their lengths, and are left."""
    statement, kinds = [], []
    for i in file.outside:
        if file.tokens[i].template:  # typename T = float, and the 2 of vec<2, T> behind it
            continue
        if file.at(i - 1) == "}" and file.at(i) != ";":  # of a function, which no semicolon ends
            statement = []
        statement.append(i)
        if file.at(i) != ";":
            continue
        words = [file.at(k) for k in statement]
        if "=" in words:
            at = words.index("=")
            name = words[at - 1]
            kinds = words[:at - 1]
            # The parentheses of T(...) are left out of the scan.
            stop = file.tokens[i].start
            start = file.tokens[statement[at]].end
            for k, token in enumerate(file.tokens):
                if start <= token.start < stop and not ("int" in kinds and "constexpr" in kinds):
                    if token.kind == "number":
                        yield from ((name, *change) for change in numbers(file, k))
                    elif token.text in ("true", "false"):
                        yield name, token.start, token.end, "false" if token.text == "true" else "true"
        statement = []


def context(text, start, end):
    begin = text.rfind("\n", 0, start) + 1
    stop = text.find("\n", end)
    return text[begin:start], text[start:end], text[end:stop if stop >= 0 else len(text)]


def squeezed(text):
    return " ".join(re.sub(r"//[^\n]*", "", text).split())


def key_of(text, mutant):
    before, old, after = context(text, mutant.start, mutant.end)
    # The squeezing must not glue or part what stands at the marks.
    line = squeezed(f"{before}@{old} => {mutant.new}@{after}")
    return f"{mutant.topic}/{mutant.function}: {line}"


def mutants(path):
    """All mutants of a file, by key."""
    text = pathlib.Path(path).read_text()
    file = File(text)
    found, seen = [], collections.Counter()
    places = set()
    for function, begin, end in file.bodies:
        for start, stop, new in in_body(file, begin, end):
            if (start, stop, new) not in places:
                places.add((start, stop, new))
                found.append(Mutant(path.stem, function, start, stop, new))
    for name, start, stop, new in outside_bodies(file):
        found.append(Mutant(path.stem, name, start, stop, new))
    for mutant in found:
        key = key_of(text, mutant)
        seen[key] += 1
        mutant.key = key if seen[key] == 1 else f"{key} #{seen[key]}"
    return file, found


def parse(key):
    """Topic, function, and the line with its old and new words, of a key."""
    topic, function, before, old, new, after, number = re.fullmatch(
        r"(\w+)/(\w+): (.*?)@(.*) => (.*)@(.*?)(?: #(\d+))?", key).groups()
    return topic, function, before, old, new, after, int(number or 1)


def named(path, key):
    """The mutant that a key written by hand names, or None where the file has no such line."""
    topic, function, before, old, new, after, number = parse(key)
    text = pathlib.Path(path).read_text()
    file = File(text)

    def loose(part):
        return r"\s+".join(re.escape(word) for word in part.split())

    def gap(part, at):
        return r"\s+" if part[at:at + 1 or None] == " " else r"\s*"

    pattern = loose(before) + gap(before, -1) + f"({loose(old)})" + gap(after, 0) + loose(after)
    # A constant or a member stands outside all functions.
    places = [(file.tokens[begin - 1].start, file.tokens[end].end) for name, begin, end in file.bodies
              if name == function] or [(0, len(text))]
    matches = [(start, match) for start, stop in places for match in re.finditer(pattern, text[start:stop])]
    if len(matches) < number:
        return None
    start, match = matches[number - 1]
    return Mutant(topic, function, start + match.start(1), start + match.end(1), new, key)


if __name__ == "__main__":
    import sys
    for argument in sys.argv[1:]:
        for mutant in mutants(pathlib.Path(argument))[1]:
            print(mutant.key)
