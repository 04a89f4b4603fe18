#!/usr/bin/env python3
"""Makes wgsl/lvsm/TOPIC.wgsl of glsl/lvsm/TOPIC.glsl, and the sampling wrappers of those with samplers apart; without
--write, fails where one is not what it would make.

The names, the order of the parameters, the comments and the lines stay. WGSL has no #include, no overloads (nor has this
library), no ?: (select), no inout (a pointer), and converts nothing by itself. config.wgsl, lvsm.wgsl, the passes and
sampling/separate.wgsl are written by hand: their comments, settings and bindings are of the language.
"""
import argparse
import pathlib
import re
import sys

from wgsl_code import Fault, Known, Parameter, Reader, Variable, wgsl_type
from wgsl_layout import lines_of

ROOT = pathlib.Path(__file__).resolve().parents[2]
BY_HAND = {"config", "lvsm", "sampling/separate", "sampling/highp"}
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "|=", "&=", "^="}


class Translation(Reader):
    def __init__(self, text, known):
        super().__init__(text, known)
        self.lines = []
        self.variables = []

    def put(self, indent, text):
        self.lines += lines_of(indent, text)

    def put_comments(self, indent, is_first):
        """Those in front of the next statement or declaration, and the empty line in front of it."""
        while True:
            token = self.next
            if token.before > 1 and not is_first and token.text != "}" and self.lines and self.lines[-1]:
                self.lines.append("")
            if token.kind != "comment":
                return
            if not token.before and self.lines:
                self.fault("a comment stands in a line of its own")
            self.lines.append(" " * indent + self.take().text)
            is_first = False

    # Declarations at the scope of a file.

    def file(self):
        directives = r"#(ifndef|define) LVSM_\w+_GLSL|#include \"[\w./]+\.glsl\"|#endif"
        while True:
            while self.next.kind == "directive":
                if not re.fullmatch(directives, self.next.text):
                    self.fault(f"cannot say {self.next.text} in WGSL")
                self.take()
            self.put_comments(0, False)
            if self.next.kind == "end":
                return
            if self.next.kind != "directive":
                self.declaration()

    def declaration(self):
        if self.accept("const"):
            type_, name = self.take_type(), self.take_name()
            self.take("=")
            self.known.constants[name] = type_
            self.put(0, f"const {name}: {wgsl_type(type_)} = {self.expression().text};")
            self.take(";")
        elif self.accept("struct"):
            self.struct(self.take_name())
        else:
            self.function(self.take_type(), self.take_name())

    def struct(self, name):
        members = self.known.structs[name] = {}
        self.put(0, f"struct {name}")
        self.take("{")
        self.lines.append("{")
        while True:
            self.put_comments(4, not members)
            if self.accept("}"):
                break
            type_, member = self.take_type(), self.take_name()
            size = self.take_size()
            self.take(";")
            members[member] = type_ + "[]" * bool(size)
            self.put(4, f"{member}: {wgsl_type(members[member], size)},")
        self.take(";")
        self.lines.append("}")

    def parameters(self):
        found = []
        self.take("(")
        while not self.accept(")"):
            if found:
                self.take(",")
            is_pointer = bool(self.accept("inout") or self.accept("out"))
            type_, name = self.take_type(), self.take_name()
            size = self.take_size()
            found.append(Parameter(type_ + "[]" * bool(size), name, is_pointer, size))
        return found

    def function(self, result, name):
        parameters = self.parameters()
        self.known.functions[name] = (result, parameters)
        said = []
        for p in parameters:
            type_ = wgsl_type(p.type, p.size)
            said.append(f"{p.name}: " + (f"ptr<function, {type_}>" if p.is_pointer else type_))
        self.put(0, f"fn {name}({', '.join(said)})" + (f" -> {wgsl_type(result)}" if result != "void" else ""))
        arguments = {p.name: Variable(p.type, True, p.is_pointer) for p in parameters}
        self.scopes, self.variables = [arguments], []
        begin = len(self.lines)
        self.block(0)
        for p in parameters:
            if arguments[p.name].is_changed and not p.is_pointer:
                self.fault(f"WGSL writes to no parameter: {p.name} of {name}")
        self.lines[begin:] = [re.sub(r"\{(\d+)\} ", lambda m: "var " if self.variables[int(m[1])].is_changed else "let ", line)
                              for line in self.lines[begin:]]

    # Statements.

    def block(self, indent):
        self.take("{")
        self.lines.append(" " * indent + "{")
        self.scopes.append({})
        is_first = True
        while True:
            self.put_comments(indent + 4, is_first)
            if self.accept("}"):
                break
            self.statement(indent + 4)
            is_first = False
        self.scopes.pop()
        self.lines.append(" " * indent + "}")

    def body(self, indent):
        """What follows an `if` or `for`, which has braces in WGSL."""
        if self.next.text == "{":
            return self.block(indent)
        self.lines.append(" " * indent + "{")
        self.scopes.append({})
        self.statement(indent + 4)
        self.scopes.pop()
        self.lines.append(" " * indent + "}")

    def statement(self, indent):
        word = self.next.text
        if word == "if":
            self.choice(indent, "")
        elif word == "for":
            self.loop(indent)
        elif word in ("return", "continue", "break"):
            self.take()
            self.put(indent, word + ("" if self.next.text == ";" else f" {self.expression().text}") + ";")
            self.take(";")
        elif word == "LVSM_PRECISE" or self.is_type():
            self.accept("LVSM_PRECISE")
            self.local(indent)
        else:
            self.assignment(indent)

    def choice(self, indent, before):
        self.take("if")
        self.take("(")
        self.put(indent, f"{before}if ({self.expression().text})")
        self.take(")")
        self.body(indent)
        if self.accept("else"):
            if self.next.text == "if":
                self.choice(indent, "else ")
            else:
                self.lines.append(" " * indent + "else")
                self.body(indent)

    def loop(self, indent):
        self.take("for")
        self.take("(")
        type_, name = self.take_type(), self.take_name()
        self.take("=")
        begin = self.expression().text
        self.take(";")
        self.scopes.append({name: Variable(type_)})
        condition = self.expression().text
        self.take(";")
        step = self.take().text
        if step not in ("++", "--") or self.take().text != name:
            self.fault("a loop ends in ++i or --i")
        self.take(")")
        self.put(indent, f"for (var {name} = {begin}; {condition}; {name}{step})")
        self.body(indent)
        self.scopes.pop()

    def local(self, indent):
        type_, name = self.take_type(), self.take_name()
        size = self.take_size()
        variable = Variable(type_ + "[]" * bool(size))
        if self.accept("="):
            self.variables.append(variable)
            mark = len(self.variables) - 1
            # As wide as the word that it becomes, so that lines align.
            text = f"{{{mark}}} {name} = " + self.expression().text
            self.put(indent, text + ";")
        else:
            self.put(indent, f"var {name}: {wgsl_type(variable.type, size)};")
        self.scopes[-1][name] = variable
        self.take(";")

    def assignment(self, indent):
        left = self.expression()
        text = left.text
        if self.next.text in ASSIGNMENTS:
            if not left.variable:
                self.fault(f"cannot assign to {left.text}")
            left.variable.is_changed = True
            text += f" {self.take().text} {self.expression().text}"
        self.put(indent, text + ";")
        self.take(";")


