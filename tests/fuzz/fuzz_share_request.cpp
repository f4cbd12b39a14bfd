// Any bytes are a request: a method, a target and four headers, one per line. Answers stay in the folder of a
// code; ranges stay inside their file. The same bytes are a head as it comes from a socket.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "game/sharing/kept_note.h"
#include "game/sharing/page_files.h"
#include "game/sharing/request_head.h"
#include "game/sharing/share_request.h"
#include "tests/fuzz/fuzz_expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace onggi;           // NOLINT: the one function here
    using namespace onggi::sharing;  // NOLINT
    using Kind = ShareAnswer::Kind;
    std::string_view text(reinterpret_cast<const char*>(data), size);
    static_cast<void>(read_note(text));
    if (const auto code = ShareCode::read(text)) fuzz::expect(ShareCode::read_exactly(code->text()) == code);
    const RequestHead head = read_head(text);
    if (head.kind == RequestHead::Kind::kFine) {
        const std::string_view whole = text.substr(0, head.bytes);
        fuzz::expect(whole.ends_with('\n') && whole.find('\0') == std::string_view::npos);
        fuzz::expect(!head.method.empty() && head.target.find_first_of(" \r\n") == std::string_view::npos);
        fuzz::expect(read_head(whole).bytes == whole.size());
        fuzz::expect(read_head(whole.substr(0, whole.size() - 1)).kind == RequestHead::Kind::kIncomplete);
    }
    std::array<std::string_view, 6> lines{};
    for (std::string_view& line : lines) {
        line = text.substr(0, text.find('\n'));
        text.remove_prefix(line.size() < text.size() ? line.size() + 1 : text.size());
    }
    const ShareRequest request{.method = lines[0],
                               .target = lines[1],
                               .range = lines[2],
                               .if_range = lines[3],
                               .accept_encoding = lines[4],
                               .accept_language = lines[5]};
    const ShareAnswer answer = answer_to(request);
    fuzz::expect(answer.kind == Kind::kNotAllowed || request.method == "GET" || request.method == "HEAD");
    if (answer.kind == Kind::kFile) {
        fuzz::expect(answer.code.has_value());
        const std::string_view name = answer.file.name;
        const auto known = page_file(name);
        fuzz::expect(known && known->media_type == answer.file.media_type);
        fuzz::expect(!name.empty() && name.find('/') == std::string_view::npos && name.front() != '.');
        fuzz::expect(name.find('\0') == std::string_view::npos);
        const std::string folder = "/" + answer.code->text() + "/";
        fuzz::expect(request.target.starts_with(folder) ||
                     (request.target.find("://") != std::string_view::npos &&
                      request.target.find(folder) != std::string_view::npos));
        fuzz::expect(!answer.takes_gzip || (known->has_twin && answer.range.empty()));
    }
    if (answer.kind == Kind::kMoved) {
        // To a folder of a code or a file in it, never to another host.
        std::string_view to = answer.location;
        while (to.starts_with("../"))
            to.remove_prefix(3);
        const std::size_t slash = to.find('/');
        fuzz::expect(slash != std::string_view::npos &&
                     ShareCode::read_exactly(to.substr(0, slash)).has_value());
        fuzz::expect(slash + 1 == to.size() || page_file(to.substr(slash + 1)).has_value());
    }
    for (const std::uint64_t file_size :
         {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1000}, ~std::uint64_t{0}}) {
        const ByteRange part = resolve_range(request.range, file_size);
        if (part.kind == ByteRange::Kind::kWhole) fuzz::expect(part.first == 0 && part.count == file_size);
        if (part.kind == ByteRange::Kind::kPart)
            fuzz::expect(part.count > 0 && part.count <= file_size && part.first <= file_size - part.count);
    }
    const std::array<std::string_view, 3> codes{"en", "ko", "ar"};
    fuzz::expect(liked_language(request.accept_language, codes).value_or(0) < codes.size());
    return 0;
}
