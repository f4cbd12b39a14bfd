#include "game/app/kiosk/gallery/moving_house.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/list_folder.h"
#include "engine/core/quote.h"
#include "engine/files/atomic_file.h"
#include "engine/files/atomic_folder.h"
#include "engine/files/read_file.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/gallery/visit_journal.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/record/session.h"
#include "game/sharing/kept_note.h"
#include "game/sharing/share_code.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kArchiveFormat = 1;
constexpr std::string_view kListName = "onggi-gallery.json";
constexpr std::size_t kMostListBytes = 4096;
constexpr std::size_t kMostNameBytes = 100;
constexpr std::string_view kSessionEnding = ".onggi";
constexpr std::string_view kSession = "pot.onggi";
constexpr std::string_view kNote = ".kept";
// The folders of an archive, and of a staged import.
constexpr std::string_view kPots = "pots";
constexpr std::string_view kStatistics = "statistics";
constexpr std::string_view kPages = "shared";

// The folders that move.
struct House {
    fs::path gallery;
    fs::path statistics;
    fs::path outbox;  // empty: nothing is shared
};

House house_of(const kiosk::Config& config) {
    return {.gallery = config.gallery.folder,
            .statistics = statistics_folder(config),
            .outbox = kiosk::shares(config) ? config.sharing.outbox : std::string()};
}

fs::path staged_folder(const House& house) {
    return house.gallery / "import";
}

bool is_day(std::string_view name) {
    constexpr std::string_view kForm = "0000-00-00";
    return std::equal(name.begin(), name.end(), kForm.begin(), kForm.end(), [](char letter, char form) {
        return form == '-' ? letter == '-' : letter >= '0' && letter <= '9';
    });
}

// Letters, digits, dots, dashes: a name that leads nowhere else. Hidden files are temporary, but for a note.
bool is_file(std::string_view name) {
    return !name.empty() && name.size() <= kMostNameBytes && !name.ends_with(".part") &&
           (name.front() != '.' || name == kNote) && std::all_of(name.begin(), name.end(), [](char letter) {
               return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z') ||
                      (letter >= 'A' && letter <= 'Z') || letter == '.' || letter == '-' || letter == '_';
           });
}

Result<void> check_name(std::string_view name, const std::string& where) {
    std::vector<std::string> parts(1);
    for (const char letter : name)
        letter == '/' ? static_cast<void>(parts.emplace_back()) : parts.back().push_back(letter);
    const bool is_pots = parts.size() == 4 && parts[0] == kPots && is_day(parts[1]) &&
                         pot_number(parts[2]) > 0 && is_file(parts[2]) && is_file(parts[3]);
    const bool is_table = parts.size() == 2 && parts[0] == kStatistics && is_file(parts[1]);
    const bool is_page = parts.size() == 3 && parts[0] == kPages &&
                         sharing::ShareCode::read_exactly(parts[1]) && is_file(parts[2]);
    if (is_pots || is_table || is_page) return {};
    return bad_input(fmt::format("{}: expected {}/DAY/pot-N/FILE, {}/FILE or {}/CODE/FILE, found {}", where,
                                 kPots, kStatistics, kPages, in_quotes(name, kMostNameBytes)));
}

// A session is checked as a whole, with all its checksums; other files by the archive's own.
Result<void> check_file(std::string_view name, std::string bytes, const std::string& where) {
    if (!name.ends_with(kSessionEnding)) return {};
    const std::string place = where + ", " + std::string(name);
    const auto session = record::parse_session(std::move(bytes), place);
    if (!session) return session.error();
    if (session->is_complete()) return {};
    return bad_input(fmt::format("{}: expected a whole session, found it cut", place));
}

struct Content {
    struct File {
        std::string name;  // in the archive
        fs::path place;
    };
    std::vector<File> files;
    std::uint64_t bytes = 0;
    Moved moved;
};

