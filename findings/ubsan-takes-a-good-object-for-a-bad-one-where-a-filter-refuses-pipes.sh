#!/usr/bin/env bash
# Package: g++ 12.2.0-14+deb12u1 with its libubsan1, libseccomp2 and libseccomp-dev 2.5.4-1+deb12u1 (Debian 12); clang 14's
# runtime does the same.
# Behaviour: under a seccomp filter that refuses pipe() and pipe2() and nothing else, -fsanitize=vptr reports each virtual
# call of a sound object as one "which does not point to an object of type": it tests whether memory can be read by writing
# it into a pipe, and takes the refused pipe for memory that cannot be read. Without the filter it reports nothing.
# Expected: no report, or one that the check itself could not run; a check of a pointer needs no system call.
# Why it matters: a server that confines itself passes its tests, and under the sanitizer ends at its first virtual call with
# a report of damaged memory, which somebody then looks for. Let the sanitized build have pipes.
# Seen:
#   without a filter: port 8081, 0 reports; without pipes: port 8081, reports yes
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download libseccomp2=2.5.4-1+deb12u1 libseccomp-dev=2.5.4-1+deb12u1
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >server.cpp <<'CODE'
#include <cstdio>
#include <initializer_list>
#include <memory>
#include <seccomp.h>
struct Server {
    virtual ~Server() = default;
    virtual int port() const { return 8080; }
};
struct QuietServer : Server {
    int port() const override { return 8081; }
};
int main(int count, char**) {
    const std::unique_ptr<Server> server = std::make_unique<QuietServer>();
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    for (const int call : {SCMP_SYS(pipe), SCMP_SYS(pipe2)})
        if (count > 1) seccomp_rule_add(filter, SCMP_ACT_ERRNO(1), call, 0);
    if (seccomp_load(filter) != 0) return 2;
    std::printf("port %d\n", server->port());
}
CODE
g++ -std=c++17 -O1 -fsanitize=vptr -Iusr/include server.cpp -o server usr/lib/x86_64-linux-gnu/libseccomp.so.2
export LD_LIBRARY_PATH=$PWD/usr/lib/x86_64-linux-gnu
reports() { grep -c "does not point to an object of type 'Server'" "$1" || true; }
free=$(./server 2>free.txt)
confined=$(./server confined 2>confined.txt)
saw="without a filter: $free, $(reports free.txt) reports; without pipes: $confined, reports $([ "$(reports confined.txt)" -gt 0 ] && echo yes || echo no)"
echo "saw: $saw"
[ "$saw" = "without a filter: port 8081, 0 reports; without pipes: port 8081, reports yes" ]
