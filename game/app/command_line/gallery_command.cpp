#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/core/quote.h"
#include "game/app/command_line/commands.h"
#include "game/app/command_line/options.h"
#include "game/app/command_line/progress.h"
#include "game/app/kiosk/gallery/moving_house.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/system/report.h"
#include "game/app/system/start_log.h"
#include "game/app/system/wall_clock.h"

namespace onggi::app {
namespace {

struct GalleryOptions {
    std::string way;
    std::string archive;
    GalleryChoice gallery;
};

// Root becomes the gallery's owner while it writes there, so that the kiosk may append to, and delete, what
// it finds. A gallery that is not there yet has the owner of the folder around it.
class AsOwner {
  public:
    explicit AsOwner(std::filesystem::path folder) {
        struct stat status {};
        while (::stat(folder.c_str(), &status) != 0 && folder.has_parent_path() &&
               folder != folder.parent_path())
            folder = folder.parent_path();
        if (::geteuid() != 0 || ::stat(folder.c_str(), &status) != 0) return;
        // Refused in a container that maps root alone: there the files are root's, as all others.
        is_other_ = ::setegid(status.st_gid) == 0 && ::seteuid(status.st_uid) == 0;
    }
    AsOwner(const AsOwner&) = delete;
    AsOwner& operator=(const AsOwner&) = delete;
    ~AsOwner() {
        if (is_other_) static_cast<void>(::seteuid(0) == 0 && ::setegid(::getgid()) == 0);
    }

  private:
    bool is_other_ = false;
};

std::string counted(std::size_t number, const char* one, const char* many) {
    return fmt::format("{} {}", number, number == 1 ? one : many);
}

Result<std::string> move_house(const GalleryOptions& options) {
    const auto config = settings_of(options.gallery);
    if (!config) return config.error();
    const std::filesystem::path gallery = config->gallery.folder;
    const bool is_export = options.way == "export";
    std::error_code error;
    if (is_export && !std::filesystem::is_directory(gallery, error))
        return bad_input(fmt::format("{}: expected a gallery, found none", shown_path(gallery.native())));
    GalleryLock lock;
    {
        const AsOwner owner(gallery);
        if (auto taken = lock.take(state_folder(gallery)); !taken) return taken.error();
        if (auto finished = finish_import(*config); !finished) return finished.error();
    }
    Progress progress(is_export ? "exporting" : "importing", 100);
    const Reached reached = [&](std::uint64_t done, std::uint64_t of) {
        progress.reached_rarely(done * 100 / of);
    };
    if (is_export) {
        const auto moved = export_gallery(*config, options.archive, reached);
        if (!moved) return moved.error();
        return fmt::format("{}: {} and {}, with the statistics\n", shown_path(options.archive),
                           counted(moved->pots, "pot", "pots"), counted(moved->pages, "page", "pages"));
    }
    // Opened before: the archive may be for root alone.
    auto archive = files::ArchiveReader::open(options.archive);
    if (!archive) return archive.error();
    const AsOwner owner(gallery);
    const auto moved = import_gallery(std::move(*archive), *config, wall_clock_s(), reached);
    if (!moved) return moved.error();
    return fmt::format("{}: {} new, {} there already; {}; statistics of {}\n", shown_path(options.archive),
                       counted(moved->pots, "pot", "pots"), moved->pots_there,
                       counted(moved->pages, "page", "pages"), counted(moved->days, "day", "days"));
}

}  // namespace

void add_gallery_command(CLI::App& program, int& exit_status) {
    CLI::App* command = program.add_subcommand(
        "gallery", "Take a kiosk's pots, pages and statistics to another machine, as one archive");
    const auto options = std::make_shared<GalleryOptions>();
    add_word_option(*command, "way", {"export", "import"}, options->way,
                    "write the archive, or bring in what one holds")
        ->required();
    command->add_option("archive", options->archive, "a ZIP file")->type_name("ARCHIVE.zip")->required();
    add_gallery_options(*command, options->gallery);
    command->footer(
        "Stop the kiosk first. All or nothing comes in; pots that are there already are left alone. "
        "Settings, "
        "the pot on\nthe wheel and the wall of the day do not move.");
    command->callback([options, &exit_status] {
        const auto said = move_house(*options);
        const bool is_told = said && std::fputs(said->c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
        exit_status =
            is_told ? 0 : report(said ? system_lacks("standard output cannot be written") : said.error());
    });
}

}  // namespace onggi::app
