// session_hashes SESSION...: replays each session and prints the hash of its last state, in 16 digits, and
// the file's name. Exit code 1 if a force or a state differs from the recording; the hash is printed all the
// same.
#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "game/app/replay/replay.h"
#include "game/app/replay/stored_session.h"

int main(int argc, char** argv) {
    using namespace onggi;
    if (argc < 2) {
        std::fputs("session_hashes: expected SESSION..., found none\n", stderr);
        return 2;
    }
    int status = 0;
    for (int at = 1; at < argc; ++at) {
        const std::string file = argv[at];
        auto loaded = app::load_session(file);
        if (!loaded) {
            fmt::print(stderr, "{}\n", loaded.error().message);
            return 2;
        }
        app::Replay replay(loaded->session, std::move(loaded->start));
        std::optional<app::Difference> first = replay.compare_start();
        while (!replay.is_over())
            if (auto difference = replay.step(); difference && !first) first = std::move(difference);
        fmt::print("{:016x} {}\n", replay.state().hash(), file);
        if (!first) continue;
        fmt::print(stderr, "{}: {}\n", file, app::sentence_for(*first));
        status = 1;
    }
    return status;
}
