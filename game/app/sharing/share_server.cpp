#include "game/app/sharing/share_server.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <microhttpd.h>
#include <netinet/in.h>
#include <sys/epoll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <deque>
#include <list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "game/app/sharing/page_store.h"
#include "game/kiosk/strings.h"
#include "game/sharing/open_counter.h"
#include "game/sharing/page_files.h"
#include "game/sharing/phone_page.h"
#include "game/sharing/request_head.h"
#include "game/sharing/share_request.h"

namespace onggi::app {
namespace {

// The server's answers, each with its header fields.

// An answer that can be sent once or many times.
class Response {
  public:
    Response() = default;
    Response(MHD_Response* response, unsigned status, std::uint64_t bytes)
        : response_(response, &MHD_destroy_response),
          status_(status),
          bytes_(bytes) {}

    explicit operator bool() const { return response_ != nullptr; }
    [[nodiscard]] MHD_Response* get() const { return response_.get(); }
    [[nodiscard]] unsigned status() const { return status_; }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    void add(const char* name, const std::string& value) const {
        MHD_add_response_header(response_.get(), name, value.c_str());
    }

  private:
    std::shared_ptr<MHD_Response> response_;
    unsigned status_ = 0;
    std::uint64_t bytes_ = 0;
};

class Responses {
  public:
    Responses();

    // The file, or the bytes in `range`; `is_twin`: the file is the compressed one.
    [[nodiscard]] static Response of_file(OpenFile file, const sharing::PageFile& known,
                                          std::string_view range, bool is_twin);
    // Returns the prepared answer for requests of anything but a pot's file.
    [[nodiscard]] Response without_a_file(const sharing::ShareAnswer& answer,
                                          std::string_view accept_language) const;
    [[nodiscard]] Response lost(std::string_view accept_language) const;
    [[nodiscard]] Response too_many() const { return too_many_; }

