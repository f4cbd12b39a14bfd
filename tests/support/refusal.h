// Why bad input was refused.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "engine/core/result.h"

namespace onggi::test {

// The error message of a result for bad input; "accepted" if there is no error.
template <typename T>
[[nodiscard]] std::string refusal(const Result<T>& result) {
    if (result) return "accepted";
    EXPECT_EQ(result.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(result.error().message.find_first_of("\n\r"), std::string::npos);
    return result.error().message;
}

}  // namespace onggi::test
