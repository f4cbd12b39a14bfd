// A client that says exactly what a test wants it to say, also what no honest one would. Blocks, within
// limits.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace onggi::test {

struct HttpAnswer {
    int status = 0;                              // 0: there was none, or it is no HTTP
    std::map<std::string, std::string> headers;  // names in small letters
    std::string body;
};

// A connection to 127.0.0.1, closed with it; from another address of this machine where that is said, such as
// 0x7f010203 for 127.1.2.3.
class HttpClient {
  public:
    // Waits so long for each answer, which scaled() makes longer on a slow machine.
    explicit HttpClient(int port, int wait_ms = 30'000, std::uint32_t from = 0x7f000001);
    HttpClient(HttpClient&& other) noexcept;
    HttpClient(const HttpClient&) = delete;
    HttpClient& operator=(const HttpClient&) = delete;
    ~HttpClient();

    [[nodiscard]] bool is_open() const { return socket_ >= 0; }
    // False where the server has closed the connection.
    bool say(std::string_view bytes) const;
    // Of a request that was said; `has_body` false for HEAD.
    [[nodiscard]] HttpAnswer answer(bool has_body = true);
    // What comes until the server closes; empty where nothing does. `closed` tells whether it did in time.
    [[nodiscard]] std::string rest(bool* closed = nullptr);

  private:
    bool more();

    int socket_ = -1;
    std::string heard_;
};

// One request on a connection of its own.
[[nodiscard]] HttpAnswer get(int port, const std::string& target, const std::string& headers = {},
                             const std::string& method = "GET");

}  // namespace onggi::test
