#include "game/sharing/outbox.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "engine/core/list_folder.h"
#include "engine/core/quote.h"
#include "engine/files/atomic_file.h"
#include "engine/files/atomic_folder.h"
#include "engine/files/read_file.h"
#include "game/sharing/kept_note.h"
#include "game/sharing/page_files.h"
#include "game/sharing/page_folder.h"
#include "game/sharing/phone_page.h"

namespace onggi::sharing {
namespace {

namespace fs = std::filesystem;

std::uint64_t bytes_in(const fs::path& folder) {
    std::uint64_t sum = 0;
    for (const fs::path& file : list_folder(folder).entries) {
        std::error_code error;
        const std::uintmax_t size = fs::file_size(file, error);
        if (!error) sum += size;
    }
    return sum;
}

// Writes the file only if its content differs, to avoid disk wear at every start.
Result<void> lay_down(const fs::path& file, std::string_view text) {
    const auto there = files::read_file(file, text.size() + 1);
    if (there && *there == text) return {};
    return files::write_file_atomically(file, text);
}

// Builds the content of this code's folder.
Result<PageFolder> filled(const SharedPot& pot, const OutboxOptions& options, const ShareCode& code,
                          const ShareTime& time) {
    auto files = PageFolder::of(pot);
    if (!files) return files;
    files->add_pages(pot, options, code, time);
    files->add_note({time.now_s, time.expires_s, pot.gallery_name});
    if (auto packed = files->add_twins(); !packed) return packed.error();
    if (files->bytes() > options.most_bytes) {
        return bad_input(fmt::format("the shared pot: expected {} bytes at most, found {}",
                                     options.most_bytes, files->bytes()));
    }
    return files;
}

}  // namespace

Result<Outbox> Outbox::open(OutboxOptions options) {
    std::error_code error;
    fs::create_directories(options.folder, error);
    if (error || !fs::is_directory(options.folder, error)) {
        const std::string found = error ? error.message() : "something else";
        return Error{error ? ErrorKind::kSystemLacks : ErrorKind::kBadInput,
                     fmt::format("{}: expected a folder for shared pots, found {}",
                                 shown_path(options.folder.native()), found)};
    }
    if (!options.languages || options.languages->empty())
        return bad_input("the outbox: expected a language for its pages, found none");
    files::clear_parts(options.folder);
    // A process killed during renew() may have left parts in a pot's folder.
    for (const fs::path& entry : list_folder(options.folder).entries) {
        if (ShareCode::read_exactly(entry.filename().native())) files::clear_parts(entry);
    }
    Outbox outbox(std::move(options));
    const fs::path& folder = outbox.options_.folder;
    const auto& languages = *outbox.options_.languages;
    const std::pair<const char*, std::string> door[] = {{"index.html", ask_page(languages, 0)},
                                                        {"404.html", lost_page(languages, 0)},
                                                        {"code.js", std::string(ask_script())},
                                                        {"robots.txt", "User-agent: *\nDisallow: /\n"}};
    for (const auto& [name, text] : door)
        if (auto laid = lay_down(folder / name, text); !laid) return laid.error();
    return outbox;
}

Result<ShareCode> Outbox::put(const SharedPot& pot, const ShareTime& time) {
    if (time.expires_s <= time.now_s)
        return bad_input("the shared pot: expected an expiry time in the future, found one in the past");
    static_cast<void>(expire(time.now_s));  // one that cannot be removed is no reason to refuse another
    for (int tries = 0; tries < 8; ++tries) {
        const auto code = ShareCode::by_chance();
        if (!code) return code.error();
        std::error_code error;
        if (fs::exists(place_of(*code), error)) continue;  // a collision, once in 2^40
        const auto files = filled(pot, options_, *code, time);
        if (!files) return files.error();
        auto folder = files::AtomicFolder::create(place_of(*code));
        if (!folder) return folder.error();
        if (auto written = files->write(folder->inside()); !written) return written.error();
        if (auto done = folder->commit(); !done) return done.error();
        if (auto room = make_room(*code, time.now_s); !room) {
            static_cast<void>(withdraw(*code));
            return room.error();
        }
        return *code;
    }
    return failed("the shared pot: found no unused code");
}

Result<bool> Outbox::renew(const ShareCode& code, const SharedPot& pot, const ShareTime& time) {
    std::error_code error;
    if (!fs::exists(place_of(code), error)) return false;
    const auto files = filled(pot, options_, code, time);
    if (!files) return files.error();
    if (auto written = files->write(place_of(code)); !written) return written.error();
    if (auto room = make_room(code, time.now_s); !room) return room.error();
    return true;
}

// Called after the new pot is on disk: a failed put() removes no other pot. Pots dated in the future were
// shared before the clock was set back, so they are older than the others.
Result<void> Outbox::make_room(const ShareCode& newcomer, std::int64_t now_s) {
    auto all = list();
    if (!all) return all.error();
    std::stable_partition(all->begin(), all->end(),
                          [&](const OutboxEntry& entry) { return entry.made_s > now_s; });
    std::uint64_t bytes = 0;
    for (const OutboxEntry& entry : *all)
        bytes += entry.bytes;
    std::size_t pots = all->size();
    Result<void> trouble;
    for (const OutboxEntry& entry : *all) {
        if (pots <= options_.most_pots && bytes <= options_.most_bytes) return {};
        if (entry.code == newcomer) continue;
        if (auto gone = withdraw(entry.code); !gone) {
            trouble = gone.error();
            continue;
        }
        bytes -= entry.bytes;
        --pots;
    }
    return pots <= options_.most_pots && bytes <= options_.most_bytes ? Result<void>{} : trouble;
}

Result<bool> Outbox::withdraw(const ShareCode& code) {
    std::error_code error;
    if (!fs::exists(place_of(code), error)) return false;
    if (auto gone = files::take_away_folder(place_of(code)); !gone) return gone.error();
    return true;
}

Result<bool> Outbox::withdraw_named(const std::string& gallery_name) {
    auto all = list();
    if (!all) return all.error();
    bool found = false;
    for (const OutboxEntry& entry : *all) {
        if (gallery_name.empty() || entry.gallery_name != gallery_name) continue;
        if (auto gone = withdraw(entry.code); !gone) return gone.error();
        found = true;
    }
    return found;
}

Result<int> Outbox::expire(std::int64_t now_s) {
    const FolderListing listing = list_folder(options_.folder);
    if (!listing.is_whole()) return system_lacks(listing_trouble(options_.folder, listing));
    int gone = 0;
    Result<void> trouble;
    for (const fs::path& entry : listing.entries) {
        const auto code = ShareCode::read_exactly(entry.filename().native());
        if (!code) continue;
        const auto text = files::read_file(entry / kNoteName, kMostNoteBytes);
        // A read error of the note is no reason to delete the pot.
        if (!text && text.error().kind != ErrorKind::kBadInput) continue;
        const auto note = text ? read_note(*text) : std::nullopt;
        if (note && !is_over(*note, now_s)) {
            const auto later = redated(*note, now_s);
            const auto noted =
                later ? files::write_file_atomically(entry / kNoteName, written(*later)) : Result<void>{};
            if (!noted) trouble = noted;
        } else if (auto taken = files::take_away_folder(entry); !taken) {
            trouble = taken;
        } else {
            ++gone;
        }
    }
    if (!trouble) return trouble.error();
    return gone;
}

Result<std::vector<OutboxEntry>> Outbox::list() const {
    const FolderListing listing = list_folder(options_.folder);
    if (!listing.is_whole()) return system_lacks(listing_trouble(options_.folder, listing));
    std::vector<OutboxEntry> entries;
    for (const fs::path& entry : listing.entries) {
        const auto code = ShareCode::read_exactly(entry.filename().native());
        const auto text = files::read_file(entry / kNoteName, kMostNoteBytes);
        if (!code || !text) continue;
        if (const auto note = read_note(*text))
            entries.push_back({*code, note->made_s, note->expires_s, note->gallery_name, bytes_in(entry)});
    }
    std::sort(entries.begin(), entries.end(), [](const OutboxEntry& a, const OutboxEntry& b) {
        return std::pair(a.made_s, a.code) < std::pair(b.made_s, b.code);
    });
    return entries;
}

}  // namespace onggi::sharing
