#include "engine/haptics/haply/json_walk.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace onggi::haptics::haply {
namespace {

class Walker {
  public:
    Walker(std::string_view text, const std::function<void(std::string_view, const JsonValue&)>& visit)
        : text_(text),
          visit_(visit) {}

    Result<void> walk() {
        if (text_.size() > kMaxMessageBytes)
            return refusal(fmt::format("at most {} bytes", kMaxMessageBytes), "more");
        if (auto done = value(0); !done) return done;
        skip_blanks();
        return at_ == text_.size() ? Result<void>() : refusal("the end", "more");
    }

  private:
    [[nodiscard]] char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void skip_blanks() {
        while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos)
            ++at_;
    }
    [[nodiscard]] Error refusal(std::string_view expected, std::string_view found = {}) const {
        const std::string there =
            at_ >= text_.size() ? "the end" : fmt::format("byte {:#04x}", static_cast<unsigned char>(here()));
        return bad_input(
            fmt::format("byte {}: expected {}, found {}", at_, expected, found.empty() ? there : found));
    }

    Result<void> value(int depth) {
        if (depth > kMaxJsonDepth)
            return refusal(fmt::format("values at most {} deep", kMaxJsonDepth), "one deeper");
        skip_blanks();
        if (here() == '{') return members('}', depth);
        if (here() == '[') return members(']', depth);
        if (here() == '"') {
            const auto text = quoted();
            if (!text) return text.error();
            visit_(place_, {.kind = JsonValue::Kind::kText, .text = *text});
            return {};
        }
        for (const std::string_view word : {"true", "false", "null"}) {
            if (!text_.substr(at_).starts_with(word)) continue;
            at_ += word.size();
            visit_(place_, {});
            return {};
        }
        return number();
    }

    // Of an object or an array: the closing letter says which.
    Result<void> members(char closing, int depth) {
        ++at_;
        skip_blanks();
        if (here() == closing) {
            ++at_;
            return {};
        }
        for (std::size_t count = 0;; ++count) {
            std::string name = fmt::format("{}", count);
            if (closing == '}') {
                skip_blanks();
                const auto read = quoted();
                if (!read) return read.error();
                name = *read;
                skip_blanks();
                if (here() != ':') return refusal("a colon");
                ++at_;
            }
            const std::size_t outside = place_.size();
            place_ += (place_.empty() ? "" : ".") + name;
            if (auto done = value(depth + 1); !done) return done;
            place_.resize(outside);
            skip_blanks();
            if (here() == closing) break;
            if (here() != ',') return refusal(closing == '}' ? "a comma or a brace" : "a comma or a bracket");
            ++at_;
        }
        ++at_;
        return {};
    }

    Result<std::string_view> quoted() {
        if (here() != '"') return refusal("a quote");
        const std::size_t first = ++at_;
        while (at_ < text_.size() && text_[at_] != '"')
            at_ += text_[at_] == '\\' ? std::size_t{2} : std::size_t{1};
        if (at_ >= text_.size()) {
            at_ = text_.size();
            return refusal("a closing quote");
        }
        return text_.substr(first, at_++ - first);
    }

    Result<void> number() {
        double found = 0.0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), found);
        const bool is_json = here() == '-' || (here() >= '0' && here() <= '9');
        if (!is_json || error != std::errc{} || !std::isfinite(found)) return refusal("a value");
        at_ = static_cast<std::size_t>(end - text_.data());
        visit_(place_, {.kind = JsonValue::Kind::kNumber, .number = found});
        return {};
    }

    std::string_view text_;
    const std::function<void(std::string_view, const JsonValue&)>& visit_;
    std::size_t at_ = 0;
    std::string place_;
};

}  // namespace

Result<void> walk_json(std::string_view text,
                       const std::function<void(std::string_view place, const JsonValue&)>& visit) {
    return Walker(text, visit).walk();
}

}  // namespace onggi::haptics::haply