  private:
    // One per language, in the order of kiosk::built_in_languages().
    std::vector<Response> lost_;
    std::vector<Response> ask_;
    Response script_;
    Response robots_;
    Response nothing_;
    Response not_allowed_;
    Response bad_request_;
    Response too_long_;
    Response too_many_;
};

constexpr const char* kHtml = "text/html; charset=utf-8";
constexpr const char* kText = "text/plain; charset=utf-8";

// Forbids caching, content sniffing and referrers.
void add_manners(const Response& response, const std::string& media_type, std::string_view policy) {
    if (!media_type.empty()) response.add(MHD_HTTP_HEADER_CONTENT_TYPE, media_type);
    response.add(MHD_HTTP_HEADER_CACHE_CONTROL, "no-store");
    response.add("X-Content-Type-Options", "nosniff");
    response.add("Referrer-Policy", "no-referrer");
    response.add("Content-Security-Policy", std::string(policy) + "; frame-ancestors 'none'");
}

Response of_text(const std::string& text, const char* media_type, unsigned status) {
    Response response(
        MHD_create_response_from_buffer(text.size(), const_cast<char*>(text.data()),  // NOLINT: copied
                                        MHD_RESPMEM_MUST_COPY),
        status, text.size());
    add_manners(response, media_type, sharing::kPlainPolicy);
    return response;
}

// The built-in language that a phone prefers, or English.
std::size_t language_of(std::string_view accept_language) {
    std::vector<std::string_view> codes;
    for (const kiosk::Language& language : kiosk::built_in_languages())
        codes.push_back(language.code());
    return sharing::liked_language(accept_language, codes).value_or(0);
}

Responses::Responses() {
    const auto& languages = kiosk::built_in_languages();
    // The phone's language and three others, so that the field to type in is not below the screen.
    constexpr std::size_t kOthers = 3;
    for (std::size_t place = 0; place < languages.size(); ++place) {
        std::vector<kiosk::Language> shown(languages.begin(), languages.begin() + kOthers);
        if (place >= kOthers) shown.insert(shown.begin(), languages[place]);
        const std::size_t first = place < kOthers ? place : 0;
        lost_.push_back(of_text(sharing::lost_page(shown, first), kHtml, MHD_HTTP_NOT_FOUND));
        ask_.push_back(of_text(sharing::ask_page(shown, first), kHtml, MHD_HTTP_OK));
        lost_.back().add(MHD_HTTP_HEADER_VARY, "Accept-Language");
        ask_.back().add(MHD_HTTP_HEADER_VARY, "Accept-Language");
    }
    script_ = of_text(std::string(sharing::ask_script()), "text/javascript; charset=utf-8", MHD_HTTP_OK);
    robots_ = of_text("User-agent: *\nDisallow: /\n", kText, MHD_HTTP_OK);
    nothing_ = of_text("", kText, MHD_HTTP_NO_CONTENT);
    not_allowed_ = of_text("", kText, MHD_HTTP_METHOD_NOT_ALLOWED);
    not_allowed_.add(MHD_HTTP_HEADER_ALLOW, "GET, HEAD");
    bad_request_ = of_text("", kText, MHD_HTTP_BAD_REQUEST);
    too_long_ = of_text("", kText, MHD_HTTP_URI_TOO_LONG);
    too_many_ = of_text("", kText, MHD_HTTP_TOO_MANY_REQUESTS);
    too_many_.add(MHD_HTTP_HEADER_RETRY_AFTER, "5");
    // These answers close the connection, to slow down a client that asks again.
    for (const Response* last : {&not_allowed_, &bad_request_, &too_long_, &too_many_})
        last->add(MHD_HTTP_HEADER_CONNECTION, "close");
}

Response Responses::of_file(OpenFile file, const sharing::PageFile& known, std::string_view range,
                            bool is_twin) {
    using Kind = sharing::ByteRange::Kind;
    const std::uint64_t size = file.size();
    const sharing::ByteRange part = sharing::resolve_range(range, size);
    if (part.kind == Kind::kBeyond) {
        Response beyond = of_text("", kText, MHD_HTTP_RANGE_NOT_SATISFIABLE);
        beyond.add(MHD_HTTP_HEADER_CONTENT_RANGE, fmt::format("bytes */{}", size));
        return beyond;
    }
    const int descriptor = file.release();
    Response response(MHD_create_response_from_fd_at_offset64(part.count, descriptor, part.first),
                      part.kind == Kind::kPart ? MHD_HTTP_PARTIAL_CONTENT : MHD_HTTP_OK, part.count);
    if (!response) {
        static_cast<void>(OpenFile(descriptor, size));  // closes it
        return {};
    }
    add_manners(response, std::string(known.media_type), sharing::kPagePolicy);
    response.add(MHD_HTTP_HEADER_ACCEPT_RANGES, "bytes");
    if (known.has_twin) response.add(MHD_HTTP_HEADER_VARY, "Accept-Encoding");
    if (is_twin) response.add(MHD_HTTP_HEADER_CONTENT_ENCODING, "gzip");
    if (part.kind == Kind::kPart) {
        response.add(MHD_HTTP_HEADER_CONTENT_RANGE,
                     fmt::format("bytes {}-{}/{}", part.first, part.first + part.count - 1, size));
    }
    return response;
}

Response Responses::lost(std::string_view accept_language) const {
    return lost_[language_of(accept_language)];
}

Response Responses::without_a_file(const sharing::ShareAnswer& answer,
                                   std::string_view accept_language) const {
    using Kind = sharing::ShareAnswer::Kind;
    switch (answer.kind) {
        case Kind::kAskForCode:
            return ask_[language_of(accept_language)];
        case Kind::kScript:
            return script_;
        case Kind::kRobots:
            return robots_;
        case Kind::kNothing:
            return nothing_;
        case Kind::kMoved: {
            Response moved = of_text("", kText, MHD_HTTP_SEE_OTHER);
            moved.add(MHD_HTTP_HEADER_LOCATION, answer.location);
            return moved;
        }
        case Kind::kNotAllowed:
            return not_allowed_;
        case Kind::kBadRequest:
            return bad_request_;
        case Kind::kTooLong:
            return too_long_;
        case Kind::kFile:
        case Kind::kNotFound:
            break;
    }
    return lost(accept_language);
}

using sharing::ShareAnswer;

// Memory per connection: a request's header and its answer's header must fit in here.
constexpr std::size_t kConnectionBytes = sharing::kMostHeadBytes;
// Of libmicrohttpd. The gate refuses what can be read in two ways; 1.0 at 1 also refuses what RFC 9112, 2.2
// and 3, let a server accept, 0.9.75 does not.
constexpr int kStrictness = MHD_VERSION < 0x01000000 ? 1 : 0;
constexpr unsigned kSilentS = 15;  // a fallback: the deadlines are shorter
constexpr double kSweepS = 0.25;

// A connection. The library reads from it only when the socket holds a whole head that sharing::read_head()
// accepts. Until then the head is inspected and stays in the socket (MSG_PEEK).
struct Client {
    enum class State {
        kHead,     // waits for a whole head
        kServed,   // the library reads and answers
        kRefused,  // has its refusal, and is heard until it closes (RFC 9112, 9.6)
    };
    int socket = -1;  // the library closes it, where `connection` is set
    sockaddr_storage address{};
    socklen_t address_size = 0;
    State state = State::kHead;
    Deadlines::Handle deadline{};
    MHD_Connection* connection = nullptr;  // null before its first whole head; suspended but in kServed
    // Method and target of each head that the library may take; several if the client sends ahead.
    std::deque<std::string> heads{};
    // Bytes after those heads that are not a whole head: the library may have read them, so the connection
    // is closed after the last answer.
    bool is_last = false;
};

// The parts of a head in which the library and the inspection must agree.
std::string line_of(std::string_view method, std::string_view target) {
    return fmt::format("{} {}", method, target);
}

sharing::AddressKey key_of(const sockaddr_storage& address) {
    std::uint8_t ipv4[4]{};
    std::uint8_t ipv6[16]{};
    if (address.ss_family == AF_INET6) {
        const auto* const found = reinterpret_cast<const sockaddr_in6*>(&address);
        std::memcpy(ipv6, &found->sin6_addr, sizeof ipv6);
        return sharing::key_of_ipv6(ipv6);
    }
    const auto* const found = reinterpret_cast<const sockaddr_in*>(&address);
    std::memcpy(ipv4, &found->sin_addr, sizeof ipv4);
    return sharing::key_of_ipv4(ipv4);
}

// Reads all received bytes from the socket. Returns false if the client has closed the connection.
bool drain(int socket) {
    std::array<char, 4096> bytes{};
    ssize_t got = 0;
    while ((got = ::recv(socket, bytes.data(), bytes.size(), MSG_DONTWAIT)) > 0) {
    }
    return got < 0 && (errno == EAGAIN || errno == EINTR);
}

std::string refusal(int status, std::int64_t wall_s) {
    return fmt::format(
        "HTTP/1.1 {} {}\r\nDate: {:%a, %d %b %Y %H:%M:%S} GMT\r\nContent-Length: 0\r\n"
        "Cache-Control: no-store\r\nConnection: close\r\n\r\n",
        status, MHD_get_reason_phrase_for(static_cast<unsigned>(status)), fmt::gmtime(wall_s));
}

std::string_view view_of(const char* text) {
    return text == nullptr ? std::string_view() : std::string_view(text);
}

std::string_view header(MHD_Connection* connection, const char* name) {
    return view_of(MHD_lookup_connection_value(connection, MHD_HEADER_KIND, name));
}

// Raises the limit of open files for `wanted` connections, each with one file to send. Returns the granted
// number of connections.
unsigned granted_connections(unsigned wanted) {
    constexpr rlim_t kOthers = 32;
    rlimit limit{};
    if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return wanted;
    const rlim_t needed = 2 * rlim_t{wanted} + kOthers;
    if (limit.rlim_cur < needed) {
        limit.rlim_cur = std::min(needed, limit.rlim_max);
        ::setrlimit(RLIMIT_NOFILE, &limit);
        ::getrlimit(RLIMIT_NOFILE, &limit);
    }
    const rlim_t room = limit.rlim_cur > kOthers ? (limit.rlim_cur - kOthers) / 2 : 1;
    return static_cast<unsigned>(std::min(rlim_t{wanted}, room));
}

class MicroServer final : public ShareServer {
  public:
    explicit MicroServer(const ShareServerOptions& options)
        : options_(options),
          store_(options.outbox),
          counter_(options.counter),
          limits_(options.rate),
          deadlines_(options.deadlines) {}
    ~MicroServer() override {
        // The library ends only when no connection is suspended.
        for (const Client& client : clients_)
            if (client.connection != nullptr && client.state != Client::State::kServed)
                MHD_resume_connection(client.connection);
        if (daemon_ != nullptr) MHD_stop_daemon(daemon_);  // forgets those that it closes
        for (const Client& client : clients_)
            ::close(client.socket);
        if (gate_ >= 0) ::close(gate_);
        ::close(options_.listening_socket);
    }

