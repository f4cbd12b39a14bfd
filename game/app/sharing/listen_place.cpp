#include "game/app/sharing/listen_place.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <net/if.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <system_error>

#include "engine/core/quote.h"

namespace onggi::app {
namespace {

struct SocketAddress {
    sockaddr_storage storage{};
    socklen_t size = 0;

    [[nodiscard]] const sockaddr* generic() const { return reinterpret_cast<const sockaddr*>(&storage); }
};

// Empty if the text is not a numeric address.
std::optional<SocketAddress> numeric(const std::string& address, int port) {
    SocketAddress made;
    const auto network_port = htons(static_cast<std::uint16_t>(port));
    sockaddr_in ipv4{.sin_family = AF_INET, .sin_port = network_port, .sin_addr = {}, .sin_zero = {}};
    sockaddr_in6 ipv6{};
    ipv6.sin6_family = AF_INET6;
    ipv6.sin6_port = network_port;
    if (::inet_pton(AF_INET, address.c_str(), &ipv4.sin_addr) == 1) {
        std::memcpy(&made.storage, &ipv4, made.size = sizeof ipv4);
    } else if (::inet_pton(AF_INET6, address.c_str(), &ipv6.sin6_addr) == 1) {
        std::memcpy(&made.storage, &ipv6, made.size = sizeof ipv6);
    } else {
        return std::nullopt;
    }
    return made;
}

std::string words_of_errno() {
    return std::generic_category().message(errno);
}

}  // namespace

Result<std::string> address_of(const std::string& address_or_interface) {
    if (numeric(address_or_interface, 0)) return address_or_interface;
    const auto unknown = [&] {
        return bad_input(fmt::format("sharing: expected an address or an interface of this machine, found {}",
                                     in_quotes(address_or_interface)));
    };
    ifreq request{};
    if (address_or_interface.empty() || address_or_interface.size() >= sizeof request.ifr_name)
        return unknown();
    std::copy(address_or_interface.begin(), address_or_interface.end(), std::begin(request.ifr_name));
    // Uses an AF_INET socket, because the service may not be allowed any other family.
    const int probe = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    const int refused = probe >= 0 && ::ioctl(probe, SIOCGIFADDR, &request) == 0 ? 0 : errno;
    if (probe >= 0) ::close(probe);
    if (refused == ENODEV) return unknown();
    if (refused != 0) {
        return system_lacks(fmt::format("sharing: expected an address on the interface {}, found none",
                                        address_or_interface));
    }
    sockaddr_in found{};
    std::memcpy(&found, &request.ifr_addr, sizeof found);
    std::array<char, INET_ADDRSTRLEN> text{};
    ::inet_ntop(AF_INET, &found.sin_addr, text.data(), text.size());
    return std::string(text.data());
}

Result<int> listen_at(const std::string& address_or_interface, int port) {
    const auto address = address_of(address_or_interface);
    if (!address) return address.error();
    const auto place = numeric(*address, port);
    const auto refused = [&] {
        return system_lacks(fmt::format("sharing: expected to listen at {}, port {}, found: {}", *address,
                                        port, words_of_errno()));
    };
    const int listening = ::socket(place->storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (listening < 0) return refused();
    const int yes = 1;
    ::setsockopt(listening, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    const int silent_s = 1;  // accept a silent client after this time
    ::setsockopt(listening, IPPROTO_TCP, TCP_DEFER_ACCEPT, &silent_s, sizeof silent_s);
    if (place->storage.ss_family == AF_INET6)
        ::setsockopt(listening, IPPROTO_IPV6, IPV6_V6ONLY, &yes, sizeof yes);
    constexpr int kBacklog = 256;
    if (::bind(listening, place->generic(), place->size) != 0 || ::listen(listening, kBacklog) != 0) {
        const Error error = refused();
        ::close(listening);
        return error;
    }
    return listening;
}

int port_of(int listening_socket) {
    sockaddr_storage storage{};
    socklen_t size = sizeof storage;
    if (::getsockname(listening_socket, reinterpret_cast<sockaddr*>(&storage), &size) != 0) return 0;
    sockaddr_in ipv4{};
    std::memcpy(&ipv4, &storage, sizeof ipv4);  // the port is at the same offset in both
    return ntohs(ipv4.sin_port);
}

bool answers_at(const std::string& address, int port, int most_ms) {
    const auto place = numeric(address, port);
    if (!place) return false;
    const int probe = ::socket(place->storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (probe < 0) return false;
    bool answers = ::connect(probe, place->generic(), place->size) == 0;
    if (!answers && errno == EINPROGRESS) {
        pollfd watched{.fd = probe, .events = POLLOUT, .revents = 0};
        int error = 0;
        socklen_t size = sizeof error;
        answers = ::poll(&watched, 1, most_ms) == 1 &&
                  ::getsockopt(probe, SOL_SOCKET, SO_ERROR, &error, &size) == 0 && error == 0;
    }
    ::close(probe);
    return answers;
}

}  // namespace onggi::app
