#include "game/sharing/page_folder.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

#include "engine/files/atomic_file.h"
#include "engine/files/gzip.h"
#include "engine/files/read_file.h"
#include "game/sharing/page_files.h"
#include "game/sharing/phone_page.h"
#include "game/sharing/share_link.h"
#include "page_assets.h"

namespace onggi::sharing {
namespace {

constexpr std::size_t kMostFileBytes = std::size_t{64} << 20U;

std::vector<std::byte> bytes_of(std::string_view text) {
    const auto* const begin = reinterpret_cast<const std::byte*>(text.data());
    return {begin, begin + text.size()};
}

// Rounds down, also before 1970.
std::int64_t day_of(std::int64_t local_s) {
    return (local_s >= 0 ? local_s : local_s - (kDayS - 1)) / kDayS;
}

}  // namespace

GoneAt gone_at(const ShareTime& time) {
    const std::int64_t goes = time.expires_s + time.utc_offset_s;
    // Midnight counts as the end of a day, not as the start of the next.
    const std::int64_t day = day_of(goes - 1);
    const std::int64_t minutes = (goes - day * kDayS) / 60;
    const std::string clock = fmt::format("{:02}:{:02}", minutes / 60, minutes % 60);
    if (day == day_of(time.now_s + time.utc_offset_s)) return {clock, true};
    return {fmt::format("{:%Y-%m-%d}, {}", fmt::gmtime(static_cast<std::time_t>(day * kDayS)), clock), false};
}

Result<void> PageFolder::add(const FileContent& content, const std::string& name) {
    if (!content.bytes.empty()) {
        files_[name] = content.bytes;
        return {};
    }
    const auto read = files::read_file(content.path, kMostFileBytes);
    if (!read) return read.error();
    files_[name] = bytes_of(*read);
    return {};
}

Result<std::string> PageFolder::add_picture(const FileContent& content, const std::string& name) {
    if (!content.is_given()) return std::string();
    if (auto added = add(content, name); !added) return added.error();
    const std::string_view ending = picture_ending(files_[name]);
    if (ending.empty()) {
        return bad_input(
            fmt::format("{}: expected a PNG, JPEG or WebP picture, found none",
                        content.path.empty() ? "the shared pot's " + name : content.path.string()));
    }
    auto node = files_.extract(name);
    node.key() = fmt::format("{}.{}", name, ending);
    std::string whole = node.key();
    files_.insert(std::move(node));
    return whole;
}

void PageFolder::add_text(const std::string& name, std::string_view text) {
    files_[name] = bytes_of(text);
}

Result<PageFolder> PageFolder::of(const SharedPot& pot) {
    PageFolder folder;
    const struct {
        const FileContent& content;
        const char* name;
        std::string& link;
    } pictures[] = {{pot.poster, "poster", folder.poster_},
                    {pot.picture, "pot", folder.picture_},
                    {pot.surface, "surface", folder.surface_},
                    {pot.film_still, "still", folder.still_}};
    for (const auto& picture : pictures) {
        auto added = folder.add_picture(picture.content, picture.name);
        if (!added) return added.error();
        picture.link = *added;
    }
    if (folder.poster_.empty()) folder.poster_ = folder.picture_;
    const struct {
        const FileContent& content;
        const char* name;
    } plain[] = {{pot.model_glb, "pot.glb"},   {pot.model_usdz, "pot.usdz"}, {pot.print_stl, "pot.stl"},
                 {pot.print_3mf, "pot.3mf"},   {pot.film, "film.webp"},      {pot.film_mp4, "film.mp4"},
                 {pot.drawing_svg, "pot.svg"}, {pot.drawing_pdf, "pot.pdf"}, {pot.measures_json, "pot.json"}};
    for (const auto& file : plain) {
        if (!file.content.is_given()) continue;
        if (auto added = folder.add(file.content, file.name); !added) return added.error();
    }
    return folder;
}

void PageFolder::add_pages(const SharedPot& pot, const OutboxOptions& options, const ShareCode& code,
                           const ShareTime& time) {
    add_text("page.css", built_in::kPageCss);
    add_text("pot.js", built_in::kPotScript);
    const GoneAt gone = gone_at(time);
    for (std::size_t place = 0; place < options.languages->size(); ++place) {
        const std::string page = phone_page(
            {.pot = pot,
             .languages = *options.languages,
             .language = place,
             .code = code,
             .links = {.poster = poster_, .picture = picture_, .surface = surface_, .film_still = still_},
             .gone_at = gone.text,
             .is_gone_today = gone.is_today,
             .own_digits = options.own_digits,
             .page_url = page_url(options.public_url, code)});
        add_text((*options.languages)[place].code() + ".html", page);
        if (place == pot.first_language || (place == 0 && pot.first_language >= options.languages->size()))
            add_text("index.html", page);
    }
}

void PageFolder::add_note(const KeptNote& note) {
    add_text(std::string(kNoteName), written(note));
}

Result<void> PageFolder::add_twins() {
    std::map<std::string, Bytes, std::less<>> twins;
    for (const auto& [name, bytes] : files_) {
        const auto known = page_file(name);
        if (!known || !known->has_twin) continue;
        auto packed = files::gzip(bytes);
        if (!packed) return packed.error();
        if (packed->size() < bytes.size()) twins[name + std::string(kTwinEnding)] = std::move(*packed);
    }
    files_.merge(twins);
    return {};
}

std::uint64_t PageFolder::bytes() const {
    std::uint64_t sum = 0;
    for (const auto& [name, bytes] : files_)
        sum += bytes.size();
    return sum;
}

Result<void> PageFolder::write(const std::filesystem::path& folder) const {
    for (const bool pages : {false, true}) {
        for (const auto& [name, bytes] : files_) {
            if ((name.find(".html") != std::string::npos) != pages) continue;
            if (auto written = files::write_file_atomically(folder / name, bytes); !written) return written;
        }
    }
    return {};
}

}  // namespace onggi::sharing