    bool start() {
        most_connections_ = granted_connections(options_.most_connections);
        daemon_ = MHD_start_daemon(
            MHD_USE_EPOLL | MHD_USE_NO_LISTEN_SOCKET | MHD_ALLOW_SUSPEND_RESUME, 0, nullptr, nullptr,
            &MicroServer::answer_to, this, MHD_OPTION_CONNECTION_LIMIT, most_connections_,
            MHD_OPTION_PER_IP_CONNECTION_LIMIT, options_.most_connections_an_address,
            MHD_OPTION_CONNECTION_TIMEOUT, kSilentS, MHD_OPTION_CONNECTION_MEMORY_LIMIT, kConnectionBytes,
            MHD_OPTION_STRICT_FOR_CLIENT, kStrictness, MHD_OPTION_SIGPIPE_HANDLED_BY_APP, 1,
            MHD_OPTION_UNESCAPE_CALLBACK, &MicroServer::leave_as_it_is, nullptr, MHD_OPTION_URI_LOG_CALLBACK,
            &MicroServer::note_target, this, MHD_OPTION_NOTIFY_CONNECTION, &MicroServer::connection_changed,
            this, MHD_OPTION_NOTIFY_COMPLETED, &MicroServer::request_done, this, MHD_OPTION_END);
        gate_ = ::epoll_create1(EPOLL_CLOEXEC);
        if (daemon_ == nullptr || gate_ < 0) return false;
        const auto* const info = MHD_get_daemon_info(daemon_, MHD_DAEMON_INFO_EPOLL_FD);
        return info != nullptr && watch(info->epoll_fd, EPOLLIN, nullptr) &&
               watch(options_.listening_socket, EPOLLIN | EPOLLET, this);
    }