Result<void> add_folder(Content& content, const fs::path& folder, const std::string& prefix) {
    FolderListing listing = list_folder(folder);
    if (!listing.is_whole()) return system_lacks(listing_trouble(folder, listing));
    std::sort(listing.entries.begin(), listing.entries.end());
    for (const fs::path& entry : listing.entries) {
        const std::string name = entry.filename().string();
        std::error_code error;
        if (!fs::is_regular_file(entry, error) || !is_file(name)) continue;
        content.bytes += fs::file_size(entry, error);
        content.files.push_back({fmt::format("{}/{}", prefix, name), entry});
    }
    return {};
}

Result<Content> content_of(const House& house) {
    Content content;
    std::string trouble;
    std::vector<KeptPot> pots = kept_pots(house.gallery, &trouble);
    if (!trouble.empty()) return system_lacks(std::move(trouble));
    std::reverse(pots.begin(), pots.end());
    for (const KeptPot& pot : pots) {
        if (pot.folder.extension() == ".part") continue;
        if (auto added = add_folder(content, pot.folder, fmt::format("{}/{}", kPots, pot.name)); !added)
            return added.error();
    }
    content.moved.pots = pots.size();
    if (auto added = add_folder(content, house.statistics, std::string(kStatistics)); !added)
        return added.error();
    if (house.outbox.empty()) return content;
    FolderListing pages = list_folder(house.outbox);
    if (!pages.is_whole()) return system_lacks(listing_trouble(house.outbox, pages));
    std::sort(pages.entries.begin(), pages.entries.end());
    for (const fs::path& page : pages.entries) {
        const std::string code = page.filename().string();
        if (!sharing::ShareCode::read_exactly(code)) continue;
        if (auto added = add_folder(content, page, fmt::format("{}/{}", kPages, code)); !added)
            return added.error();
        ++content.moved.pages;
    }
    return content;
}

// The archive's first file.
struct List {
    std::size_t pots = 0;
    std::uint64_t files = 0;
    std::uint64_t bytes = 0;
};

Result<List> read_list(files::ArchiveReader& archive, const std::string& where) {
    const auto name = archive.next();
    if (!name) return name.error();
    if (*name != std::optional(std::string(kListName))) {
        return bad_input(
            fmt::format("{}: expected an archive by onggi gallery export, which begins with {}, found {}",
                        where, kListName, *name ? in_quotes(**name) : "nothing"));
    }
    const auto text = archive.read(kMostListBytes);
    if (!text) return text.error();
    const json list = json::parse(*text, nullptr, false);
    const auto number = [&](const char* key) {
        const auto found = list.is_object() ? list.find(key) : list.end();
        return found != list.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
    };
    const std::uint64_t format = number("format");
    if (format > kArchiveFormat) {
        return bad_input(fmt::format("{}, {}: expected format {}, found {}: upgrade this program first",
                                     where, kListName, kArchiveFormat, format));
    }
    if (format == 0)
        return bad_input(
            fmt::format("{}, {}: expected format {}, found none", where, kListName, kArchiveFormat));
    return List{.pots = number("pots"), .files = number("files"), .bytes = number("bytes")};
}

// Every file is written with its folder synced; the staged folder's commit() syncs the folders above.
Result<void> unpack(files::ArchiveReader& archive, const List& list, const fs::path& into,
                    const std::string& where, const Reached& reached) {
    std::uint64_t bytes = 0;
    for (std::uint64_t done = 0;; ++done) {
        const auto name = archive.next();
        if (!name) return name.error();
        if (done == list.files || !*name) {
            if (done == list.files && !*name && bytes == list.bytes) return {};
            return bad_input(fmt::format("{}: expected {} files with {} bytes, as its {} says, found {}",
                                         where, list.files, list.bytes, kListName,
                                         *name ? "more" : fmt::format("{} with {}", done, bytes)));
        }
        if (auto good = check_name(**name, where); !good) return good;
        auto content = archive.read(std::min<std::uint64_t>(list.bytes - bytes, kMostSessionBytes));
        if (!content) return content.error();
        bytes += content->size();
        const fs::path place = into / **name;
        std::error_code error;
        if (fs::exists(place, error))
            return bad_input(fmt::format("{}: expected each file once, found two {}", where, **name));
        fs::create_directories(place.parent_path(), error);
        if (auto written = files::write_file_atomically(place, *content); !written) return written;
        if (auto good = check_file(**name, std::move(*content), where); !good) return good;
        reached(done + 1, list.files);
    }
}

