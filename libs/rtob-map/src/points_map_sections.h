// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/core/bits_math.h>
#include <mrpt/maps/CPointsMap.h>
#include <rtob/core/option_checks.h>
#include <rtob/map/rtob_map_options.h>

#include <array>
#include <string_view>
#include <utility>

/// The sections of a map in an .ini with MRPT's own key names, for the strict loader: MRPT itself
/// ignores unknown keys and takes "abc" for 0.
namespace rtob
{
/// ..._creationOpts: our options, and MRPT's three switches for maps of every kind.
struct CreationSection : RtobMapOptions
{
    bool enableSaveAs3DObject = true;
    bool enableObservationLikelihood = true;
    bool enableObservationInsertion = true;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        RtobMapOptions::fields(s, visit);
        visit("enableSaveAs3DObject", s.enableSaveAs3DObject, "MRPT: may be shown in 3D");
        visit("enableObservationLikelihood", s.enableObservationLikelihood, "MRPT: is asked");
        visit("enableObservationInsertion", s.enableObservationInsertion, "MRPT: may grow");
    }
};

/// ..._insertOpts
struct InsertionSection : mrpt::maps::CPointsMap::TInsertionOptions
{
    float horizontal_tolerance_deg = mrpt::RAD2DEG(horizontalTolerance);

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("minDistBetweenLaserPoints", s.minDistBetweenLaserPoints, "m; >= 0");
        visit("addToExistingPointsMap", s.addToExistingPointsMap, "always true here");
        visit("also_interpolate", s.also_interpolate, "add points between far neighbours");
        visit("disableDeletion", s.disableDeletion, "always true here");
        visit("fuseWithExisting", s.fuseWithExisting, "always false here");
        visit("isPlanarMap", s.isPlanarMap, "leave out scans that are not horizontal");
        visit("horizontalTolerance", s.horizontal_tolerance_deg, "deg, for isPlanarMap; >= 0");
        visit("maxDistForInterpolatePoints", s.maxDistForInterpolatePoints, "m; >= 0");
        visit("insertInvalidPoints", s.insertInvalidPoints, "insert points at the laser's origin");
    }
    void validate() const
    {
        const char* const whole = "as it is by default: this map keeps every point of every scan";
        require(
            minDistBetweenLaserPoints >= 0, "minDistBetweenLaserPoints", minDistBetweenLaserPoints,
            ">= 0");
        require(addToExistingPointsMap, "addToExistingPointsMap", "false", whole);
        require(disableDeletion, "disableDeletion", "false", whole);
        require(!fuseWithExisting, "fuseWithExisting", "true", whole);
        require(
            horizontal_tolerance_deg >= 0, "horizontalTolerance", horizontal_tolerance_deg, ">= 0");
        require(
            maxDistForInterpolatePoints >= 0, "maxDistForInterpolatePoints",
            maxDistForInterpolatePoints, ">= 0");
    }
};

/// ..._likelihoodOpts
struct LikelihoodSection : mrpt::maps::CPointsMap::TLikelihoodOptions
{
    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("sigma_dist", s.sigma_dist, "m^2, MRPT's name for a variance; > 0");
        visit("max_corr_distance", s.max_corr_distance, "m; > 0");
        visit("decimation", s.decimation, "one of so many rays is looked at; >= 1");
    }
    void validate() const
    {
        require(sigma_dist > 0, "sigma_dist", sigma_dist, "> 0");
        require(max_corr_distance > 0, "max_corr_distance", max_corr_distance, "> 0");
        require(decimation >= 1, "decimation", decimation, ">= 1");
    }
};

enum class PointColours
{
    One,
    Grayscale,
    Jet,
    Hot
};

constexpr auto enum_names(PointColours)
{
    return std::array<std::pair<PointColours, std::string_view>, 4>{
        {{PointColours::One, "cmNONE"},
         {PointColours::Grayscale, "cmGRAYSCALE"},
         {PointColours::Jet, "cmJET"},
         {PointColours::Hot, "cmHOT"}}};
}

/// ..._renderOpts
struct RenderSection : mrpt::maps::CPointsMap::TRenderOptions
{
    PointColours colours = PointColours::One;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("point_size", s.point_size, "pixels; > 0");
        visit("color.R", s.color.R, "[0, 1]");
        visit("color.G", s.color.G, "[0, 1]");
        visit("color.B", s.color.B, "[0, 1]");
        visit("colormap", s.colours, "by height; cmNONE: one colour");
    }
    void validate() const { require(point_size > 0, "point_size", point_size, "> 0"); }
};
}  // namespace rtob