    void run(int most_ms) override {
        constexpr MHD_UNSIGNED_LONG_LONG kLongMs = 1'000'000;
        MHD_UNSIGNED_LONG_LONG library_ms = 0;
        if (MHD_get_timeout(daemon_, &library_ms) == MHD_YES)
            most_ms = std::min(most_ms, static_cast<int>(std::min(library_ms, kLongMs)));
        std::array<epoll_event, 64> events{};
        const int count = ::epoll_wait(gate_, events.data(), static_cast<int>(events.size()), most_ms);
        for (int i = 0; i < count; ++i) {
            const epoll_event& event = events[static_cast<std::size_t>(i)];
            if (event.data.ptr == this)
                has_newcomers_ = true;
            else if (event.data.ptr != nullptr)
                look_at(*static_cast<Client*>(event.data.ptr), (event.events & (EPOLLRDHUP | EPOLLHUP)) != 0);
        }
        accept_new();
        run_library();
        const double now_s = options_.now_s();
        if (now_s < next_sweep_s_) return;
        next_sweep_s_ = now_s + kSweepS;
        deadlines_.sweep(now_s, &MicroServer::cut);
    }

    [[nodiscard]] std::size_t connections() const override { return deadlines_.size(); }

  private:
    struct Request {
        std::string target;  // as received
        bool is_known = false;
    };

