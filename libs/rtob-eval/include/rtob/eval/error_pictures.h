// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

/// Pictures of where and when a trajectory is wrong. 8-bit BGR; texts are ASCII.
namespace rtob
{
/// One panel of the plot.
struct ErrorCurve
{
    std::string name;            ///< with its unit: "translation error, m"
    std::vector<double> values;  ///< one a time, >= 0
    double mean = 0;             ///< drawn as a level
    double rmse = 0;
};

struct ErrorPlotInput
{
    std::string title;
    std::string facts;               ///< a line below the title
    std::vector<double> times_s;     ///< of the errors; in any order, from any zero
    std::vector<ErrorCurve> curves;  ///< at least one; one panel each, one below the other
};

/// Errors over time, a dot each. Throws std::invalid_argument when there are none, or not as many
/// as times.
[[nodiscard]] cv::Mat draw_error_plot(const ErrorPlotInput& input);

struct ErrorPathInput
{
    std::string title;
    std::string facts;
    std::vector<Pose2> path;       ///< in the reference's map where there is one
    std::vector<double> errors_m;  ///< one a pose; NaN where it is not known
    std::vector<Pose2> reference;  ///< may be empty; drawn below in grey
    int max_long_side_px = 1600;   ///< >= 400
};

/// The path coloured by its error, the largest errors on top. The colours end at the 98th
/// percentile where the largest error is far above it. Throws std::invalid_argument as above.
[[nodiscard]] cv::Mat draw_error_path(const ErrorPathInput& input);

/// Write them as PNG; a file of that name holds either its old or the whole new content. Throw
/// std::runtime_error when it cannot be written.
void write_error_plot(const std::string& file, const ErrorPlotInput& input);
void write_error_path(const std::string& file, const ErrorPathInput& input);
}  // namespace rtob
