#include "game/app/sharing/confinement.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>

#include "engine/core/quote.h"

namespace onggi::app {
namespace {

// All rights of Landlock's first version, which every kernel with Landlock accepts.
constexpr std::uint64_t kEverything =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_READ_FILE |
    LANDLOCK_ACCESS_FS_READ_DIR | LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
    LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
    LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK |
    LANDLOCK_ACCESS_FS_MAKE_SYM;

Error refused(std::string_view what) {
    return system_lacks(
        fmt::format("sharing: expected {}, found: {}", what, std::generic_category().message(errno)));
}

Result<void> allow(int rules, const std::filesystem::path& place, std::uint64_t access) {
    landlock_path_beneath_attr rule{};
    rule.allowed_access = access;
    rule.parent_fd = ::open(place.c_str(), O_PATH | O_CLOEXEC);
    if (rule.parent_fd < 0) return refused("to find " + shown_path(place.native()));
    const long added = ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
    const Error error = refused("to get access to " + shown_path(place.native()));
    ::close(rule.parent_fd);
    if (added != 0) return error;
    return {};
}

}  // namespace

Result<bool> confine_to(const std::filesystem::path& readable, const std::filesystem::path& writable) {
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return refused("to give up new privileges");
    landlock_ruleset_attr attributes{};
    attributes.handled_access_fs = kEverything;
    const int rules =
        static_cast<int>(::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0));
    if (rules < 0) return false;
    Result<void> allowed = allow(rules, readable, LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR);
    if (allowed && !writable.empty()) allowed = allow(rules, writable, LANDLOCK_ACCESS_FS_WRITE_FILE);
    if (allowed && ::syscall(SYS_landlock_restrict_self, rules, 0) != 0)
        allowed = refused("to confine the process");
    ::close(rules);
    if (!allowed) return allowed.error();
    return true;
}

}  // namespace onggi::app
