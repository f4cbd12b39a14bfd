#!/usr/bin/env python3
"""make.py ONGGI [NAME ...]: throws the demonstrations with that program and leaves them here as sessions."""
import pathlib
import subprocess
import sys
import tempfile

import pots

HERE = pathlib.Path(__file__).resolve().parent


def throw(onggi, name, folder):
    demonstration = pots.ALL[name]
    gesture = folder / f"{name}.csv"
    gesture.write_text(demonstration.hands().table())
    words = [str(word) for word in demonstration.options]
    for option, session in demonstration.pots.items():
        words += [option, str(HERE / f"{session}.onggi")]
    # Half of the usual rate: the clay is the same within hundredths of a millimetre, the file half as large.
    subprocess.run([onggi, "throw", str(gesture), "--rate", "500", *words, "--save",
                    str(HERE / f"{name}.onggi")], check=True)


def main():
    if len(sys.argv) < 2:
        sys.exit("expected: make.py ONGGI [NAME ...], found no program")
    names = sys.argv[2:] or list(pots.ALL)
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            throw(sys.argv[1], name, pathlib.Path(folder))
            print(name)


if __name__ == "__main__":
    main()
