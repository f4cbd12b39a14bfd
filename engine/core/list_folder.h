// What lies in a folder, or as much of it as the system tells. A range-for over the standard's iterator
// throws where a disk fails in the middle of a folder, which under noexcept is the end of the program; this
// never does. Any thread but the haptic one; blocks.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "engine/core/quote.h"

namespace onggi {

struct FolderListing {
    std::vector<std::filesystem::path> entries;  // with the folder's own path before them, in no order
    std::error_code error;                       // why there may be more than these

    [[nodiscard]] bool is_whole() const { return !error; }
};

// A folder that is not there has nothing in it, which is no error.
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

// The one line that says so, of a listing that is not whole.
[[nodiscard]] inline std::string listing_trouble(const std::filesystem::path& folder,
                                                 const FolderListing& listing) {
    return shown_path(folder.native()) +
           ": expected to list all that is in this folder, found: " + listing.error.message();
}

}  // namespace onggi
