"""The blocks of code in a document, and the comments before them that readers do not see.

    <!-- not run: REASON -->    the block cannot run in a test
    <!-- file: NAME -->         the block is the content of this file
    <!-- before: COMMANDS -->   runs first; what a reader has by other means
"""

import dataclasses
import re

RUNS = ("sh", "python")
TEXT = ("text", "toml")
MARK = re.compile(r"<!-- (not run|file|before): (.*?)\s*-->", re.S)


@dataclasses.dataclass
class Block:
    """A block of code: where it is, what it has, and its marks."""

    page: str
    line: int
    language: str
    text: str
    marks: dict

    @property
    def place(self):
        return f"{self.page}:{self.line}"

    @property
    def runs(self):
        return self.language in RUNS and "not run" not in self.marks and "file" not in self.marks


def marks_before(lines):
    """Returns {kind: text} of the comments that end the lines, blank lines aside."""
    found, text = {}, "\n".join(lines).rstrip()
    while text.endswith("-->"):
        begin = text.rindex("<!--")
        mark = MARK.fullmatch(text[begin:])
        if not mark:
            break
        found[mark[1]] = mark[2]
        text = text[:begin].rstrip()
    return found


def blocks_of(page, text):
    """Returns the blocks of a document. A block may stand in a list, with an indentation."""
    found, lines, begin = [], text.splitlines(), None
    for number, line in enumerate(lines):
        fence = re.fullmatch(r"( *)```(\w*)", line)
        if not fence:
            continue
        if begin is None:
            begin, indent, language = number, len(fence[1]), fence[2]
            continue
        body = "".join(inner[indent:] + "\n" for inner in lines[begin + 1:number])
        found.append(Block(page, begin + 1, language, body, marks_before(lines[:begin])))
        begin = None
    if begin is not None:
        raise ValueError(f"{page}:{begin + 1}: the block does not end")
    return found


def faults_of(block):
    """Returns what is wrong with a block itself, or None."""
    if block.language not in RUNS + TEXT:
        return f"'{block.language}' is not one of {', '.join(RUNS + TEXT)}"
    for kind, words in block.marks.items():
        if not words.strip():
            return f"'{kind}' is empty"
    if "not run" in block.marks and block.language not in RUNS:
        return f"a block of {block.language} does not run, so it needs no reason"
    return None
