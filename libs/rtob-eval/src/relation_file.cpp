// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/relations.h>

#include <array>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace rtob
{
namespace
{
using Columns = std::array<double, 8>;  // t1 t2 x y z roll pitch yaw

constexpr const char* format = "expected `t1 t2 x y z roll pitch yaw`";

/// Takes the next word off the line; empty at its end.
std::string_view next_word(std::string_view& line)
{
    const auto begin = std::min(line.find_first_not_of(" \t\r"), line.size());
    const auto end = std::min(line.find_first_of(" \t\r", begin), line.size());
    const auto word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

double parsed_number(std::string_view word)
{
    double number = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || stop != word.data() + word.size() || !std::isfinite(number))
        throw std::runtime_error("'" + std::string(word) + "' is not a number; " + format);
    return number;
}

Columns parsed_columns(std::string_view line)
{
    Columns columns{};
    for (auto& column : columns)
    {
        const auto word = next_word(line);
        if (word.empty()) throw std::runtime_error(std::string("too few numbers; ") + format);
        column = parsed_number(word);
    }
    if (!next_word(line).empty())
        throw std::runtime_error(std::string("more than 8 words; ") + format);
    return columns;
}

Relation parsed_relation(std::string_view line)
{
    const auto [t1_s, t2_s, x, y, z, roll, pitch, yaw] = parsed_columns(line);
    if (z != 0 || roll != 0 || pitch != 0)
        throw std::runtime_error("z, roll and pitch must be 0: only motions in the plane compare");
    return {t1_s, t2_s, {x, y, wrap_angle(yaw)}};
}

bool is_skipped(std::string_view line)
{
    const auto word = next_word(line);
    return word.empty() || word.front() == '#';
}

/// Whether the file starts with these bytes; leaves it at its start.
bool starts_with(std::ifstream& in, std::string_view mark)
{
    std::string beginning(mark.size(), '\0');
    in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    in.clear();
    in.seekg(0);
    return beginning == mark;
}
}  // namespace

std::vector<Relation> read_relations(const std::string& file)
{
    std::ifstream bytes(file, std::ios::binary);
    if (!bytes || bytes.peek() == std::ifstream::traits_type::eof())
        throw std::runtime_error("relations file " + file + " is missing, unreadable or empty");
    boost::iostreams::filtering_istream lines;
    if (starts_with(bytes, "\x1F\x8B")) lines.push(boost::iostreams::gzip_decompressor());
    if (starts_with(bytes, "BZh")) lines.push(boost::iostreams::bzip2_decompressor());
    lines.push(bytes);
    lines.exceptions(std::ios::badbit);  // so that damaged data throws

    std::vector<Relation> relations;
    std::size_t line_number = 1;
    try
    {
        for (std::string line; std::getline(lines, line); ++line_number)
            if (!is_skipped(line)) relations.push_back(parsed_relation(line));
    }
    catch (const std::exception& e)
    {
        throw std::runtime_error(
            "relations file " + file + ", line " + std::to_string(line_number) + ": " + e.what());
    }
    if (relations.empty()) throw std::runtime_error("relations file " + file + " has no relations");
    return relations;
}
}  // namespace rtob
