// A client that sends exactly the given bytes, valid or not. Blocks, with timeouts.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace onggi::test {

struct HttpAnswer {
    int status = 0;                              // 0: no answer, or not HTTP
    std::map<std::string, std::string> headers;  // lower-case names
    std::string body;
};

// A connection to 127.0.0.1, closed by the destructor; optionally from another local address, such as
// 0x7f010203 for 127.1.2.3.
class HttpClient {
  public:
    // wait_ms: the timeout of each answer, which scaled() extends on a slow machine.
    explicit HttpClient(int port, int wait_ms = 30'000, std::uint32_t from = 0x7f000001);
    HttpClient(HttpClient&& other) noexcept;
    HttpClient(const HttpClient&) = delete;
    HttpClient& operator=(const HttpClient&) = delete;
    ~HttpClient();

    [[nodiscard]] bool is_open() const { return socket_ >= 0; }
    // Returns false if the server has closed the connection.
    bool say(std::string_view bytes) const;
    // The answer to a sent request; `has_body` false for HEAD.
    [[nodiscard]] HttpAnswer answer(bool has_body = true);
    // Everything received until the server closes; may be empty. `closed`: whether it closed in time.
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
