#include "game/sharing/request_head.h"

#include <algorithm>
#include <optional>

namespace onggi::sharing {
namespace {

constexpr int kBadRequest = 400;
constexpr int kTooLarge = 413;
constexpr int kTargetTooLong = 414;
constexpr int kHeadTooLarge = 431;
constexpr int kNotImplemented = 501;
constexpr int kUnknownVersion = 505;

char small(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool is_digit(char letter) {
    return letter >= '0' && letter <= '9';
}

bool is_alphanumeric(char letter) {
    return is_digit(letter) || (small(letter) >= 'a' && small(letter) <= 'z');
}

// A method or a field's name (RFC 9110, 5.6.2).
bool is_token(std::string_view text) {
    constexpr std::string_view kSigns = "!#$%&'*+-.^_`|~";
    return !text.empty() && std::all_of(text.begin(), text.end(), [&](char letter) {
        return is_alphanumeric(letter) || kSigns.find(letter) != std::string_view::npos;
    });
}

// No NUL, CR or other control character but the tab (RFC 9110, 5.5).
bool is_field_value(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char letter) {
        const auto byte = static_cast<unsigned char>(letter);
        return byte == '\t' || (byte >= ' ' && byte != 0x7f);
    });
}

// Letters, digits, marks and percent-encoded bytes of a name (RFC 3986, 3.2.2); a colon as well within the
// brackets of an IPv6 address.
bool is_name(std::string_view text, bool with_colons) {
    constexpr std::string_view kSigns = "-._~!$&'()*+,;=";
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%') {
            if (i + 2 >= text.size() || detail::hex_value(text[i + 1]) < 0 ||
                detail::hex_value(text[i + 2]) < 0)
                return false;
            i += 2;
        } else if (!is_alphanumeric(text[i]) && kSigns.find(text[i]) == std::string_view::npos &&
                   !(with_colons && text[i] == ':')) {
            return false;
        }
    }
    return true;
}

// The fields of a head that decide how much of the connection belongs to it, and for whom it is.
struct Framing {
    int hosts = 0;
    std::optional<std::string_view> length{};
    bool has_codings = false;
    int codings = 0;
    int chunked = 0;
    bool ends_chunked = false;
};

// The status of a refusal, 0 for none, of one field line (RFC 9112, 5).
int take_field(std::string_view line, Framing& framing) {
    const std::size_t colon = line.find(':');
    // A space before the colon makes the name no token, and one before the name as well: a folded line, or
    // one that follows the request line (RFC 9112, 5.1, 5.2, 2.2).
    if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) return kBadRequest;
    const std::string_view name = line.substr(0, colon);
    std::string_view value = detail::trimmed(line.substr(colon + 1));
    if (!is_field_value(value)) return kBadRequest;
    if (detail::same_word(name, "host")) {
        if (++framing.hosts > 1 || !is_host(value)) return kBadRequest;
    } else if (detail::same_word(name, "content-length")) {
        constexpr std::size_t kMostDigits = 19;  // fits in 64 bits
        if (value.empty() || !std::all_of(value.begin(), value.end(), is_digit)) return kBadRequest;
        if (framing.length && *framing.length != value) return kBadRequest;
        if (value.size() > kMostDigits) return kTooLarge;
        framing.length = value;
    } else if (detail::same_word(name, "transfer-encoding")) {
        framing.has_codings = true;
        while (!value.empty()) {
            const std::string_view coding = detail::trimmed(detail::take_until(value, ','));
            if (coding.empty()) continue;
            framing.ends_chunked = detail::same_word(coding, "chunked");
            framing.chunked += framing.ends_chunked ? 1 : 0;
            ++framing.codings;
        }
    }
    return 0;
}

// Sets method and target. Several spaces before the target are taken for one (RFC 9112, 3).
int take_request_line(std::string_view line, RequestHead& head, bool& needs_host) {
    head.method = detail::take_until(line, ' ');
    if (!is_token(head.method)) return kBadRequest;
    while (line.starts_with(' '))
        line.remove_prefix(1);
    head.target = detail::take_until(line, ' ');
    const bool is_plain = std::all_of(head.target.begin(), head.target.end(),
                                      [](char letter) { return letter > ' ' && letter < '\x7f'; });
    constexpr std::string_view kName = "HTTP/";
    const bool is_version = line.size() == kName.size() + 3 && line.starts_with(kName) && is_digit(line[5]) &&
                            line[6] == '.' && is_digit(line[7]);
    if (head.target.empty() || !is_plain || !is_version) return kBadRequest;
    if (line[5] != '1') return kUnknownVersion;
    needs_host = line[7] != '0';
    return 0;
}

// What no single line shows.
int at_the_end(const Framing& framing, bool needs_host) {
    if (needs_host && framing.hosts == 0) return kBadRequest;  // RFC 9112, 3.2
    if (!framing.has_codings) return 0;
    if (!framing.ends_chunked || framing.chunked > 1) return kBadRequest;  // RFC 9112, 6.3, 7.1
    return framing.codings > 1 ? kNotImplemented : 0;                      // RFC 9112, 6.1
}

}  // namespace

bool detail::same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char one, char other) { return small(one) == small(other); });
}

std::string_view detail::trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t'))
        text.remove_suffix(1);
    return text;
}

std::string_view detail::take_until(std::string_view& text, char sign) {
    const std::size_t end = text.find(sign);
    const std::string_view taken = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return taken;
}

int detail::hex_value(char letter) {
    if (is_digit(letter)) return letter - '0';
    const char low = small(letter);
    return low >= 'a' && low <= 'f' ? low - 'a' + 10 : -1;
}

bool is_host(std::string_view text) {
    std::string_view host;
    if (text.starts_with('[')) {
        const std::size_t end = text.find(']');
        host = text.substr(1, end == std::string_view::npos ? 0 : end - 1);
        if (host.empty() || !is_name(host, true)) return false;
        text.remove_prefix(end + 1);
    } else {
        host = text.substr(0, text.find(':'));
        if (!is_name(host, false)) return false;
        text.remove_prefix(host.size());
    }
    return text.empty() || (text.front() == ':' && std::all_of(text.begin() + 1, text.end(), is_digit));
}

RequestHead read_head(std::string_view bytes) {
    RequestHead head;
    Framing framing;
    bool needs_host = false;
    const auto refused = [](int status) {
        return RequestHead{.kind = RequestHead::Kind::kRefused, .status = status};
    };
    const std::string_view all = bytes.substr(0, kMostHeadBytes);
    for (std::size_t at = 0;;) {
        const std::size_t end = all.find('\n', at);
        if (end == std::string_view::npos) {
            if (all.size() < kMostHeadBytes) return {};
            return refused(head.method.empty() ? kTargetTooLong : kHeadTooLarge);
        }
        std::string_view line = all.substr(at, end - at);
        if (line.ends_with('\r')) line.remove_suffix(1);
        at = end + 1;
        if (head.method.empty()) {
            if (line.empty()) continue;
            if (const int status = take_request_line(line, head, needs_host); status != 0)
                return refused(status);
        } else if (!line.empty()) {
            if (const int status = take_field(line, framing); status != 0) return refused(status);
        } else {
            if (const int status = at_the_end(framing, needs_host); status != 0) return refused(status);
            head.kind = RequestHead::Kind::kFine;
            head.bytes = at;
            return head;
        }
    }
}

}  // namespace onggi::sharing
