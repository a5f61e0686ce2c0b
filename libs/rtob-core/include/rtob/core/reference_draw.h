// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/core/random.h>
#include <rtob/core/scan_table.h>
#include <rtob/core/time_density.h>
#include <rtob/core/visit_index.h>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace rtob
{
enum class DrawMode
{
    Independent,  ///< the paper's: each point on its own
    Stratified    ///< the same density with less variance: one point a stratum of p(t)
};

constexpr auto enum_names(DrawMode)
{
    return std::array<std::pair<DrawMode, std::string_view>, 2>{
        {{DrawMode::Independent, "independent"}, {DrawMode::Stratified, "stratified"}}};
}

struct DrawOptions
{
    int points = 1800;
    DrawMode mode = DrawMode::Stratified;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("points", s.points, "points drawn from the map for each scan; >= 10 [sec. 2.3.2]");
        visit(
            "mode", s.mode, "how they are drawn: the paper's independent draws, or one a stratum");
    }
    void validate() const;
};

/// What of a map the draw needs to see; all of it stays the map's own.
struct MapView
{
    PointsView points_map;
    const ScanTable& scans;
    const VisitIndex& visits;
};

/// A fixed-size random sample of the map, eq. 5.
struct Reference
{
    Points points;                       ///< map axes, seen from (origin_x, origin_y)
    std::vector<std::uint64_t> indices;  ///< which points of the map these are
    double origin_x = 0, origin_y = 0;   ///< in map
};

/// Draws references. Keeps its buffers between draws, so that it allocates nothing once warm; the
/// cost of a draw does not depend on the map's size.
class ReferenceDraw
{
 public:
    explicit ReferenceDraw(const DrawOptions& options = {});

    /// Draws for `now`, only points inside `gate` if there is one. When the support holds fewer
    /// points than asked, each comes once, in order of time; with a gate so too, if the support
    /// holds at most four times as many as asked. In a larger support a gate that lets few points
    /// through gives what a fixed number of tries finds: fewer than asked, and some twice.
    void draw(
        const MapView& map, const TimeDensity& density, const Moment& now,
        const std::optional<Box>& gate, Random& random, Reference& reference);

 private:
    /// Neighbouring points that stand for an equal share of the envelope: of one scan, or of any
    /// where p(t) is flat. On the axis of the map's points, ends need not be whole.
    struct Unit
    {
        double begin, end;
        double weight_before;  ///< of all units before this one
    };

    /// Where in the envelope a stratum is looked at.
    struct Look
    {
        std::size_t stretch;
        std::uint64_t point;
        std::size_t scan;
    };

    void layOutSupport(const ScanTable& scans);
    void takeAll(const MapView& map, const TimeDensity& density, const Moment& now);
    void dropOutside(const Box& gate, const PointsView& points_map);
    void keepEvenly(std::size_t count, Random& random);
    [[nodiscard]] std::uint64_t pointAt(const ScanTable& scans, std::size_t s, double place) const;
    void pickIndependent(
        const MapView& map, const TimeDensity& density, const Moment& now, std::size_t count,
        Random& random);
    void makeUnits(
        const MapView& map, const TimeDensity& density, const Moment& now, Random& random);
    void chooseLooks(const ScanTable& scans, double stratum, Random& random);
    void makeFlatUnits(const ScanTable& scans);
    void pickStratified(std::size_t count, Random& random);
    void gather(const PointsView& points_map, Reference& reference) const;

    DrawOptions options_;
    Support support_;
    std::vector<double> envelope_before_;  ///< points x bound of all stretches before; one more
    std::uint64_t support_points_ = 0;
    std::vector<Look> looks_;
    std::vector<Unit> units_;
    double units_weight_ = 0;
    std::vector<std::uint64_t> picked_;
};
}  // namespace rtob
