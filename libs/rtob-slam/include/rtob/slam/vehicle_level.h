// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation.h>
#include <rtob/fusion/fusion_options.h>
#include <rtob/fusion/sensor_watch.h>
#include <rtob/slam/motion_readings.h>

#include <boost/circular_buffer.hpp>
#include <optional>

namespace rtob
{
/// Keeps what was told of roll, pitch and height, for the time when a scan asks. Allocates nothing
/// after construction.
class VehicleLevel
{
 public:
    explicit VehicleLevel(const FusionOptions& options = {});

    void observe(const mrpt::obs::CObservation& observation);

    /// At this time; nothing where there is no reading close to it.
    [[nodiscard]] std::optional<Tilt> tiltAt(double time_s) const;
    [[nodiscard]] std::optional<double> heightAt(double time_s) const;

    [[nodiscard]] const SensorWatch& attitude() const { return attitude_; }
    [[nodiscard]] const SensorWatch& altimeter() const { return altimeter_; }

 private:
    struct Reading
    {
        double time_s;
        Eigen::Vector2d value;
    };
    using Readings = boost::circular_buffer<Reading>;

    void addTilt(double time_s, const Tilt& tilt);
    void addHeight(double time_s, double height_m);
    static void add(
        double time_s, const Eigen::Vector2d& value, bool is_plausible, SensorWatch& watch,
        Readings& readings);
    [[nodiscard]] static std::optional<Eigen::Vector2d> at(double time_s, const Readings& readings);

    double max_climb_mps_;
    SensorWatch attitude_, altimeter_;
    Readings tilts_, heights_;  ///< by time
};
}  // namespace rtob
