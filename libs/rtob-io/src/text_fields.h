// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace rtob
{
/// A field that is missing or not what was expected; the text says which.
class FieldError : public std::runtime_error
{
 public:
    using std::runtime_error::runtime_error;
};

/// Takes the fields of a line one by one, in the C locale whatever the program's locale is.
class TextFields
{
 public:
    explicit TextFields(std::string_view line) : rest_(line) {}

    /// Empty at the end of the line.
    [[nodiscard]] std::string_view next_word();
    /// The name tells the reader of the error which field was expected.
    [[nodiscard]] std::string_view word(const char* name);
    [[nodiscard]] double number(const char* name);  ///< may be NaN or infinite
    [[nodiscard]] double finite_number(const char* name);
    [[nodiscard]] std::size_t count(const char* name, std::size_t most);

 private:
    std::string_view rest_;
};

/// The value of a number in units of 1e-7, rounded: exact where a double is not (with an exponent
/// as a double). Throws FieldError for anything else, and beyond the year 5138.
[[nodiscard]] std::int64_t parse_ticks_100ns(std::string_view seconds, const char* name);
}  // namespace rtob
