#include "engine/haptics/haply/service_probe.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace onggi::haptics::haply {
namespace {

class Socket {
  public:
    Socket() : number_(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {}
    ~Socket() {
        if (number_ >= 0) ::close(number_);
    }
    Socket(const Socket&) = delete;
    Socket& operator=(const Socket&) = delete;

    [[nodiscard]] int number() const { return number_; }

  private:
    int number_;
};

// Returns 0 if connected, otherwise errno.
int connected(const Socket& socket, const sockaddr_in& address, int within_ms) {
    if (socket.number() < 0) return errno;
    if (::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
        return 0;
    if (errno != EINPROGRESS) return errno;
    pollfd watched{.fd = socket.number(), .events = POLLOUT, .revents = 0};
    const int ready = ::poll(&watched, 1, within_ms);
    if (ready < 0) return errno;
    if (ready == 0) return ETIMEDOUT;
    int error = 0;
    socklen_t size = sizeof error;
    return ::getsockopt(socket.number(), SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

}  // namespace

Result<void> find_service(const InverseOptions& options, int within_ms) {
    const std::string place = fmt::format("{}:{}", options.host, options.port);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(options.port));
    if (::inet_pton(AF_INET, options.host.c_str(), &address.sin_addr) != 1)
        return system_lacks(fmt::format("{}: expected an IPv4 address", place));
    const Socket socket;
    switch (const int error = connected(socket, address, within_ms)) {
        case 0:
            return {};
        case ECONNREFUSED:
            return system_lacks(fmt::format("nothing listens at {}", place));
        case ETIMEDOUT:
            return system_lacks(fmt::format("no answer from {} within {} ms", place, within_ms));
        default:
            return system_lacks(fmt::format("{}: {}", place, std::generic_category().message(error)));
    }
}

}  // namespace onggi::haptics::haply
