#!/usr/bin/env bash
# Package: python3-meshio 7.0.0-3, whose program says 5.0.0 (Debian 12).
# Behaviour: a face of an OBJ may count its corners back from the last one, "f -3 -2 -1". meshio takes 1 from each number,
# as from one that counts from the front, and keeps -4 -3 -2; a PLY that it writes has these numbers in its faces.
# Expected: the corners that the file means, or a refusal: the form has been in the format's text from the first.
# Why it matters: exporters that write a pot part by part use it. Both triangles here name corners of the second, turned
# by one, so numpy takes them without a word; in the PLY they are no corners at all, and the exit code is 0.
# Seen:
#   faces 0 1 2 and 3 4 5 are read as -4 -3 -2 and -4 -3 -2; written: the same
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download python3-meshio=7.0.0-3 python3-numpy=1:1.24.2-1+deb12u1 \
    python3-rich=13.3.1-1 python3-pygments=2.14.0+dfsg-1 python3-commonmark=0.9.1-4
for package in *.deb; do dpkg-deb -x "$package" .; done
export PYTHONPATH=$folder/usr/lib/python3/dist-packages
printf 'v %s\n' '0 0 0' '1 0 0' '0 1 0' >part1.txt
printf 'v %s\n' '0 0 1' '1 0 1' '0 1 1' >part2.txt
{ cat part1.txt; echo 'f -3 -2 -1'; cat part2.txt; echo 'f -3 -2 -1'; } >pot.obj
cat >read.py <<'CODE'
import meshio
mesh = meshio.read("pot.obj")
mesh.write("pot.ply", binary=False)
def text(faces):
    return " and ".join(" ".join(str(corner) for corner in face) for face in faces)
read = text(mesh.cells[0].data)
written = text(line.split()[1:] for line in open("pot.ply").read().splitlines()[-2:])
print(f"faces 0 1 2 and 3 4 5 are read as {read}; written: {'the same' if written == read else written}")
CODE
saw=$(/usr/bin/python3 -W ignore read.py 2>/dev/null | grep faces)
echo "saw: $saw"
[ "$saw" = "faces 0 1 2 and 3 4 5 are read as -4 -3 -2 and -4 -3 -2; written: the same" ]
