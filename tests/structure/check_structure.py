"""Prints every breach of the project's structure as FILE:LINE: MESSAGE; exit code 1 if there is one.

check_structure.py ROOT
"""

import sys

from structure_rules import Tree, problems


def main():
    found = problems(Tree(sys.argv[1]))
    for problem in found:
        print(problem)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
