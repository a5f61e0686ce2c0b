// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/version.h>
#include <rtob/core/map_clock.h>
#include <rtob/core/pose2.h>
#include <rtob/core/random.h>
#include <rtob/core/reference_draw.h>
#include <rtob/core/scan_table.h>
#include <rtob/core/time_density.h>
#include <rtob/core/visit_index.h>
#include <rtob/map/match_sample.h>
#include <rtob/map/rtob_map_options.h>

#include <optional>
#include <string>
#include <vector>

namespace rtob
{
/// Makes the map known to MRPT, for .ini files and for reading stored maps. Every program calls it
/// once: a linker may drop a library of which no symbol is used.
void register_classes();

/// The RTOB map as an MRPT metric map, `rtobMap` in an .ini: all scans in order of arrival, of
/// which a scan is matched against a fixed-size random sample.
///
/// The points are the base's own x, y, z; beside them stands one table entry a scan. Whatever adds
/// points through the base's other functions (loadFromRangeScan, resize, ...) breaks that and is
/// refused at the next use. Matching keeps its sample between calls: match one map object from one
/// thread.
///
/// - determineMatching2D and, while a sample is kept, squareDistanceToClosestCorrespondence look at
///   the sample: constant cost whatever the map's size.
/// - Likelihoods, 3D matching and determineMatching3D are the base's, over all points: they serve
///   localisation in a finished map, where its kd-tree is built once.
class RtobMap : public mrpt::maps::CSimplePointsMap
{
    DEFINE_SERIALIZABLE(RtobMap, rtob)

 public:
    explicit RtobMap(const RtobMapOptions& options = {});
    RtobMap(const RtobMap& other);
    RtobMap& operator=(const RtobMap& other);
    ~RtobMap() override = default;

    [[nodiscard]] const RtobMapOptions& options() const { return state_.options; }
    /// Keeps the points; draws start anew from the options' seed. @throws std::invalid_argument
    void setOptions(const RtobMapOptions& options);

    /// @name What a SLAM pipeline uses
    /// @{

    /// Map time for a new scan, asked once for each scan of the log, inserted or not.
    /// @param stamp_s as the log has it; UNIX time or any other.
    double tick(double stamp_s) { return state_.clock.advance(stamp_s); }
    [[nodiscard]] const MapClock& clock() const { return state_.clock; }

    /// Appends a scan; memory grows in large blocks, seldom. A scan of no points is left out.
    /// @param time_s map time, from tick(). @param points_vehicle finite numbers.
    /// @throws std::invalid_argument for a time before the last scan's
    void insertScan(double time_s, const Pose2& pose_map_vehicle, const PointsView& points_vehicle);

    /// Forgets all other scans and their points; those that stay move up, and the clock goes on.
    /// Allocates nothing. @param keep one entry a scan: 0 to forget it.
    void keepOnly(const std::vector<char>& keep);

    /// Moves the newest scans, and their points with them.
    /// @param poses_map_vehicle one for each scan from `first` to the last.
    /// @throws std::invalid_argument where these are more or fewer
    void moveScans(std::size_t first, const std::vector<Pose2>& poses_map_vehicle);

    /// Makes room for a map that gets no larger: nothing is allocated for it afterwards.
    void reserveOnce(std::size_t scans, std::size_t points);

    /// Draws for the vehicle at this pose, now, within the options' gate.
    void draw(const Pose2& pose_map_vehicle, Reference& reference);
    /// The same within another gate too, if there is one, and only of scans from scans_begin on.
    void draw(
        const Pose2& pose_map_vehicle, const std::optional<Box>& gate, std::size_t scans_begin,
        Reference& reference);

    /// @}

    [[nodiscard]] PointsView points() const { return {m_x.data(), m_y.data(), m_x.size()}; }
    [[nodiscard]] const ScanTable& scans() const { return state_.scans; }
    /// @throws std::logic_error when points and scans do not belong together (see above)
    [[nodiscard]] MapView view() const;
    /// Bytes in use for points and scans: at most 16 a point with 180 points a scan.
    [[nodiscard]] std::size_t bytesInUse() const;

    /// The sample for this scan: drawn at the first call, then kept while scan and map stay and the
    /// pose stays near. It follows from seed, map and scan alone.
    [[nodiscard]] const Reference& sampleFor(
        const PointsView& scan_vehicle, const Pose2& pose_map_vehicle) const;

    void determineMatching2D(
        const mrpt::maps::CMetricMap* other_map, const mrpt::poses::CPose2D& other_map_pose,
        mrpt::tfest::TMatchingPairList& pairs, const mrpt::maps::TMatchingParams& params,
        mrpt::maps::TMatchingExtraResults& extra) const override;

    /// Of the kept sample; of all points where none is kept.
    float squareDistanceToClosestCorrespondence(float x, float y) const override;

    std::string asString() const override;

    /// Writes prefix.txt and prefix.ply (points) and prefix_scans.txt (time and pose of each scan).
    void saveMetricMapRepresentationToFile(const std::string& prefix) const override;

 protected:
    void internal_clear() override;
    /// One table entry for each observation that gives points; false for one that gives none.
    bool internal_insertObservation(
        const mrpt::obs::CObservation& observation,
        const std::optional<const mrpt::poses::CPose3D>& pose_map_vehicle = std::nullopt) override;

 private:
    /// What this class stores beside the base's points.
    struct State
    {
        explicit State(const RtobMapOptions& all_options);

        RtobMapOptions options;
        MapClock clock;
        ScanTable scans;
        VisitIndex visits;
        std::size_t scans_reserved = 0;
        TimeDensity density;
        Random random;
    };
    /// Matching is const in MRPT, yet draws and keeps its sample.
    struct Matching
    {
        ReferenceDraw draw;
        MatchSample sample;
    };

    [[nodiscard]] std::optional<Box> gateAround(const Pose2& pose_map_vehicle) const;
    [[nodiscard]] Moment momentAt(const Pose2& pose_map_vehicle) const;
    void reserveFor(std::size_t more_points);
    void appendScan(double time_s, const Pose2& pose_map_vehicle, std::size_t point_count);
    void dropPointsThatAreNoNumbers(std::size_t first);
    void copyBaseOptionsFrom(const mrpt::maps::CPointsMap& other);
    void readScans(mrpt::serialization::CArchive& in);

    State state_;
    mutable Matching matching_;

    MAP_DEFINITION_START(RtobMap)
    RtobMapOptions creationOpts;
    mrpt::maps::CPointsMap::TInsertionOptions insertionOpts;
    mrpt::maps::CPointsMap::TLikelihoodOptions likelihoodOpts;
    mrpt::maps::CPointsMap::TRenderOptions renderOpts;
    MAP_DEFINITION_END(RtobMap)
};
}  // namespace rtob
