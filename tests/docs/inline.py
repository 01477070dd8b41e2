"""Commands within the sentences of a document: their options must exist."""

import functools
import os
import re
import subprocess

PROGRAMS = {"burnish": "BURNISH_BINARY", "burnish-server": "BURNISH_SERVER_BINARY"}
BLOCK = re.compile(r"^ *```.*?^ *```", re.M | re.S)
COMMAND = re.compile(r"`(burnish|burnish-server) ([^`]+)`")


@functools.lru_cache(None)
def help_of(program, *words):
    return subprocess.run([os.environ[PROGRAMS[program]], *words, "--help"], check=True,
                          capture_output=True, text=True).stdout


def command_of(program, words):
    """Returns the names of the command and of those in it with which these words begin."""
    found = []
    for word in words:
        if not re.search(rf"^  {re.escape(word)}  ", help_of(program, *found), re.M):
            break
        found.append(word)
    return found or (["window"] if program == "burnish" else [])


def faults_in(text):
    """Returns what is wrong with the commands in the sentences of a page."""
    faults = []
    for program, rest in COMMAND.findall(BLOCK.sub("", text)):
        known = help_of(program, *command_of(program, rest.split()))
        top = help_of(program)
        for option in re.findall(r"(?<!\S)--[a-z][a-z-]*", rest):
            if not re.search(rf"{option}(?![\w-])", known + top):
                faults.append(f"`{program} {rest}`: no option {option}")
    return faults
