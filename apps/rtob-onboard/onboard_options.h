// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace rtob
{
/// [Onboard]
struct OnboardOptions
{
    std::string output_folder = "flights";
    int max_waiting_scans = 3;
    double status_period_s = 5;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit(
            "output_folder", s.output_folder,
            "each run makes a folder of its own in it, named after the time it began");
        visit(
            "max_waiting_scans", s.max_waiting_scans,
            "scans that wait to be localised; a newer one drops the oldest; 1 to 100");
        visit("status_period_s", s.status_period_s, "time between two lines of status; 0: none");
    }
    void validate() const;
};

/// [Capture]
struct CaptureOptions
{
    bool enabled = true;
    double flush_s = 0.5;
    double rotate_mb = 500;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("enabled", s.enabled, "write all observations and poses into a rawlog");
        visit(
            "flush_s", s.flush_s,
            "what is older is on the disk, whatever happens to the program; 0.05 to 10");
        visit("rotate_mb", s.rotate_mb, "a capture of this size is followed by another; >= 1");
    }
    void validate() const;
};

/// [StateStream]
struct StateStreamOptions
{
    std::string udp_host = "127.0.0.1";
    unsigned udp_port = 0;
    std::string tcp_bind = "127.0.0.1";
    unsigned tcp_port = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("udp_host", s.udp_host, "the address that gets a datagram of JSON with each pose");
        visit("udp_port", s.udp_port, "its port; 0: none");
        visit(
            "tcp_bind", s.tcp_bind,
            "the own address where clients may connect for lines of JSON; 0.0.0.0: any");
        visit("tcp_port", s.tcp_port, "the port there; 0: none");
    }
    void validate() const;
};
}  // namespace rtob