    // The gate: connections without a whole head.

    // Wakes look_at(), which ends the connection.
    static void cut(int socket) { ::shutdown(socket, SHUT_RDWR); }

    [[nodiscard]] bool watch(int descriptor, std::uint32_t events, void* what) const {
        epoll_event event{.events = events, .data = {.ptr = what}};
        return ::epoll_ctl(gate_, EPOLL_CTL_ADD, descriptor, &event) == 0;
    }

    // The listening socket reports newcomers once; those that find no room wait in its queue.
    void accept_new() {
        while (has_newcomers_) {
            if (clients_.size() >= most_connections_)
                return deadlines_.end_a_slow_answer(options_.now_s(), &MicroServer::cut);
            Client client{.address_size = sizeof(sockaddr_storage)};
            client.socket = ::accept4(options_.listening_socket, reinterpret_cast<sockaddr*>(&client.address),
                                      &client.address_size, SOCK_NONBLOCK | SOCK_CLOEXEC);
            has_newcomers_ = client.socket >= 0;
            if (client.socket < 0) return;
            client.deadline =
                deadlines_.add(client.socket, key_of(client.address), options_.now_s(), &MicroServer::cut);
            clients_.push_back(std::move(client));
            if (!watch(clients_.back().socket, EPOLLIN | EPOLLRDHUP | EPOLLET, &clients_.back()))
                cut(clients_.back().socket);
            look_at(clients_.back(), false);
        }
    }

    // `has_closed`: the client sends nothing more.
    void look_at(Client& client, bool has_closed) {
        if (client.state == Client::State::kServed) return;
        if (client.state == Client::State::kRefused || client.deadline->is_cut) {
            if (!drain(client.socket) || client.deadline->is_cut) end(client);
            return;
        }
        std::array<char, sharing::kMostHeadBytes> bytes;  // NOLINT: 8 kB that recv() fills
        const ssize_t got = ::recv(client.socket, bytes.data(), bytes.size(), MSG_PEEK | MSG_DONTWAIT);
        if (got < 0 && (errno == EAGAIN || errno == EINTR)) return;
        // A TLS handshake (RFC 8446, 5.1): a browser that tries https first falls back to http when the
        // connection is closed.
        constexpr char kHandshake = 0x16;
        if (got <= 0 || bytes[0] == kHandshake) return end(client);
        std::string_view rest(bytes.data(), static_cast<std::size_t>(got));
        sharing::RequestHead head = sharing::read_head(rest);
        if (head.kind == sharing::RequestHead::Kind::kRefused) return refuse(client, head.status);
        if (head.kind == sharing::RequestHead::Kind::kIncomplete) {
            if (has_closed) end(client);
            return;
        }
        while (head.kind == sharing::RequestHead::Kind::kFine) {
            client.heads.push_back(line_of(head.method, head.target));
            rest.remove_prefix(head.bytes);
            head = sharing::read_head(rest);
        }
        client.is_last = !rest.empty();
        hand_over(client);
    }

    void hand_over(Client& client) {
        client.state = Client::State::kServed;
        deadlines_.answers(client.deadline, options_.now_s(), 0);  // no open head any more
        if (client.connection != nullptr) return MHD_resume_connection(client.connection);
        handed_over_.push_back(&client);
        const MHD_Result taken = MHD_add_connection(
            daemon_, client.socket, reinterpret_cast<const sockaddr*>(&client.address), client.address_size);
        if (taken != MHD_YES) forget(client);  // the library has closed it: too many of this address
    }