bool have_same_session(const fs::path& one, const fs::path& other) {
    std::error_code error;
    if (fs::file_size(one / kSession, error) != fs::file_size(other / kSession, error) || error) return false;
    const auto first = files::read_file(one / kSession, kMostSessionBytes);
    const auto second = files::read_file(other / kSession, kMostSessionBytes);
    return first && second && *first == *second;
}

using NewNames = std::map<std::string, std::string>;  // of pots that were renumbered

// Drops the staged pots that the gallery has, and renumbers those whose number it has given to another pot.
Result<NewNames> sift_pots(const fs::path& staged, const fs::path& gallery, Moved& moved) {
    NewNames names;
    std::string trouble;
    for (const KeptPot& pot : kept_pots(staged, &trouble)) {
        const std::string day = pot.folder.parent_path().filename().string();
        std::error_code error;
        if (!fs::exists(pot.folder / kSession, error))
            return bad_input(
                fmt::format("{}: expected a {} in every pot, found none in {}", kPots, kSession, pot.name));
        const FolderListing there = list_folder(gallery / day);
        if (!there.is_whole()) return system_lacks(listing_trouble(gallery / day, there));
        const bool is_there =
            std::any_of(there.entries.begin(), there.entries.end(), [&](const fs::path& other) {
                return pot_number(other.filename().string()) > 0 && have_same_session(pot.folder, other);
            });
        if (is_there) {
            fs::remove_all(pot.folder, error);
            ++moved.pots_there;
        } else {
            ++moved.pots;
            if (!fs::exists(gallery / pot.name, error)) continue;
            const int number =
                std::max(next_pot_number(gallery / day), next_pot_number(pot.folder.parent_path()));
            const std::string name = fmt::format("{}/pot-{:03}", day, number);
            fs::rename(pot.folder, staged / name, error);
            names[pot.name] = name;
        }
        if (error)
            return system_lacks(fmt::format("{}: {}", shown_path(pot.folder.native()), error.message()));
    }
    return trouble.empty() ? Result<NewNames>(std::move(names)) : system_lacks(std::move(trouble));
}

// Drops the staged pages that have expired or are there, and tells the others the new names of their pots.
Result<void> sift_pages(const fs::path& staged, const fs::path& outbox, const NewNames& names,
                        std::int64_t now_s, Moved& moved) {
    for (const fs::path& page : list_folder(staged).entries) {
        const auto text = files::read_file(page / kNote, sharing::kMostNoteBytes);
        auto note = text ? sharing::read_note(*text) : std::nullopt;
        std::error_code error;
        const bool stays = note && !sharing::is_over(*note, now_s) && !outbox.empty() &&
                           !fs::exists(outbox / page.filename(), error);
        if (!stays) {
            fs::remove_all(page, error);
            continue;
        }
        ++moved.pages;
        const auto renamed = names.find(note->gallery_name);
        if (renamed == names.end()) continue;
        note->gallery_name = renamed->second;
        if (auto written = files::write_file_atomically(page / kNote, sharing::written(*note)); !written)
            return written;
    }
    return {};
}

struct Table {
    std::string header;
    std::vector<std::string> lines;

    // Of the older version where there are two: the reader takes lines of as many cells, and of the present
    // number.
    [[nodiscard]] std::string older_header(const Table& other) const {
        const auto cells = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
        return cells(other.header) < cells(header) ? other.header : header;
    }
};

constexpr std::size_t kMostTableBytes = std::size_t{64} << 20U;

Result<Table> read_table(const fs::path& file) {
    const auto text = files::read_file(file, kMostTableBytes);
    if (!text) return text.error();
    Table table;
    for (std::string_view rest = *text; !rest.empty();) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string line(rest.substr(0, end));
        table.header.empty() ? table.header = line : table.lines.emplace_back(line);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return table;
}

std::string day_of_line(const std::string& line) {
    return line.substr(0, line.find(','));
}

