// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cctype>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace rtob
{
/// Fewest insertions, deletions and replacements of a letter that turn one word into the other
/// (Levenshtein). Upper and lower case count as the same letter: mixing them up is the smallest of
/// typos.
[[nodiscard]] inline std::size_t edit_distance(std::string_view a, std::string_view b)
{
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    std::vector<std::size_t> row(b.size() + 1);  // distances of a's first i letters to b's first j
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
            const std::size_t replaced = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

/// The known name that a person who typed `word` probably meant (the first of equals); empty when
/// more than half of the word's letters would have to change.
[[nodiscard]] inline std::string nearest_name(
    std::string_view word, const std::vector<std::string>& known)
{
    std::string nearest;
    std::size_t smallest = std::max<std::size_t>(1, word.size() / 2) + 1;
    for (const auto& name : known)
    {
        const std::size_t distance = edit_distance(word, name);
        if (distance >= smallest) continue;
        smallest = distance;
        nearest = name;
    }
    return nearest;
}

/// The names as a person reads them: "a, b, c".
[[nodiscard]] inline std::string joined(const std::vector<std::string>& names)
{
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// The end of an error message about an unknown name: "; did you mean 'x'?", or else all that is
/// known.
[[nodiscard]] inline std::string suggestion(
    std::string_view word, const std::vector<std::string>& known)
{
    const std::string nearest = nearest_name(word, known);
    if (!nearest.empty()) return "; did you mean '" + nearest + "'?";
    return "; known: " + joined(known);
}
}  // namespace rtob