    void refuse(Client& client, int status) {
        drain(client.socket);
        const std::string text = refusal(status, options_.wall_s());
        // The send buffer of a new connection has room for it; a client that does not read misses the
        // refusal.
        static_cast<void>(::send(client.socket, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT));
        ::shutdown(client.socket, SHUT_WR);
        client.state = Client::State::kRefused;
        deadlines_.refuses(client.deadline, options_.now_s());
    }

    // The library sees only heads that were handed over.
    void end(Client& client) {
        drain(client.socket);
        if (client.connection != nullptr) {
            cut(client.socket);
            client.state = Client::State::kServed;
            MHD_resume_connection(client.connection);  // which finds it closed, and says so
            return;
        }
        ::close(client.socket);
        forget(client);
    }

    void forget(Client& client) {
        deadlines_.remove(client.deadline);
        std::erase(handed_over_, &client);
        std::erase(answered_, &client);
        clients_.remove_if([&](const Client& other) { return &other == &client; });
    }

    // The library: connections with a whole head.

    void run_library() {
        const bool has_new = !handed_over_.empty();
        MHD_run_wait(daemon_, 0);
        if (has_new) MHD_run_wait(daemon_, 0);  // the first turn only takes them in
        for (Client* const refused : std::exchange(handed_over_, {}))
            forget(*refused);
        for (Client* const client : std::exchange(answered_, {})) {
            MHD_suspend_connection(client->connection);
            client->state = Client::State::kHead;
            look_at(*client, false);
        }
    }

    static std::size_t leave_as_it_is(void*, MHD_Connection*, char* text) { return std::strlen(text); }

    static void* note_target(void*, const char* target, MHD_Connection*) {
        return new Request{.target = target};  // NOLINT: request_done() takes it
    }

    static void request_done(void* self, MHD_Connection* connection, void** context,
                             MHD_RequestTerminationCode) {
        delete static_cast<Request*>(*context);  // NOLINT
        *context = nullptr;
        auto& server = *static_cast<MicroServer*>(self);
        Client* const client = client_of(connection);
        if (client == nullptr) return;
        server.deadlines_.has_answered(client->deadline, server.options_.now_s());
        if (!client->heads.empty()) return;
        if (client->is_last) return cut(client->socket);
        // Suspended after this turn of the library, unless the connection ends with it.
        server.answered_.push_back(client);
    }

    static void connection_changed(void* self, MHD_Connection* connection, void** context,
                                   MHD_ConnectionNotificationCode what) {
        auto& server = *static_cast<MicroServer*>(self);
        if (what == MHD_CONNECTION_NOTIFY_STARTED) {
            const auto* const info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
            const auto found =
                std::find_if(server.handed_over_.begin(), server.handed_over_.end(),
                             [&](const Client* client) { return client->socket == info->connect_fd; });
            if (found == server.handed_over_.end()) return;
            (*found)->connection = connection;
            *context = *found;
            server.handed_over_.erase(found);
        } else if (*context != nullptr) {
            server.forget(*static_cast<Client*>(*context));
            *context = nullptr;
        }
    }

    static Client* client_of(MHD_Connection* connection) {
        const auto* const info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_SOCKET_CONTEXT);
        return info == nullptr ? nullptr : static_cast<Client*>(info->socket_context);
    }

