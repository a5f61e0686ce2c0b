// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace rtob::devices
{
/// The device's end of a serial line that a program opens by a name of the file system. The name is
/// a link, so that it stays the same while the device is unplugged and plugged in again.
class PseudoTerminal
{
 public:
    /// Throws std::runtime_error where the link cannot be made.
    explicit PseudoTerminal(std::string link);
    ~PseudoTerminal();
    PseudoTerminal(const PseudoTerminal&) = delete;
    PseudoTerminal& operator=(const PseudoTerminal&) = delete;

    void plug();
    void unplug();
    [[nodiscard]] bool isPlugged() const { return master_ >= 0; }
    [[nodiscard]] const std::string& name() const { return link_; }

    /// What the program has sent; waits for it at most this long.
    [[nodiscard]] std::vector<std::uint8_t> receive(int timeout_ms);
    /// As much as fits: a program that does not read loses bytes, as on a real line.
    void send(const std::vector<std::uint8_t>& bytes);
    /// The speed that the program chose.
    [[nodiscard]] unsigned baud() const;

 private:
    std::string link_;
    int master_ = -1;
    int slave_ = -1;  ///< held open, or closing programs would look like unplugging
};
}  // namespace rtob::devices
