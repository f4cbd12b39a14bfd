#include "tests/sharing/http_client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <utility>

#include "tests/support/patience.h"

namespace onggi::test {

HttpClient::HttpClient(int port, int wait_ms, std::uint32_t from)
    : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in place{.sin_family = AF_INET,
                      .sin_port = htons(static_cast<std::uint16_t>(port)),
                      .sin_addr = {htonl(INADDR_LOOPBACK)},
                      .sin_zero = {}};
    const auto wait_us = std::chrono::microseconds(scaled(std::chrono::milliseconds(wait_ms))).count();
    const timeval wait{.tv_sec = wait_us / 1'000'000, .tv_usec = wait_us % 1'000'000};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &wait, sizeof wait);
    ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &wait, sizeof wait);
    const sockaddr_in own{.sin_family = AF_INET, .sin_port = 0, .sin_addr = {htonl(from)}, .sin_zero = {}};
    ::bind(socket_, reinterpret_cast<const sockaddr*>(&own), sizeof own);
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0) return;
    ::close(socket_);
    socket_ = -1;
}

HttpClient::HttpClient(HttpClient&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)),
      heard_(std::move(other.heard_)) {}

HttpClient::~HttpClient() {
    if (socket_ >= 0) ::close(socket_);
}

bool HttpClient::say(std::string_view bytes) const {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
}

bool HttpClient::more() {
    char bytes[65536];
    const ssize_t got = ::recv(socket_, bytes, sizeof bytes, 0);
    if (got > 0) heard_.append(bytes, static_cast<std::size_t>(got));
    return got > 0;
}

std::string HttpClient::rest(bool* closed) {
    while (more()) {
    }
    char byte = 0;
    const ssize_t got = ::recv(socket_, &byte, 1, MSG_DONTWAIT);
    if (closed != nullptr) *closed = got == 0 || (got < 0 && errno != EAGAIN);
    return std::exchange(heard_, {});
}

HttpAnswer HttpClient::answer(bool has_body) {
    HttpAnswer answer;
    std::size_t end = std::string::npos;
    while ((end = heard_.find("\r\n\r\n")) == std::string::npos)
        if (!more()) return answer;
    std::string_view head = std::string_view(heard_).substr(0, end + 2);
    if (!head.starts_with("HTTP/1.1 ")) return answer;
    std::from_chars(head.data() + 9, head.data() + 12, answer.status);
    head.remove_prefix(head.find("\r\n") + 2);
    while (!head.empty()) {
        const std::string_view line = head.substr(0, head.find("\r\n"));
        head.remove_prefix(line.size() + 2);
        const std::size_t colon = line.find(": ");
        std::string name(line.substr(0, colon));
        for (char& letter : name)
            if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
        answer.headers[name] = line.substr(colon + 2);
    }
    heard_.erase(0, end + 4);
    std::size_t length = 0;
    const std::string& said = answer.headers["content-length"];
    std::from_chars(said.data(), said.data() + said.size(), length);
    while (has_body && heard_.size() < length)
        if (!more()) break;
    if (has_body) {
        answer.body = heard_.substr(0, length);
        heard_.erase(0, length);
    }
    return answer;
}

HttpAnswer get(int port, const std::string& target, const std::string& headers, const std::string& method) {
    HttpClient client(port);
    client.say(method + " " + target + " HTTP/1.1\r\nHost: pots\r\n" + headers + "\r\n");
    return client.answer(method != "HEAD");
}

}  // namespace onggi::test
