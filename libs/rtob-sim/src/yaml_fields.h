// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/sim/shape.h>
#include <yaml-cpp/yaml.h>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rtob::sim
{
/// What a number may be.
struct Range
{
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
    bool is_open = false;  ///< `from` itself is not allowed

    static Range positive() { return {0, std::numeric_limits<double>::infinity(), true}; }
    static Range notNegative() { return {0}; }
    static Range share() { return {0, 1}; }
};

/// A map of a YAML file, read key by key. Errors name file, line, key, and what is allowed.
class YamlFields
{
 public:
    YamlFields(std::string file, YAML::Node map, std::string where);

    [[nodiscard]] bool has(const std::string& key);
    [[nodiscard]] int line() const { return line_of(map_); }
    [[nodiscard]] const std::string& file() const { return file_; }

    /// Each leaves the value alone where the key is not there.
    void read(const std::string& key, double& value, Range range = {});
    void read(const std::string& key, int& value);
    void read(const std::string& key, bool& value);
    void read(const std::string& key, std::string& value);
    void read(const std::string& key, Point2& value);
    void read(const std::string& key, std::vector<Point2>& value);
    void read(const std::string& key, std::vector<double>& value, std::size_t count);

    /// The map below this key.
    [[nodiscard]] std::optional<YamlFields> fields(const std::string& key);
    /// The maps of the list below this key; none where it is not there.
    [[nodiscard]] std::vector<YamlFields> list(const std::string& key);

    /// Keys that finish() is to accept, read or not.
    void allow(const std::vector<std::string>& keys);
    /// To be called when all has been read: throws for keys that nobody asked for.
    void finish() const;
    [[noreturn]] void fail(const std::string& reason) const;
    [[noreturn]] void fail(const std::string& key, const std::string& reason) const;

    [[nodiscard]] static int line_of(const YAML::Node& node) { return node.Mark().line + 1; }

 private:
    [[nodiscard]] YAML::Node get(const std::string& key);
    [[nodiscard]] double number(const YAML::Node& node, const std::string& key, Range range) const;
    [[nodiscard]] Point2 point(const YAML::Node& node, const std::string& key) const;
    [[noreturn]] void failAt(int line, const std::string& reason) const;

    std::string file_;
    YAML::Node map_;
    std::string where_;  ///< for messages: "laser", "objects[3]"
    std::vector<std::string> known_;
};
}  // namespace rtob::sim
