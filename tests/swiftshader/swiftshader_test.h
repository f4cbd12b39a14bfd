// What a test needs that draws by SwiftShader. Main thread.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

// Skips the test, and says why, where the driver is not installed.
#define ONGGI_NEEDS_SWIFTSHADER()                    \
    if (!std::filesystem::exists(ONGGI_SWIFTSHADER)) \
    GTEST_SKIP() << "expected SwiftShader of Debian's chromium, found none in " << ONGGI_SWIFTSHADER
