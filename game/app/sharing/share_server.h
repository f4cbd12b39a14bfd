// Serves the outbox to phones over HTTP/1.1 (libmicrohttpd): no cookies, no log, no listing. What a request
// means is decided in game/sharing/share_request.h. One thread, whoever calls run().
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

#include "engine/core/result.h"
#include "game/app/sharing/deadlines.h"
#include "game/sharing/share_limits.h"

namespace onggi::app {

struct ShareServerOptions {
    int listening_socket = -1;  // of listen_at(); closed by the server
    std::filesystem::path outbox;
    std::filesystem::path counter;               // a pipe, or empty: nothing is counted
    unsigned most_connections = 512;             // fewer where the system grants fewer files
    unsigned most_connections_an_address = 128;  // a museum's whole Wi-Fi may stand behind one
    sharing::RateRules rate = {};
    DeadlineRules deadlines = {};
    std::function<double()> now_s;         // never goes back
    std::function<std::int64_t()> wall_s;  // seconds since 1970, UTC
};

class ShareServer {
  public:
    // System lacks: no memory, no files. SIGPIPE must be ignored by then.
    [[nodiscard]] static Result<std::unique_ptr<ShareServer>> start(const ShareServerOptions& options);
    ShareServer(const ShareServer&) = delete;
    ShareServer& operator=(const ShareServer&) = delete;
    virtual ~ShareServer() = default;

    // Answers what there is to answer, and waits at most so long for more; a signal ends it sooner.
    virtual void run(int most_ms) = 0;
    [[nodiscard]] virtual std::size_t connections() const = 0;

  protected:
    ShareServer() = default;
};

}  // namespace onggi::app
