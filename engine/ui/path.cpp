#include "engine/ui/path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "engine/core/quote.h"

namespace onggi::ui {
namespace {

class PathReader {
  public:
    explicit PathReader(std::string_view words) : words_(words) {}

    Result<std::vector<PathStep>> read() {
        while (skip_spaces(), at_ < words_.size()) {
            const char letter = words_[at_];
            if (std::isalpha(static_cast<unsigned char>(letter)) != 0) {
                command_ = letter;
                ++at_;
            } else if (command_ == 0) {
                return wrong("a path beginning with M");
            }
            if (steps_.empty() && command_ != 'M' && command_ != 'm') return wrong("a path beginning with M");
            if (auto done = take_command(); !done) return done.error();
        }
        return std::move(steps_);
    }

  private:
    Error wrong(std::string_view expected) const {
        return bad_input(fmt::format("path, letter {}: expected {}, found {}", at_ + 1, expected,
                                     at_ < words_.size() ? in_quotes(words_.substr(at_, 12)) : "its end"));
    }
    void skip_spaces() {
        while (at_ < words_.size() && (words_[at_] == ' ' || words_[at_] == ',' || words_[at_] == '\n'))
            ++at_;
    }
    bool number(float& value) {
        skip_spaces();
        const char* const begin = words_.data() + at_;
        const auto [end, error] = std::from_chars(begin, words_.data() + words_.size(), value);
        // Larger than any drawing; arcs square their numbers, which must not overflow.
        constexpr float kMost = 1e6F;
        if (error != std::errc() || !(std::abs(value) <= kMost)) return false;
        at_ += static_cast<std::size_t>(end - begin);
        return true;
    }
    bool point(vec2& value) {
        if (!number(value.x) || !number(value.y)) return false;
        if (is_relative()) value += here_;
        return true;
    }
    [[nodiscard]] bool is_relative() const { return std::islower(static_cast<unsigned char>(command_)) != 0; }

    void line_to(vec2 to) {
        steps_.push_back({PathStep::Kind::kLine, to, {}, {}});
        here_ = to;
    }
    void curve_to(vec2 first, vec2 second, vec2 to) {
        steps_.push_back({PathStep::Kind::kCurve, to, first, second});
        here_ = to;
    }

    Result<void> take_command() {
        vec2 a{0.0F};
        vec2 b{0.0F};
        vec2 to{0.0F};
        switch (std::toupper(static_cast<unsigned char>(command_))) {
            case 'M':
                if (!point(to)) return wrong("two numbers");
                steps_.push_back({PathStep::Kind::kMove, to, {}, {}});
                here_ = start_ = to;
                command_ = is_relative() ? 'l' : 'L';  // further points after a move are lines
                return {};
            case 'L':
                if (!point(to)) return wrong("two numbers");
                line_to(to);
                return {};
            case 'H':
            case 'V': {
                const bool level = std::toupper(static_cast<unsigned char>(command_)) == 'H';
                float value = 0.0F;
                if (!number(value)) return wrong("a number");
                to = here_;
                float& changed = level ? to.x : to.y;
                changed = is_relative() ? changed + value : value;
                line_to(to);
                return {};
            }
            case 'C':
                if (!point(a) || !point(b) || !point(to)) return wrong("six numbers");
                curve_to(a, b, to);
                return {};
            case 'Q':
                if (!point(a) || !point(to)) return wrong("four numbers");
                curve_to(here_ + (a - here_) * (2.0F / 3.0F), to + (a - to) * (2.0F / 3.0F), to);
                return {};
            case 'A':
                return arc();
            case 'Z':
                steps_.push_back({PathStep::Kind::kClose, start_, {}, {}});
                here_ = start_;
                command_ = 0;
                return {};
            default:
                --at_;
                return wrong("one of M L H V C Q A Z");
        }
    }

    // SVG 1.1, appendix F.6: converts end points to a centre, then to cubic curves of at most a quarter turn.
    Result<void> arc() {
        vec2 radius{0.0F};
        float turn_degrees = 0.0F;
        float large = 0.0F;
        float sweep = 0.0F;
        vec2 to{0.0F};
        if (!number(radius.x) || !number(radius.y) || !number(turn_degrees) || !number(large) ||
            !number(sweep) || !point(to)) {
            return wrong("seven numbers");
        }
        radius = glm::abs(radius);
        constexpr float kLeast = 1e-4F;  // shorter arcs are points or straight lines
        if (radius.x < kLeast || radius.y < kLeast || glm::length(to - here_) < kLeast) {
            line_to(to);
            return {};
        }
        const float turn = turn_degrees * kPiF / 180.0F;
        const vec2 axis(std::cos(turn), std::sin(turn));
        const vec2 half = 0.5F * (here_ - to);
        const vec2 p(axis.x * half.x + axis.y * half.y, -axis.y * half.x + axis.x * half.y);
        const float stretch = glm::dot(p / radius, p / radius);
        if (stretch > 1.0F) radius *= std::sqrt(stretch);
        const vec2 r2 = radius * radius;
        const float weight = r2.x * p.y * p.y + r2.y * p.x * p.x;
        float scale = std::sqrt(std::max(0.0F, (r2.x * r2.y - weight) / weight));
        if ((large != 0.0F) == (sweep != 0.0F)) scale = -scale;
        const vec2 c(scale * radius.x * p.y / radius.y, -scale * radius.y * p.x / radius.x);
        const vec2 centre =
            vec2(axis.x * c.x - axis.y * c.y, axis.y * c.x + axis.x * c.y) + 0.5F * (here_ + to);
        const float from_angle = std::atan2((p.y - c.y) / radius.y, (p.x - c.x) / radius.x);
        float span = std::atan2((-p.y - c.y) / radius.y, (-p.x - c.x) / radius.x) - from_angle;
        if (sweep != 0.0F && span < 0.0F) span += kTurnF;
        if (sweep == 0.0F && span > 0.0F) span -= kTurnF;
        const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(span) / (0.5F * kPiF) - 1e-4F)));
        const float step = span / static_cast<float>(pieces);
        const float reach = 4.0F / 3.0F * std::tan(0.25F * step);
        const auto out = [&](vec2 q) {
            q *= radius;
            return centre + vec2(axis.x * q.x - axis.y * q.y, axis.y * q.x + axis.x * q.y);
        };
        for (int piece = 0; piece < pieces; ++piece) {
            const float u = from_angle + step * static_cast<float>(piece);
            const vec2 e0(std::cos(u), std::sin(u));
            const vec2 e1(std::cos(u + step), std::sin(u + step));
            curve_to(out(e0 + reach * vec2(-e0.y, e0.x)), out(e1 - reach * vec2(-e1.y, e1.x)),
                     piece + 1 == pieces ? to : out(e1));
        }
        return {};
    }

    std::string_view words_;
    std::size_t at_ = 0;
    char command_ = 0;
    vec2 here_{0.0F};
    vec2 start_{0.0F};
    std::vector<PathStep> steps_;
};

}  // namespace

Result<std::vector<PathStep>> read_path(std::string_view words) {
    return PathReader(words).read();
}

}  // namespace onggi::ui