def translated(text, known):
    # No precision is asked for.
    text = text.replace("Needs: sampling/highp.", "Needs: no other.").replace("sampling/highp, ", "")
    # No sampler filters codes.
    functions = text.split("\n}\n")
    text = "\n}\n".join(re.sub(r", (sampler )?filtering\b", "", f) if "utexture" in f else f for f in functions)
    translation = Translation(text, known)
    translation.file()
    return "\n".join(translation.lines) + "\n"


def topics(root):
    """In an order in which each topic stands behind those that it includes."""
    found = []

    def add(stem):
        if stem not in found:
            path = root / f"glsl/lvsm/{stem}.glsl"
            for included in re.findall(r'^#include "([\w./]+)\.glsl"', path.read_text(), re.MULTILINE):
                add((path.parent / included).resolve().relative_to((root / "glsl/lvsm").resolve()).as_posix())
            found.append(stem)

    for umbrella in ("lvsm", "sampling/separate"):
        if (root / f"glsl/lvsm/{umbrella}.glsl").exists():
            add(umbrella)
    return [stem for stem in found if stem not in BY_HAND]


def made(root):
    """Yields each file and what it is to hold. What config declares is read from config.wgsl."""
    known = Known()
    names = {"f32": "float", "i32": "int"}
    for name, type_ in re.findall(r"^const (\w+): (\w+)", (root / "wgsl/lvsm/config.wgsl").read_text(), re.MULTILINE):
        known.constants[name] = names[type_]
    for stem in topics(root):
        path = root / f"glsl/lvsm/{stem}.glsl"
        try:
            yield root / f"wgsl/lvsm/{stem}.wgsl", translated(path.read_text(), known)
        except Fault as fault:
            raise Fault(f"{path.relative_to(root)}, {fault}") from fault


def differences(root):
    """What check.py has to say."""
    try:
        for path, text in made(root):
            if not path.exists() or path.read_text() != text:
                yield f"{path.relative_to(root)} is not what is made of GLSL: tests/mirror/wgsl.py --write"
    except (Fault, FileNotFoundError) as fault:
        yield f"WGSL cannot be made: {fault}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true")
    if parser.parse_args().write:
        for path, text in made(ROOT):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
    found = list(differences(ROOT))
    print(*found, f"{len(found)} differences", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
