// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_job.h"
#include "run/read_ahead.h"

#include <rtob/core/enum_names.h>
#include <rtob/io/checked_object.h>
#include <rtob/io/tum.h>
#include <rtob/slam/final_path.h>
#include <rtob/slam/map_file.h>
#include <rtob/slam/written_scans.h>

#include <memory>
#include <stdexcept>

#include "run/map_files.h"
#include "run/packed_object.h"
#include "run/peak_memory.h"
#include "run/scan_files.h"
#include "run/scan_mounts.h"

namespace rtob
{
namespace
{
using Clock = ProgressLine::Clock;

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Keeps what the results need of each scan; the folder is made with the first one, so that a log
/// without scans leaves nothing behind.
class ScanRecorder
{
 public:
    ScanRecorder(const RunJob& job, const OutputFolder& folder, const Slam& slam)
        : job_(job), folder_(folder), slam_(slam), sensor_(job.config.slam.sensor)
    {
        if (job.guard_wish) guard_ = std::make_unique<GuardReplay>(job.config, *job.guard_wish);
    }

    void add(const mrpt::obs::CObservation2DRangeScan& scan, const ScanReport& report)
    {
        if (!scan_files_)
        {
            folder_.create();
            scan_files_ = std::make_unique<ScanFiles>(folder_);
            if (guard_) guard_->open(folder_);
        }
        counters_.add(report);
        scan_files_->add(report);
        if (guard_) guard_->add(scan, report);
        path_.add(report);
        const auto mount = sensor_.mountOf(scan);
        mounts_.add(report, {mount.x(), mount.y(), mount.yaw()});
        if (report.inserted && job_.wants_simple_map) keep(scan, mount, report);
    }

    [[nodiscard]] const RunCounters& counters() const { return counters_; }
    [[nodiscard]] std::optional<GuardCounts> guardCounts() const
    {
        return guard_ ? std::optional(guard_->counts()) : std::nullopt;
    }

    /// @return the resolution of the map's picture
    double write()
    {
        scan_files_->commit();
        if (guard_) guard_->commit();
        if (job_.wants_simple_map)
            write_packed_object(folder_.file("map.simplemap"), written_.in(slam_.map().scans()));
        const auto path = path_.in(slam_.map().scans());
        write_tum(folder_.file("trajectory_final.tum"), path);
        std::vector<Pose2> poses;
        for (const StampedPose2& stamped : path) poses.push_back(stamped.pose);
        return write_map_files(
            folder_, {slam_.map(), mounts_.of(slam_.map().scans()), poses,
                      job_.config.run.map_resolution_m, title(), !job_.config.slam.map.localize});
    }

 private:
    /// @param mount replaces the scan's own.
    void keep(
        const mrpt::obs::CObservation2DRangeScan& scan, const mrpt::poses::CPose3D& mount,
        const ScanReport& report)
    {
        const auto copy = mrpt::obs::CObservation2DRangeScan::Create(scan);
        copy->sensorPose = mount;
        written_.add(copy, report);
    }

    /// The picture itself adds path length and number of scans.
    [[nodiscard]] std::string title() const
    {
        const auto name = std::filesystem::path(job_.log).filename().string();
        return name + ", " + std::string(name_of(job_.config.slam.density.density)) + ", seed " +
               std::to_string(job_.config.run.seed);
    }

    const RunJob& job_;
    const OutputFolder& folder_;
    const Slam& slam_;
    SensorChoice sensor_;
    std::unique_ptr<ScanFiles> scan_files_;
    std::unique_ptr<GuardReplay> guard_;
    RunCounters counters_;
    FinalPath path_;
    ScanMounts mounts_;
    WrittenScans written_;
};

void write_config(const OutputFolder& folder, const RunConfig& config)
{
    AtomicFile out(folder.file("config.effective.ini"));
    out.stream() << "# Every option of this run, by rtob-slam " RTOB_VERSION
                    "; given with -c it repeats the run.\n\n";
    save_run_config(out.stream(), config);
    out.commit();
}

RunSummary summary_of(
    const RunJob& job, const Slam& slam, const OfflineRun& run, const RunCounters& counters)
{
    RunSummary summary;
    summary.log = job.log;
    summary.config_file = job.config_file;
    summary.config = job.config;
    summary.limits = job.limits;
    summary.run = run;
    summary.counters = counters;
    summary.clock = slam.map().clock().anomalies();
    summary.final_state = slam.state();
    summary.has_odometry = slam.hasOdometry();
    summary.sensors = sensor_figures(slam.motion());
    summary.map_points = slam.map().size();
    summary.map_scans = slam.map().scans().size();
    summary.map_bytes = slam.map().bytesInUse();
    summary.map_checksum = checksum_text(map_checksum(slam.map()));
    return summary;
}
}  // namespace

RunSummary do_run(const RunJob& job, ProgressLine& progress, const std::function<bool()>& stop)
{
    const OutputFolder folder(job.folder, job.may_overwrite);
    ReadAhead log(open_log(job.log));
    const auto start = Clock::now();
    Slam slam(job.config.slam);
    enter_map(slam);
    const std::uint32_t checksum_before = map_checksum(slam.map());
    ScanRecorder recorder(job, folder, slam);

    const auto run = run_log(
        log, slam, job.limits,
        [&](const auto& scan, const ScanReport& report)
        {
            recorder.add(scan, report);
            progress.update(
                {log.progress(), recorder.counters().scans(), report.map_time_s,
                 seconds_since(start), report.state},
                Clock::now());
        },
        stop);
    progress.clear();
    if (run.scans == 0) throw std::runtime_error(no_scans_message(job.log, run));

    RunSummary summary = summary_of(job, slam, run, recorder.counters());
    summary.guard = recorder.guardCounts();
    summary.map_checksum_before = checksum_text(checksum_before);
    summary.matching_s = seconds_since(start);
    summary.matching_memory_mb = peak_memory_mb();
    summary.map_resolution_m = recorder.write();
    write_config(folder, job.config);
    summary.total_s = seconds_since(start);
    summary.memory_mb = peak_memory_mb();
    write_text(folder.file("summary.json"), summary_json(summary));
    write_text(folder.file("summary.txt"), summary_text(summary));
    return summary;
}
}  // namespace rtob