// The lines of all tables by day, each with its table's name in front.
using Days = std::map<std::string, std::multiset<std::string>>;
using Tables = std::map<std::string, Table>;

std::string keyed_line(const std::string& table, const std::string& line) {
    return table + '\n' + line;
}

Days days_of(const Tables& tables) {
    Days days;
    for (const auto& [name, table] : tables)
        for (const std::string& line : table.lines)
            days[day_of_line(line)].insert(keyed_line(name, line));
    return days;
}

// What is missing here of each day there. A day of which all lines are here was counted here already. Where
// all lines of here are there, here is an earlier part of the same day. Otherwise two machines counted that
// day, and both count.
Days missing_of(const Tables& here, const Tables& there) {
    const Days known = days_of(here);
    Days missing;
    for (auto& [day, lines] : days_of(there)) {
        const auto found = known.find(day);
        const auto mine = found != known.end() ? found->second : std::multiset<std::string>();
        if (std::includes(mine.begin(), mine.end(), lines.begin(), lines.end())) continue;
        auto& more = missing[day];
        if (std::includes(lines.begin(), lines.end(), mine.begin(), mine.end())) {
            std::set_difference(lines.begin(), lines.end(), mine.begin(), mine.end(),
                                std::inserter(more, more.end()));
        } else {
            more = lines;
        }
    }
    return missing;
}

// Makes of the staged tables those that the kiosk shall have, and drops those that bring nothing.
Result<void> merge_statistics(const fs::path& staged, const fs::path& here, Moved& moved) {
    Tables mine;
    Tables theirs;
    for (const fs::path& file : list_folder(staged).entries) {
        std::error_code error;
        const std::string name = file.filename().string();
        const bool is_there = fs::exists(here / name, error);
        if (file.extension() != ".csv") {
            if (is_there) fs::remove(file, error);  // the staff's settings of this machine count
            continue;
        }
        auto table = read_table(file);
        if (!table) return table.error();
        theirs[name] = std::move(*table);
        if (!is_there) continue;
        auto own = read_table(here / name);
        if (!own) return own.error();
        mine[name] = std::move(*own);
    }
    Days missing = missing_of(mine, theirs);
    moved.days = missing.size();
    for (auto& [name, table] : theirs) {
        const auto own = mine.find(name);
        if (own == mine.end()) continue;
        Table merged{.header = table.older_header(own->second), .lines = own->second.lines};
        for (const std::string& line : table.lines) {
            auto& lines = missing[day_of_line(line)];
            const auto found = lines.find(keyed_line(name, line));
            if (found == lines.end()) continue;
            lines.erase(found);
            merged.lines.push_back(line);
        }
        std::error_code error;
        if (merged.lines.size() == own->second.lines.size()) {
            fs::remove(staged / name, error);
            continue;
        }
        constexpr std::size_t kDayAndHour = std::string_view("2026-11-21,14").size();
        std::stable_sort(merged.lines.begin(), merged.lines.end(),
                         [](const std::string& one, const std::string& other) {
                             return one.compare(0, kDayAndHour, other, 0, kDayAndHour) < 0;
                         });
        const std::string text = fmt::format("{}\n{}\n", merged.header, fmt::join(merged.lines, "\n"));
        if (auto written = files::write_file_atomically(staged / name, text); !written) return written;
    }
    return {};
}

Result<void> check_most_pots(const House& house, const kiosk::Config& config, std::size_t more) {
    std::string trouble;
    const std::size_t here = kept_pots(house.gallery, &trouble).size();
    if (!trouble.empty()) return system_lacks(std::move(trouble));
    if (more == 0 || here + more <= static_cast<std::size_t>(config.gallery.most_pots)) return {};
    return bad_input(
        fmt::format("{}: expected room for {} pots beside {}, found most_pots = {} in [gallery]: "
                    "the next visitor's pot would delete the oldest",
                    shown_path(house.gallery.native()), more, here, config.gallery.most_pots));
}

}  // namespace

