// SPDX-License-Identifier: BSD-3-Clause
#include "compare/variant_run.h"

#include <rtob/core/processor_time.h>
#include <rtob/eval/map_picture.h>
#include <rtob/io/atomic_file.h>
#include <rtob/io/tum.h>
#include <rtob/slam/scan_filter.h>

#include <chrono>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "compare/scan_steps.h"

namespace rtob
{
namespace
{
struct ScanTimes
{
    std::vector<double> stamps_s;
    std::vector<float> wall_ms, cpu_ms;
};

struct VariantResult
{
    std::vector<StampedPose2> path;  ///< in the program's own map frame
    ScanTimes times;
    double peak_memory_mb = 0;
    std::optional<std::uint64_t> lost_scans;
};

/// Of this program alone: getrusage() would count what its parent held when it started it.
double peak_memory_mb()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind("VmHWM:", 0) == 0) return std::stod(line.substr(6)) * 1024 / 1e6;
    return 0;
}

double written_stamp(const mrpt::obs::CObservation& scan)
{
    return scan.timestamp == INVALID_TIMESTAMP ? 0 : mrpt::Clock::toDouble(scan.timestamp);
}

/// @param stamp_s taken before: the program may change the scan
void add_step(Variant& variant, const ScanStep& step, double stamp_s, VariantResult& result)
{
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const double start_s = process_processor_time_s();
    const Pose2 pose_map_vehicle = variant.process(step);
    const double cpu_s = process_processor_time_s() - start_s;
    const std::chrono::duration<float, std::milli> wall = Clock::now() - start;
    if (!is_finite(pose_map_vehicle))
        throw std::runtime_error(
            "the pose at scan " + std::to_string(result.path.size() + 1) + " is not a number");
    result.path.push_back({stamp_s, pose_map_vehicle});
    result.times.stamps_s.push_back(stamp_s);
    result.times.wall_ms.push_back(wall.count());
    result.times.cpu_ms.push_back(static_cast<float>(1e3 * cpu_s));
}

/// Too slow to wait for: half a path would look better, or worse, than the whole one.
class TimeLimit
{
 public:
    explicit TimeLimit(double limit_s) : limit_s_(limit_s) {}

    /// Throws std::runtime_error when it has passed.
    void check(std::size_t scans) const
    {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
        if (limit_s_ <= 0 || elapsed.count() <= limit_s_) return;
        std::ostringstream text;
        text << "too slow: ended at scan " << scans << " by --time-limit, after " << limit_s_ / 60
             << " min";
        throw std::runtime_error(text.str());
    }

 private:
    double limit_s_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

VariantResult run_over_log(const VariantJob& job, const RunConfig& config, Variant& variant)
{
    VariantResult result;
    ScanSteps steps(job.log, config, job.limits);
    const TimeLimit limit(job.time_limit_s);
    while (const auto step = steps.next())
    {
        limit.check(result.path.size());
        add_step(variant, *step, written_stamp(*step->scan), result);
    }
    result.lost_scans = variant.lostScans();
    result.peak_memory_mb = peak_memory_mb();
    if (result.path.empty()) throw std::runtime_error(no_scans_message(job.log, steps.read()));
    return result;
}

/// All scans of the log as if the vehicle had been where the path says.
Points scans_along(
    const std::vector<StampedPose2>& path, const VariantJob& job, const RunConfig& config)
{
    ScanSteps steps(job.log, config, job.limits);
    ScanFilter filter(config.slam.scan_filter);
    Points points_vehicle, points_map;
    for (const auto& [stamp_s, pose] : path)
    {
        const auto step = steps.next();
        if (!step) break;
        filter.filter(*step->scan, step->scan->sensorPose, points_vehicle);
        const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
        for (std::size_t i = 0; i < points_vehicle.size(); ++i)
        {
            const double x = points_vehicle.x[i], y = points_vehicle.y[i];
            points_map.add(
                static_cast<float>(pose.x + c * x - s * y),
                static_cast<float>(pose.y + s * x + c * y));
        }
    }
    return points_map;
}

void write_picture(
    const std::string& file, const Points& points_map, const std::vector<StampedPose2>& path,
    const std::string& title)
{
    MapPictureInput picture;
    picture.points_map = points_map.view();
    for (const auto& stamped : path) picture.path.push_back(stamped.pose);
    picture.title = title;
    picture.max_long_side_px = 1000;
    write_map_picture(file, picture);
}

void write_trajectory(const std::string& file, std::vector<StampedPose2> path)
{
    const Pose2 pose_map_first = path.front().pose;
    for (auto& stamped : path) stamped.pose = between(pose_map_first, stamped.pose);
    write_tum(file, path);
}

void write_times(const std::string& file, const ScanTimes& times)
{
    AtomicFile out(file);
    out.stream() << std::fixed << "stamp_s,wall_ms,cpu_ms\n";
    for (std::size_t i = 0; i < times.stamps_s.size(); ++i)
        out.stream() << std::setprecision(6) << times.stamps_s[i] << std::setprecision(4) << ','
                     << times.wall_ms[i] << ',' << times.cpu_ms[i] << '\n';
    out.commit();
}

void read_times(const std::string& file, ComparedRun& run)
{
    std::ifstream in(file);
    std::string header;
    std::getline(in, header);
    char comma = ',';
    double stamp_s = 0;
    float wall_ms = 0, cpu_ms = 0;
    while (in >> stamp_s >> comma >> wall_ms >> comma >> cpu_ms)
    {
        run.scan_wall_ms.push_back(wall_ms);
        run.scan_cpu_ms.push_back(cpu_ms);
    }
    if (run.scan_cpu_ms.empty()) throw std::runtime_error(file + " holds no times");
}
}  // namespace

void run_variant(const VariantJob& job, const MakeVariant& make)
{
    const RunConfig config = config_of(job);
    const auto variant = make(job);
    const VariantResult result = run_over_log(job, config, *variant);
    const VariantMap map = variant->map();
    const std::string folder = job.folder + "/";
    write_trajectory(folder + "trajectory.tum", result.path);
    write_times(folder + "timing.csv", result.times);
    write_picture(folder + "map.png", map.points, result.path, job.title + ": its own map");
    write_picture(
        folder + "scans.png", scans_along(result.path, job, config), result.path, job.title);
    nlohmann::ordered_json json{
        {"scans", result.path.size()},
        {"peak_memory_mb", result.peak_memory_mb},
        {"map_size", map.size},
        {"map_unit", map.unit}};
    if (result.lost_scans) json["lost_scans"] = *result.lost_scans;
    write_text(folder + "result.json", json.dump(2) + "\n");
}

void read_variant_run(const std::string& folder, ComparedRun& run)
{
    const std::string file = folder + "/result.json";
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file + " was not written");
    const auto json = nlohmann::json::parse(in);
    json.at("peak_memory_mb").get_to(run.peak_memory_mb);
    json.at("map_size").get_to(run.map_size);
    json.at("map_unit").get_to(run.map_unit);
    if (json.contains("lost_scans")) run.lost_scans = json["lost_scans"].get<std::uint64_t>();
    run.trajectory = read_tum(folder + "/trajectory.tum");
    read_times(folder + "/timing.csv", run);
}
}  // namespace rtob
