// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/slam/drift.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace rtob
{
void DriftOptions::validate() const
{
    require(share >= 0, "share", share, ">= 0");
    require(trusted_m > 0, "trusted_m", trusted_m, "> 0");
    require(local_path_m >= 0, "local_path_m", local_path_m, ">= 0");
    require(
        min_information >= 0 && min_information <= 0.5, "min_information", min_information,
        "in [0, 0.5]");
}

Drift::Drift(const DriftOptions& options) : options_(options)
{
    options_.validate();
}

void Drift::held(const TravelLog& travel, const IcpResult& fit)
{
    if (!onlyHeldDirection(fit)) heldNow(travel);
}

std::size_t Drift::trustedBegin(const TravelLog& travel) const
{
    if (expected_m(travel) <= options_.trusted_m) return 0;
    return travel.scansBefore(path_m(travel) + options_.local_path_m);
}

std::optional<Eigen::Vector2d> Drift::onlyHeldDirection(const IcpResult& fit) const
{
    const double pairs = std::max<double>(1, static_cast<double>(fit.pairs));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> a_pair(
        fit.information.topLeftCorner<2, 2>() / pairs);
    if (a_pair.eigenvalues()(0) >= options_.min_information) return std::nullopt;
    return a_pair.eigenvectors().col(1);
}
}  // namespace rtob
