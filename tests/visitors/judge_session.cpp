// Prints on one line whether a session's pot is worth keeping: judge_session SESSION.onggi. Exit code 0: yes;
// 1: no, with the reason; 2: no such session.
#include <fmt/format.h>

#include <cstdio>

#include "tests/visitors/judge.h"

int main(int argc, char** argv) {
    using namespace onggi;
    if (argc != 2) {
        std::fputs("judge_session: expected one session\n", stderr);
        return 2;
    }
    const auto verdict = visitors::judge_session(argv[1]);
    if (!verdict) {
        std::fprintf(stderr, "judge_session: %s\n", verdict.error().message.c_str());
        return 2;
    }
    const std::string said =
        verdict->is_pot ? fmt::format("a pot: {}\n", visitors::words_for(*verdict))
                        : fmt::format("no pot, it {}: {}\n", verdict->why_not, visitors::words_for(*verdict));
    std::fwrite(said.data(), 1, said.size(), stdout);
    return verdict->is_pot ? 0 : 1;
}
