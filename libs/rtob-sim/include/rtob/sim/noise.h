// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/random.h>

#include <cmath>

namespace rtob::sim
{
/// Seeded chance of one part of the simulation. Parts with streams of their own do not disturb each
/// other: more beams do not change the gusts.
class Noise
{
 public:
    Noise(std::uint64_t seed, std::uint64_t stream) : random_(mixed(seed, stream)) {}

    [[nodiscard]] bool happens(double chance) { return chance > 0 && random_.uniform() < chance; }

    /// Normal, mean 0; by Marsaglia's polar method.
    [[nodiscard]] double gaussian(double sigma)
    {
        if (has_spare_)
        {
            has_spare_ = false;
            return sigma * spare_;
        }
        double u = 0, v = 0, square = 0;
        do
        {
            u = 2 * random_.uniform() - 1;
            v = 2 * random_.uniform() - 1;
            square = u * u + v * v;
        } while (square >= 1 || square == 0);
        const double scale = std::sqrt(-2 * std::log(square) / square);
        spare_ = v * scale;
        has_spare_ = true;
        return sigma * u * scale;
    }

 private:
    /// Seeds that differ little give streams that have nothing in common (SplitMix64's finaliser).
    static std::uint64_t mixed(std::uint64_t seed, std::uint64_t stream)
    {
        std::uint64_t z = seed + 0x9E3779B97F4A7C15u * (stream + 1);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

    Random random_;
    double spare_ = 0;
    bool has_spare_ = false;
};

/// A disturbance that wanders about 0: Gauss-Markov of first order.
class Wander
{
 public:
    Wander(double rms, double correlation_time_s) : rms_(rms), time_s_(correlation_time_s) {}

    double step(double dt_s, Noise& noise)
    {
        const double kept = std::exp(-dt_s / time_s_);
        return value_ = kept * value_ + noise.gaussian(rms_ * std::sqrt(1 - kept * kept));
    }
    [[nodiscard]] double value() const { return value_; }

 private:
    double rms_, time_s_, value_ = 0;
};
}  // namespace rtob::sim
