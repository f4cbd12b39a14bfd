#include "engine/core/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace onggi {
namespace {

Result<int> half_of(int number) {
    if (number % 2 != 0) return bad_input("expected an even number, found " + std::to_string(number));
    return number / 2;
}

TEST(Result, HoldsAValueOrAnError) {
    const Result<int> four = half_of(8);
    ASSERT_TRUE(four);
    EXPECT_EQ(*four, 4);

    const Result<int> none = half_of(7);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(none.error().message, "expected an even number, found 7");
}

TEST(Result, OfVoidHoldsSuccessOrAnError) {
    EXPECT_TRUE(Result<void>{});
    EXPECT_FALSE(Result<void>{failed("no")});
}

TEST(Result, MovesAValueThatCannotBeCopied) {
    Result<std::unique_ptr<int>> owner{std::make_unique<int>(3)};
    const std::unique_ptr<int> moved = std::move(owner).value();
    EXPECT_EQ(*moved, 3);
}

TEST(ExitCode, IsTheAgreedOne) {
    EXPECT_EQ(exit_code(ErrorKind::kFailed), 1);
    EXPECT_EQ(exit_code(ErrorKind::kBadInput), 2);
    EXPECT_EQ(exit_code(ErrorKind::kSystemLacks), 3);
}

}  // namespace
}  // namespace onggi
