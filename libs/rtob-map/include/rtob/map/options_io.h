// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/nearest_name.h>
#include <rtob/map/config_file.h>
#include <rtob/map/option_text.h>

#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

/// Options structs from and to configuration files, flags and documents. A struct T of options
/// lists its fields once,
///     template <class Self, class Visit>
///     static void fields(Self& s, Visit&& visit) { visit("key_m", s.key_m, "what it does; > 0");
///     ... }
/// and throws std::invalid_argument from `void validate() const` where a value is out of its range.
/// A field is a double, float, int, unsigned, std::uint64_t, bool, std::string or an enum with
/// names.
namespace rtob
{
/// The keys of T in the order of its list.
template <class T>
[[nodiscard]] std::vector<std::string> option_keys()
{
    std::vector<std::string> keys;
    const T options{};
    T::fields(options, [&](const char* key, const auto&, const char*) { keys.emplace_back(key); });
    return keys;
}

/// Sets one field from text, as a command line does; std::invalid_argument names the key and what
/// is allowed. Call options.validate() after the last one: ranges may hang on several fields.
template <class T>
void set_option(T& options, const std::string& wanted_key, const std::string& text)
{
    bool is_known = false;
    T::fields(
        options,
        [&](const char* key, auto& value, const char*)
        {
            if (wanted_key != key) return;
            is_known = true;
            try
            {
                parse_option(text, value);
            }
            catch (const std::invalid_argument& e)
            {
                throw std::invalid_argument("key " + wanted_key + ": " + e.what());
            }
        });
    if (!is_known)
        throw std::invalid_argument(
            "unknown key '" + wanted_key + "'" + suggestion(wanted_key, option_keys<T>()));
}

/// Sets the fields whose keys stand in the section; the others keep their values. An unknown key, a
/// malformed value or one out of range throws std::runtime_error that names file, section and key;
/// then `options` is as before.
template <class T>
void load_options(
    const mrpt::config::CConfigFileBase& config, const std::string& section, T& options)
{
    T loaded = options;
    try
    {
        for (const auto& key : config_keys(config, section))
            set_option(loaded, key, config_value(config, section, key));
        loaded.validate();
    }
    catch (const std::invalid_argument& e)
    {
        throw std::runtime_error(config_name(config) + ", section [" + section + "], " + e.what());
    }
    options = loaded;
}

/// What a field accepts beyond what its doc says: the names of an enum.
template <class Field>
[[nodiscard]] std::string allowed_names()
{
    if constexpr (std::is_enum_v<Field>)
        return "; one of: " + joined(all_names<Field>());
    else
        return {};
}

/// Writes the section with every key, its doc as a comment above it. Read back, each value has the
/// same bits.
template <class T>
void save_options(std::ostream& out, const std::string& section, const T& options)
{
    out << "[" << section << "]\n";
    T::fields(
        options,
        [&](const char* key, const auto& value, const char* doc)
        {
            using Field = std::decay_t<decltype(value)>;
            out << "# " << doc << allowed_names<Field>() << "\n"
                << key << " = " << option_text(value) << "\n";
        });
}

/// A bar would end the cell of a Markdown table.
[[nodiscard]] inline std::string markdown_cell(const std::string& text)
{
    std::string cell;
    for (const char c : text) cell += c == '|' ? std::string("\\|") : std::string(1, c);
    return cell;
}

/// A Markdown section with a table: key, default (the values of `options`), what it does and its
/// range.
template <class T>
[[nodiscard]] std::string options_markdown(const std::string& section, const T& options)
{
    std::string text =
        "## [" + section + "]\n\n| key | default | meaning, range |\n|---|---|---|\n";
    T::fields(
        options,
        [&](const char* key, const auto& value, const char* doc)
        {
            using Field = std::decay_t<decltype(value)>;
            const std::string shown = option_text(value);
            text += "| `" + std::string(key) + "` | " + (shown.empty() ? "" : "`" + shown + "`") +
                    " | " + markdown_cell(doc + allowed_names<Field>()) + " |\n";
        });
    return text;
}
}  // namespace rtob
