#include "game/app/sharing/share_server.h"

#include <fmt/format.h>
#include <microhttpd.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
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
    for (std::size_t place = 0; place < languages.size(); ++place) {
        lost_.push_back(of_text(sharing::lost_page(languages, place), kHtml, MHD_HTTP_NOT_FOUND));
        ask_.push_back(of_text(sharing::ask_page(languages, place), kHtml, MHD_HTTP_OK));
        lost_.back().add(MHD_HTTP_HEADER_VARY, "Accept-Language");
        ask_.back().add(MHD_HTTP_HEADER_VARY, "Accept-Language");
    }
    script_ = of_text(std::string(sharing::ask_script()), "text/javascript; charset=utf-8", MHD_HTTP_OK);
    robots_ = of_text("User-agent: *\nDisallow: /\n", kText, MHD_HTTP_OK);
    nothing_ = of_text("", kText, MHD_HTTP_NO_CONTENT);
    not_allowed_ = of_text("", kText, MHD_HTTP_METHOD_NOT_ALLOWED);
    not_allowed_.add(MHD_HTTP_HEADER_ALLOW, "GET, HEAD");
    bad_request_ = of_text("", kText, MHD_HTTP_BAD_REQUEST);
    too_many_ = of_text("", kText, MHD_HTTP_TOO_MANY_REQUESTS);
    too_many_.add(MHD_HTTP_HEADER_RETRY_AFTER, "5");
    // These answers close the connection, to slow down a client that asks again.
    for (const Response* last : {&not_allowed_, &bad_request_, &too_many_})
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
        case Kind::kFile:
        case Kind::kNotFound:
            break;
    }
    return lost(accept_language);
}

using sharing::ShareAnswer;

// Memory per connection: a request's header and its answer's header must fit in here.
constexpr std::size_t kConnectionBytes = 8192;
constexpr unsigned kSilentS = 15;  // a fallback: the deadlines are shorter
constexpr double kSweepS = 0.25;

