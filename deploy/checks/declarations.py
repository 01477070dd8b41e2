"""Reads which names a C++ header declares. Reads text, not C++: enough for this tree's style."""

import re

# Raw strings, comments, strings, and characters. A quote after a digit separates digits.
NOISE = re.compile(r'R"(\w*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"'
                   r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'", re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
MACRO = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)", re.MULTILINE)
# A macro that stands for declarations has no semicolon.
MACRO_CALL = re.compile(r"^[A-Z][A-Z_]+\([^()]*\)$", re.MULTILINE)
TOKEN = re.compile(r"[A-Za-z_]\w*|::|->|\S")
TYPE_KEYS = ("class", "struct", "union", "enum")


def without_noise(text):
    return NOISE.sub(lambda match: " " if match[0][0] == "/" else '""', text)


def is_name(token):
    return token[0].isalpha() or token[0] == "_"


def after_template_head(tokens):
    """Drops leading `template <...>`, for its parameters are not declared names."""
    while tokens[:1] == ["template"]:
        depth = 0
        for place, token in enumerate(tokens):
            depth += (token == "<") - (token == ">")
            if place > 1 and depth == 0:
                break
        tokens = tokens[place + 1:]
    return tokens


def declared_type(tokens):
    """The name of `struct [[attribute]] NAME ...`, or None."""
    depth = 0
    last = None
    for token in tokens:
        depth += (token in "([") - (token in ")]")
        if depth == 0 and token in (":", "final"):
            break
        if depth == 0 and is_name(token) and token not in TYPE_KEYS:
            last = token
    return last


def declared_name(tokens):
    """The name that one declaration without its body introduces, or None."""
    tokens = after_template_head(tokens)
    if not tokens or tokens[0] in ("friend", "static_assert"):
        return None
    if tokens[0] in TYPE_KEYS and len(tokens) <= 3:
        return None  # a forward declaration
    if tokens[0] == "using" and tokens[1:2] != ["namespace"]:
        return tokens[1] if "=" in tokens else tokens[-1]
    if tokens[0] == "concept":
        return tokens[1]
    if "operator" in tokens:
        return "operator"
    last = None
    for token in tokens:
        if token in ("(", "=", "[", ":") and last:
            return last
        if is_name(token) and token not in ("alignas", "decltype", "__launch_bounds__"):
            last = token
    return last


class Declarations:
    """The names that a header declares: `outer` at namespace scope, `members` of its types."""

    def __init__(self, text):
        text = without_noise(text)
        self.outer = set(MACRO.findall(text))
        self.members = set()
        self._tokens = iter(TOKEN.findall(MACRO_CALL.sub("", DIRECTIVE.sub("", text))))
        self._scope(self.outer)
        self.outer.discard(None)
        self.members.discard(None)

    def _scope(self, names):
        """Reads declarations up to the brace that closes this scope."""
        statement = []
        for token in self._tokens:
            if token == "}":
                return
            if token == "{":
                statement = self._braces(statement, names)
            elif token == ";":
                names.add(declared_name(statement))
                statement = []
            elif token == ":" and statement in (["public"], ["private"], ["protected"]):
                statement = []
            else:
                statement.append(token)

    def _braces(self, statement, names):
        """Reads what stands in braces; returns what the statement goes on with."""
        head = after_template_head(statement)
        if "namespace" in head or head[:1] == ["extern"]:
            self._scope(names)
            return []
        if head and head[0] in TYPE_KEYS and head[-1] != ")":
            names.add(declared_type(head))
            if head[0] == "enum":
                self._enumerators(self.members if head[1:2] == ["class"] else names)
            else:
                self._scope(self.members)
            return ["}"]  # the `;` that follows declares nothing new
        if statement:
            names.add(declared_name(statement))
        self._skip()
        return [] if ")" in statement else statement

    def _enumerators(self, names):
        depth, is_first = 1, True
        for token in self._tokens:
            depth += (token in "({") - (token in ")}")
            if depth == 0:
                return
            if is_first and is_name(token):
                names.add(token)
            is_first = token == "," and depth == 1

    def _skip(self):
        depth = 1
        for token in self._tokens:
            depth += (token == "{") - (token == "}")
            if depth == 0:
                return
