"""The command ``gearlash``: the program of the binary, in this process."""

import sys

from gearlash import _core


def main() -> int:
    """Run the command line of this process and return its exit code: 0 done, 1 a check failed, 2 bad input."""
    return _core.run(["gearlash", *sys.argv[1:]])
