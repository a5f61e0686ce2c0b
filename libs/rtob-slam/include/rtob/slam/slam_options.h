// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp.h>
#include <rtob/core/reference_draw.h>
#include <rtob/core/time_density.h>
#include <rtob/fusion/fusion_options.h>
#include <rtob/map/rtob_map_options.h>
#include <rtob/slam/anchor.h>
#include <rtob/slam/fit_gate.h>
#include <rtob/slam/insertion_policy.h>
#include <rtob/slam/local_reference.h>
#include <rtob/slam/local_search.h>
#include <rtob/slam/loop_search.h>
#include <rtob/slam/map_options.h>
#include <rtob/slam/prealignment.h>
#include <rtob/slam/relocaliser.h>
#include <rtob/slam/scan_filter.h>
#include <rtob/slam/scan_geometry.h>
#include <rtob/slam/sensor_choice.h>
#include <rtob/slam/tracking.h>

#include <cstdint>

namespace rtob
{
struct SlamOptions
{
    SensorOptions sensor;
    ScanGeometryOptions scan;
    ScanFilterOptions scan_filter;
    PrealignOptions prealign;
    FusionOptions fusion;
    DensityOptions density;
    DrawOptions draw;
    ReferenceOptions reference;
    IcpOptions icp;
    FitGateOptions fit_gate;
    SearchOptions search;
    TrackingOptions tracking;
    InsertionOptions insertion;
    DriftOptions drift;
    AnchorOptions anchor;
    LoopSearchOptions loop_search;
    RelocaliseOptions relocalise;
    MapOptions map;
    std::uint64_t seed = 1;

    /// Calls visit(section, options) for each group, in the order of the pipeline: the only list of
    /// the sections of an .ini.
    template <class Self, class Visit>
    static void sections(Self& s, Visit&& visit)
    {
        visit("Sensor", s.sensor);
        visit("Scan", s.scan);
        visit("ScanFilter", s.scan_filter);
        visit("Prealign", s.prealign);
        visit("Fusion", s.fusion);
        visit("Density", s.density);
        visit("Draw", s.draw);
        visit("Reference", s.reference);
        visit("Icp", s.icp);
        visit("FitGate", s.fit_gate);
        visit("Search", s.search);
        visit("Tracking", s.tracking);
        visit("Insertion", s.insertion);
        visit("Drift", s.drift);
        visit("Anchor", s.anchor);
        visit("LoopSearch", s.loop_search);
        visit("Relocalise", s.relocalise);
        visit("Map", s.map);
    }
    /// Whether old scans may decide: not where the user asked to forget.
    [[nodiscard]] bool remembers() const
    {
        return density.density == Density::Revisit && density.forgetting_s == 0;
    }
    void validate() const
    {
        sections(*this, [](const char*, const auto& options) { options.validate(); });
    }
};

/// What of these the map needs.
[[nodiscard]] RtobMapOptions map_options(const SlamOptions& options);
}  // namespace rtob
