"""Reads the GLSL of the maths files, expression by expression, and says it in WGSL.

It knows what these files are made of, and their types: WGSL converts nothing by itself, its clamp takes no scalar beside
a vector, it has no ?: and writes to no parameter. What it cannot read, or what WGSL cannot say, is a Fault.
A line's end inside an expression stays one in the text, for wgsl_layout.py to align.
"""
import dataclasses
import re

SCALARS = {"float": "f32", "int": "i32", "uint": "u32", "bool": "bool"}
# What only parameters are.
OPAQUE = {"sampler": "sampler", "texture2D": "texture_2d<f32>", "texture2DArray": "texture_2d_array<f32>",
          "utexture2DArray": "texture_2d_array<u32>"}
# A texture and its sampler in one, and what a texel of it is.
JOINED = {"sampler2D": "vec4", "sampler2DArray": "vec4", "usampler2DArray": "uvec4"}
SUFFIXES = {"": ("f", "float"), "i": ("i", "int"), "u": ("u", "uint")}
VECTOR = re.compile(r"([iu]?)vec([234])")
# Built-ins by the type of their result: that of the first argument, or float.
LIKE_FIRST = {"abs", "ceil", "clamp", "cos", "exp", "exp2", "floor", "inversesqrt", "log", "log2", "max", "min", "mix", "sign",
              "sin", "sqrt"}
FLOATS = {"dot", "length"}
BITS = {"uintBitsToFloat": ("bitcast<f32>", "float"), "floatBitsToUint": ("bitcast<u32>", "uint")}
OTHER_NAMES = {"inversesqrt": "inverseSqrt"}
# From the loosest on.
OPERATORS = [["||"], ["&&"], ["|"], ["^"], ["&"], ["==", "!="], ["<", ">", "<=", ">="], ["<<", ">>"], ["+", "-"],
             ["*", "/", "%"]]
LOGICAL = {"||", "&&", "==", "!=", "<", ">", "<=", ">="}
# Of WGSL's keywords and reserved words those that a name could be.
RESERVED = set("""alias as async auto break case class common compile const continue default delete diagnostic discard do
else enable enum explicit export extern external false filter final finally fn for from get goto handle if impl import in
inline inout instance interface layout let loop macro match meta mod module move mut namespace new nil null of operator out
override package partition pass patch precise precision private protected ptr pub public readonly ref register requires
resource return self set shared sizeof smooth static std struct super switch target template this throw trait true try
type typedef union unless unsafe use using var virtual where while with writeonly yield""".split())

TOKEN = re.compile(r"(?P<space>[ \t]+)|(?P<line>\n)|(?P<comment>//[^\n]*)|(?P<directive>#[^\n]*)|"
                   r"(?P<number>0x[0-9a-fA-F]+u?|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?u?)|(?P<word>[A-Za-z_]\w*)|"
                   r"(?P<sign><<=|>>=|<<|>>|<=|>=|==|!=|&&|\|\||\+\+|--|[-+*/%&|^]=|[-+*/%<>=!&|^~?:;,.(){}\[\]])")


class Fault(Exception):
    pass


@dataclasses.dataclass
class Token:
    kind: str
    text: str
    before: int  # how many lines end between it and the one in front
    line: int


@dataclasses.dataclass
class Variable:
    type: str
    is_parameter: bool = False
    is_pointer: bool = False
    is_changed: bool = False


@dataclasses.dataclass
class Expression:
    text: str
    type: str
    variable: Variable = None  # what it is a part of
    is_choice: bool = False    # a select, which needs no parentheses
    parts: tuple = ()          # what a constructor or a call is given


@dataclasses.dataclass
class Parameter:
    type: str
    name: str
    is_pointer: bool
    size: str  # of an array, as WGSL has it; else empty


@dataclasses.dataclass
class Known:
    """What all files declare at their scope."""
    constants: dict = dataclasses.field(default_factory=dict)  # type by name
    structs: dict = dataclasses.field(default_factory=dict)    # types of the members by name, by name
    functions: dict = dataclasses.field(default_factory=dict)  # (result's type, parameters) by name


