#include "game/sharing/share_request.h"

#include <algorithm>

#include "engine/core/number_in.h"
#include "game/sharing/request_head.h"

namespace onggi::sharing {
namespace {

using detail::hex_value;
using detail::same_word;
using detail::take_until;
using detail::trimmed;

constexpr std::size_t kMostHeader = 512;  // longer headers are ignored
constexpr int kFullWeight = 1000;

// ";q=0.5" as 500; 1000 by default.
int weight(std::string_view parameters) {
    while (!parameters.empty()) {
        const std::string_view one = trimmed(take_until(parameters, ';'));
        if (one.size() < 3 || (one[0] != 'q' && one[0] != 'Q') || one[1] != '=') continue;
        if (one[2] == '1') return kFullWeight;
        if (one[2] != '0') return 0;
        int value = 0;
        int unit = kFullWeight / 10;
        for (std::size_t i = 4; i < one.size() && unit > 0; ++i, unit /= 10) {
            if (one[i] < '0' || one[i] > '9') return 0;
            value += (one[i] - '0') * unit;
        }
        return value;
    }
    return kFullWeight;
}

// The code from the form at "/": "code=k73f-q9tx".
std::optional<ShareCode> typed_code(std::string_view query) {
    constexpr std::string_view kField = "code=";
    while (!query.empty()) {
        std::string_view field = take_until(query, '&');
        if (!field.starts_with(kField)) continue;
        field.remove_prefix(kField.size());
        std::string typed;
        for (std::size_t i = 0; i < field.size(); ++i) {
            if (field[i] == '+') {
                typed += ' ';
            } else if (field[i] == '%' && i + 2 < field.size() && hex_value(field[i + 1]) >= 0 &&
                       hex_value(field[i + 2]) >= 0) {
                typed += static_cast<char>(hex_value(field[i + 1]) * 16 + hex_value(field[i + 2]));
                i += 2;
            } else {
                typed += field[i];
            }
        }
        return ShareCode::read(typed);
    }
    return std::nullopt;
}

ShareAnswer moved_to(std::string location) {
    return {.kind = ShareAnswer::Kind::kMoved, .location = std::move(location)};
}

// The path of a target in absolute form, which a server has to take (RFC 9112, 3.2.2): whatever host it
// names, but one it has to name (RFC 9110, 4.2).
std::string_view without_authority(std::string_view target) {
    for (const std::string_view scheme : {"http://", "https://"}) {
        if (!same_word(target.substr(0, scheme.size()), scheme)) continue;
        const std::size_t end = target.find_first_of("/?", scheme.size());
        const std::string_view host = target.substr(0, end).substr(scheme.size());
        if (host.empty() || host.starts_with(':') || !is_host(host)) return {};
        return end == std::string_view::npos ? "/"
               : target[end] == '/'          ? target.substr(end)
                                             : std::string_view();
    }
    return target;
}

// "/": the page that asks for a code, or a redirect for a typed code.
ShareAnswer at_the_door(std::string_view query) {
    if (query.empty()) return {.kind = ShareAnswer::Kind::kAskForCode};
    const auto code = typed_code(query);
    if (!code) return {.kind = ShareAnswer::Kind::kNotFound};
    return moved_to(code->text() + "/");
}

// Without what a messenger took for a part of the link: a bracket, a full stop, a space, one more slash.
std::string_view without_tail(std::string_view path) {
    constexpr std::string_view kSigns = ")],.;:!?'\"";
    constexpr std::string_view kSpace = "%20";
    for (;;) {
        if (path.ends_with("..")) return path;  // which leads upwards
        if (path.ends_with(kSpace)) {
            path.remove_suffix(kSpace.size());
        } else if (path.ends_with("//") ||
                   (!path.empty() && kSigns.find(path.back()) != std::string_view::npos)) {
            path.remove_suffix(1);
        } else {
            return path;
        }
    }
}

// "/CODE" and "/CODE/FILE".
ShareAnswer in_a_folder(std::string_view path, const ShareRequest& request) {
    const bool has_slash = path.find('/') != std::string_view::npos;
    const std::string_view folder = take_until(path, '/');
    const auto code = ShareCode::read_exactly(folder);
    if (!code || !has_slash) {
        // A code in typed form is redirected to its exact form, because the museum's own server has only
        // exact folder names.
        const auto meant = ShareCode::read(folder);
        if (!meant || !path.empty()) return {.kind = ShareAnswer::Kind::kNotFound};
        return moved_to((has_slash ? "../" : "") + meant->text() + "/");
    }
    const auto file = page_file(path.empty() ? std::string_view("index.html") : path);
    if (!file) return {.kind = ShareAnswer::Kind::kNotFound};
    // A range refers to the uncompressed file. With If-Range the whole file is sent.
    const bool has_range = !request.range.empty() && request.if_range.empty();
    const auto named = detail::weight_of(request.accept_encoding, "gzip");
    const int gzip = named ? *named : detail::weight_of(request.accept_encoding, "*").value_or(0);
    return {.kind = ShareAnswer::Kind::kFile,
            .code = code,
            .file = *file,
            .takes_gzip = file->has_twin && !has_range && gzip > 0,
            .range = has_range ? request.range : std::string_view()};
}

}  // namespace

std::optional<int> detail::weight_of(std::string_view header, std::string_view word) {
    if (header.size() > kMostHeader) return std::nullopt;
    while (!header.empty()) {
        std::string_view item = take_until(header, ',');
        const std::string_view name = trimmed(take_until(item, ';'));
        // "ko-KR" matches "ko" as well.
        if (same_word(name, word) || (name.size() > word.size() && name[word.size()] == '-' &&
                                      same_word(name.substr(0, word.size()), word)))
            return weight(item);
    }
    return std::nullopt;
}

ShareAnswer answer_to(const ShareRequest& request) {
    using Kind = ShareAnswer::Kind;
    if (request.method != "GET" && request.method != "HEAD") return {.kind = Kind::kNotAllowed};
    std::string_view path = without_authority(request.target);
    const auto is_plain = [](char letter) { return letter > ' ' && letter < '\x7f'; };
    if (path.size() > kMostTargetBytes) return {.kind = Kind::kTooLong};
    if (!path.starts_with('/') || !std::all_of(path.begin(), path.end(), is_plain))
        return {.kind = Kind::kBadRequest};
    const std::size_t query_at = path.find('?');
    const std::string_view query =
        query_at == std::string_view::npos ? std::string_view() : path.substr(query_at + 1);
    path = path.substr(1, query_at == std::string_view::npos ? query_at : query_at - 1);
    if (path.empty()) return at_the_door(query);
    if (const std::string_view meant = without_tail(path); meant.size() < path.size()) {
        const auto code = ShareCode::read(meant.ends_with('/') ? meant.substr(0, meant.size() - 1) : meant);
        if (!code && in_a_folder(meant, request).kind != Kind::kFile) return {.kind = Kind::kNotFound};
        std::string up;
        for (auto slashes = std::count(path.begin(), path.end(), '/'); slashes > 0; --slashes)
            up += "../";
        return moved_to(up + (code ? code->text() + "/" : std::string(meant)));
    }
    if (path == "code.js") return {.kind = Kind::kScript};
    if (path == "robots.txt") return {.kind = Kind::kRobots};
    if (path == "favicon.ico") return {.kind = Kind::kNothing};
    return in_a_folder(path, request);
}

ByteRange resolve_range(std::string_view range, std::uint64_t size) {
    const ByteRange whole{.kind = ByteRange::Kind::kWhole, .first = 0, .count = size};
    constexpr std::string_view kUnit = "bytes=";
    if (!range.starts_with(kUnit) || range.size() > kMostHeader) return whole;
    const std::string_view spec = trimmed(range.substr(kUnit.size()));
    const std::size_t dash = spec.find('-');
    if (dash == std::string_view::npos || spec.find(',') != std::string_view::npos) return whole;
    const std::string_view from_text = spec.substr(0, dash);
    const std::string_view to_text = spec.substr(dash + 1);
    const auto from = number_in<std::uint64_t>(from_text);
    const auto to = number_in<std::uint64_t>(to_text);
    if ((!from && !from_text.empty()) || (!to && !to_text.empty()) || (!from && !to)) return whole;
    if (from && to && *to < *from) return whole;
    if (!from) {  // suffix range: the last bytes
        const std::uint64_t count = std::min(*to, size);
        if (count == 0) return {.kind = ByteRange::Kind::kBeyond};
        return {.kind = ByteRange::Kind::kPart, .first = size - count, .count = count};
    }
    if (*from >= size) return {.kind = ByteRange::Kind::kBeyond};
    const std::uint64_t last = to ? std::min(*to, size - 1) : size - 1;
    return {.kind = ByteRange::Kind::kPart, .first = *from, .count = last - *from + 1};
}

}  // namespace onggi::sharing
