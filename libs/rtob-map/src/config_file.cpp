// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/nearest_name.h>
#include <rtob/map/config_file.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <utility>

namespace rtob
{
namespace
{
constexpr const char* blanks = " \t\r";

std::string trimmed(const std::string& text)
{
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool starts_with(const std::string& text, const std::string& start)
{
    return text.compare(0, start.size(), start) == 0;
}

bool is_comment(const std::string& text)
{
    return starts_with(text, "#") || starts_with(text, ";") || starts_with(text, "//");
}

/// Cuts a comment that starts the value or follows a blank: "3 # cm" but not "a#b" or "http://x".
std::string without_comment(const std::string& value)
{
    for (std::size_t i = 0; i < value.size(); ++i)
    {
        const bool may_start = i == 0 || value[i - 1] == ' ' || value[i - 1] == '\t';
        if (may_start && is_comment(value.substr(i, 2))) return trimmed(value.substr(0, i));
    }
    return trimmed(value);
}

/// Reads the lines of a file one after the other and throws at the first that MRPT would skip or
/// merge.
class SyntaxCheck
{
 public:
    explicit SyntaxCheck(std::string file) : file_(std::move(file)) {}

    void readLine(const std::string& raw)
    {
        ++line_;
        const std::string line = trimmed(line_ == 1 ? withoutByteOrderMark(raw) : raw);
        const bool continues = std::exchange(continued_, !line.empty() && line.back() == '\\');
        if (continues || line.empty() || is_comment(line)) return;
        if (starts_with(line, "@")) return;  // a directive of MRPT's reader, such as @define
        if (line.front() == '[')
            readSection(line);
        else
            readKey(line);
    }

 private:
    static std::string withoutByteOrderMark(const std::string& line)
    {
        return starts_with(line, "\xEF\xBB\xBF") ? line.substr(3) : line;
    }

    void readSection(const std::string& line)
    {
        const auto end = line.find(']');
        if (end == std::string::npos) refuse("'" + line + "' lacks its closing ']'");
        section_ = trimmed(line.substr(1, end - 1));
        if (section_.empty()) refuse("a section without a name");
        if (!without_comment(line.substr(end + 1)).empty())
            refuse("text after the section's ']': '" + line + "'");
    }

    void readKey(const std::string& line)
    {
        const auto equals = line.find('=');
        if (equals == std::string::npos)
            refuse("'" + line + "' is neither [section], key = value nor a comment");
        const std::string key = trimmed(line.substr(0, equals));
        if (key.empty()) refuse("'" + line + "' lacks the key before '='");
        if (section_.empty()) refuse("key '" + key + "' stands before the first [section]");
        const auto [first, is_new] = first_lines_.insert({lower(section_ + "/" + key), line_});
        if (is_new) return;
        refuse(
            "key '" + key + "' of section [" + section_ + "] was set already in line " +
            std::to_string(first->second) + "; keep one");
    }

    /// MRPT's reader takes "Key" and "key" for the same.
    static std::string lower(std::string text)
    {
        for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        return text;
    }

    [[noreturn]] void refuse(const std::string& why) const
    {
        throw std::runtime_error(file_ + ", line " + std::to_string(line_) + ": " + why);
    }

    std::string file_;
    std::size_t line_ = 0;
    bool continued_ = false;  ///< the last line ended in a backslash
    std::string section_;
    std::map<std::string, std::size_t> first_lines_;  ///< where "section/key" was first set
};
}  // namespace

mrpt::config::CConfigFile open_config(const std::string& file)
{
    if (!std::filesystem::exists(file))
        throw std::runtime_error("configuration file " + file + " does not exist");
    if (!std::filesystem::is_regular_file(file))
        throw std::runtime_error("configuration file " + file + " is not a regular file");
    std::ifstream in(file);
    if (!in) throw std::runtime_error("configuration file " + file + " cannot be read");
    SyntaxCheck check(file);
    for (std::string line; std::getline(in, line);) check.readLine(line);
    return mrpt::config::CConfigFile(file);
}

void check_sections(
    const mrpt::config::CConfigFileBase& config, const std::vector<std::string>& known)
{
    std::vector<std::string> sections;
    config.getAllSections(sections);
    for (const auto& section : sections)
    {
        if (section.empty()) continue;  // MRPT's home for comment lines before the first section
        if (std::find(known.begin(), known.end(), section) != known.end()) continue;
        throw std::runtime_error(
            config_name(config) + ": unknown section [" + section + "]" +
            suggestion(section, known));
    }
}

std::string config_name(const mrpt::config::CConfigFileBase& config)
{
    const auto* file = dynamic_cast<const mrpt::config::CConfigFile*>(&config);
    return file ? file->getAssociatedFile() : "configuration in memory";
}

std::vector<std::string> config_keys(
    const mrpt::config::CConfigFileBase& config, const std::string& section)
{
    std::vector<std::string> keys;
    config.getAllKeys(section, keys);
    // MRPT takes the comment line "// a = b" for a key named "// a".
    keys.erase(std::remove_if(keys.begin(), keys.end(), is_comment), keys.end());
    return keys;
}

std::string config_value(
    const mrpt::config::CConfigFileBase& config, const std::string& section, const std::string& key)
{
    return without_comment(config.read_string(section, key, ""));
}
}  // namespace rtob
