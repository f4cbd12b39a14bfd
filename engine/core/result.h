// Result<T>: the return type of a function that can fail. An expected failure is a value, never an exception.
// Any thread. Not for the haptic tick, where nothing fails.
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace onggi {

// Who can fix the error; it determines the program's exit code (see exit_code).
enum class ErrorKind {
    kBadInput,     // the user's words or files: name the place, what was expected, what was found
    kSystemLacks,  // the machine lacks something: a Vulkan device, disk space, a permission
    kFailed,       // anything else
};

struct Error {
    ErrorKind kind = ErrorKind::kFailed;
    std::string message;  // one line, without a full stop or a line break at its end
};

inline Error bad_input(std::string message) {
    return {ErrorKind::kBadInput, std::move(message)};
}
inline Error system_lacks(std::string message) {
    return {ErrorKind::kSystemLacks, std::move(message)};
}
inline Error failed(std::string message) {
    return {ErrorKind::kFailed, std::move(message)};
}

// The exit codes are part of the interface: 0 done, 1 anything else, 2 bad usage or input, 3 the system lacks
// something.
constexpr int exit_code(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::kBadInput:
            return 2;
        case ErrorKind::kSystemLacks:
            return 3;
        case ErrorKind::kFailed:
            break;
    }
    return 1;
}

template <typename T>
class [[nodiscard]] Result {
  public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}  // NOLINT: a value is a result
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: so is an error

    explicit operator bool() const { return content_.index() == 0; }

    // Precondition of value(): the result holds one; of error(): it does not.
    T& value() & { return assert(*this), *std::get_if<0>(&content_); }
    const T& value() const& { return assert(*this), *std::get_if<0>(&content_); }
    T&& value() && { return assert(*this), std::move(*std::get_if<0>(&content_)); }
    const Error& error() const { return assert(!*this), *std::get_if<1>(&content_); }

    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

  private:
    std::variant<T, Error> content_;
};

template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}  // NOLINT: an error is a result

    explicit operator bool() const { return !error_.has_value(); }
    const Error& error() const { return assert(error_), *error_; }

  private:
    std::optional<Error> error_;
};

}  // namespace onggi
