"""Lays a statement out in lines, aligned below what they continue, as the other languages have it by hand."""
WIDTH = 120
# With how much worse it is to end a line there than at a comma.
OPERATORS = {" + ": 0, " - ": 0, " | ": 0, " && ": 0, " || ": 0, " * ": 1, " / ": 1}


def opened(text, start, columns):
    """The columns behind the parentheses that are open after the text, which begins at column start."""
    columns = list(columns)
    for at, character in enumerate(text):
        if character in "([":
            columns.append(start + at + 1)
        elif character in ")]":
            columns.pop()
    return columns


def first_column(line):
    """Where an expression begins: behind `=` or `return`."""
    for mark in (" = ", "= ", "return "):
        if mark in line:
            return line.index(mark) + len(mark)
    return len(line) - len(line.lstrip()) + 4


def aligned(indent, parts):
    """The parts as lines."""
    lines = [" " * indent + parts[0]]
    base, columns = first_column(lines[0]), opened(lines[0], 0, [])
    for part in parts[1:]:
        column = columns[-1] if columns else base
        lines.append(" " * column + part)
        columns = opened(part, column, columns)
    return lines


def cut(line, start, columns):
    """Where to end the line: at the least nested comma or operator, the last of these that fits."""
    best = None
    for at in range(WIDTH, start, -1):
        worse = 0 if line[at - 1:at + 1] == ", " else OPERATORS.get(line[at - 2:at + 1])
        if worse is not None:
            price = 2 * len(opened(line[start:at], start, columns)) + worse
            if best is None or price < best[0]:
                best = (price, at)
    return best and best[1]


def lines_of(indent, text):
    """The lines of a statement: ended where its text ends them, if they fit, else wherever it is best."""
    lines = aligned(indent, text.split("\n"))
    if max(map(len, lines)) <= WIDTH:
        return lines
    rest, parts, start, columns = " " * indent + text.replace("\n", " "), [], indent, []
    base = first_column(rest)
    while len(rest) > WIDTH:
        at = cut(rest, start, columns)
        if not at:
            break
        parts.append(rest[start:at])
        columns = opened(rest[start:at], start, columns)
        start = columns[-1] if columns else base
        rest = " " * start + rest[at + 1:]
    return aligned(indent, parts + [rest[start:]])
