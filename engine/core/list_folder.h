// Lists a folder, or as many entries as the system returns. The standard's directory_iterator throws if a
// disk fails in the middle of a folder, which ends the program under noexcept; this does not. Any thread but
// the haptic one; blocks.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "engine/core/quote.h"

namespace onggi {

struct FolderListing {
    std::vector<std::filesystem::path> entries;  // full paths, in no order
    std::error_code error;                       // set if the list may be incomplete

    [[nodiscard]] bool is_whole() const { return !error; }
};

// A missing folder yields an empty list without an error.
[[nodiscard]] inline FolderListing list_folder(const std::filesystem::path& folder) {
    FolderListing listing;
    std::filesystem::directory_iterator entry(folder, listing.error);
    for (const std::filesystem::directory_iterator end; !listing.error && entry != end;
         entry.increment(listing.error))
        listing.entries.push_back(entry->path());
    if (listing.error == std::errc::no_such_file_or_directory && listing.entries.empty())
        listing.error.clear();
    return listing;
}

// The one-line message for an incomplete listing.
[[nodiscard]] inline std::string listing_trouble(const std::filesystem::path& folder,
                                                 const FolderListing& listing) {
    return shown_path(folder.native()) +
           ": expected to list all that is in this folder, found: " + listing.error.message();
}

}  // namespace onggi
