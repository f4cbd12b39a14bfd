// A kiosk that shares the pots of its gallery, where one is kept already.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include "engine/asset/image.h"
#include "engine/files/atomic_file.h"
#include "game/app/kiosk/keeping/kiosk_phone.h"
#include "tests/support/comes_true.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {

namespace fs = std::filesystem;

class SharingKiosk : public ::testing::Test {
  protected:
    SharingKiosk() {
        settings_.config.gallery.folder = (folder_.path() / "gallery").string();
        settings_.config.sharing.outbox = (folder_.path() / "outbox").string();
        settings_.config.sharing.public_url = "http://pots.example";
        const fs::path pot = folder_.path() / "gallery" / kName;
        fs::create_directories(pot);
        const asset::Image picture{.width = 2, .height = 2, .rgba = std::vector<std::uint8_t>(16, 200)};
        EXPECT_TRUE(files::write_file_atomically(pot / "pot.png", asset::encode_png(picture).value()));
        for (const char* file : {"pot.glb", "pot.stl", "pot.3mf"})
            std::ofstream(pot / file) << file;
    }
    [[nodiscard]] PotToShare kept() const {
        auto pot = std::make_shared<screens::FiredPot>();
        pot->shape = pot::hollowed({{40, 0}, {50, 50}, {45, 100}}, 5.0F, 8.0F);
        pot->height_mm = 100.0;
        return {.gallery_name = kName, .pot = pot};
    }
    static std::shared_ptr<const PhoneAnswer> answer_of(KioskPhone& phone) {
        std::shared_ptr<const PhoneAnswer> answer;
        test::comes_true([&] { return (answer = phone.next_answer()) != nullptr; });
        return answer;
    }
    [[nodiscard]] std::vector<sharing::OutboxEntry> shared() const {
        return sharing::Outbox::open({.folder = folder_.path() / "outbox", .languages = settings_.languages})
            .value()
            .list()
            .value();
    }

    static constexpr const char* kName = "2026-11-22/pot-003";
    test::TemporaryFolder folder_;
    KioskSettings settings_ = load_settings("").value();
};

}  // namespace onggi::app
