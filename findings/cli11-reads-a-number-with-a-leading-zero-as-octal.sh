#!/usr/bin/env bash
# Package: libcli11-dev 2.1.2+ds-1 (Debian 12).
# Behaviour: an option bound to an int takes 010 as 8 and refuses 08; one bound to a double takes 010 as 10. Nothing in the
# help or the call says so.
# Expected: decimal digits: what a person types at a command line, and what the same text means for the double.
# Why it matters: a seed, a pot's number or a height of 010 from a list with filled-up digits is another one, without a
# word; only an 8 or a 9 shows it. Take the text, and read it in base ten.
# Seen:
#   int: 010 is 8, 08 is refused; double: 010 is 10
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download libcli11-dev=2.1.2+ds-1
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >number.cpp <<'CODE'
#include <CLI/CLI.hpp>
#include <cstdio>
template <typename T>
void show(const char* text) {
    T number{};
    CLI::App app;
    app.add_option("--number", number);
    try {
        app.parse(std::vector<std::string>{text, "--number"});  // Last first.
        std::printf("%s is %g", text, static_cast<double>(number));
    } catch (const CLI::ParseError&) {
        std::printf("%s is refused", text);
    }
}
int main() {
    std::printf("int: ");
    show<int>("010");
    std::printf(", ");
    show<int>("08");
    std::printf("; double: ");
    show<double>("010");
}
CODE
g++ -std=c++17 -w -Iusr/include number.cpp -o number
saw=$(./number)
echo "saw: $saw"
[ "$saw" = "int: 010 is 8, 08 is refused; double: 010 is 10" ]
