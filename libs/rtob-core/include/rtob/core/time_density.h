// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/scan_table.h>
#include <rtob/core/visit_index.h>
#include <array>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace rtob
{
/// Which p(t) decides the drawn points, sec. 2.3.2 and 2.3.3.
enum class Density
{
    Uniform,     ///< the whole past
    Interval,    ///< uniform over [t_min, t_max]
    Window,      ///< uniform over [t - t_offset, t]
    Forgetting,  ///< lambda exp(-lambda age) over the whole past
    Revisit      ///< the times when the vehicle was near, each widened by a Gaussian
};

constexpr auto enum_names(Density)
{
    return std::array<std::pair<Density, std::string_view>, 5>{
        {{Density::Uniform, "uniform"},
         {Density::Interval, "interval"},
         {Density::Window, "window"},
         {Density::Forgetting, "forgetting"},
         {Density::Revisit, "revisit"}}};
}

struct DensityOptions
{
    Density density = Density::Revisit;
    double interval_begin_s = 0;
    double interval_end_s = 1e9;
    double window_s = 30;
    double forgetting_s = 0;
    double sigma_s = 1;
    double laser_range_m = 12;
    double vicinity_m = 0;
    double gate_m = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("density", s.density, "p(t) that decides which points are drawn [sec. 2.3.2]");
        visit("interval_begin_s", s.interval_begin_s, "interval: t_min in map time; >= 0");
        visit("interval_end_s", s.interval_end_s, "interval: t_max in map time; > t_min");
        visit("window_s", s.window_s, "window: t_offset; > 0");
        visit(
            "forgetting_s", s.forgetting_s,
            "1/lambda of exponential forgetting, with every density; 0: never forget "
            "(forgetting: 60)");
        visit("sigma_s", s.sigma_s, "revisit: width of the Gaussians; > 0 [sec. 2.3.3]");
        visit(
            "laser_range_m", s.laser_range_m,
            "the laser's useful range r, not the header's 80 m; > 0 [sec. 2.3.3]");
        visit(
            "vicinity_m", s.vicinity_m,
            "revisit: near is within this in x and in y; 0: r / sqrt(2) [sec. 2.3.3]");
        visit(
            "gate_m", s.gate_m,
            "draw only points within this of the vehicle in x and in y; 0: everywhere");
    }
    void validate() const;
};

/// The moment for which points are drawn.
struct Moment
{
    double time_s = 0;    ///< map time
    double x = 0, y = 0;  ///< the vehicle in map, as pre-aligned
    /// Only scans from the first to before the second are drawn.
    std::size_t scans_begin = 0;
    std::size_t scans_end = std::numeric_limits<std::size_t>::max();
};

/// Consecutive scans that may be drawn, with an upper bound of p(t) over them.
struct Stretch
{
    ScanRange scans;
    double bound = 1;
};

/// Where p(t) is not 0: stretches in order of time, disjoint. Their number is bounded whatever the
/// map's size.
struct Support
{
    std::vector<Stretch> stretches;
    double newest_s = 0;  ///< time of the newest scan in it: forgetting counts from there
};

/// p(t) up to a constant factor: a value that holds its options and picks scans. P(point) follows
/// p(its time), so a scan weighs p(t) x its number of points. Not for two threads at once.
class TimeDensity
{
 public:
    /// Gaussians and forgetting are cut where they fall below about 1e-3 and 1e-6 of their peak.
    static constexpr double kGaussianReach = 4.0;   ///< in sigma: exp(-8)
    static constexpr double kForgettingReach = 14;  ///< in 1/lambda: exp(-14)
    static constexpr std::size_t kMaxVisits = 512;  ///< bound of the cost, see VisitIndex::query

    explicit TimeDensity(const DensityOptions& options = {});

    void findSupport(
        const ScanTable& table, const VisitIndex& visits, const Moment& now,
        Support& support) const;

    /// p(time of the scan), not normalised; at most the bound of the scan's stretch.
    [[nodiscard]] double weight(
        const ScanTable& table, const Moment& now, const Support& support, std::size_t scan) const;

    /// Whether p(t) is the same all over the support.
    [[nodiscard]] bool isFlat() const
    {
        return options_.density != Density::Revisit && forgetting_rate_ == 0;
    }

    /// Delta x = Delta y of sec. 2.3.3 [m].
    [[nodiscard]] double vicinity() const { return vicinity_m_; }

 private:
    void visitedScans(
        const ScanTable& table, const VisitIndex& visits, const Moment& now,
        std::vector<Stretch>& stretches) const;
    [[nodiscard]] double gaussianBound(const ScanTable& table, const ScanRange& scans) const;
    static void keepRange(const ScanRange& range, std::vector<Stretch>& stretches);
    void cutByAge(const ScanTable& table, Support& support) const;
    [[nodiscard]] double gaussianSum(
        const ScanTable& table, const Moment& now, std::size_t scan) const;

    DensityOptions options_;
    double vicinity_m_;
    double forgetting_rate_;                 ///< lambda [1/s]
    mutable std::vector<ScanRange> ranges_;  ///< buffers of findSupport()
    mutable std::vector<Stretch> uncut_;
};
}  // namespace rtob
