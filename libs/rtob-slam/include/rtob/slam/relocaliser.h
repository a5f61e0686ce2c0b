// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/global_search.h>
#include <rtob/core/map_raster.h>
#include <rtob/core/reference_draw.h>
#include <rtob/core/wide_search.h>
#include <rtob/slam/place_check.h>

#include <optional>
#include <vector>

namespace rtob
{
struct RelocaliseOptions
{
    bool enabled = true;
    double min_score = 0.5;
    double min_explained_share = 0.8;
    double max_through_share = 0.15;
    double min_lead = 2;
    int confirm_scans = 3;
    int max_scans = 12;
    int looks_per_scan = 20'000'000;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("enabled", s.enabled, "while LOST, look for the vehicle in the whole map");
        visit(
            "min_score", s.min_score,
            "share of a scan's points that must fall near map points for a place to be looked at; "
            "(0, 1]");
        visit(
            "min_explained_share", s.min_explained_share,
            "share of the scan's points that must fall on map points; (0, 1]");
        visit(
            "max_through_share", s.max_through_share,
            "share of the beams that may pass through what no scan of the map looked through; [0, "
            "1]");
        visit(
            "min_lead", s.min_lead,
            "by how much a place must outdo any other, in logarithms of the misfit (mean squared "
            "distance), summed over the scans; > 0");
        visit(
            "confirm_scans", s.confirm_scans,
            "scans in a row that must fit the place before it is believed; >= 1");
        visit(
            "max_scans", s.max_scans,
            "scans after which places between which nothing decides are searched for anew; >= "
            "confirm_scans");
        visit(
            "looks_per_scan", s.looks_per_scan,
            "work of the search a scan, in looks into the map; >= 100000");
    }
    void validate() const;
};

/// By how much a place explains scans better than others do, in logarithms of the misfit, summed
/// over them.
struct PlaceLead
{
    double over_tracked = 0;  ///< than the place where the vehicle is tracked
    double over_others = 0;   ///< than any third one
};

/// Finds a vehicle in a map, from anywhere in it: the map is searched for a scan, the best places
/// are refined and followed through the next scans, and only one that fits scan after scan and
/// outdoes all others is believed. Its work a scan is bounded.
class Relocaliser
{
 public:
    Relocaliser(const RelocaliseOptions& options, const IcpOptions& icp);

    [[nodiscard]] bool enabled() const { return options_.enabled; }

    /// The map is another one, or has changed: it is drawn anew with the next scan to be taken.
    void forgetMap() { raster_ready_ = false; }
    /// Draws the map now.
    void learn(const MapView& map);
    /// Whether the scan reaches far enough to tell one place from another: not with a covered
    /// laser.
    [[nodiscard]] static bool tellsPlaces(const Points& points_vehicle);
    /// Starts from nothing.
    void restart();

    /// The next scan of a vehicle that is lost, or may be.
    /// @param pose_prev_now its motion since the last one, where odometry tells.
    /// @param pose_map_tracked where it is if it is not lost: one place more to be compared.
    /// @return the place, once it is sure; restart() before looking for another.
    [[nodiscard]] std::optional<PlaceEvidence> take(
        const MapView& map, const Points& points_vehicle, const std::optional<Pose2>& pose_prev_now,
        const std::optional<Pose2>& pose_map_tracked = std::nullopt);

    /// What the scans followed say for another place than the tracked one; nothing where no other
    /// is confirmed, or none so far off that tracking would not come back by itself.
    /// @param log_misfit of the scans, summed, at the tracked place.
    [[nodiscard]] PlaceLead leadOver(const Pose2& pose_map_tracked, double log_misfit) const;
    /// For how many scans the places of the last search have been followed.
    [[nodiscard]] int scansFollowed() const { return scans_followed_; }
    /// Whether another place may yet do so.
    [[nodiscard]] bool hasRival(const Pose2& pose_map_tracked) const;

    /// Whether there are places that wait to be confirmed.
    [[nodiscard]] bool hasCandidates() const { return !places_.empty(); }

 private:
    struct Place
    {
        PlaceEvidence evidence;  ///< of the newest scan
        double log_misfit = 0;   ///< summed over the scans
        int good_in_a_row = 0;
    };

    [[nodiscard]] bool search(const Points& points_vehicle, const Pose2& pose_prev_now);
    void follow(const Points& points_vehicle, const Pose2& pose_prev_now);
    void refine(const Points& points_vehicle);
    void add(const PlaceEvidence& evidence, Place& place) const;
    void sortPlaces();
    void weed();
    [[nodiscard]] std::optional<PlaceEvidence> decide();
    [[nodiscard]] Pose2 motionTo(const Points& points_vehicle);

    RelocaliseOptions options_;
    MapRaster raster_;
    GlobalSearch search_;
    PlaceCheck check_;
    WideSearch scan_search_;  ///< scan to scan
    Icp icp_;                 ///< the same
    std::vector<Place> places_;
    Pose2 pose_searched_now_;  ///< motion since the scan that is searched for
    Points points_prev_, points_thinned_, points_turned_, points_shifted_;
    bool raster_ready_ = false, searching_ = false;
    int scans_followed_ = 0;
};
}  // namespace rtob
