// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/io/log_reader.h>

#include <string>

#include "carmen_survey.h"
#include "line_source.h"

namespace rtob
{
/// CARMEN text logs: FLASER, RLASER, ROBOTLASER1, ROBOTLASER2, and ODOM where the laser lines carry
/// no odometry. A laser line becomes its odometry ("odometry"), then its scan ("laser_front",
/// "laser_rear"), both with the line's stamp. Comments and messages of other kinds are passed over.
class CarmenReader : public LogReader
{
 public:
    explicit CarmenReader(const std::string& file);

    [[nodiscard]] std::optional<LogEntry> next() override;
    [[nodiscard]] double progress() const override { return lines_.progress(); }
    [[nodiscard]] LogLosses losses() const override { return losses_; }

 private:
    [[nodiscard]] std::optional<LogEntry> read_line(std::string_view line);
    [[nodiscard]] std::optional<LogEntry> read_scan(TextFields& fields);
    [[nodiscard]] LogError line_error(const std::string& problem, const std::string& fix) const;

    std::string file_;
    CarmenSurvey survey_;
    LineSource lines_;
    CarmenScan scan_;
    LogLosses losses_;
    mrpt::obs::CObservation::Ptr waiting_scan_;  ///< its odometry was given out just before
};
}  // namespace rtob
