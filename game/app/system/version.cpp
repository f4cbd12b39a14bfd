#include "game/app/system/version.h"

#include <fmt/format.h>

#include "commit.h"  // written while building

namespace onggi::app {

std::string version() {
    return fmt::format("{} ({}, {})", ONGGI_VERSION, kCommit, kCommitDay);
}

std::string commit_day() {
    return kCommitDay;
}

}  // namespace onggi::app
