// SPDX-License-Identifier: BSD-3-Clause
#include "yaml_fields.h"

#include <rtob/core/nearest_name.h>
#include <rtob/sim/world_file.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace rtob::sim
{
namespace
{
std::string allowed(const Range& range)
{
    std::ostringstream text;
    const bool has_end = range.to < std::numeric_limits<double>::infinity();
    if (has_end)
        text << range.from << " to " << range.to;
    else
        text << (range.is_open ? "> " : ">= ") << range.from;
    return text.str();
}
}  // namespace

YamlFields::YamlFields(std::string file, YAML::Node map, std::string where)
    : file_(std::move(file)), map_(std::move(map)), where_(std::move(where))
{
    if (!map_.IsMap()) fail("must hold lines `key: value`");
    std::set<std::string> seen;
    for (const auto& entry : map_)
        if (!seen.insert(entry.first.Scalar()).second)
            failAt(line_of(entry.first), "the key '" + entry.first.Scalar() + "' stands twice");
}

void YamlFields::failAt(int line, const std::string& reason) const
{
    throw WorldError(
        file_ + ":" + std::to_string(line) + ": " + (where_.empty() ? "" : where_ + ": ") + reason);
}

void YamlFields::fail(const std::string& reason) const
{
    failAt(line(), reason);
}

void YamlFields::fail(const std::string& key, const std::string& reason) const
{
    const auto node = map_[key];
    failAt(node ? line_of(node) : line(), key + ": " + reason);
}

YAML::Node YamlFields::get(const std::string& key)
{
    known_.push_back(key);
    return std::as_const(map_)[key];
}

bool YamlFields::has(const std::string& key)
{
    known_.push_back(key);
    return std::as_const(map_)[key].IsDefined();
}

double YamlFields::number(const YAML::Node& node, const std::string& key, Range range) const
{
    double value = 0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value))
        failAt(
            line_of(node), key + ": " +
                               (node.IsScalar() ? "'" + node.Scalar() + "' is not a number"
                                                : std::string("must be a number")));
    if (value < range.from || value > range.to || (range.is_open && value == range.from))
        failAt(
            line_of(node),
            key + ": " + node.Scalar() + " is out of range: must be " + allowed(range));
    return value;
}

Point2 YamlFields::point(const YAML::Node& node, const std::string& key) const
{
    if (!node.IsSequence() || node.size() != 2)
        failAt(line_of(node), key + ": a point is two numbers, [x, y] in metres");
    return {number(node[0], key, {}), number(node[1], key, {})};
}

void YamlFields::read(const std::string& key, double& value, Range range)
{
    if (const auto node = get(key)) value = number(node, key, range);
}

void YamlFields::read(const std::string& key, int& value)
{
    const auto node = get(key);
    if (!node) return;
    if (!node.IsScalar() || !YAML::convert<int>::decode(node, value))
        fail(key, "must be a whole number");
}

void YamlFields::read(const std::string& key, bool& value)
{
    const auto node = get(key);
    if (!node) return;
    if (!node.IsScalar() || !YAML::convert<bool>::decode(node, value))
        fail(key, "must be true or false");
}

void YamlFields::read(const std::string& key, std::string& value)
{
    const auto node = get(key);
    if (!node) return;
    if (!node.IsScalar()) fail(key, "must be a word");
    value = node.Scalar();
}

void YamlFields::read(const std::string& key, Point2& value)
{
    if (const auto node = get(key)) value = point(node, key);
}

void YamlFields::read(const std::string& key, std::vector<Point2>& value)
{
    const auto node = get(key);
    if (!node) return;
    if (!node.IsSequence()) fail(key, "must be a list of points, [[x, y], [x, y]]");
    value.clear();
    for (const auto& entry : node) value.push_back(point(entry, key));
}

void YamlFields::read(const std::string& key, std::vector<double>& value, std::size_t count)
{
    const auto node = get(key);
    if (!node) return;
    if (!node.IsSequence() || node.size() != count)
        fail(key, "must be a list of " + std::to_string(count) + " numbers");
    value.clear();
    for (const auto& entry : node) value.push_back(number(entry, key, {}));
}

std::optional<YamlFields> YamlFields::fields(const std::string& key)
{
    const auto node = get(key);
    if (!node) return std::nullopt;
    return YamlFields(file_, node, where_.empty() ? key : where_ + "." + key);
}

std::vector<YamlFields> YamlFields::list(const std::string& key)
{
    const auto node = get(key);
    std::vector<YamlFields> entries;
    if (!node) return entries;
    if (!node.IsSequence()) fail(key, "must be a list, each entry with a '-'");
    for (std::size_t i = 0; i < node.size(); ++i)
        entries.emplace_back(
            file_, node[i],
            (where_.empty() ? "" : where_ + ".") + key + "[" + std::to_string(i) + "]");
    return entries;
}

void YamlFields::allow(const std::vector<std::string>& keys)
{
    known_.insert(known_.end(), keys.begin(), keys.end());
}

void YamlFields::finish() const
{
    for (const auto& entry : map_)
    {
        const auto& key = entry.first.Scalar();
        if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
        failAt(line_of(entry.first), "unknown key '" + key + "'" + suggestion(key, known_));
    }
}
}  // namespace rtob::sim
