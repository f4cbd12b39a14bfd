#include "game/app/sharing/responses.h"

#include <fmt/format.h>

#include "game/kiosk/strings.h"
#include "game/sharing/phone_page.h"
#include "game/sharing/plain_pages.h"

namespace onggi::app {
namespace {

constexpr const char* kHtml = "text/html; charset=utf-8";
constexpr const char* kText = "text/plain; charset=utf-8";

// Nothing is kept in between, guessed or told on.
void add_manners(const Response& response, const std::string& media_type, std::string_view policy) {
    if (!media_type.empty()) response.add(MHD_HTTP_HEADER_CONTENT_TYPE, media_type);
    response.add(MHD_HTTP_HEADER_CACHE_CONTROL, "no-store");
    response.add("X-Content-Type-Options", "nosniff");
    response.add("Referrer-Policy", "no-referrer");
    response.add("Content-Security-Policy", std::string(policy) + "; frame-ancestors 'none'");
}

Response of_text(const std::string& text, const char* media_type, unsigned status) {
    Response response(
        MHD_create_response_from_buffer(text.size(), const_cast<char*>(text.data()),  // NOLINT: copied
                                        MHD_RESPMEM_MUST_COPY),
        status, text.size());
    add_manners(response, media_type, sharing::kPlainPolicy);
    return response;
}

// Which of the built-in languages a phone likes best; English where it likes none.
std::size_t language_of(std::string_view accept_language) {
    std::vector<std::string_view> codes;
    for (const kiosk::Language& language : kiosk::built_in_languages())
        codes.push_back(language.code());
    return sharing::liked_language(accept_language, codes).value_or(0);
}

}  // namespace

Responses::Responses() {
    const auto& languages = kiosk::built_in_languages();
    for (std::size_t place = 0; place < languages.size(); ++place) {
        lost_.push_back(of_text(sharing::lost_page(languages, place), kHtml, MHD_HTTP_NOT_FOUND));
        ask_.push_back(of_text(sharing::ask_page(languages, place), kHtml, MHD_HTTP_OK));
        lost_.back().add(MHD_HTTP_HEADER_VARY, "Accept-Language");
        ask_.back().add(MHD_HTTP_HEADER_VARY, "Accept-Language");
    }
    script_ = of_text(std::string(sharing::ask_script()), "text/javascript; charset=utf-8", MHD_HTTP_OK);
    robots_ = of_text("User-agent: *\nDisallow: /\n", kText, MHD_HTTP_OK);
    nothing_ = of_text("", kText, MHD_HTTP_NO_CONTENT);
    not_allowed_ = of_text("", kText, MHD_HTTP_METHOD_NOT_ALLOWED);
    not_allowed_.add(MHD_HTTP_HEADER_ALLOW, "GET, HEAD");
    bad_request_ = of_text("", kText, MHD_HTTP_BAD_REQUEST);
    too_many_ = of_text("", kText, MHD_HTTP_TOO_MANY_REQUESTS);
    too_many_.add(MHD_HTTP_HEADER_RETRY_AFTER, "5");
    // Who is not to ask again at once need not hold a connection.
    for (const Response* last : {&not_allowed_, &bad_request_, &too_many_})
        last->add(MHD_HTTP_HEADER_CONNECTION, "close");
}

Response Responses::of_file(OpenFile file, const sharing::PageFile& known, std::string_view range,
                            bool is_twin) {
    using Kind = sharing::ByteRange::Kind;
    const std::uint64_t size = file.size();
    const sharing::ByteRange part = sharing::resolve_range(range, size);
    if (part.kind == Kind::kBeyond) {
        Response beyond = of_text("", kText, MHD_HTTP_RANGE_NOT_SATISFIABLE);
        beyond.add(MHD_HTTP_HEADER_CONTENT_RANGE, fmt::format("bytes */{}", size));
        return beyond;
    }
    const int descriptor = file.release();
    Response response(MHD_create_response_from_fd_at_offset64(part.count, descriptor, part.first),
                      part.kind == Kind::kPart ? MHD_HTTP_PARTIAL_CONTENT : MHD_HTTP_OK, part.count);
    if (!response) {
        static_cast<void>(OpenFile(descriptor, size));  // closes it
        return {};
    }
    add_manners(response, std::string(known.media_type), sharing::kPagePolicy);
    response.add(MHD_HTTP_HEADER_ACCEPT_RANGES, "bytes");
    if (known.has_twin) response.add(MHD_HTTP_HEADER_VARY, "Accept-Encoding");
    if (is_twin) response.add(MHD_HTTP_HEADER_CONTENT_ENCODING, "gzip");
    if (part.kind == Kind::kPart) {
        response.add(MHD_HTTP_HEADER_CONTENT_RANGE,
                     fmt::format("bytes {}-{}/{}", part.first, part.first + part.count - 1, size));
    }
    return response;
}

Response Responses::lost(std::string_view accept_language) const {
    return lost_[language_of(accept_language)];
}

Response Responses::without_a_file(const sharing::ShareAnswer& answer,
                                   std::string_view accept_language) const {
    using Kind = sharing::ShareAnswer::Kind;
    switch (answer.kind) {
        case Kind::kAskForCode:
            return ask_[language_of(accept_language)];
        case Kind::kScript:
            return script_;
        case Kind::kRobots:
            return robots_;
        case Kind::kNothing:
            return nothing_;
        case Kind::kMoved: {
            Response moved = of_text("", kText, MHD_HTTP_SEE_OTHER);
            moved.add(MHD_HTTP_HEADER_LOCATION, answer.location);
            return moved;
        }
        case Kind::kNotAllowed:
            return not_allowed_;
        case Kind::kBadRequest:
            return bad_request_;
        case Kind::kFile:
        case Kind::kNotFound:
            break;
    }
    return lost(accept_language);
}

}  // namespace onggi::app
