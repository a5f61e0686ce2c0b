// SPDX-License-Identifier: BSD-3-Clause
#include "campaign.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

namespace rtob::fly
{
namespace
{
constexpr std::size_t kNumbersKept = 10;
constexpr double kDoorSpare_m = 0.10;  // beyond twice the clearance
constexpr double kDoorFlight_s = 20;

template <class Part>
auto nth(const Part& parts, std::uint64_t& number)
{
    const auto chosen = parts[number % parts.size()];
    number /= parts.size();
    return chosen;
}
}  // namespace

void CampaignTally::add(std::uint64_t number, const FlightSetup& setup, const FlightResult& result)
{
    CampaignTally one;
    one.flights = 1;
    one.flights_with_contact = result.contacts > 0 ? 1 : 0;
    one.contacts = static_cast<std::uint64_t>(result.contacts);
    one.side_changes = static_cast<std::uint64_t>(result.side_changes);
    one.decisions = result.decisions;
    one.flown_s = setup.duration_s;
    one.flown_m = result.flown_m;
    one.wished_m = result.wished_m;
    one.along_wish_m = result.along_wish_m;
    one.decision_s = result.decision_s;
    one.least_gap_m = result.least_gap_m;
    one.least_gap_flight = number;
    one.reasons = result.reasons;
    if (result.contacts > 0) one.contact_flights.push_back(number);
    *this += one;
}

CampaignTally& CampaignTally::operator+=(const CampaignTally& other)
{
    flights += other.flights;
    flights_with_contact += other.flights_with_contact;
    contacts += other.contacts;
    side_changes += other.side_changes;
    decisions += other.decisions;
    flown_s += other.flown_s;
    flown_m += other.flown_m;
    wished_m += other.wished_m;
    along_wish_m += other.along_wish_m;
    decision_s += other.decision_s;
    if (other.least_gap_m < least_gap_m)
    {
        least_gap_m = other.least_gap_m;
        least_gap_flight = other.least_gap_flight;
    }
    for (std::size_t i = 0; i < reasons.size(); ++i) reasons[i] += other.reasons[i];
    for (const auto number : other.contact_flights)
        if (contact_flights.size() < kNumbersKept) contact_flights.push_back(number);
    return *this;
}

NumberedFlight numbered_flight(const CampaignPlan& plan, std::uint64_t number)
{
    NumberedFlight flight;
    std::uint64_t rest = number;
    flight.world = nth(plan.worlds, rest);
    flight.setup.avoider = plan.avoider;
    flight.setup.pilot = nth(plan.pilots, rest);
    flight.setup.hardship.always_latest = rest % 2 == 0;
    flight.setup.hardship.holds_place = plan.holds_place;
    flight.setup.hardship.field_of_view_deg = plan.field_of_view_deg;
    flight.setup.seed = number + 1;
    flight.setup.duration_s = plan.duration_s;
    flight.setup.limits = fly_limits();
    flight.setup.options = fly_options();
    return flight;
}

CampaignTally run_campaign(
    const CampaignPlan& plan, const std::function<void(std::uint64_t)>& progress)
{
    CampaignTally tally;
    std::atomic<std::uint64_t> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&]
    {
        try
        {
            for (std::uint64_t i = next++; i < plan.flights; i = next++)
            {
                const std::uint64_t number = plan.first + i;
                const NumberedFlight flight = numbered_flight(plan, number);
                const FlightResult result = fly(make_fly_world(flight.world), flight.setup);
                const std::lock_guard<std::mutex> lock(mutex);
                tally.add(number, flight.setup, result);
                progress(tally.flights);
            }
        }
        catch (...)
        {
            const std::lock_guard<std::mutex> lock(mutex);
            failure = std::current_exception();
        }
    };
    std::vector<std::thread> workers;
    for (unsigned job = 1; job < plan.jobs; ++job) workers.emplace_back(work);
    work();
    for (std::thread& worker : workers) worker.join();
    if (failure) std::rethrow_exception(failure);
    return tally;
}

DoorTally try_doors(const std::string& avoider, int tries, double field_of_view_deg)
{
    DoorTally doors;
    Random random(1);
    for (int i = 0; i < tries; ++i)
    {
        FlightSetup setup;
        setup.avoider = avoider;
        setup.pilot = PilotKind::Straight;
        setup.seed = static_cast<std::uint64_t>(i) + 1;
        setup.duration_s = kDoorFlight_s;
        setup.hardship.field_of_view_deg = field_of_view_deg;
        setup.limits = fly_limits();
        setup.options = fly_options();
        const double width_m = 2 * setup.limits.clearance() + kDoorSpare_m;
        const FlyWorld world = door_world(width_m, i % 2 == 0 ? 0.1 : 0.4);
        // Straight along +x, up to half a vehicle off the door's middle.
        const double off_m = (random.uniform() - 0.5) * 2 * setup.limits.radius_m;
        const double yaw_rad =
            field_of_view_deg < 360 ? random.uniform() - 0.5 : 6 * random.uniform();
        setup.start_map = Pose2{1.2, off_m, yaw_rad};
        const FlightResult result = fly(world, setup);
        ++doors.tries;
        doors.passed += result.end_map.x > 4 && result.contacts == 0 ? 1 : 0;
        doors.flights.add(static_cast<std::uint64_t>(i), setup, result);
    }
    return doors;
}
}  // namespace rtob::fly
