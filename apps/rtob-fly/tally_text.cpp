// SPDX-License-Identifier: BSD-3-Clause
#include "tally_text.h"

#include <rtob/core/enum_names.h>

#include <iomanip>
#include <sstream>

namespace rtob::fly
{
namespace
{
std::string fixed(double value, int decimals)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(decimals) << value;
    return text.str();
}

double share(double part, double whole)
{
    return whole > 0 ? part / whole : 0;
}

std::string row(const std::string& name, const CampaignTally& tally, const std::string& doors)
{
    std::ostringstream text;
    text << "| " << name << " | " << tally.flights << " | " << tally.contacts << " in "
         << tally.flights_with_contact << " | " << fixed(100 * tally.least_gap_m, 1) << " | "
         << fixed(share(tally.flown_m, static_cast<double>(tally.flights)), 1) << " | "
         << fixed(100 * share(tally.along_wish_m, tally.wished_m), 1) << " | "
         << fixed(share(static_cast<double>(tally.side_changes), tally.flown_s / 60), 1) << " | "
         << doors << " | "
         << fixed(1e6 * share(tally.decision_s, static_cast<double>(tally.decisions)), 1) << " |\n";
    return text.str();
}
}  // namespace

std::string tally_head()
{
    return "| | flights | contacts | least gap, cm | flown a flight, m | of the wish, % | side "
           "changes a min | doors passed | us a decision |\n"
           "|---|---|---|---|---|---|---|---|---|\n";
}

std::string tally_row(const std::string& name, const CampaignTally& tally)
{
    return row(name, tally, "-");
}

std::string tally_row(const std::string& name, const CampaignTally& tally, const DoorTally& doors)
{
    return row(name, tally, std::to_string(doors.passed) + " of " + std::to_string(doors.tries));
}

std::string tally_notes(const CampaignTally& tally)
{
    std::ostringstream text;
    text << "reasons:";
    for (std::size_t i = 0; i < tally.reasons.size(); ++i)
        if (tally.reasons[i] > 0)
            text << ' ' << name_of(static_cast<GuardReason>(i)) << ' '
                 << fixed(
                        100 * share(
                                  static_cast<double>(tally.reasons[i]),
                                  static_cast<double>(tally.decisions)),
                        1)
                 << " %";
    text << "\nexcluded: 0 flights (all obstacles stand still, and no flight starts nearer than "
            "clearance + 10 cm to one)\n";
    if (!tally.contact_flights.empty())
    {
        text << "contacts in flights number";
        for (const auto number : tally.contact_flights) text << ' ' << number;
        text << "\n";
    }
    text << "least gap in flight number " << tally.least_gap_flight << "\n";
    return text.str();
}
}  // namespace rtob::fly
