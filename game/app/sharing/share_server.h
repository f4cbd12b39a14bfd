// Serves the outbox to phones over HTTP/1.1 (libmicrohttpd): no cookies, no log, no listing.
// game/sharing/request_head.h decides which heads the library may read, and share_request.h determines the
// answers. One thread, the one that calls run().
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <memory>

#include "engine/core/result.h"
#include "game/sharing/share_limits.h"

namespace onggi::app {

// The deadline of each connection. A client that sends its request or takes its file byte by byte is cut off,
// sooner if there are many connections. The caller passes the time. One thread at a time.
struct DeadlineRules {
    double head_s = 10.0;         // for a whole request header, and for silence
    double crowded_head_s = 1.0;  // the same in a crowd
    std::size_t crowd = 384;      // connections that make a crowd
    // Limits of the connections without a whole request, and of those with an answer. A new one beyond them
    // replaces the oldest, but no answer younger than slow_answer_s, so that open headers and slow readers
    // cannot lock out other phones, at the same address or another.
    std::size_t most_an_address = 96;
    std::size_t most = 448;
    double slow_answer_s = 5.0;
    double answer_s = 20.0;         // time for an answer, plus
    double bytes_per_s = 16'384.0;  // its transfer time at this rate
    double refusal_s = 2.0;         // for a refusal, until the client closes
};

class Deadlines {
  public:
    struct Connection {
        int socket = -1;
        sharing::AddressKey address{};
        double since_s = 0.0;  // start of the present state
        double until_s = 0.0;
        bool is_answered = false;  // the answer is being sent
        bool is_cut = false;
    };
    using Handle = std::list<Connection>::iterator;

    explicit Deadlines(const DeadlineRules& rules = {}) : rules_(rules) {}

    // Calls cut(socket) for each connection that is replaced.
    template <typename Cut>
    [[nodiscard]] Handle add(int socket, const sharing::AddressKey& address, double now_s, Cut cut) {
        const auto has_address = [&](const Connection& other) { return other.address == address; };
        const auto any = [](const Connection&) { return true; };
        make_room(false, has_address, rules_.most_an_address, now_s, cut);
        make_room(false, any, rules_.most, now_s, cut);
        make_room(true, has_address, rules_.most_an_address, now_s, cut);
        const Handle added =
            connections_.insert(connections_.end(), Connection{.socket = socket, .address = address});
        has_answered(added, now_s);
        return added;
    }
    void answers(Handle connection, double now_s, std::uint64_t bytes) const {
        connection->since_s = now_s;
        connection->until_s = now_s + rules_.answer_s + static_cast<double>(bytes) / rules_.bytes_per_s;
        connection->is_answered = true;
    }
    void refuses(Handle connection, double now_s) const {
        connection->until_s = now_s + rules_.refusal_s;
        connection->is_answered = true;
    }
    // The connection may send its next request.
    void has_answered(Handle connection, double now_s) const {
        connection->since_s = now_s;
        connection->until_s = now_s + rules_.head_s;
        connection->is_answered = false;
    }
    void remove(Handle connection) { connections_.erase(connection); }
    [[nodiscard]] std::size_t size() const { return connections_.size(); }

    // Calls cut(socket) for the oldest slow answer: a newcomer finds no place.
    template <typename Cut>
    void end_a_slow_answer(double now_s, Cut cut) {
        const auto any = [](const Connection&) { return true; };
        make_room(true, any, 0, now_s, cut);
    }

    // Calls cut(socket) once for each connection past its deadline.
    template <typename Cut>
    void sweep(double now_s, Cut cut) {
        const bool is_crowded = connections_.size() >= rules_.crowd;
        for (Connection& connection : connections_) {
            if (connection.is_cut) continue;
            const bool is_in_the_way = is_crowded && now_s >= connection.since_s + rules_.crowded_head_s;
            if (now_s < connection.until_s && (connection.is_answered || !is_in_the_way)) continue;
            connection.is_cut = true;
            cut(connection.socket);
        }
    }

  private:
    // Makes room for one more among the open heads, or among the answers, that `counts` accepts.
    template <typename Counts, typename Cut>
    void make_room(bool of_answers, Counts counts, std::size_t most, double now_s, Cut cut) {
        std::size_t found = 0;
        Connection* oldest = nullptr;
        for (Connection& connection : connections_) {
            if (connection.is_answered != of_answers || connection.is_cut || !counts(connection)) continue;
            ++found;
            if (oldest == nullptr || connection.since_s < oldest->since_s) oldest = &connection;
        }
        if (found < most || oldest == nullptr) return;
        if (of_answers && now_s < oldest->since_s + rules_.slow_answer_s) return;
        oldest->is_cut = true;
        cut(oldest->socket);
    }

    DeadlineRules rules_;
    std::list<Connection> connections_;
};

struct ShareServerOptions {
    int listening_socket = -1;  // from listen_at(); the server closes it
    std::filesystem::path outbox;
    std::filesystem::path counter;               // a pipe, or empty for no counting
    unsigned most_connections = 512;             // fewer if the system's file limit is lower
    unsigned most_connections_an_address = 128;  // a museum's whole Wi-Fi may share one
    sharing::RateRules rate = {};
    DeadlineRules deadlines = {};
    std::function<double()> now_s;         // never goes back
    std::function<std::int64_t()> wall_s;  // seconds since 1970, UTC
};

class ShareServer {
  public:
    // System lacks: no memory, no files. Precondition: SIGPIPE is ignored.
    [[nodiscard]] static Result<std::unique_ptr<ShareServer>> start(const ShareServerOptions& options);
    ShareServer(const ShareServer&) = delete;
    ShareServer& operator=(const ShareServer&) = delete;
    virtual ~ShareServer() = default;

    // Answers the pending requests, and waits up to `most_ms` for more; a signal ends the wait.
    virtual void run(int most_ms) = 0;
    [[nodiscard]] virtual std::size_t connections() const = 0;

  protected:
    ShareServer() = default;
};

}  // namespace onggi::app
