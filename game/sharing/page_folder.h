// The content of a shared pot's folder, built in memory and then written: pages, style, files, their
// compressed twins, the note. Internal to the outbox. Any thread but the haptic one; write() blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/sharing/kept_note.h"
#include "game/sharing/outbox.h"

namespace onggi::sharing {

class PageFolder {
  public:
    // Reads the pot's files. Bad input: a file that cannot be read, or a picture in an unknown format.
    [[nodiscard]] static Result<PageFolder> of(const SharedPot& pot);

    // Adds the pages, and the files that are the same for every pot.
    void add_pages(const SharedPot& pot, const OutboxOptions& options, const ShareCode& code,
                   const ShareTime& time);
    void add_note(const KeptNote& note);
    Result<void> add_twins();

    [[nodiscard]] std::uint64_t bytes() const;
    // Writes the pages last, so that no page links to a missing file.
    Result<void> write(const std::filesystem::path& folder) const;

  private:
    using Bytes = std::vector<std::byte>;
    Result<void> add(const FileContent& content, const std::string& name);
    // Adds NAME.png, .jpg or .webp. Returns the full name.
    Result<std::string> add_picture(const FileContent& content, const std::string& name);
    void add_text(const std::string& name, std::string_view text);

    std::map<std::string, Bytes, std::less<>> files_;
    std::string poster_;
    std::string picture_;
    std::string surface_;
    std::string still_;
};

// The expiry time as on the page: "18:00" for a time on the same local day, "24:00" for its end; else
// "2026-11-25, 18:00".
struct GoneAt {
    std::string text;
    bool is_today = false;
};
[[nodiscard]] GoneAt gone_at(const ShareTime& time);

}  // namespace onggi::sharing
