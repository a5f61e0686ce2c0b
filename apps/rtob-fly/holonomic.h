// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "avoider.h"

/// MRPT's holonomic reactive methods, for comparison, used as its reactive navigator uses them: a
/// free distance for each direction of a round vehicle, in shares of a reference distance, and its
/// ramp that slows down before obstacles. The wish is a far target in its direction.
namespace rtob::fly
{
enum class HolonomicMethod
{
    NearnessDiagram,  ///< CHolonomicND
    FullEvaluation    ///< CHolonomicFullEval
};

/// Our clearance is the radius of its vehicle; all else is as MRPT has it by default.
[[nodiscard]] std::unique_ptr<Avoider> make_holonomic(
    HolonomicMethod method, const VehicleLimits& limits);

/// How far a disc of this radius gets in each of so many directions, from -pi on around, up to
/// most_m. What it touches already holds it back from coming nearer, not from getting away.
[[nodiscard]] std::vector<double> free_ways(
    const GuardScan& scan, double radius_m, std::size_t directions, double most_m);
}  // namespace rtob::fly
