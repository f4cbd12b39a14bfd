// An outbox with pots, served by `onggi share`, for a test.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <charconv>
#include <ctime>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "game/sharing/outbox.h"
#include "tests/cli/run_program.h"
#include "tests/support/comes_true.h"
#include "tests/support/shared_pot_samples.h"
#include "tests/support/temporary_folder.h"

namespace onggi::test {

// Ten hours from now by the machine's clock, which the program uses.
inline sharing::ShareTime from_now(std::int64_t stays_s = 36'000) {
    const std::int64_t now_s = std::time(nullptr);
    return {.now_s = now_s, .expires_s = now_s + stays_s};
}

// Waits until `onggi share` prints the port at which it listens, and returns it. 0: it ended before.
inline int port_said_by(RunningOnggi& server) {
    int port = 0;
    comes_true([&] {
        const std::string& said = server.printed();
        const std::size_t at = said.find("port ");
        if (at == std::string::npos || said.find('\n', at) == std::string::npos) return !server.at_work();
        std::from_chars(said.data() + at + 5, said.data() + said.size(), port);
        return true;
    });
    EXPECT_NE(port, 0) << server.printed();
    return port;
}

class ServedOutbox {
  public:
    // Port 0: the system chooses one.
    explicit ServedOutbox(std::vector<std::string> more = {}, int port = 0)
        : outbox_(open()),
          server_(words(std::move(more), port)),
          port_(port_said_by(server_)) {}

    std::string put(const sharing::SharedPot& pot, const sharing::ShareTime& time = from_now()) {
        const auto code = outbox_.put(pot, time);
        EXPECT_TRUE(code) << code.error().message;
        return code ? code->text() : "";
    }
    sharing::Outbox& outbox() { return outbox_; }
    RunningOnggi& server() { return server_; }
    [[nodiscard]] int port() const { return port_; }
    [[nodiscard]] std::filesystem::path box() const { return folder_ / "box"; }
    [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

  private:
    sharing::Outbox open() {
        auto outbox =
            sharing::Outbox::open({.folder = folder_ / "box", .languages = support::three_languages()});
        EXPECT_TRUE(outbox) << outbox.error().message;
        return std::move(outbox).value();
    }
    std::vector<std::string> words(std::vector<std::string> more, int port) const {
        std::vector<std::string> all{"share",     "--outbox", (folder_ / "box").string(), "--listen",
                                     "127.0.0.1", "--port",   std::to_string(port)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    TemporaryFolder folder_;
    sharing::Outbox outbox_;
    RunningOnggi server_;
    int port_;
};

}  // namespace onggi::test
