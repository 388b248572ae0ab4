"""Every deck can be read by any reader of XML: test_decks.py ROOT."""

import pathlib
import sys
import xml.etree.ElementTree

wrong, root = 0, pathlib.Path(sys.argv[1])
for deck in [*root.glob("decks/**/*.xml"), *root.glob("regression/**/*.xml"), *root.glob("docs/**/*.xml")]:
    try:
        xml.etree.ElementTree.parse(deck)
    except xml.etree.ElementTree.ParseError as error:
        wrong += 1
        print(f"{deck.relative_to(root)}: {error}")
sys.exit(1 if wrong else 0)
