"""Finds the messages of the sources: what C++ throws, prints or gives to VTK, what Python raises.

A message is a string in which "…" stands for every part that is known at run time only. Of C++ only as
much is understood as sentences are made of: literals, joined by `+` or `<<`; alternatives of `? :`; a
stream or string that is filled before it is thrown; a function that returns the sentence; a parameter
that each caller gives a part of it.
"""
import ast
import itertools
import os
import re

VARIABLE = "…"
# What is thrown without a sentence of its own.
SILENT = {"Aborted", "bad_alloc"}
MACROS = {"vtkErrorMacro", "vtkWarningMacro", "vtkGenericWarningMacro", "vtkErrorWithObjectMacro"}
TOKEN = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^(\s]*)\((?P<raw>.*?)\)(?P=mark)"|"(?:\\.|[^"\\\n])*"'
    r"|'(?:\\.|[^'\\\n])+'|[A-Za-z_]\w*|\.?\d[\w.']*|<<|>>|->|::|\+=|==|[^\s]", re.DOTALL)
ESCAPES = {"n": "\n", "t": "\t", "0": "\0"}
OPENING, CLOSING = ("(", "[", "{"), (")", "]", "}")
DEEPEST = 4  # calls that are followed, so that functions that call themselves come to an end


class Token(str):
    """A word of C++; `text` is what a literal says, and None otherwise."""
    line = 0
    text = None


def tokens_of(source):
    """The words of C++ source without its comments."""
    found = []
    line, end = 1, 0
    for match in TOKEN.finditer(source):
        line += source.count("\n", end, match.start())
        end = match.start()
        word = match.group()
        if word.startswith(("//", "/*")):
            continue
        token = Token(word)
        token.line = line
        if match.group("raw") is not None:
            token.text = match.group("raw")
        elif word[0] in "\"'":
            token.text = re.sub(r"\\(.)", lambda m: ESCAPES.get(m.group(1), m.group(1)), word[1:-1],
                                flags=re.DOTALL)
        found.append(token)
    return found


def closing(tokens, opening):
    """The place of the bracket that closes the one at `opening`."""
    depth = 0
    for i in range(opening, len(tokens)):
        depth += (tokens[i] in OPENING) - (tokens[i] in CLOSING)
        if depth == 0:
            return i
    return len(tokens)


def end_of_statement(tokens, begin):
    """The place of the semicolon that ends the statement, or of the bracket around it."""
    i = begin
    while i < len(tokens) and tokens[i] != ";" and tokens[i] not in CLOSING:
        i = closing(tokens, i) + 1 if tokens[i] in OPENING else i + 1
    return i


def split(tokens, separators):
    """The parts between separators that stand in no bracket."""
    parts, depth = [[]], 0
    for token in tokens:
        depth += (token in OPENING) - (token in CLOSING)
        if depth == 0 and token in separators and token.text is None:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


def branches(expression):
    """The two values of `? :`, or None."""
    question = split(expression, ("?",))
    if len(question) == 1:
        return None
    rest = expression[len(question[0]) + 1:]
    first = split(rest, (":",))[0]
    return first, rest[len(first) + 1:]


def tidy(message):
    return re.sub("(%s)+" % VARIABLE, VARIABLE, re.sub(r"\s+", " ", message)).strip()


def is_name(token):
    return token.text is None and re.match(r"[A-Za-z_]", token) is not None


def bodies_of(tokens):
    """(begin, end, bracket that closes the parameters) of the functions of a file."""
    found = []
    i = 0
    while i < len(tokens):
        if tokens[i] == "{":
            before = i - 1
            while tokens[before] in ("const", "noexcept", "override"):
                before -= 1
            if tokens[before] == ")":
                found.append((i, closing(tokens, i), before))
                i = closing(tokens, i)
        i += 1
    return found


class Cpp:
    """The messages of a set of C++ files: `files` gives the words of each by its name."""

    def __init__(self, files):
        self.files = files
        self.calls = {}  # where a name stands before a bracket
        self.values = {}  # where it stands before `=`
        self.bodies = {name: bodies_of(tokens) for name, tokens in files.items()}
        for name, tokens in files.items():
            for i in range(1, len(tokens) - 1):
                if tokens[i + 1] in ("(", "=") and is_name(tokens[i]):
                    places = self.calls if tokens[i + 1] == "(" else self.values
                    places.setdefault(str(tokens[i]), []).append((name, i))

    def messages(self):
        """(file, line, message); the message is None where it cannot be told."""
        for name, tokens in self.files.items():
            for i, token in enumerate(tokens):
                found = self.messages_at(tokens, i)
                if found is not None:
                    for message in sorted(set(map(tidy, found)) - {VARIABLE}) or [None]:
                        yield name, token.line, message

    def messages_at(self, tokens, i):
        """What the word at i begins to say; None if it says nothing."""
        if tokens[i] == "throw":
            opening = i + 1
            while opening < len(tokens) and tokens[opening] not in ("(", "{", ";", ")"):
                opening += 1
            if tokens[opening] not in ("(", "{") or tokens[opening - 1] in SILENT:
                return None
            inside = tokens[opening + 1:closing(tokens, opening)]
            if not inside:
                return self.constructed(tokens[opening - 1])
            return self.read(split(inside, (",",))[0], tokens, i)
        if tokens[i] in MACROS and tokens[i + 1] == "(":
            inside = tokens[i + 2:closing(tokens, i + 1)]
            if tokens[i] == "vtkErrorWithObjectMacro":
                inside = inside[len(split(inside, (",",))[0]) + 1:]
            return self.read(inside, tokens, i)
        if tokens[i] == "cerr" and tokens[i + 1] == "<<":
            found = self.read(tokens[i + 2:end_of_statement(tokens, i)], tokens, i)
            found = [re.sub("^crossfield: ", "", message) for message in found]
            # What only passes on a sentence of others begins with it.
            return [m for m in found if not m.startswith((VARIABLE, "Warning: " + VARIABLE))] or None
        return None

    def constructed(self, kind):
        """What an exception of a class says whose constructor has no arguments."""
        for tokens in self.files.values():
            for i in range(len(tokens) - 4):
                if tokens[i:i + 4] == [kind, "(", ")", ":"]:
                    opening = next(j for j in range(i + 4, len(tokens)) if tokens[j] == "(")
                    return self.read(tokens[opening + 1:closing(tokens, opening)], tokens, i)
        return []

    def read(self, expression, tokens, place, depth=0):
        """The messages that an expression can make that stands at `place` of a file."""
        while expression[:1] in (["<<"], ["return"]):
            expression = expression[1:]
        two = branches(expression)
        if two:
            return [m for part in two for m in self.read(part, tokens, place, depth)]
        # What a message is known by is its beginning: only there it matters what a name stands for.
        choices = [self.operand(part, tokens, place, depth if i == 0 else DEEPEST)
                   for i, part in enumerate(split(expression, ("+", "<<")))]
        return list(map("".join, itertools.product(*choices)))

    def operand(self, part, tokens, place, depth):
        if part and all(t.text is not None for t in part):
            return ["".join(t.text for t in part) or VARIABLE]  # "" is one of several values
        for wrapping in (["("], ["std", "::", "string", "("], ["std", "::", "move", "("]):
            begin = len(wrapping)
            if part[:begin] == wrapping and closing(part, begin - 1) == len(part) - 1:
                inside = split(part[begin:-1], (",",))[0]
                return self.read(inside, tokens, place, depth)
        return (self.looked_up(part, tokens, place, depth + 1) if depth < DEEPEST else []) or [VARIABLE]

    def looked_up(self, part, tokens, place, depth):
        """What a name or a call stands for; nothing where that is known at run time only."""
        if not part or not is_name(part[0]):
            return []
        if part[-4:] == [".", "str", "(", ")"] or len(part) == 1:
            found = self.filled(part[0], tokens, place, depth)
            found = found or self.given(part[0], tokens, place, depth)
            return found or self.constant(part[0], depth)
        if len(part) == 3 and part[1] == "::":
            return self.constant(part[2], depth)
        if len(part) == 3 and part[1] == "." and depth == 1:
            return self.assigned(part[2], depth)
        if part[-1] == ")" and closing(part, part.index("(")) == len(part) - 1:
            return self.returned(part[part.index("(") - 1], depth)
        return []

    def filled(self, name, tokens, place, depth):
        """What the variable holds that is filled before `place` in the same function."""
        first = self.body_around(tokens, place)[0]
        begin = place
        while begin > first and not (tokens[begin] == name and
                                     tokens[begin - 1] in ("ostringstream", "string")):
            begin -= 1
        if begin == first:
            return []
        choices = []
        i = begin
        while i < place:
            if tokens[i] == name and tokens[i + 1] in ("<<", "=", "+=", "(", "{"):
                end = end_of_statement(tokens, i + 1)
                if tokens[i + 1] in ("(", "{"):
                    end = closing(tokens, i + 1)
                if closing(["{"] + tokens[i:place], 0) > place - i:  # no block ended in between
                    choices.append(
                        self.read(tokens[i + 2:end], tokens, i, DEEPEST if choices else depth))
                elif choices:
                    choices.append([VARIABLE])  # in an alternative that may have run before
                i = end
            i += 1
        return [m for m in map("".join, itertools.product(*choices)) if m.strip(VARIABLE)]

    def body_around(self, tokens, place):
        """Where the function around `place` begins, its name and its parameters that are text."""
        bodies = next(b for name, b in self.bodies.items() if self.files[name] is tokens)
        for begin, end, closed in bodies:
            if begin < place < end:
                opening, level = closed, 1
                while level > 0:
                    opening -= 1
                    level += (tokens[opening] in CLOSING) - (tokens[opening] in OPENING)
                names = []
                for parameter in split(tokens[opening + 1:closed], (",",)):
                    words = [t for t in split(parameter, ("=",))[0] if is_name(t)]
                    names.append(words[-1] if {"string", "char"} & set(words) else "")
                return begin, tokens[opening - 1], names
        return place, None, []

    def given(self, name, tokens, place, depth):
        """What the callers give for a parameter of the function around `place`."""
        _, function, names = self.body_around(tokens, place)
        if name not in names:
            return []
        found = []
        for file, i in self.calls.get(str(function), []):
            caller = self.files[file]
            arguments = split(caller[i + 2:closing(caller, i + 1)], (",",))
            following = caller[closing(caller, i + 1) + 1:][:1]
            if len(arguments) <= names.index(name) or following in (["{"], ["const"]):
                continue
            argument = arguments[names.index(name)]
            if len(argument) > 1 and argument[:2] in (["const", "std"], ["const", "char"]):
                continue  # the declaration
            found.extend(self.read(argument, caller, i, depth))
        return found

    def constant(self, name, depth):
        """The text of a constant."""
        return self.equal(name, ("const", "*", "char", "string"), depth)

    def assigned(self, member, depth):
        """What is assigned to members of this name anywhere."""
        return self.equal(member, (".",), depth)

    def equal(self, name, before, depth):
        found = []
        for file, i in self.values.get(str(name), []):
            tokens = self.files[file]
            if tokens[i - 1] in before:
                value = tokens[i + 2:end_of_statement(tokens, i + 2)]
                found.extend(self.read(value, tokens, i, depth))
        return [message for message in found if message.strip(VARIABLE)]

    def returned(self, name, depth):
        """What a function returns."""
        found = []
        for file, i in self.calls.get(str(name), []):
            tokens = self.files[file]
            body = closing(tokens, i + 1) + 1
            kind = i - 1
            while tokens[kind] == "::":
                kind -= 2  # the class or namespace that it belongs to
            if tokens[kind] != "string" or tokens[body:body + 1] != ["{"]:
                continue
            for j in range(body, closing(tokens, body)):
                if tokens[j] == "return":
                    found.extend(self.read(tokens[j + 1:end_of_statement(tokens, j)], tokens, j, depth))
        return [message for message in found if message.strip(VARIABLE)]


def python_text(node):
    """The message that an expression of Python makes."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.JoinedStr):
        return "".join(python_text(value) for value in node.values)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mod):
        return re.sub(r"%%", "%", re.sub(r"%(?!%)[-+ #0-9.]*[a-z]", VARIABLE, python_text(node.left)))
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return python_text(node.left) + python_text(node.right)
    return VARIABLE


def python_messages(name, source):
    """(file, line, message) of what a Python file raises."""
    # What CMake fills in is a word like others.
    tree = ast.parse(re.sub(r"@(\w+)@", r"\1", source), name)
    for node in ast.walk(tree):
        if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
            message = tidy(python_text(node.exc.args[0])) if node.exc.args else None
            yield name, node.lineno, None if message == VARIABLE else message


def of_sources(sources):
    """(file, line, message) of files, whose text is given by their names."""
    cpp = {name: tokens_of(text) for name, text in sources.items() if name.endswith((".cxx", ".h"))}
    found = list(Cpp(cpp).messages())
    for name, text in sources.items():
        if name.endswith((".py", ".py.in")):
            found.extend(python_messages(name, text))
    return found


def read_sources(root, folders, left_out=()):
    """The text of all C++ and Python files in the folders, by their names relative to `root`."""
    sources = {}
    for folder in folders:
        for place, inside, names in os.walk(os.path.join(root, folder)):
            inside[:] = sorted(name for name in inside if name not in left_out)
            for name in sorted(names):
                if name.endswith((".cxx", ".h", ".py", ".py.in")):
                    path = os.path.join(place, name)
                    with open(path, encoding="utf-8") as file:
                        sources[os.path.relpath(path, root)] = file.read()
    return sources
