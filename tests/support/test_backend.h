// The backend for tests of the moving picture: ONGGI_TEST_BACKEND, "gpu", "cpu" or "auto" (default).
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/render/quality.h"

namespace onggi::test {

inline render::BackendChoice backend_of_environment() {
    const char* name = std::getenv("ONGGI_TEST_BACKEND");
    if (name == nullptr) return render::BackendChoice::kAuto;
    const auto choice = render::backend_choice_named(name);
    EXPECT_TRUE(choice) << "ONGGI_TEST_BACKEND: expected gpu, cpu or auto, found " << name;
    return choice.value_or(render::BackendChoice::kAuto);
}

}  // namespace onggi::test
