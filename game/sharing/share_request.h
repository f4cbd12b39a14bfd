// What a request of a phone asks for, decided from its words alone: no file is looked at. Whatever the words
// are, the answer names a file of page_files.h in the folder of a code, or something that the server holds in
// memory, or refuses; so no path of a request ever reaches the disk. Any thread; pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "game/sharing/page_files.h"
#include "game/sharing/share_code.h"

namespace onggi::sharing {

// As they came, nothing decoded. What a request has not is empty.
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
        kFile,        // of the folder of `code`
        kAskForCode,  // the page at "/": for those without a camera
        kScript,      // of that page
        kRobots,      // robots.txt: nobody is to index anything
        kNothing,     // the picture that browsers ask for unasked
        kMoved,       // to `location`
        kNotFound,
        kNotAllowed,  // another method than GET and HEAD
        kBadRequest,  // no target that this server could have
    };
    Kind kind = Kind::kNotFound;
    std::optional<ShareCode> code{};
    PageFile file{"", ""};        // its name is of the request: it lives no longer
    bool takes_gzip = false;      // the twin may be sent
    std::string_view range = {};  // to be resolved when the size is known; empty: all of it
    std::string location{};       // relative to the target, so that a house may put it below any path
};

[[nodiscard]] ShareAnswer answer_to(const ShareRequest& request);

// Which bytes of a file of that size a Range header means (RFC 9110, 14). One range is obeyed; several, or
// what is no range of bytes, mean the whole file.
struct ByteRange {
    enum class Kind { kWhole, kPart, kBeyond };
    Kind kind = Kind::kWhole;
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};
[[nodiscard]] ByteRange resolve_range(std::string_view range, std::uint64_t size);

// Which of `count` languages, asked for by their codes, a phone likes best (Accept-Language, RFC
// 9110 12.5.4); none where it names none of them.
template <typename Codes>
[[nodiscard]] std::optional<std::size_t> liked_language(std::string_view accept_language, const Codes& codes);

namespace detail {
// How much a header of weighted words ("gzip;q=0.5, br") likes this one, 0 to 1000; none: it is not named.
[[nodiscard]] std::optional<int> weight_of(std::string_view header, std::string_view word);
}  // namespace detail

template <typename Codes>
std::optional<std::size_t> liked_language(std::string_view accept_language, const Codes& codes) {
    std::optional<std::size_t> best;
    int best_weight = 0;
    std::size_t place = 0;
    for (const std::string_view code : codes) {
        const int weight = detail::weight_of(accept_language, code).value_or(0);
        if (weight > best_weight) {
            best = place;
            best_weight = weight;
        }
        ++place;
    }
    return best;
}

}  // namespace onggi::sharing
