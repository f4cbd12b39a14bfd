#include "tests/unit/screens/flatten.h"

#include <algorithm>
#include <cmath>

namespace onggi::screens {
namespace {

class Ground {
  public:
    Ground(int width, int height, const ui::Colour& colour)
        : width_(width),
          height_(height),
          pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                  vec3(colour.r, colour.g, colour.b)) {}

    // Colour multiplied by alpha.
    void lay(int x, int y, const vec3& colour, float alpha) {
        if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
        vec3& pixel = pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                              static_cast<std::size_t>(x)];
        pixel = pixel * (1.0F - alpha) + colour;
    }
    [[nodiscard]] asset::Image image() const {
        asset::Image image{.width = width_, .height = height_, .rgba = {}};
        for (const vec3& pixel : pixels_) {
            for (int i = 0; i < 3; ++i)
                image.rgba.push_back(
                    static_cast<std::uint8_t>(std::lround(std::clamp(pixel[i], 0.0F, 1.0F) * 255.0F)));
            image.rgba.push_back(255);
        }
        return image;
    }

  private:
    int width_;
    int height_;
    std::vector<vec3> pixels_;
};

}  // namespace

asset::Image flatten(const Composition& composition, const ui::Colour& ground, bool with_words,
                     std::optional<double> since_s) {
    const float scale = composition.px_per_u;
    const int width = static_cast<int>(std::lround(composition.bounds.width * scale));
    const int height = static_cast<int>(std::lround(composition.bounds.height * scale));
    Ground into(width, height, ground);
    for (const Item& item : composition.items) {
        if (!with_words && item.is_words) continue;
        const Moved moves = since_s ? moved(item.motion, *since_s) : moved_to_the_end(item.motion);
        const float strength = item.alpha * moves.alpha;
        if (!item.painting) {
            const ui::Rect rect = item.rect.scaled(scale);
            for (int y = static_cast<int>(std::lround(rect.y));
                 y < static_cast<int>(std::lround(rect.bottom())); ++y) {
                for (int x = static_cast<int>(std::lround(rect.x));
                     x < static_cast<int>(std::lround(rect.right())); ++x) {
                    const float u = (static_cast<float>(x) + 0.5F - rect.x) / rect.width;
                    const float v = (static_cast<float>(y) + 0.5F - rect.y) / rect.height;
                    const ui::Colour colour = ui::mix(ui::mix(item.corners[0], item.corners[1], u),
                                                      ui::mix(item.corners[3], item.corners[2], u), v);
                    const float alpha = strength * colour.a;
                    into.lay(x, y, vec3(colour.r, colour.g, colour.b) * alpha, alpha);
                }
            }
            continue;
        }
        const int left = static_cast<int>(std::lround(item.rect.x * scale));
        const int top = static_cast<int>(std::lround((item.rect.y + moves.down_u) * scale));
        const std::uint8_t* pixel = item.painting->rgba.data();
        for (int y = 0; y < item.painting->height; ++y) {
            for (int x = 0; x < item.painting->width; ++x, pixel += 4) {
                if (pixel[3] == 0) continue;
                into.lay(left + x, top + y, vec3(pixel[0], pixel[1], pixel[2]) * (strength / 255.0F),
                         static_cast<float>(pixel[3]) * (strength / 255.0F));
            }
        }
    }
    return into.image();
}

}  // namespace onggi::screens
