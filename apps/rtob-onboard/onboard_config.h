// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/config/CConfigFile.h>
#include <rtob/drivers/autopilot_options.h>
#include <rtob/drivers/pilot_stick.h>

#include <optional>
#include <string>
#include <vector>

#include "onboard_options.h"
#include "pilot_options.h"
#include "run/run_options.h"

namespace rtob
{
/// A sensor of the configuration: a section with a `driver`, as for rawlog-grabber.
struct SensorSection
{
    std::string name, driver;
    std::string port;         ///< of a serial line; empty: none
    double sweep_s = 0;       ///< of its scans, where the driver does not tell; 0: not known
    double stamp_late_s = 0;  ///< from a scan's first beam until the driver has it
    /// Of silence; 0: never. Not given: 3 s for lasers, never for others.
    std::optional<double> restart_after_s;
};

/// All that an .ini of rtob-onboard may hold.
struct OnboardConfig
{
    RunConfig run;
    OnboardOptions onboard;
    CaptureOptions capture;
    StateStreamOptions stream;
    AutopilotOptions autopilot;
    PilotOptions pilot;
    StickOptions stick;
    std::vector<SensorSection> sensors;

    template <class Self, class Visit>
    static void sections(Self& s, Visit&& visit)
    {
        visit("Onboard", s.onboard);
        visit("Capture", s.capture);
        visit("StateStream", s.stream);
        visit("Autopilot", s.autopilot);
        visit("Pilot", s.pilot);
        visit("Stick", s.stick);
    }
};

/// Throws std::runtime_error that names file, section, key and the fix.
[[nodiscard]] OnboardConfig load_onboard_config(const mrpt::config::CConfigFileBase& ini);
}  // namespace rtob
