#!/usr/bin/env bash
# Package: libtinygltf-dev, libtinygltf2d 2.7.0+dfsg-2 (Debian 12).
# Behaviour: in extras an empty list and an empty object are written as null; a list of one number, an empty
# text and false stay as they are. Read back, the value is of no kind, and a second write drops the field.
# Expected: [] and {}, which JSON has and which the library's own Value tells apart.
# Why it matters: a reader that walks a model's list of marks, colours or links fails at null on the one model that has
# none; a program that opens and saves files changes others' fields. Leave empty fields out.
# Seen:
#   list null, object null, list of one [1.0], text "", written again: list absent
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=2.7.0+dfsg-2
apt-get -qq -o APT::Sandbox::User=root download "libtinygltf-dev=$version" "libtinygltf2d=$version"
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >write.cpp <<'CODE'
#include <fstream>
#include <sstream>
#include <string>
#include <tiny_gltf.h>
int main() {
    using tinygltf::Value;
    tinygltf::Model model;
    model.asset.version = "2.0";
    model.asset.extras = Value(Value::Object{{"list", Value(Value::Array())},
                                             {"object", Value(Value::Object())},
                                             {"one", Value(Value::Array{Value(1.0)})},
                                             {"text", Value(std::string())}});
    tinygltf::TinyGLTF gltf;
    std::ofstream first("first.gltf");
    if (!gltf.WriteGltfSceneToStream(&model, first, true, false)) return 2;
    first.close();
    tinygltf::Model again;
    std::string error, warning;
    if (!gltf.LoadASCIIFromFile(&again, &error, &warning, "first.gltf")) return 3;
    std::ofstream second("second.gltf");
    return gltf.WriteGltfSceneToStream(&again, second, true, false) ? 0 : 4;
}
CODE
libraries=$(dirname "$(find . -name 'libtinygltf.so*' | head -1)")
g++ -std=c++17 -w -Iusr/include write.cpp -o write -L"$libraries" -ltinygltf
LD_LIBRARY_PATH=$libraries ./write
cat >look.py <<'CODE'
import json
first, second = [json.load(open(name))["asset"]["extras"] for name in ("first.gltf", "second.gltf")]
said = {name: json.dumps(value) for name, value in first.items()}
print(f"list {said['list']}, object {said['object']}, list of one {said['one']}, text {said['text']}, written again: list "
      + (json.dumps(second["list"]) if "list" in second else "absent"))
CODE
saw=$(python3 look.py)
echo "saw: $saw"
[ "$saw" = 'list null, object null, list of one [1.0], text "", written again: list absent' ]
