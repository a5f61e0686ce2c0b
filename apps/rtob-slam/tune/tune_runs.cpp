// SPDX-License-Identifier: BSD-3-Clause
#include "tune/tune_runs.h"

#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/core/processor_time.h>
#include <rtob/core/spread.h>
#include <rtob/eval/trajectory_score.h>
#include <rtob/io/pose_file.h>
#include <rtob/slam/slam.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <thread>

namespace rtob
{
namespace
{
/// Calls work(0) to work(count - 1), a thread a core; the first error is thrown when all are over.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work)
{
    std::atomic<std::size_t> next{0};
    std::exception_ptr error;
    std::mutex error_mutex;
    const auto take = [&]
    {
        for (std::size_t i = next++; i < count; i = next++) try
            {
                work(i);
            }
            catch (...)
            {
                const std::lock_guard lock(error_mutex);
                error = std::current_exception();
            }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back(take);
    for (auto& thread : threads) thread.join();
    if (error) std::rethrow_exception(error);
}
}  // namespace

TuneFlight read_flight(
    const std::string& log, const std::string& truth, std::uint64_t first_scans, bool odometry)
{
    TuneFlight flight;
    flight.truth = read_poses(truth);
    const auto reader = open_log(log);
    std::uint64_t scans = 0;
    while (auto entry = reader->next())
    {
        const auto* seen = entry->observation.get();
        const bool is_scan =
            dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(seen) != nullptr;
        const bool is_odometry =
            entry->motion || dynamic_cast<const mrpt::obs::CObservationOdometry*>(seen) != nullptr;
        if (!is_scan && !(is_odometry && odometry)) continue;
        flight.entries.push_back(std::move(*entry));
        if (is_scan && ++scans == first_scans) break;
    }
    if (scans == 0) throw std::runtime_error(log + " holds no scans");
    return flight;
}

TuneRuns::TuneRuns(std::vector<TuneFlight> flights, int seeds, Done done)
    : flights_(std::move(flights)), seeds_(seeds), done_(std::move(done))
{
}

TuneRuns::OneRun TuneRuns::run(const RunConfig& setting, int seed) const
{
    const auto& flight = flights_[static_cast<std::size_t>(seed - 1) % flights_.size()];
    SlamOptions options = setting.slam;
    options.seed = static_cast<std::uint64_t>(seed);
    Slam slam(options);
    OneRun result;
    std::vector<StampedPose2> path;
    for (const auto& entry : flight.entries)
    {
        if (entry.motion)
        {
            slam.observe(*entry.motion);
            continue;
        }
        // Of the processor: what other programs take is no property of a setting.
        const double start_s = process_processor_time_s();
        const ScanReport* report = slam.observe(*entry.observation);
        const double cpu_s = process_processor_time_s() - start_s;
        if (report == nullptr) continue;
        path.push_back({report->stamp_s, report->pose_map_vehicle});
        result.scan_ms.push_back(static_cast<float>(1e3 * cpu_s));
        if (report->state == TrackingState::Lost) ++result.lost_scans;
    }
    ScoreOptions score;
    score.relative.clear();
    result.rmse_m = score_trajectory(path, flight.truth, score).absolute.distance_m.rmse;
    return result;
}

void TuneRuns::measureAccuracy(
    const std::vector<RunConfig>& settings, std::vector<TuneFigures>& figures) const
{
    const auto seeds = static_cast<std::size_t>(seeds_);
    std::vector<OneRun> runs(settings.size() * seeds);
    std::mutex done_mutex;
    std::size_t over = 0;
    on_all_cores(
        runs.size(),
        [&](std::size_t i)
        {
            runs[i] = run(settings[i / seeds], static_cast<int>(i % seeds) + 1);
            const std::lock_guard lock(done_mutex);
            done_(++over, runs.size());
        });
    for (std::size_t i = 0; i < settings.size(); ++i)
    {
        std::vector<double> errors_m;
        figures[i].lost_scans = 0;
        for (std::size_t seed = 0; seed < seeds; ++seed)
        {
            errors_m.push_back(runs[i * seeds + seed].rmse_m);
            figures[i].lost_scans += runs[i * seeds + seed].lost_scans;
        }
        const Spread spread = spread_of(errors_m);
        figures[i].worst_m = spread.highest;
        figures[i].median_m = spread.median;
    }
}

void TuneRuns::measureTime(
    const std::vector<RunConfig>& settings, std::vector<TuneFigures>& figures) const
{
    for (std::size_t i = 0; i < settings.size(); ++i)
    {
        const auto once = run(settings[i], 1);
        figures[i].p50_ms = percentile(once.scan_ms, 0.5);
        figures[i].p99_ms = percentile(once.scan_ms, 0.99);
        done_(i + 1, settings.size());
    }
}
}  // namespace rtob
