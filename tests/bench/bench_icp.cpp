// SPDX-License-Identifier: BSD-3-Clause
// 360 beams against 3600 drawn points, 50 iterations, pairs within 0.3 m: ours with draw and grid,
// MRPT's CICP with its kd-tree, PCL's ICP with the paper's settings. Nobody may stop early.
#include "standing_map.h"

#include <benchmark/benchmark.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/slam/CICP.h>
#include <rtob/core/icp.h>

#ifdef RTOB_HAVE_PCL
// gcc 12 is wrong about Eigen's umeyama, as PCL uses it.
#pragma GCC diagnostic ignored "-Warray-bounds"
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>
#endif

using namespace rtob;

namespace
{
constexpr int kIterations = 50;
constexpr double kPairDistance_m = 0.3;

/// The scan of a vehicle that is 7 cm and 1.1 deg off its guess, and a reference for it.
struct Task
{
    const test::TestMap& map = bench::standing_map(1'000'000);
    Moment now = bench::now_of(map);
    Points scan = test::moved(
        test::room_4x3().scan_vehicle({now.x - 0.05, now.y + 0.05, 0.03}), {0, 0, 0.05});
    TimeDensity density;
    ReferenceDraw draw;
    Random random{1};
    Reference reference;

    Task() { drawPoints(); }
    void drawPoints() { draw.draw(map.view(), density, now, {}, random, reference); }
};

void ours(benchmark::State& state, IcpMetric metric)
{
    Task task;
    IcpOptions options;
    options.iterations = kIterations;
    options.stop_step_m = 0;
    options.max_pair_distance_m = options.final_pair_distance_m = kPairDistance_m;
    options.metric = metric;
    options.kernel = RobustKernel::None;
    Icp icp(options);
    for (auto _ : state)
    {
        task.drawPoints();
        benchmark::DoNotOptimize(icp.align(task.scan.view(), task.reference.points.view()));
    }
}

void mrpt_cicp(benchmark::State& state)
{
    const Task task;
    const Points &scan = task.scan, &points = task.reference.points;
    mrpt::maps::CSimplePointsMap reference, moving;
    moving.setAllPoints(scan.x, scan.y);
    mrpt::slam::CICP::TConfigParams config;
    config.ICP_algorithm = mrpt::slam::icpClassic;
    config.maxIterations = kIterations;
    config.minAbsStep_trans = config.minAbsStep_rot = 0;
    config.thresholdDist = kPairDistance_m;
    config.thresholdAng = 0;
    config.ALFA = 0.999999;
    config.smallestThresholdDist = kPairDistance_m;
    config.corresponding_points_decimation = 1;
    config.doRANSAC = false;
    config.skip_cov_calculation = true;
    mrpt::slam::CICP icp(config);
    for (auto _ : state)
    {
        reference.setAllPoints(points.x, points.y);  // and so a new kd-tree
        mrpt::slam::CICP::TReturnInfo info;
        benchmark::DoNotOptimize(icp.Align(&reference, &moving, mrpt::poses::CPose2D(), info));
        state.counters["iterations"] = info.nIterations;
    }
}

#ifdef RTOB_HAVE_PCL
void pcl_icp(benchmark::State& state)
{
    const Task task;
    using Cloud = pcl::PointCloud<pcl::PointXYZ>;
    const auto cloud_of = [](const Points& points)
    {
        Cloud::Ptr cloud(new Cloud);
        for (std::size_t i = 0; i < points.size(); ++i)
            cloud->push_back({points.x[i], points.y[i], 0});
        return cloud;
    };
    const auto scan = cloud_of(task.scan), reference = cloud_of(task.reference.points);
    for (auto _ : state)
    {
        pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
        icp.setMaximumIterations(kIterations);
        icp.setTransformationEpsilon(1e-9);
        icp.setEuclideanFitnessEpsilon(1e-9);
        icp.setMaxCorrespondenceDistance(kPairDistance_m);
        icp.setInputSource(scan);
        icp.setInputTarget(reference);
        Cloud aligned;
        icp.align(aligned);
        benchmark::DoNotOptimize(icp.getFinalTransformation());
    }
}
BENCHMARK(pcl_icp)->Unit(benchmark::kMicrosecond);
#endif

BENCHMARK_CAPTURE(ours, point_to_point, IcpMetric::PointToPoint)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ours, point_to_line, IcpMetric::PointToLine)->Unit(benchmark::kMicrosecond);
BENCHMARK(mrpt_cicp)->Unit(benchmark::kMicrosecond);
}  // namespace
