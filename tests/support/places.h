// Where the checkout and its build lie. Compiled into one object file only, so that ccache hits for all
// others in another checkout.
#pragma once

#include <string>
#include <string_view>

namespace onggi::test {

// An absolute path; path: from the root of the checkout, which is named by none.
[[nodiscard]] std::string in_checkout(std::string_view path = {});
// An absolute path; path: from the folder of this build.
[[nodiscard]] std::string in_build(std::string_view path);

}  // namespace onggi::test