Result<Moved> export_gallery(const kiosk::Config& config, const fs::path& destination,
                             const Reached& reached) {
    const House house = house_of(config);
    const auto content = content_of(house);
    if (!content) return content.error();
    auto archive = files::ArchiveWriter::create(destination);
    if (!archive) return archive.error();
    const json list = {{"format", kArchiveFormat},
                       {"pots", content->moved.pots},
                       {"files", content->files.size()},
                       {"bytes", content->bytes}};
    if (auto added = archive->add(std::string(kListName), list.dump(2) + "\n"); !added) return added.error();
    std::uint64_t bytes = 0;
    for (std::size_t done = 0; done < content->files.size(); ++done) {
        const Content::File& file = content->files[done];
        if (auto good = check_name(file.name, shown_path(house.gallery.native())); !good) return good.error();
        auto text = files::read_file(file.place, kMostSessionBytes);
        if (!text) return text.error();
        bytes += text->size();
        if (auto added = archive->add(file.name, *text); !added) return added.error();
        if (auto good = check_file(file.name, std::move(*text), shown_path(house.gallery.native())); !good)
            return good.error();
        reached(done + 1, content->files.size());
    }
    if (bytes != content->bytes)
        return failed(fmt::format("{}: expected {} bytes, found {}: the gallery changed meanwhile",
                                  shown_path(house.gallery.native()), content->bytes, bytes));
    if (auto done = archive->commit(); !done) return done.error();
    return content->moved;
}

Result<Moved> import_gallery(files::ArchiveReader archive, const kiosk::Config& config, std::int64_t now_s,
                             const Reached& reached) {
    if (auto finished = finish_import(config); !finished) return finished.error();
    const House house = house_of(config);
    const std::string where = shown_path(archive.file().native());
    const auto list = read_list(archive, where);
    if (!list) return list.error();
    auto staged = files::AtomicFolder::create(staged_folder(house));
    if (!staged) return staged.error();
    const double needed_mb = static_cast<double>(list->bytes) / kiosk::kBytesPerMb;
    const Gallery gallery(config);
    if (auto room = gallery.expect_free(needed_mb); !room) return room.error();
    const fs::path& inside = staged->inside();
    if (auto done = unpack(archive, *list, inside, where, reached); !done) return done.error();
    Moved moved;
    const auto names = sift_pots(inside / kPots, house.gallery, moved);
    if (!names) return names.error();
    if (moved.pots + moved.pots_there != list->pots)
        return bad_input(fmt::format("{}: expected {} pots, as its {} says, found {}", where, list->pots,
                                     kListName, moved.pots + moved.pots_there));
    if (auto room = check_most_pots(house, config, moved.pots); !room) return room.error();
    if (auto done = merge_statistics(inside / kStatistics, house.statistics, moved); !done)
        return done.error();
    if (auto done = sift_pages(inside / kPages, house.outbox, *names, now_s, moved); !done)
        return done.error();
    if (auto done = staged->commit(); !done) return done.error();
    if (auto finished = finish_import(config); !finished) return finished.error();
    return moved;
}

// Tables come first: a kiosk that starts before the rest could come in appends to what stays.
Result<void> finish_import(const kiosk::Config& config) {
    const House house = house_of(config);
    const fs::path staged = staged_folder(house);
    std::error_code error;
    if (!fs::exists(staged, error)) return {};
    for (const fs::path& file : list_folder(staged / kStatistics).entries)
        if (auto done = files::move_into_place(file, house.statistics / file.filename()); !done) return done;
    for (const KeptPot& pot : kept_pots(staged / kPots)) {
        fs::path place = house.gallery / pot.name;
        if (fs::exists(place, error))
            place = place.parent_path() / fmt::format("pot-{:03}", next_pot_number(place.parent_path()));
        if (auto done = files::move_into_place(pot.folder, place); !done) return done;
    }
    for (const fs::path& page : list_folder(staged / kPages).entries) {
        const fs::path place = house.outbox / page.filename();
        if (house.outbox.empty() || fs::exists(place, error)) continue;
        if (auto done = files::move_into_place(page, place); !done) return done;
    }
    return files::take_away_folder(staged);
}

}  // namespace onggi::app
