// Where paintings lie in the one texture that an overlay draws from. Two halves take turns: what is new goes
// into one of them, and when that is full the other is emptied and begun. A painting that is asked for again
// from the half before keeps its place until then; nothing is ever moved. No Vulkan here. Main thread.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "engine/ui/geometry.h"
#include "engine/ui/painting.h"

namespace onggi::ui {

class Atlas {
  public:
    // A square texture of this many pixels a side.
    explicit Atlas(int side_px);
    // For pictures of this size: as small as will do, for what lies in it lies in memory twice.
    [[nodiscard]] static int side_px_for(int width_px, int height_px);

    struct Upload {
        int x = 0;
        int y = 0;
        std::shared_ptr<const Painting> painting;
    };

    // Where the painting with this key lies, pixels; it is taken in if it is not there yet. Nothing when it
    // is larger than a half. Flips halves when the current one is full: paintings asked for since
    // begin_frame() may then have lost their place, and generation() has changed: ask for all of them again.
    [[nodiscard]] std::optional<Rect> place(std::uint64_t key,
                                            const std::shared_ptr<const Painting>& painting);

    // Another painting of the same size in the place of the one with this key; as place() where there is
    // none.
    [[nodiscard]] std::optional<Rect> replace(std::uint64_t key,
                                              const std::shared_ptr<const Painting>& painting);

    // From here on, what is asked for counts as wanted.
    void begin_asking() { ++asking_; }
    // What was not asked for since begin_asking() loses its place. So that nobody keeps its painting for a
    // place that nobody draws from, one clear pixel is uploaded over its corner.
    void forget_unasked();

    // What is to be copied into the texture before it is drawn from; it is taken away.
    [[nodiscard]] std::vector<Upload> take_uploads();
    // How often a half has been emptied.
    [[nodiscard]] std::uint64_t generation() const { return generation_; }
    [[nodiscard]] int side_px() const { return side_; }

  private:
    struct Shelf {
        int y = 0;
        int height = 0;
        int used = 0;  // pixels from the left
    };
    struct Place {
        Rect rect;
        std::uint64_t asked = 0;  // the asking_ in which it was asked for last
    };
    struct Half {
        int top = 0;
        int next_shelf_y = 0;
        std::vector<Shelf> shelves;
        std::unordered_map<std::uint64_t, Place> places;
    };
    [[nodiscard]] std::optional<Rect> find(std::uint64_t key);
    [[nodiscard]] std::optional<Rect> room_for(Half& half, int width, int height) const;
    void empty(Half& half);

    int side_;
    std::array<Half, 2> halves_;
    std::size_t current_ = 0;
    std::uint64_t generation_ = 0;
    std::uint64_t asking_ = 0;
    std::vector<Upload> uploads_;
};

}  // namespace onggi::ui
