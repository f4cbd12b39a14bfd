#include "engine/files/append_line.h"

#include <fcntl.h>
#include <unistd.h>

#include <string>

#include "engine/files/file_errors.h"

namespace onggi::files {
namespace {

constexpr mode_t kTableMode = 0666;  // minus the umask

// Returns 0 or an errno.
int write_all(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

bool ends_in_a_line(int descriptor, off_t size) {
    char last = '\0';
    return size > 0 && ::pread(descriptor, &last, 1, size - 1) == 1 && last == '\n';
}

int append(int descriptor, std::string_view first_line, std::string_view line) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) return errno;
    off_t size = status.st_size;
    const bool is_whole = ends_in_a_line(descriptor, size);
    if (!is_whole && size <= static_cast<off_t>(first_line.size())) {
        if (size > 0 && ::ftruncate(descriptor, 0) != 0) return errno;
        size = 0;
    }
    std::string text;
    if (size == 0) {
        text = std::string(first_line) + "\n";
    } else if (!is_whole) {
        text = "\n";
    }
    text.append(line).append("\n");
    const int error = write_all(descriptor, text);
    // Remove the partial line; if even that fails, it stays.
    if (error != 0) static_cast<void>(!::ftruncate(descriptor, size));
    return error;
}

}  // namespace

Result<void> append_line(const std::filesystem::path& file, std::string_view first_line,
                         std::string_view line) {
    const int descriptor = ::open(file.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, kTableMode);
    if (descriptor < 0) return error_of_errno(file, errno, "append");
    int error = append(descriptor, first_line, line);
    if (::close(descriptor) != 0 && error == 0) error = errno;
    if (error != 0) return error_of_errno(file, error, "append");
    return {};
}

}  // namespace onggi::files