def tokens(text):
    found, at, before, line = [], 0, 0, 1
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise Fault(f"line {line}: cannot read {text[at:at + 20]!r}")
        at = match.end()
        if match.lastgroup == "line":
            before, line = before + 1, line + 1
        elif match.lastgroup != "space":
            found.append(Token(match.lastgroup, match.group(), before, line))
            before = 0
    found.append(Token("end", "", before, line))
    return found


def wgsl_type(type_, size=""):
    if type_.endswith("[]"):
        return f"array<{wgsl_type(type_[:-2])}, {size}>"
    vector = VECTOR.fullmatch(type_)
    return f"vec{vector[2]}{SUFFIXES[vector[1]][0]}" if vector else {**SCALARS, **OPAQUE}.get(type_, type_)


def is_vector(type_):
    return VECTOR.fullmatch(type_) is not None


def flat(text):
    return text.replace("\n", " ")


class Reader:
    """The tokens of a file, and its expressions."""

    def __init__(self, text, known):
        self.tokens = tokens(text)
        self.at = 0
        self.known = known
        self.scopes = []

    def fault(self, message):
        raise Fault(f"line {self.next.line}: {message}")

    @property
    def next(self):
        return self.tokens[self.at]

    def take(self, text=None):
        token = self.next
        if text is not None and token.text != text:
            self.fault(f"{text} expected, not {token.text!r}")
        self.at += 1
        return token

    def accept(self, text):
        if self.next.text == text:
            return self.take()
        return None

    def gap(self):
        """What stands in front of the next token."""
        return "\n" if self.next.before else " "

    def is_type(self):
        text = self.next.text
        return text in {*SCALARS, *OPAQUE, *self.known.structs, "void"} or is_vector(text)

    def take_type(self):
        if not self.is_type():
            self.fault(f"a type expected, not {self.next.text!r}")
        return self.take().text

    def take_name(self):
        token = self.take()
        if token.kind != "word" or token.text in RESERVED:
            self.fault(f"WGSL takes no such name: {token.text}")
        return token.text

    def take_size(self):
        """That of an array, behind its name."""
        if not self.accept("["):
            return ""
        size = self.expression().text
        self.take("]")
        return size

    def find(self, name):
        for scope in reversed(self.scopes):
            if name in scope:
                return scope[name]
        return None

    def expression(self):
        condition = self.operation(0)
        if not self.accept("?"):
            return condition
        chosen = self.expression()
        self.take(":")
        other = self.expression()
        if chosen.type in self.known.structs or chosen.type.endswith("[]"):
            self.fault("select chooses no structs")
        return Expression(flat(f"select({other.text}, {chosen.text}, {condition.text})"), chosen.type, is_choice=True)

    def operation(self, level):
        if level == len(OPERATORS):
            return self.unary()
        left = self.operation(level + 1)
        while self.next.text in OPERATORS[level]:
            operator = self.take().text
            gap = self.gap()
            right = self.operation(level + 1)
            type_ = "bool" if operator in LOGICAL else right.type if is_vector(right.type) else left.type
            left = Expression(f"{left.text} {operator}{gap}{right.text}", type_)
        return left

    def unary(self):
        if self.next.text in ("-", "!", "~"):
            sign = self.take().text
            operand = self.unary()
            return Expression(sign + operand.text, operand.type)
        return self.postfix()

    def postfix(self):
        found = self.primary()
        while True:
            if self.accept("["):
                index = self.expression().text
                self.take("]")
                vector = VECTOR.fullmatch(found.type)
                type_ = SUFFIXES[vector[1]][1] if vector else found.type.removesuffix("[]")
                found = Expression(f"{found.text}[{index}]", type_, found.variable)
            elif self.accept("."):
                member = self.take().text
                found = Expression(f"{found.text}.{member}", self.member_type(found.type, member), found.variable)
            else:
                return found

    def member_type(self, type_, member):
        if type_ in self.known.structs:
            if member not in self.known.structs[type_]:
                self.fault(f"{type_} has no {member}")
            return self.known.structs[type_][member]
        vector = VECTOR.fullmatch(type_)
        if not vector or not re.fullmatch("[xyzw]{1,4}", member):
            self.fault(f"{type_} has no {member}")
        return SUFFIXES[vector[1]][1] if len(member) == 1 else f"{vector[1]}vec{len(member)}"

    def primary(self):
        if self.accept("("):
            inner = self.expression()
            self.take(")")
            return inner if inner.is_choice else Expression(f"({inner.text})", inner.type)
        token = self.take()
        if token.kind == "number":
            whole = re.fullmatch(r"\d+", token.text)
            return Expression(token.text, "uint" if token.text.endswith("u") else "int" if whole else "float")
        if token.kind != "word":
            self.at -= 1
            self.fault(f"cannot read {token.text!r}")
        if self.next.text == "(":
            return self.call(token.text)
        variable = self.find(token.text)
        if variable:
            text = token.text if not variable.is_pointer else (
                f"(*{token.text})" if self.next.text in (".", "[") else f"*{token.text}")
            return Expression(text, variable.type, variable)
        if token.text in self.known.constants:
            return Expression(token.text, self.known.constants[token.text])
        if token.text in ("true", "false"):
            return Expression(token.text, "bool")
        self.at -= 1
        self.fault(f"{token.text} is declared nowhere")

    def call(self, name):
        parameters = self.known.functions[name][1] if name in self.known.functions else []
        self.take("(")
        arguments, text = [], ""
        while not self.accept(")"):
            if arguments:
                self.take(",")
                text += "," + self.gap()
            by_pointer = len(arguments) < len(parameters) and parameters[len(arguments)].is_pointer
            arguments.append(self.pointer() if by_pointer else self.expression())
            text += arguments[-1].text
        if name in self.known.functions:
            return Expression(f"{name}({text})", self.known.functions[name][0])
        if name in SCALARS or is_vector(name) or name in self.known.structs:
            return Expression(f"{wgsl_type(name)}({text})", name, parts=tuple(arguments))
        if name in JOINED:
            return Expression(text, name, parts=tuple(arguments))
        if name.startswith("tex") and arguments and arguments[0].type in JOINED:
            return self.texture_call(name, *arguments)
        if name in BITS:
            return Expression(f"{BITS[name][0]}({text})", BITS[name][1])
        if name not in LIKE_FIRST | FLOATS or not arguments:
            self.fault(f"the function {name} is not known")
        type_ = arguments[0].type
        if is_vector(type_) and any(not is_vector(argument.type) for argument in arguments[1:]):
            text = ", ".join(a.text if is_vector(a.type) else f"{wgsl_type(type_)}({a.text})" for a in arguments)
        return Expression(f"{OTHER_NAMES.get(name, name)}({text})", "float" if name in FLOATS else type_)

    def texture_call(self, name, joined, *arguments):
        """One of GLSL's functions that read a texture: WGSL has the slice of an array apart, and no sampler to a fetch."""
        texture = joined.parts[0].text
        if name == "textureSize":
            return Expression(f"textureDimensions({texture})", "uvec2")
        place, *others = arguments
        words = place.text
        if joined.type.endswith("Array"):
            words = f"{words}.xy, i32({words}.z)" if place.type == "vec3" else f"{words}.xy, {words}.z"
            if len(place.parts) == 2:
                across, slice_ = place.parts
                words = f"{across.text}, {slice_.parts[0].text if place.type == 'vec3' else slice_.text}"
        named = {"textureGrad": f"textureSampleGrad({joined.text}", "textureGather": f"textureGather(0, {joined.text}",
                 "texelFetch": f"textureLoad({texture}"}
        if name not in named:
            self.fault(f"the function {name} is not known")
        return Expression(", ".join([named[name], words, *(other.text for other in others)]) + ")", JOINED[joined.type])

    def pointer(self):
        """An argument that the function changes: a variable of its own, since WGSL points to no part of one."""
        name = self.take().text
        variable = self.find(name)
        if not variable or self.next.text not in (",", ")"):
            self.fault("WGSL passes a whole variable to what changes it, and no part of one")
        variable.is_changed = True
        return Expression(name if variable.is_pointer else f"&{name}", variable.type)
