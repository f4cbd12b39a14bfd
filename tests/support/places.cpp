#include "tests/support/places.h"

namespace onggi::test {

std::string in_checkout(std::string_view path) {
    std::string root = ONGGI_SOURCE_DIR;
    return path.empty() ? root : root.append("/").append(path);
}

std::string in_build(std::string_view path) {
    return std::string(ONGGI_BINARY_DIR "/").append(path);
}

}  // namespace onggi::test
