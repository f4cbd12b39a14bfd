// How force and tick rate went in the last few seconds, for their plots: a ring of samples, one a frame. Main
// thread. s, N, Hz.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace onggi::screens {

class ForceTrace {
  public:
    static constexpr double kWindowS = 4.0;
    static constexpr std::size_t kMost = 512;  // 120 frames a second fill less

    struct Sample {
        double time_s = 0.0;
        double force_n = 0.0;
        double rate_hz = 0.0;
    };

    // Times ascend; ticks: how many the loop has run since it began.
    void add(double time_s, double force_n, std::uint64_t ticks);

    // Oldest first; those older than the window are gone.
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] const Sample& at(std::size_t place) const { return kept(place).sample; }
    // Of the last quarter of a second; 0 before there was one.
    [[nodiscard]] double rate_hz() const { return count_ == 0 ? 0.0 : at(count_ - 1).rate_hz; }
    // What a plot's height stands for: the next of 0.1, 0.2, 0.5, 1, 2, 5 up to 100 N that nothing in the
    // window passes.
    [[nodiscard]] double full_n() const { return full_n_; }

  private:
    struct Kept {
        Sample sample;
        std::uint64_t ticks = 0;
    };
    [[nodiscard]] const Kept& kept(std::size_t place) const { return ring_[(first_ + place) % kMost]; }

    std::array<Kept, kMost> ring_{};
    std::size_t first_ = 0;
    std::size_t count_ = 0;
    double full_n_ = 0.1;
};

}  // namespace onggi::screens
