// Decides the answer to a phone's request from its text alone: no file is read. For any input, the answer
// names a file of page_files.h in the folder of a code, or content that the server holds in memory, or
// refuses; so a request's path never reaches the disk. Any thread; pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/language_tag.h"
#include "game/sharing/page_files.h"
#include "game/sharing/share_code.h"

namespace onggi::sharing {

// As received, nothing decoded. Missing headers are empty.
struct ShareRequest {
    std::string_view method{};
    std::string_view target{};  // "/K73FQ9TX/pot.glb?x=1"
    std::string_view range{};
    std::string_view if_range{};
    std::string_view accept_encoding{};
    std::string_view accept_language{};
};

struct ShareAnswer {
    enum class Kind {
        kFile,        // in the folder of `code`
        kAskForCode,  // the page at "/", for phones without a camera
        kScript,      // the script of that page
        kRobots,      // robots.txt: forbids indexing
        kNothing,     // the icon that browsers request on their own
        kMoved,       // to `location`
        kNotFound,
        kNotAllowed,  // a method other than GET and HEAD
        kBadRequest,  // a target that this server cannot have
        kTooLong,     // a target longer than any of this server's
    };
    Kind kind = Kind::kNotFound;
    std::optional<ShareCode> code{};
    PageFile file{"", ""};        // its name points into the request, and lives only as long
    bool takes_gzip = false;      // the compressed twin may be sent
    std::string_view range = {};  // to be resolved with the file's size; empty: the whole file
    std::string location{};       // relative to the target, so that a museum may mount it below any path
};

[[nodiscard]] ShareAnswer answer_to(const ShareRequest& request);

// Resolves a Range header for a file of that size (RFC 9110, 14). One range is honoured; several ranges, or
// anything that is not a byte range, mean the whole file.
struct ByteRange {
    enum class Kind { kWhole, kPart, kBeyond };
    Kind kind = Kind::kWhole;
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};
[[nodiscard]] ByteRange resolve_range(std::string_view range, std::uint64_t size);

// The index in `codes` of the language that a phone prefers (Accept-Language, RFC 9110 12.5.4); empty if it
// names none of them.
template <typename Codes>
[[nodiscard]] std::optional<std::size_t> liked_language(std::string_view accept_language, const Codes& codes);

namespace detail {
// Weight of a word in a header of weighted words ("gzip;q=0.5, br"), 0 to 1000; empty if it is not listed.
[[nodiscard]] std::optional<int> weight_of(std::string_view header, std::string_view word);
}  // namespace detail

template <typename Codes>
std::optional<std::size_t> liked_language(std::string_view accept_language, const Codes& codes) {
    std::optional<std::size_t> best;
    int best_weight = 0;
    std::size_t place = 0;
    for (const std::string_view code : codes) {
        // "zh-CN" likes "zh-Hans", but less than "zh-CN".
        const auto whole = detail::weight_of(accept_language, code);
        const auto primary = detail::weight_of(accept_language, primary_language(code));
        const int weight = std::max(2 * whole.value_or(0), 2 * primary.value_or(0) - 1);
        if (weight > best_weight) {
            best = place;
            best_weight = weight;
        }
        ++place;
    }
    return best;
}

}  // namespace onggi::sharing
