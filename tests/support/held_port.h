// A port of 127.0.0.1 that stays a test's own for as long as the object lives.
#pragma once

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace onggi::test {

// The kernel chooses the port. A socket stays bound to it and never listens, so that
// - nothing listens there, and a connection is refused at once;
// - the kernel gives the port to no other socket that leaves the choice to it;
// - a server that sets SO_REUSEADDR may listen there by the port's number, and again after it has ended.
class HeldPort {
  public:
    HeldPort() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        const int yes = 1;
        ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof place;
        EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&place), size), 0);
        EXPECT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&place), &size), 0);
        number_ = ntohs(place.sin_port);
    }
    HeldPort(const HeldPort&) = delete;
    HeldPort& operator=(const HeldPort&) = delete;
    ~HeldPort() { ::close(socket_); }

    [[nodiscard]] int number() const { return number_; }

  private:
    int socket_;
    int number_ = 0;
};

}  // namespace onggi::test
