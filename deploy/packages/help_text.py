"""What a program says of itself with --help."""

import re
import subprocess


def help_of(*words):
    """Returns the help of a program or of one of its commands."""
    done = subprocess.run([*words, "--help"], check=True, capture_output=True, text=True)
    return done.stdout


def sections_of(text):
    """Returns {heading: lines} of a help; the lines before the first heading under ""."""
    found, heading = {"": []}, ""
    for line in text.splitlines():
        if re.fullmatch(r"[A-Z][A-Za-z ]*:", line):
            heading = line[:-1]
            found[heading] = []
        else:
            found[heading].append(line)
    return found


def commands_of(text):
    """Returns [(name, what it does)] of the commands that a help lists."""
    lines = sections_of(text).get("Subcommands", [])
    return [tuple(match.groups()) for match in (re.match(r"  (\S+)\s+(.*)", line) for line in lines)
            if match]


def options_of(text):
    """Returns the options that a help lists, in its order."""
    lines = sections_of(text).get("Options", [])
    return [name for line in lines if re.match(r"  -", line)
            for name in re.match(r"  ([^ ]+)", line)[1].split(",")]
