// Visitors who chose a museum's pot and follow the outline that the kiosk shows, with the help it gives.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "game/app/kiosk_pot.h"
#include "game/heritage/score.h"
#include "tests/visitors/population.h"

namespace onggi::visitors {
namespace {

TEST(TargetFollowers, Experiment) {
    const auto targets = heritage::load_targets(ONGGI_SOURCE_DIR "/assets/heritage");
    ASSERT_TRUE(targets);
    std::vector<std::size_t> places;
    ASSERT_EQ(app::exhibits_of(*targets, places).size(), 4u);
    std::vector<std::vector<Left>> sheet;
    for (const auto& [id, fraction] :
         std::vector<std::pair<std::string, double>>{{"ido-kizaemon", 1.0},
                                                     {"buncheong-small-bowl", 1.0},
                                                     {"joseon-bowl", 1.0},
                                                     {"maebyeong-1869", 0.5},
                                                     {"moon-jar-nmk", 1.0 / 3.0}}) {
        const heritage::Target target = *heritage::find_target(*targets, id);
        {
            {
                const double mass = 1000.0;
                std::vector<dvec2> outline;
                const double scale = fraction * clay::wet_scale_of_fired(clay::ClayBody::kStoneware);
                for (int i = 0; i <= 40; ++i) {
                    const double y = target.height_mm * i / 40.0;
                    outline.emplace_back(target.radius_at(y) * scale, y * scale);
                }
                if (outline.back().y > 270.0 || outline.back().y < 50.0) continue;
                const auto all = throw_pots({.kind = Kind::kFollowsOutline,
                                             .count = 6,
                                             .first_seed = 41,
                                             .mass_g = mass,
                                             .shown_mm = outline});
                double height = 0.0;
                for (const auto& left : all)
                    height += left.verdict.height_mm / 6.0;
                std::printf(
                    "%s %.2f %.0f g: pots %.2f median rms %.1f within 6: %.2f height %.0f of %.0f; %.0f s\n",
                    target.id.c_str(), fraction, mass, share_of_pots(all), median_rms_mm(all),
                    share_within_mm(all, 6.0), height, outline.back().y, all.front().visit.seconds);
                sheet.push_back(all);
            }
        }
    }
    write_sheet(ONGGI_BINARY_DIR "/targets.png", sheet);
}

}  // namespace
}  // namespace onggi::visitors