// Whether the client has closed a connection whose data has all been read. libmicrohttpd 0.9.75 does not
// notice a close that arrives with the last bytes: its epoll is edge-triggered, and it stops reading after a
// read shorter than its buffer.
bool has_gone(int socket) {
    char byte = 0;
    return ::recv(socket, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
}

// Whether the client begins with a TLS handshake (RFC 8446, 5.1). A browser that tries https first goes on to
// http as soon as the connection is closed. The listening socket hands connections over with their first
// bytes (TCP_DEFER_ACCEPT).
bool speaks_tls(int socket) {
    constexpr char kHandshake = 0x16;
    char first = 0;
    return ::recv(socket, &first, 1, MSG_PEEK | MSG_DONTWAIT) == 1 && first == kHandshake;
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
        if (daemon_ != nullptr) MHD_stop_daemon(daemon_);
    }

    bool start() {
        daemon_ = MHD_start_daemon(
            MHD_USE_EPOLL, 0, nullptr, nullptr, &MicroServer::answer_to, this, MHD_OPTION_LISTEN_SOCKET,
            options_.listening_socket, MHD_OPTION_CONNECTION_LIMIT,
            granted_connections(options_.most_connections), MHD_OPTION_PER_IP_CONNECTION_LIMIT,
            options_.most_connections_an_address, MHD_OPTION_CONNECTION_TIMEOUT, kSilentS,
            MHD_OPTION_CONNECTION_MEMORY_LIMIT, kConnectionBytes, MHD_OPTION_STRICT_FOR_CLIENT, 1,
            MHD_OPTION_UNESCAPE_CALLBACK, &MicroServer::leave_as_it_is, nullptr, MHD_OPTION_URI_LOG_CALLBACK,
            &MicroServer::note_target, this, MHD_OPTION_NOTIFY_CONNECTION, &MicroServer::connection_changed,
            this, MHD_OPTION_NOTIFY_COMPLETED, &MicroServer::request_done, this, MHD_OPTION_END);
        return daemon_ != nullptr;
    }

    void run(int most_ms) override {
        MHD_run_wait(daemon_, most_ms);
        const double now_s = options_.now_s();
        if (now_s < next_sweep_s_) return;
        next_sweep_s_ = now_s + kSweepS;
        deadlines_.sweep(now_s, has_gone, &MicroServer::cut);
    }

    [[nodiscard]] std::size_t connections() const override { return deadlines_.size(); }

  private:
    struct Request {
        std::string target;  // as received
        bool is_known = false;
    };

    static void cut(int socket) { ::shutdown(socket, SHUT_RDWR); }

    static std::size_t leave_as_it_is(void*, MHD_Connection*, char* text) { return std::strlen(text); }

    static void* note_target(void*, const char* target, MHD_Connection*) {
        return new Request{.target = target};  // NOLINT: request_done() takes it
    }

    static void request_done(void* self, MHD_Connection* connection, void** context,
                             MHD_RequestTerminationCode) {
        delete static_cast<Request*>(*context);  // NOLINT
        *context = nullptr;
        auto& server = *static_cast<MicroServer*>(self);
        if (auto* const handle = handle_of(connection))
            server.deadlines_.has_answered(*handle, server.options_.now_s());
    }

    static void connection_changed(void* self, MHD_Connection* connection, void** context,
                                   MHD_ConnectionNotificationCode what) {
        auto& deadlines = static_cast<MicroServer*>(self)->deadlines_;
        if (what == MHD_CONNECTION_NOTIFY_STARTED) {
            const auto* const info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
            if (speaks_tls(info->connect_fd)) cut(info->connect_fd);
            const double now_s = static_cast<MicroServer*>(self)->options_.now_s();
            *context = new Deadlines::Handle(  // NOLINT
                deadlines.add(info->connect_fd, address_of(connection), now_s, &MicroServer::cut));
        } else if (*context != nullptr) {
            auto* const handle = static_cast<Deadlines::Handle*>(*context);
            deadlines.remove(*handle);
            delete handle;  // NOLINT
            *context = nullptr;
        }
    }

    static Deadlines::Handle* handle_of(MHD_Connection* connection) {
        const auto* const info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_SOCKET_CONTEXT);
        return info == nullptr ? nullptr : static_cast<Deadlines::Handle*>(info->socket_context);
    }

    static sharing::AddressKey address_of(MHD_Connection* connection) {
        const auto* const info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CLIENT_ADDRESS);
        std::uint8_t ipv4[4]{};
        std::uint8_t ipv6[16]{};
        if (info == nullptr || info->client_addr == nullptr) return sharing::key_of_ipv4(ipv4);
        if (info->client_addr->sa_family == AF_INET6) {
            const auto* const address = reinterpret_cast<const sockaddr_in6*>(info->client_addr);
            std::memcpy(ipv6, &address->sin6_addr, sizeof ipv6);
            return sharing::key_of_ipv6(ipv6);
        }
        const auto* const address = reinterpret_cast<const sockaddr_in*>(info->client_addr);
        std::memcpy(ipv4, &address->sin_addr, sizeof ipv4);
        return sharing::key_of_ipv4(ipv4);
    }

    static MHD_Result answer_to(void* self, MHD_Connection* connection, const char*, const char* method,
                                const char*, const char*, std::size_t* upload_size, void** context) {
        *upload_size = 0;  // uploads are not read
        auto* const request = static_cast<Request*>(*context);
        if (request == nullptr) return MHD_NO;
        // Answering in the first call ends the connection, as intended for a request with a body.
        const bool has_body = !header(connection, MHD_HTTP_HEADER_CONTENT_LENGTH).empty() ||
                              !header(connection, MHD_HTTP_HEADER_TRANSFER_ENCODING).empty();
        if (!std::exchange(request->is_known, true) && !has_body) return MHD_YES;
        return static_cast<MicroServer*>(self)->answer(connection, method, request->target);
    }

    MHD_Result answer(MHD_Connection* connection, std::string_view method, std::string_view target) {
        const double now_s = options_.now_s();
        const sharing::AddressKey address = address_of(connection);
        if (!limits_.allows(address, now_s)) return send(connection, responses_.too_many());
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
            return send(connection, responses_.without_a_file(answer, language));
        }
        Response file = file_answer(answer);
        if (!file) {
            limits_.missed(address, now_s);
            return send(connection, responses_.lost(language));
        }
        if (method == "GET" && answer.file.counted != '\0')
            counter_.count(static_cast<sharing::ShareEvent>(answer.file.counted));
        return send(connection, file);
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

    MHD_Result send(MHD_Connection* connection, const Response& response) {
        if (!response) return MHD_NO;
        if (auto* const handle = handle_of(connection))
            deadlines_.answers(*handle, options_.now_s(), response.bytes());
        return MHD_queue_response(connection, response.status(), response.get());
    }

    ShareServerOptions options_;
    PageStore store_;
    sharing::CounterWriter counter_;
    sharing::ShareLimits limits_;
    Deadlines deadlines_;
    Responses responses_;
    MHD_Daemon* daemon_ = nullptr;
    double next_sweep_s_ = 0.0;
};

}  // namespace

Result<std::unique_ptr<ShareServer>> ShareServer::start(const ShareServerOptions& options) {
    auto server = std::make_unique<MicroServer>(options);
    if (!server->start()) return system_lacks("sharing: the server cannot start: not enough memory or files");
    return std::unique_ptr<ShareServer>(std::move(server));
}

}  // namespace onggi::app
