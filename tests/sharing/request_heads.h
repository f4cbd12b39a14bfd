// Heads of requests and what RFC 9112 has them answered with; game/app/sharing/README.md has the same table.
#pragma once

#include <string>
#include <vector>

namespace onggi::test {

struct HeadCase {
    const char* section;
    std::string bytes;
    int status = 400;
};

inline std::string head_of(const std::string& request_line, const std::string& fields = "Host: pots\r\n") {
    return request_line + "\r\n" + fields + "\r\n";
}
// A field beside a valid Host.
inline std::string head_with(const std::string& field) {
    return head_of("GET / HTTP/1.1", "Host: pots\r\n" + field + "\r\n");
}

inline std::vector<HeadCase> refused_heads() {
    using namespace std::string_literals;
    const std::string get = "GET / HTTP/1.1";
    std::vector<HeadCase> cases{
        {"2.2: white space before the first field", get + "\r\n X: y\r\nHost: pots\r\n\r\n"},
        {"2.2: a tab before the first field", get + "\r\n\tHost: pots\r\n\r\n"},
        {"2.2: a bare CR in the request line", head_of("GET /\rx HTTP/1.1")},
        {"2.2: a bare CR in a value", head_with("X: a\rb")},
        {"2.2: a bare CR before a name", head_with("\rX: a")},
        {"2.2: CR CR LF", head_of(get + "\r")},
        {"2.3: another version", head_of("GET / HTTP/2.0"), 505},
        {"2.3: an old version", head_of("GET / HTTP/0.9"), 505},
        {"2.3: a version of one digit", head_of("GET / HTTP/1")},
        {"2.3: a version of two digits", head_of("GET / HTTP/1.10")},
        {"2.3: the name in small letters", head_of("GET / http/1.1")},
        {"3: no version", head_of("GET /")},
        {"3: no target", head_of("GET HTTP/1.1")},
        {"3: two spaces before the version", head_of("GET /  HTTP/1.1")},
        {"3: tabs", head_of("GET\t/\tHTTP/1.1")},
        {"3: a space in the target", head_of("GET /a b HTTP/1.1")},
        {"3: a space before the method", head_of(" GET / HTTP/1.1")},
        {"3: a long target", head_of("GET /" + std::string(600, 'a') + " HTTP/1.1"), 414},
        {"3: a longer one", head_of("GET /" + std::string(9000, 'a') + " HTTP/1.1"), 414},
        {"3.1: a method that is no token", head_of("GE(T / HTTP/1.1")},
        {"3.2: no Host", head_of(get, "")},
        {"3.2: Host twice", head_with("Host: pots")},
        {"3.2: two hosts", head_with("HOST: other")},
        {"3.2: a space in Host", head_of(get, "Host: a b\r\n")},
        {"3.2: a path in Host", head_of(get, "Host: a/b\r\n")},
        {"3.2: a user in Host", head_of(get, "Host: user@pots\r\n")},
        {"3.2: a port of letters", head_of(get, "Host: pots:http\r\n")},
        {"3.2: an open bracket", head_of(get, "Host: [fd00::5\r\n")},
        {"3.2: a bad percent sign", head_of(get, "Host: a%zz\r\n")},
        {"3.2: a target that is no path", head_of("GET index.html HTTP/1.1")},
        {"3.2.2: no host in the absolute form", head_of("GET http:/// HTTP/1.1")},
        {"3.2.2: a user in the absolute form", head_of("GET http://user@pots/ HTTP/1.1")},
        {"3.2.3: the form of CONNECT", head_of("GET pots:80 HTTP/1.1")},
        {"3.2.4: the form of OPTIONS", head_of("GET * HTTP/1.1")},
        {"5: no colon", head_with("X")},
        {"5: no name", head_with(": y")},
        {"5: a name that is no token", head_with("X(: y")},
        {"5: a name beyond ASCII", head_with("X\xe9: y")},
        {"5.1: a space before the colon", head_with("X : y")},
        {"5.1: a tab before the colon", head_with("X\t: y")},
        {"5.1: a space before Host's colon", head_of(get, "Host : pots\r\n")},
        {"5.2: a folded line", head_with("X: a\r\n b")},
        {"5.2: a line folded by a tab", head_with("X: a\r\n\tb")},
        {"5.4: a long field", head_with("X: " + std::string(9000, 'a')), 431},
        {"5.5: NUL in a value", head_with("X: a\0b"s)},
        {"5.5: NUL in Host", head_of(get, "Host: pots\0.x\r\n"s)},
        {"5.5: NUL in a name", head_with("X\0Y: a"s)},
        {"5.5: NUL in the target", head_of("GET /\0x HTTP/1.1"s)},
        {"5.5: a control character", head_with("X: a\x01z")},
        {"5.5: delete", head_with("X: a\x7fz")},
        {"6.1: an unknown coding", head_with("Transfer-Encoding: gnus, chunked"), 501},
        {"6.3: no chunks at the end", head_with("Transfer-Encoding: chunked, gzip")},
        {"6.3: chunks twice", head_with("Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked")},
        {"6.3: no coding", head_with("Transfer-Encoding:")},
        {"6.3: two lengths", head_with("Content-Length: 5\r\nContent-Length: 6")},
        {"6.3: a list of lengths", head_with("Content-Length: 5, 6")},
        {"6.3: a length below zero", head_with("Content-Length: -1")},
        {"6.3: a length with a sign", head_with("Content-Length: +5")},
        {"6.3: a length in hexadecimal", head_with("Content-Length: 0x5")},
        {"6.3: an empty length", head_with("Content-Length:")},
        {"6.3: a length beyond 64 bits", head_with("Content-Length: 99999999999999999999"), 413},
    };
    return cases;
}

inline std::vector<HeadCase> answered_heads() {
    const std::string get = "GET /robots.txt HTTP/1.1";
    return {
        {"plain", head_of(get), 200},
        {"2.2: lines that end with LF", "GET /robots.txt HTTP/1.1\nHost: pots\n\n", 200},
        {"2.2: empty lines before", "\r\n\r\n" + head_of(get), 200},
        {"2.3: a higher minor version", head_of("GET /robots.txt HTTP/1.9"), 200},
        {"2.3: HTTP/1.0 without Host", head_of("GET /robots.txt HTTP/1.0", ""), 200},
        {"3: two spaces before the target", head_of("GET  /robots.txt HTTP/1.1"), 200},
        {"3.2: an empty Host", head_of(get, "Host:\r\n"), 200},
        {"3.2: a host and a port", head_of(get, "hOST:\tpots.example_1:8080 \r\n"), 200},
        {"3.2: an IPv6 address", head_of(get, "Host: [fd00::5]:8080\r\n"), 200},
        {"3.2: a name with all its signs", head_of(get, "Host: a%C3%A9!$&'()*+,;=-._~:\r\n"), 200},
        {"3.2.2: the absolute form", head_of("GET http://other:80/robots.txt HTTP/1.1"), 200},
        {"5.5: bytes beyond ASCII, tabs", head_of(get, "Host: pots\r\nX:\xc3\xa9\tb \r\nY:\r\n"), 200},
        {"6: a body", head_of(get, "Host: pots\r\nContent-Length: 5\r\n") + "hello", 200},
        {"6.1: chunks", head_of(get, "Host: pots\r\nTransfer-Encoding: Chunked\r\n") + "0\r\n\r\n", 200},
        {"6.3: one length twice",
         head_of(get, "Host: pots\r\nContent-Length: 5\r\nContent-Length: 5\r\n") + "hello", 200},
    };
}

}  // namespace onggi::test