    static MHD_Result answer_to(void* self, MHD_Connection* connection, const char*, const char* method,
                                const char*, const char*, std::size_t* upload_size, void** context) {
        *upload_size = 0;  // uploads are not read
        auto* const request = static_cast<Request*>(*context);
        Client* const client = client_of(connection);
        if (request == nullptr || client == nullptr) return MHD_NO;
        if (!std::exchange(request->is_known, true)) {
            // The library may have read bytes that arrived after the inspection: close without an answer.
            if (client->heads.empty() || client->heads.front() != line_of(method, request->target))
                return MHD_NO;
            client->heads.pop_front();
            // Answering in the first call ends the connection, as intended for a request with a body
            // (findings/libmicrohttpd-closes-a-connection-that-is-answered-at-the-first-call.sh).
            const bool has_body = !header(connection, MHD_HTTP_HEADER_CONTENT_LENGTH).empty() ||
                                  !header(connection, MHD_HTTP_HEADER_TRANSFER_ENCODING).empty();
            if (!has_body) return MHD_YES;
        }
        return static_cast<MicroServer*>(self)->answer(*client, method, request->target);
    }

    MHD_Result answer(const Client& client, std::string_view method, std::string_view target) {
        const double now_s = options_.now_s();
        MHD_Connection* const connection = client.connection;
        const sharing::AddressKey& address = client.deadline->address;
        const auto send = [&](const Response& response) {
            if (!response) return MHD_NO;
            deadlines_.answers(client.deadline, now_s, response.bytes());
            return MHD_queue_response(connection, response.status(), response.get());
        };
        if (!limits_.allows(address, now_s)) return send(responses_.too_many());
        const std::string_view language = header(connection, MHD_HTTP_HEADER_ACCEPT_LANGUAGE);
        const ShareAnswer answer =
            sharing::answer_to({.method = method,
                                .target = target,
                                .range = header(connection, MHD_HTTP_HEADER_RANGE),
                                .if_range = header(connection, MHD_HTTP_HEADER_IF_RANGE),
                                .accept_encoding = header(connection, MHD_HTTP_HEADER_ACCEPT_ENCODING),
                                .accept_language = language});
        if (answer.kind != ShareAnswer::Kind::kFile) {
            if (answer.kind == ShareAnswer::Kind::kNotFound) limits_.missed(address, now_s);
            return send(responses_.without_a_file(answer, language));
        }
        Response file = file_answer(answer);
        if (!file) {
            limits_.missed(address, now_s);
            return send(responses_.lost(language));
        }
        // A player asks for ranges, as often as it likes.
        if (method == "GET" && answer.range.empty() && answer.file.counted != '\0')
            counter_.count(static_cast<sharing::ShareEvent>(answer.file.counted));
        return send(file);
    }

    Response file_answer(const ShareAnswer& answer) {
        const std::int64_t wall_s = options_.wall_s();
        if (answer.takes_gzip) {
            const std::string twin = std::string(answer.file.name) + std::string(sharing::kTwinEnding);
            if (OpenFile packed = store_.open(*answer.code, twin, wall_s))
                return Responses::of_file(std::move(packed), answer.file, {}, true);
        }
        OpenFile plain = store_.open(*answer.code, answer.file.name, wall_s);
        if (!plain) return {};
        return Responses::of_file(std::move(plain), answer.file, answer.range, false);
    }

    ShareServerOptions options_;
    PageStore store_;
    sharing::CounterWriter counter_;
    sharing::ShareLimits limits_;
    Deadlines deadlines_;
    Responses responses_;
    unsigned most_connections_ = 0;
    MHD_Daemon* daemon_ = nullptr;
    int gate_ = -1;  // epoll: the listening socket, the library's epoll and every connection
    bool has_newcomers_ = false;
    std::list<Client> clients_;
    std::vector<Client*> handed_over_;  // new to the library, which has not taken them in yet
    std::vector<Client*> answered_;     // the library may want to read their next head
    double next_sweep_s_ = 0.0;
};

}  // namespace

Result<std::unique_ptr<ShareServer>> ShareServer::start(const ShareServerOptions& options) {
    auto server = std::make_unique<MicroServer>(options);
    if (!server->start()) return system_lacks("sharing: the server cannot start: not enough memory or files");
    return std::unique_ptr<ShareServer>(std::move(server));
}

}  // namespace onggi::app
